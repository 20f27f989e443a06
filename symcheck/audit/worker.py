"""What worker processes start with: the waiting process reports an error that ends one, never the worker itself.

Errors of what a worker is asked to do are answers (`executor.Crash`). Others come from its start, as when the process
that wanted it is interrupted and closes what they speak through.
"""

from __future__ import annotations

import sys
from types import TracebackType


def _silent(kind: type[BaseException], error: BaseException, trace: TracebackType | None) -> None:
    """Reported elsewhere."""


if any("multiprocessing.forkserver" in argument for argument in sys.orig_argv):
    sys.excepthook = _silent
