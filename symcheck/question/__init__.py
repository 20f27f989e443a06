"""One formula, asked without a paper and without declarations: what its letters are is inferred, and shown."""

from symcheck.question.answer import Answer, Status
from symcheck.question.ask import decide

__all__ = ["Answer", "Status", "decide"]
