"""What a run of the quick tests takes of a long list of cases; `make test-full` takes all."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import pytest


def every(step: int, cases: Iterable[Any]) -> list[Any]:
    """The cases for one parameter, of which all but one in so many are slow."""
    return [case if k % step == 0 else pytest.param(case, marks=pytest.mark.slow) for k, case in enumerate(cases)]
