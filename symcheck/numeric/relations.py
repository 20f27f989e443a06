"""The kernels of `symcheck.relations`, which the papers do not print."""

from __future__ import annotations

from pathlib import Path
from types import ModuleType

from symcheck import kernels

FOLDER = Path(__file__).resolve().parents[1] / "relations"

kernels_of_relations: ModuleType = kernels.load(str(FOLDER))
