"""A cache for tests in which there is what the gates of `make test` have just decided; the checker checks it again."""

from __future__ import annotations

import shutil
from pathlib import Path

DECIDED = Path(__file__).resolve().parents[1] / "build" / "cache"  # as in the Makefile


def warm_cache(folder: Path) -> str:
    """The folder, filled with the cache of the gates if there is one."""
    if DECIDED.is_dir() and not folder.exists():
        shutil.copytree(DECIDED, folder)
    return str(folder)
