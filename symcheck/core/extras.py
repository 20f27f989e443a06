"""What installs the libraries that only some commands and functions need: the extras of the package."""

from __future__ import annotations

import os
import shlex
import sys


def installing(extra: str) -> str:
    """The command that installs an extra for the Python that runs now; another `pip` may belong to another Python.

    It works in a checkout too: pip takes the package itself as it is installed.
    """
    python, here = sys.executable, os.getcwd() + os.sep
    return f"{shlex.quote(python.removeprefix(here))} -m pip install 'symcheck[{extra}]'"
