"""Re-checks certificates with the standard library alone: this folder, and `symcheck.core`, are what has to be trusted.

`python -m symcheck.checker` checks files; `check` and `check_all` check certificates that have been read from JSON.
"""

from symcheck.checker.certificates import check, check_all

__all__ = ["check", "check_all"]
