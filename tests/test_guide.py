"""The guide's example: printed as its source has it, and shown without what differs from run to run."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from pkgutil import iter_modules

import pytest

import symcheck
from symcheck import papers
from symcheck.core.claims import Paper
from symcheck.core.verdicts import SymcheckError
from symcheck.views.notebook import committed
from symcheck.views.notebook.guide import EXAMPLE, Checkout, excerpt
from symcheck.views.notebook.source import slug


@pytest.fixture
def example(monkeypatch: pytest.MonkeyPatch) -> Iterator[Paper]:
    """The example as one of the papers."""
    monkeypatch.setattr(papers, "__path__", [*papers.__path__, str(committed.folder() / "guide")])
    yield papers.Papers()[EXAMPLE]
    for name in [name for name in sys.modules if name.startswith(f"{papers.__name__}.{EXAMPLE}")]:
        del sys.modules[name]
    delattr(papers, EXAMPLE)


def test_every_printed_form_of_the_example_stands_on_its_line(example: Paper) -> None:
    lines = (committed.folder() / "guide" / EXAMPLE / example.source).read_text(encoding="utf-8").splitlines()
    declared = [item for _, _, item in example.items()]
    assert [item.number for item in declared] == re.findall(r"\\tag\{(\d)\}", "\n".join(lines))
    assert [item.number for item in declared if item.source.printed[0] not in lines[item.source.line - 1]] == []


def test_a_declaration_that_is_not_there_is_named() -> None:
    with pytest.raises(SymcheckError, match=r"sec1\.py declares no lenght; it declares SQUARE, moment, length"):
        excerpt("sec1.py", "lenght")


def test_a_file_is_shown_whole_or_by_declarations() -> None:
    assert "least_length" in repr(excerpt("sec1.py"))
    assert "least_length" not in repr(excerpt("sec1.py", "reversible"))


def test_a_command_shows_what_it_prints_and_its_error_and_no_times() -> None:
    checkout = Checkout()
    decided = repr(checkout.run("symcheck check pendulum:4 --jobs 0"))
    assert "proved" in decided
    assert not re.search(r"\d s$", decided, flags=re.MULTILINE)
    assert "did you mean pendulum" in repr(checkout.run("symcheck check pendulm --jobs 0"))


def test_the_guide_names_every_folder_of_the_package() -> None:
    text = (committed.folder() / "sources" / "guide" / "6_contribute.md").read_text(encoding="utf-8")
    listed = re.findall(r"^  (\w+)/", text, flags=re.MULTILINE)
    folders = {each.name for each in iter_modules(symcheck.__path__) if each.ispkg} - {"generated"}
    assert sorted(listed) == sorted(folders)


def test_every_decision_has_a_short_page_that_the_guide_lists() -> None:
    guide = committed.folder() / "guide"
    text = (committed.folder() / "sources" / "guide" / "7_decisions.md").read_text(encoding="utf-8")
    listed = re.findall(r"^- \[(.+)\]\((decisions/.+\.md)\): .+$", text, flags=re.MULTILINE)
    pages = {file: file.read_text(encoding="utf-8") for file in (guide / "decisions").iterdir()}
    assert sorted(listed) == sorted(
        (text.partition("\n")[0][2:], f"decisions/{file.name}") for file, text in pages.items()
    )
    assert [file.name for file, text in pages.items() if file.stem != slug(text.partition("\n")[0])] == []
    parts = ["What", "Why", "Instead"]
    assert [
        file for file, text in pages.items() if re.findall(r"^\*\*(\w+)\.\*\* ", text, flags=re.MULTILINE) != parts
    ] == []
    assert max(len(text.split()) for text in pages.values()) < 200


def test_links_of_notebooks_lead_to_what_is_there() -> None:
    sources = committed.folder() / "sources"
    links = {
        (file, link)
        for file in sources.rglob("*.md")
        for link in re.findall(r"\]\(([^)#]+)[^)]*\)", file.read_text(encoding="utf-8"))
        if "://" not in link
    }
    made = {file: committed.folder() / file.relative_to(sources) for file, _ in links}
    assert [link for file, link in links if not (made[file].parent / link).exists()] == []
    assert len(links) > 30


def test_a_checkout_is_removed_with_its_object() -> None:
    checkout = Checkout()
    root = checkout._root
    assert (root / "symcheck" / "papers" / EXAMPLE).is_dir()
    assert sorted(path.name for path in (root / "symcheck" / "papers").iterdir() if path.is_dir()) == [EXAMPLE]
    del checkout
    assert not root.exists()
