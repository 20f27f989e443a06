"""Three documents of our own, of different fields and markup: audited as they stand, and with misprints planted."""

from __future__ import annotations

import json
import random
import re
from pathlib import Path

import pytest
from test_new import _apart, begun, run, verdicts  # noqa: F401

from symcheck.document.sources import source

DOCUMENTS = Path(__file__).parent / "documents"
NAMES = sorted(file.name for file in DOCUMENTS.iterdir())
# claims that are neither proved nor refuted, for want of a method
OPEN = {"gas.tex": set(), "circuit.md": set(), "chance.rst": set()}
DISPLAYS, READ, NOTICED, REFUTED, TRIED = 25, 0.8, 0.9, 0.5, 12
SLIPS = [  # each is one sign for another
    (re.compile(r"(?<![\d_{])[2-9](?!\d)"), lambda sign: str(int(sign) % 8 + 2)),
    (re.compile(r"(?<=\S )\+(?= )"), lambda sign: "-"),
    (re.compile(r"(?<=\S )-(?= )"), lambda sign: "+"),
    (re.compile(r"\\sin"), lambda sign: r"\cos"),
    (re.compile(r"\\cos"), lambda sign: r"\sin"),
    (re.compile(r"\^2"), lambda sign: "^3"),
]


@pytest.mark.parametrize("name", NAMES)
def test_a_document_is_audited_without_an_edit(name: str, tmp_path: Path) -> None:
    text = (DOCUMENTS / name).read_text(encoding="utf-8")
    audit = begun(tmp_path, text, name)
    displays = [each for each in source(tmp_path / name).formulas if each.display]
    code = (audit / "audit.py").read_text(encoding="utf-8")
    assert len(displays) >= DISPLAYS
    assert code.count("# source.exclusion") <= (1 - READ) * len(displays)
    found = verdicts(audit)
    assert {number for number, verdict in found.items() if verdict != "proved"} == OPEN[name]
    assert "refuted" not in found.values()


def planted(text: str, line: int) -> str:
    """The text with one slip in the relations of a line; the same if there is no place for one."""
    lines = text.split("\n")
    printed = lines[line - 1].partition(r"\label")[0]
    choices = [(found, change) for pattern, change in SLIPS for found in pattern.finditer(printed)]
    for found, change in random.Random(lines[line - 1]).sample(choices, min(1, len(choices))):
        before, after = lines[line - 1][: found.start()], lines[line - 1][found.end() :]
        lines[line - 1] = before + change(found[0]) + after
    return "\n".join(lines)


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_misprints_are_noticed_from_the_source_alone(name: str, tmp_path: Path) -> None:
    """In what is proved, and in what it follows from: it is no longer proved, and mostly refuted."""
    text = (DOCUMENTS / name).read_text(encoding="utf-8")
    audit = begun(tmp_path, text, name)
    items = json.loads(run("check", audit, "--jobs", 0, "--json").stdout)["items"]
    proved = [item for item in items if item["verdict"] == "proved"]
    used = {id for item in proved for id in (item["id"], *item["uses"])}
    lines = {item["line"] for item in items if item["id"] in used and item["role"] != "premise"}
    texts = [changed for line in sorted(lines) if (changed := planted(text, line)) != text]
    unproved = refuted = 0
    for changed in random.Random(name).sample(texts, TRIED):
        (tmp_path / name).write_text(changed, encoding="utf-8")
        now = verdicts(audit)
        unproved += any(now.get(item["id"].partition(":")[2]) != "proved" for item in proved)
        refuted += "refuted" in now.values()
    assert unproved >= NOTICED * TRIED
    assert refuted >= REFUTED * TRIED
