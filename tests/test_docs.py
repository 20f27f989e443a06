"""The reference of public names is built without a warning, and needs no network to be read."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from build_docs import PACKAGES, main


@pytest.mark.slow
def test_the_reference_is_built_and_needs_no_network(tmp_path: Path) -> None:
    assert main([str(tmp_path / "docs")]) == 0
    pages = {file.stem: file.read_text(encoding="utf-8") for file in (tmp_path / "docs").glob("*.html")}
    assert {"index", *PACKAGES} <= pages.keys()
    loaded = [found for text in pages.values() for found in re.findall(r'(?:src|<link[^>]* href)="([^"]+)"', text)]
    assert [address for address in loaded if "//" in address] == []
    assert "symcheck.numeric.wheels.envelope" in pages["symcheck.numeric.wheels"]
