"""Re-checks certificates with the standard library alone.

What has to be trusted is this folder, and the modules `terms`, `formulas`, `calculus` and `fields` of `symcheck.core`.

`python -m symcheck.checker` checks files; `check` and `check_all` check certificates that have been read from JSON.
"""

from symcheck.checker.certificates import check, check_all

__all__ = ["check", "check_all"]
