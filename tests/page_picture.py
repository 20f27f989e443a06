"""Takes the README's picture of the page, with Chromium: python tests/page_picture.py"""

from __future__ import annotations

import os
import shutil
from pathlib import Path
from tempfile import TemporaryDirectory

from click.testing import CliRunner

PICTURE = Path(__file__).resolve().parent.parent / "notebooks" / "guide" / "page.png"
RELATION = "mirer2009:2.1.2"
SIZE = {"width": 1200, "height": 1000}
ROOM = 100  # pixels below a heading, for what stands there
CHROMIUM = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)


def take(target: Path) -> list[str]:
    """Write the picture of one relation, as `symcheck report` shows it; the headings that can be seen on it."""
    from playwright.sync_api import sync_playwright

    from symcheck.cli import cli

    arguments = ["--no-sandbox"] if hasattr(os, "geteuid") and os.geteuid() == 0 else []
    with TemporaryDirectory() as folder, sync_playwright() as playwright:
        page = Path(folder) / "page.html"
        done = CliRunner().invoke(cli, ["report", "--jobs", "0", "--output", str(page), RELATION])
        assert done.exit_code == 0, done.output
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=arguments)
        opened = browser.new_page(viewport=SIZE)
        opened.goto(f"{page.as_uri()}#{RELATION}")
        opened.wait_for_selector("html[data-ready]", state="attached")
        opened.screenshot(path=target)
        headings = opened.locator("#view-claim h2").all()
        boxes = [(each.inner_text(), each.bounding_box()) for each in headings]
        browser.close()
    return [text for text, box in boxes if box and box["y"] + box["height"] + ROOM < SIZE["height"]]


if __name__ == "__main__":
    take(PICTURE)
