"""Python without docstrings, as -OO and PYTHONOPTIMIZE=2 run it: what is about docstrings is left out there."""

from __future__ import annotations

import sys

import pytest

about_docstrings = pytest.mark.skipif(sys.flags.optimize > 1, reason="there are no docstrings here")
