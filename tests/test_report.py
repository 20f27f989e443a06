"""The report: what stands in the page, before any browser shows it."""

from __future__ import annotations

import json
import re
import struct
import zlib
from collections import Counter
from collections.abc import Callable, Iterator
from hashlib import sha256
from html import unescape
from pathlib import Path
from typing import Any

import pytest
import stand_in
from click.testing import Result
from msgspec.structs import replace
from stand_in import correction, hypothesis
from unpacked import unpacked

from symcheck import __version__, kernels, papers
from symcheck.audit import expand
from symcheck.audit.decide import decide
from symcheck.core.problems import Method
from symcheck.core.verdicts import Group, Origin, Reading, Role, SymcheckError, Verdict
from symcheck.dimensions import CONSISTENT, Dimensions
from symcheck.ledger import Edit, Need, Record, Repair
from symcheck.ledger.selftested import evidence
from symcheck.proof.search import methods as search_methods
from symcheck.views.latex import is_formula
from symcheck.views.model import Relation, errata
from symcheck.views.page import sources
from symcheck.views.page.difference import marked
from symcheck.views.page.graph import graph
from symcheck.views.page.marks import marks
from symcheck.views.page.meanings import FAULT, MEANINGS, RIGHT, answer
from symcheck.views.page.page import Extras, page
from symcheck.views.page.plots import colour, coloured, curves, png
from symcheck.views.page.sources import Excerpt, Publication, meanings
from symcheck.views.page.typeset import typeset
from symcheck.views.steps import RULES, steps

TOY = (Publication("toy", "The toy paper", "toy.txt", {"1": "The only section"}),)
ROW = r"V_1 : \mathbf{H} = [1, 1, -1] = (0, 0, 1)"
ENVELOPE: dict[str, Any] = {
    "title": "A cube",
    "paper": "toy",
    "lists": ["1V", "1E", "1F", "T1"],
    "names": ["V_1", "V_2", "V_2'", "V_1'"],
    "vertices": [[1, 1, -1], [1, -1, -1], [-1, 1, 1], [-1, -1, 1]],
    "signs": [[1, 1, -1], [1, -1, -1], [-1, 1, 1], [-1, -1, 1]],
    "edges": [[0, 1]],
    "faces": [[0, 1, 2, 3]],
}


def record(number: str, **fields: Any) -> Record:
    given: dict[str, Any] = {"section": "1", "line": 1, "role": Role.CLAIM, "verdict": Verdict.PROVED, **fields}
    return Record(id=f"toy:{number}", paper="toy", **given)


def wrong(number: str, printed: str, corrected: str, **fields: Any) -> Record:
    given: dict[str, Any] = {
        "verdict": Verdict.REFUTED,
        "reading": Reading.MISPRINT,
        "kind": "sign",
        "origin": Origin.PAPER,
        "erratum": correction(**fields.pop("repair", {})),
        **fields,
    }
    return record(number, printed=printed, corrected=corrected, **given)


def folded(text: str, name: str) -> Any:
    found = re.search(rf'id="folded-{name}">([^<]*)<', text)
    assert found
    return unpacked(found[1])


def printed_texts() -> Iterator[str]:
    for paper in papers.load().values():
        for obligation in expand(paper):
            yield from (*obligation.item.source.printed, *obligation.item.stated)


def test_the_page_says_which_version_wrote_it() -> None:
    assert f"symcheck report</code>, version {__version__}, from" in page([], [])


def test_the_page_says_when_it_was_written() -> None:
    assert ", on 2026-02-03, from" in page([], [], Extras(date="2026-02-03"))


def test_every_role_reading_and_method_is_explained() -> None:
    methods = {record.method for key in ("mirer2009:2.12", "mirer2009:2.17") for record in decide(key)}
    assert methods == {"identity", "cases"}
    declared = {each.name for each in vars(search_methods).values() if isinstance(each, Method)}
    assert {*Verdict, *Role, *Reading, *methods, *declared} <= {*MEANINGS}
    index = folded(page([record("1")], TOY), "index")
    assert index["meanings"] == {str(word): says for word, says in MEANINGS.items()}


@pytest.mark.parametrize(
    ("given", "said"),
    [
        (record("1", reading=Reading.AS_PRINTED), "Right as printed."),
        (
            record("1", reading=Reading.AS_PRINTED, hypotheses=(hypothesis("h", "h is given", "printed", None),)),
            "Right as printed, given the hypothesis below.",
        ),
        (record("1", reading=Reading.STATED), "Right as stated by the auditor."),
        (
            wrong("1", "x = y", "x = -y"),
            "Wrong as printed: it fails at the exact point below; what is right instead is proved. "
            "The fault is the paper's own.",
        ),
        (
            wrong("1", "x = y", "x = -y", origin=Origin.OCR, erratum=None),
            "Wrong as it stands in the digitised text: it fails at the exact point below. "
            "The fault lies in the digitised text, not in the paper.",
        ),
        (
            wrong("1", "", "x = -y", origin=Origin.UNCERTAIN, erratum=None),
            "Wrong as the words state it: it fails at the exact point below. "
            "The text at hand does not tell whether the paper or its digitisation is at fault.",
        ),
        (record("1", verdict=Verdict.UNDECIDED), f"Not decided: {MEANINGS[Verdict.UNDECIDED]}."),
        (record("1", verdict=None, role=Role.PREMISE), f"Not decided: {MEANINGS[Role.PREMISE]}."),
    ],
)
def test_a_claim_says_first_whether_it_is_right(given: Record, said: str) -> None:
    assert answer(Relation(given)) == said
    (claim,), strings = (folded(page([given], TOY), "claims-toy")[name] for name in ("claims", "strings"))
    place = re.search(r'<p class="answer" data-s="(\d+)">', claim)
    assert place
    assert strings[int(place[1])] == said


def test_what_lacks_a_hypothesis_alone_is_shown_once_with_the_hypothesis() -> None:
    given = record(
        "1",
        printed="x = y",
        read="x = y",
        corrected="x = y (given: y is a number)",
        verdict=Verdict.REFUTED,
        reading=Reading.NEEDS_HYPOTHESIS,
        kind="missing hypothesis",
        origin=Origin.PAPER,
        erratum=correction(added=("y is a number",)),
    )
    text = page([given], TOY)
    (claim,) = folded(text, "claims-toy")["claims"]
    for shown in (text, claim):
        assert '<dt>right if</dt><dd class="prose">y is a number</dd>' in shown
        assert "<dt>correct</dt>" not in shown
    (other,) = folded(page([wrong("1", "x = y", "x = -y")], TOY), "claims-toy")["claims"]
    assert "<dt>correct</dt>" in other
    assert "<dt>right if</dt>" not in other


@pytest.mark.parametrize(
    ("printed", "read", "otherwise"),
    [
        (r"\left( a_{1} + b \right) c,", "(a_1 + b) c", False),
        ("a = b.", "a = b", False),
        ("a = -b", "a = b", True),
        ("V_1  2.478", "V_1 = 2.478", True),
    ],
)
def test_what_is_read_as_it_is_printed_is_shown_once(printed: str, read: str, otherwise: bool) -> None:
    given = record("1", printed=printed, read=read)
    (claim,) = folded(page([given], TOY), "claims-toy")["claims"]
    assert ("<h2>As read</h2>" in claim) is otherwise
    assert ("It is read as it is printed." in claim) is not otherwise


def test_the_general_form_is_set_as_a_formula_and_nothing_of_it_is_cut() -> None:
    form = ["=", "E", ["+", *(["*", ["^", "c", 2], f"m_{n}"] for n in range(10))]]
    one = Dimensions(verdict=CONSISTENT, sides=("J", "kg"), scales=("c_{\\max} = 1",), general=(form,))
    part = folded(page([record("1", dimension=one)], TOY), "claims-toy")
    (claim,) = part["claims"]
    assert "consistent if c_max = 1: J against kg" in part["strings"]
    assert ">with c_max restored:</p>" in claim
    assert [json.loads(part["strings"][int(n)]) for n in re.findall(r'data-g="(\d+)"', claim)] == [form]
    long = replace(one, general=(form,) * 9)
    (claim,) = folded(page([record("1", dimension=long)], TOY), "claims-toy")["claims"]
    assert "with c_max restored, it is a long formula: <code>symcheck show toy:1</code>" in claim
    assert "data-g" not in claim
    (other,) = folded(page([record("1", dimension=Dimensions(verdict=CONSISTENT))], TOY), "claims-toy")["claims"]
    assert "restored" not in other


def test_what_is_counted_is_counted_in_the_right_number() -> None:
    one = unescape(page([record("1", uses=("toy:1",))], TOY))
    assert "1 relation of 1 paper was decided" in one
    assert "2 relations of 1 paper were decided" in page([record("1"), record("2")], TOY)


def test_where_no_claim_uses_another_one_that_is_said() -> None:
    said = "No claim here is said to use another one."
    assert said in page([record("1")], TOY)
    assert said not in page([record("1"), record("2", uses=("toy:1",))], TOY)


def test_whether_it_is_right_is_said_of_every_reading_and_origin() -> None:
    assert {*Origin} == {*FAULT}
    wrong_only, of_documents = {Reading.NEEDS_HYPOTHESIS}, {Reading.STATED, Reading.REWRITTEN}
    assert {*Reading} - wrong_only - of_documents == {*RIGHT}


def test_the_letters_of_a_counterexample_and_of_hypotheses_are_explained() -> None:
    records = [each for each in decide("ignatov2005:T9.18") if each.id == "ignatov2005:T9.18a"]
    [found] = meanings({"ignatov2005": papers.load()["ignatov2005"]}, records).values()
    assert [(each.latex, each.says) for each in found] == [
        (r"\mathbf{V}_{i}", "vertex, N m s, Y in proofs"),
        ("a", "angle between the axis of a wheel and OZ (the original prints alpha in places), rad"),
    ]


def test_proofs_of_several_parts_are_told_apart() -> None:
    [found] = [Relation(each) for each in decide("ignatov2005:2.2.14") if each.id == "ignatov2005:2.2.14a"]
    assert [each.title for each in found.proofs] == [
        *(f"as printed, part {n} of 3, refuted" for n in (1, 2, 3)),
        *(f"as corrected, part {n} of 3, proved" for n in (1, 2, 3)),
    ]


def test_an_implication_fails_where_its_condition_holds_and_what_follows_does_not() -> None:
    [found] = [Relation(each) for each in decide("poloskov2004:3.2.8")]
    assert found.counterexample
    assert found.counterexample.compared == (("the condition", "true"), ("what follows", "false"))


def test_a_claim_says_where_its_paper_was_published_and_which_file_was_audited() -> None:
    shown = Publication("toy", "The toy paper", "toy.txt", {}, "Journal of Toys 3, pages 4-5", "0123")
    text = page([record("1", line=7)], [shown])
    (claim,) = folded(text, "claims-toy")["claims"]
    assert "line 7 of toy.txt" in claim
    told = {"key": "toy", "title": "The toy paper", "published": "Journal of Toys 3, pages 4-5"}
    assert folded(text, "index")["papers"] == [told | {"source": "toy.txt", "digest": "0123"}]


def test_the_digests_of_the_papers_are_those_of_the_texts_at_hand(sources: Path) -> None:
    for paper in papers.load().values():
        assert paper.published
        assert len(paper.digest) == 16
        assert sha256((sources / paper.source).read_bytes()).hexdigest().startswith(paper.digest), paper.key


def test_repairs_are_shown_as_formulas_and_never_as_the_signs_of_their_source() -> None:
    repair = Repair("factor", r"factor \frac{a}{b} dropped", "x = y")
    row = wrong(
        "1",
        r"x = \frac{a}{b} y",
        "x = y",
        read=r"x = \frac{a}{b} y",
        repair={"repairs": (repair,), "edit": (Edit("a", "b"),)},
    )
    (claim,) = folded(page([row], TOY), "claims-toy")["claims"]
    assert "one single edit repairs it" in claim
    assert "dropped" not in claim
    assert len(re.findall(r'class="m"', claim.split("one single edit")[1].split("</ul>")[0])) == 2


def test_what_is_seen_first_has_its_formulas_apart_from_those_of_the_claims() -> None:
    rows = [wrong("1", "x = 1", "x = 2"), record("2", printed="y = 3")]
    text = page(rows, TOY)
    assert len(folded(text, "errata")["math"]) == 2
    assert any("<mn>3</mn>" in math for math in folded(text, "claims-toy")["math"])
    assert not any("<mn>3</mn>" in math for math in folded(text, "errata")["math"])


def test_letters_of_ours_are_told_from_those_that_are_printed() -> None:
    [found] = meanings({"esenkov2006": papers.load()["esenkov2006"]}, decide("esenkov2006:2.1.4")).values()
    ours = [each.latex for each in found if each.is_ours]
    assert ours == ["F", "G", "H"]
    assert {"A": "transverse moment of inertia, kg m^2"}.items() <= {each.latex: each.says for each in found}.items()


def test_every_formula_of_the_papers_is_typeset_and_nothing_else() -> None:
    found = typeset(printed_texts())
    assert len(found) > 1500
    assert [text for text, math in found.items() if is_formula(text) and not (math or "").startswith("<math")] == []
    assert [text for text, math in found.items() if not is_formula(text) and math] == []


@pytest.mark.parametrize(
    "text", ["a & b \\\\ c & d", "$V'_1$\t1\t2", r"h_\max", "x\ny", r"\begin{aligned}x\\y\end{aligned}"]
)
def test_what_is_cut_out_of_an_array_is_typeset_too(text: str) -> None:
    assert typeset([text])[text]


@pytest.mark.parametrize("text", ["(р = IT}", "The list with that put right.", "", "a}{b"])
def test_words_and_damaged_characters_are_not_typeset_as_formulas(text: str) -> None:
    assert typeset([text]) == {text: None}


def test_differences_are_marked_on_both_sides() -> None:
    before, after = typeset(["a_1 + b", "a_1 - b"]).values()
    assert before
    assert after
    one, other = marked(before, after)
    assert re.findall(r'class="del"[^>]*>([^<]*)<', one) == ["+"]
    assert re.findall(r'class="ins"[^>]*>([^<]*)<', other) == ["−"]
    assert re.sub(r' class="(?:del|ins)"', "", one + other) == before + after


def test_equal_formulas_have_no_mark() -> None:
    [math] = typeset([r"\left(x\right)^2 = 1"]).values()
    assert math
    assert marked(math, math) == (math, math)


POINT = {"values": {"x": ["/", 2, 7]}, "shown": [["=", "x", ["/", 2, 7]], ["=", ["-", "x"], ["/", -2, 7]]]}


def test_the_page_says_what_the_records_say() -> None:
    refuted = {**stand_in.REFUTED, "id": "toy:3", "point": POINT}
    rows = [
        record("1", printed="x = x", uses=("toy:2",)),
        record("2", role=Role.OURS, words="A <b>bold</b> & sentence", used_by=("toy:1",)),
        wrong("3", "x = -x", "x = x", certificates=(refuted,)),
        record("4", role=Role.PREMISE, verdict=None),
    ]
    text = page(rows, TOY)
    index, ledger = folded(text, "index"), folded(text, "claims-toy")
    assert [row[0] for row in index["rows"]] == [each.id for each in rows]
    assert Counter(index["names"][row[1]] for row in index["rows"]) == {"proved": 2, "refuted": 1, "premise": 1}
    assert "3 relations of 1 paper were decided, 2 read as they are printed, 1 added by us" in text
    assert re.search(r"<b>2</b> proved.*<b>1</b> refuted.*<b>0</b> undecided", text)
    claims = dict(zip((each.id for each in rows), ledger["claims"], strict=True))
    assert 'href="#toy:2"' in claims["toy:1"]
    assert 'href="#toy:1"' in claims["toy:2"]
    assert "−2/7" in claims["toy:3"]
    point = re.search(r'<span data-f="([^"]*)"', claims["toy:3"])
    assert point
    assert json.loads(unescape(point[1])) == ["=", "x", ["/", 2, 7]]
    assert "<b>bold</b> & sentence" in "".join(ledger["strings"])
    assert "<b>bold" not in "".join(claims.values())


def test_what_is_printed_cannot_become_markup() -> None:
    evil = '<script>alert("x")</script>'
    fields = {"name": evil, "reason": evil, "words": evil}
    text = page([wrong("1", evil, evil, **fields), record("2", printed=evil, **fields)], TOY)
    ledger = folded(text, "claims-toy")
    assert evil not in text
    assert evil not in "".join(ledger["claims"])
    assert "alert" in "".join(ledger["strings"])


def test_a_page_asks_nothing_of_any_network() -> None:
    text = page([record("1", printed="x = x")], TOY)
    assert re.findall(r'(?:src|href)="(?!#|data:)[^"]*"', text) == []
    assert re.findall(r"url\((?!data:)", text) == []
    assert "default-src 'none'" in text
    assert "//cdn" not in text
    assert "@import" not in text


def test_errata_come_first_and_the_serious_ones_before_the_slips() -> None:
    rows = [
        wrong("1", "x", "y", kind="lost prime"),
        wrong("2", "x", "y", reading=Reading.DAMAGED, verdict=Verdict.PROVED),
        wrong("3V.1", "x", "y", repair={"row": True}),
        wrong("4", "x", "y"),
    ]
    text = page(rows, TOY)
    places = [text.index(str(group).capitalize()) for group in Group]
    assert places == sorted(places)
    assert places[-1] < text.index('id="view-ledger"')
    assert [group for group, _ in errata(rows)] == list(Group)


def test_faults_of_one_row_are_listed_once_with_the_letters_of_its_parts() -> None:
    rows = [wrong(f"1V.8{letter}", "x", "y", repair={"row": True}) for letter in "ab"]
    [(_, [faults])] = errata(rows)
    [fault] = faults.faults
    assert (faults.place, fault.number, len(fault.relations)) == ("toy:1V", "1V.8a, b", 2)


def test_certificates_are_folded_whole_but_for_the_digest() -> None:
    certificate = {
        "id": "toy:1",
        "claim": ["=", "x", "x"],
        "definitions": [["x", ["+", "y", 1]]],
        "hypotheses": {},
        "verdict": "proved",
        "proof": {"rule": "identity", "cofactors": []},
    }
    proofs = folded(page([record("1", certificates=(certificate,))], TOY), "proofs-toy")
    again = {key: values[0] for key, values in proofs["fields"].items()}
    again["definitions"] = [json.loads(proofs["texts"][n]) for n in again["definitions"]]
    assert again == certificate
    assert proofs["rules"]["identity"] == RULES["identity"]


def test_what_must_not_vanish_is_shown_with_a_proof_that_needs_it() -> None:
    proof = {"rule": "identity", "cofactors": []}
    shown = {"id": "toy:1", "claim": ["=", "x", "x"], "definitions": [], "hypotheses": {}, "verdict": "proved"}
    shown |= {"nonzero": [["/", ["+", "c", 1], "k"]], "proof": proof}
    (claim,) = folded(page([record("1", certificates=(shown,))], TOY), "claims-toy")["claims"]
    assert "(c + 1)/k ≠ 0" in claim


def test_the_self_test_and_the_hypotheses_are_shown() -> None:
    records = [record("1", hypotheses=(hypothesis("x", "x is positive", "printed", Need(needed=False)),))]
    none = page(records, TOY)
    assert "Nothing is recorded" in none
    assert "x is positive" in none.split("Which hypotheses are needed")[1]
    counts = {"planted": 5, "rejected": 4, "accepted": 1, "equivalent": 0, "right": 0, "false_rejections": 0}
    counts["rejected_of_faults"] = [0.3, 0.8, 1.0]  # type: ignore[assignment]
    engines = {"points": 3, "evaluated": {"flint": 3}, "all_three": 3, "disagreements": []}
    found = {**counts, "classes": {"signs": {**counts, "kinds": {}}}, "engines": engines, "evidence": "other"}
    other = page(records, TOY, Extras(selftest=found))
    assert "80.00 %" not in other
    assert "found with other certificates, verdicts or kernels than those shown here" in other
    current = page(records, TOY, Extras(selftest={**found, "evidence": evidence(records)}))
    assert "80.00 % (30.00 to 100.00)" in current
    assert "done with the certificates shown here" in current


def test_every_application_of_a_theorem_is_listed() -> None:
    given = {"s": ["pow", ["*", 4, "x"], 2], "t": ["pow", ["+", "y", 1], 2]}
    proof = {"rule": "theorem", "of": "congruence", "with": given, "premises": [], "then": {"rule": "identity"}}
    assert "(s = pow(4*x, 2); t = pow(y + 1, 2))" in next(steps(proof))


def test_a_claim_shows_its_kernels_and_the_cells_that_name_it(tmp_path: Path) -> None:
    cell = {"cell_type": "code", "source": ["# toy2004:1 at work\n", "moments(1.0)"]}
    (tmp_path / "tour.ipynb").write_text(json.dumps({"cells": [{"source": "# A tour"}, cell]}), encoding="utf-8")
    found = sources.cells(tmp_path)
    assert found == {"toy2004:1": [Excerpt("tour", "tour.ipynb, cell 2", "# toy2004:1 at work\nmoments(1.0)")]}
    extras = Extras(
        {"toy:1": [Excerpt("moments", "generated/toy.py", "def moments(): ...")]}, {"toy:1": found["toy2004:1"]}
    )
    ledger = folded(page([record("1a"), record("2")], TOY, extras), "claims-toy")
    assert "moments" in ledger["claims"][0]
    assert "tour.ipynb, cell 2" in ledger["claims"][0]
    assert "moments" not in ledger["claims"][1]
    assert ledger["excerpts"] == ["def moments(): ...", "# toy2004:1 at work\nmoments(1.0)"]


def test_a_broken_notebook_is_named(tmp_path: Path) -> None:
    (tmp_path / "tour.ipynb").write_text("{", encoding="utf-8")
    with pytest.raises(SymcheckError, match=r"tour\.ipynb"):
        sources.cells(tmp_path)
    assert sources.cells(tmp_path / "none") == {}


def test_every_generated_kernel_is_found_by_its_claims() -> None:
    found = sources.kernels(papers.load(), kernels.folder())
    assert {each.name for each in found["mirer2009:2.12"]} == {"product_of_two_axial_moments"}
    shown = found["mirer2009:2.12"][0].text
    assert "    # I_1: " in shown  # what is declared, not what a docstring says
    assert '"""' not in shown
    public = {name for key in papers.load() for name in kernels.load(key).__all__}
    assert {each.name for excerpts in found.values() for each in excerpts} == public


@pytest.mark.parametrize(
    ("number", "corrected", "cell"),
    [
        ("1V.1b", ROW, "v0"),
        ("1E.1a", r"V_1 V_2 : \mathbf{H} = [1, u, -1]", "e0"),
        ("1F.1a", r"F_1, \mathbf{H} = [u, v, w]".replace("w", "0"), "f0"),
        ("T1.3c", r"V'_2, X = 1, Y = 2, Z = 3", "v2"),
    ],
)
def test_an_erratum_is_marked_where_its_row_says(number: str, corrected: str, cell: str) -> None:
    [mark] = marks(ENVELOPE, [wrong(number, "x", corrected, repair={"row": True})])
    assert (mark["cell"], mark["id"], mark["slip"]) == (cell, f"toy:{number}", False)


def test_rows_of_other_lists_and_right_rows_are_not_marked() -> None:
    rows = [wrong("9V.1a", "x", ROW, repair={"row": True}), record("1V.1a", printed=ROW), wrong("1Vb", "x", "All.")]
    assert marks(ENVELOPE, rows) == []


def test_a_slip_is_marked_as_a_slip() -> None:
    [mark] = marks(ENVELOPE, [wrong("1V.1a", ROW, ROW, kind="lost prime")])
    assert mark["slip"]


def test_arcs_join_what_is_used_with_what_uses_it_and_lists_are_one_place() -> None:
    rows = [
        record("1", name="first"),
        record("2a", name="chain", uses=("toy:1",)),
        replace(record("2b", name="chain"), verdict=Verdict.REFUTED),
        *(record(f"3V.{k}", name="rows", uses=("toy:2",)) for k in (1, 2)),
        record("4", name="alone"),
        record("5", name="first", section="2", uses=("toy:1",)),
    ]
    found = graph("toy", rows)
    assert [(node.id, node.label, node.verdict) for node in found.nodes] == [
        ("toy:1", "1", "proved"),
        ("toy:2a", "2", "refuted"),
        ("toy:3V.1", "3V", "proved"),
        ("toy:5", "5", "proved"),
    ]
    assert [(arc.used, arc.by) for arc in found.arcs] == [(0, 1), (0, 3), (1, 2)]


def test_a_plot_has_round_ticks_and_its_curves_stay_inside() -> None:
    plot = {"x": [0, 1, 2], "curves": [{"label": "one", "y": [0, 3, 1]}]}
    axes, [(label, path)] = curves(plot)
    assert (label, [text for _, text in axes.across]) == ("one", ["0.0", "0.5", "1.0", "1.5", "2.0"])
    points = [tuple(map(float, pair.split())) for pair in path[1:].split("L")]
    assert all(axes.left <= x <= axes.right and axes.top <= y <= axes.bottom for x, y in points)
    assert points[1][1] == min(y for _, y in points)


def test_a_map_is_a_picture_of_its_values() -> None:
    palette = [(0, 0, 0), *map(colour, (1, 63))]
    data = png([b"\0\1", b"\2\0"], palette)
    assert data.startswith(b"\x89PNG\r\n\x1a\n")
    assert struct.unpack(">II", data[16:24]) == (2, 2)
    start = data.index(b"IDAT") + 4
    assert zlib.decompressobj().decompress(data[start:]) == b"\0\0\1\0\2\0"
    plot = {"x": [0, 1], "y": [0, 1], "growth": [[0, 0.5], [0.25, 0]], "boundary": [[0, 0], [1, 0], [1, 1]]}
    drawn = coloured(plot)
    assert drawn.highest == 0.5
    assert drawn.image.startswith("data:image/png")
    assert drawn.boundary.endswith("Z")


def test_pictures_are_in_the_page_with_words_for_those_who_do_not_see_them() -> None:
    density = {"title": "Density", "source": ["toy:1"], "across": "a", "up": "p", "x": [0, 1]}
    density["curves"] = [{"label": "α = 1", "y": [0, 1]}]
    plot = {"title": "Map", "source": ["toy:1"], "across": "x", "up": "y", "x": [0, 1], "y": [0, 1]}
    plot |= {"growth": [[0, 1]], "boundary": [[0, 0], [1, 1]]}
    rows = [record("1"), wrong("1V.1b", "x", ROW, repair={"row": True})]
    text = page(rows, TOY, Extras(envelopes=[ENVELOPE], densities=[density], stability=plot))
    assert 'aria-label="Density: p against a; α = 1"' in text
    assert "Map: growth rate over x and y" in text
    [envelope] = folded(text, "envelopes")
    assert [mark["cell"] for mark in envelope["marks"]] == ["v0"]


@pytest.fixture
def report(symcheck: Callable[..., Result], toy: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[..., Result]:
    """`symcheck report` on the toy papers, whose sections and kernels there are none of."""
    monkeypatch.setattr(sources, "kernels", lambda *_: {})
    monkeypatch.chdir(toy)
    return lambda *args: symcheck("report", "--jobs", "0", *args)


def test_the_report_names_its_file_and_how_many_items_it_has(toy: Path, report: Callable[..., Result]) -> None:
    result = report("toy:1.1", "toy:1.3", "--output", str(toy / "deep" / "page.html"))
    assert result.exit_code == 0, result.output
    assert "2 items" in result.output
    text = (toy / "deep" / "page.html").read_text(encoding="utf-8")
    assert [row[0] for row in folded(text, "index")["rows"]] == ["toy:1.1", "toy:1.3"]


def test_a_file_that_cannot_be_written_is_reported_in_one_line(toy: Path, report: Callable[..., Result]) -> None:
    (toy / "file").write_text("", encoding="utf-8")
    result = report("toy:1.1", "--output", str(toy / "file" / "page.html"))
    assert result.exit_code == 2
    assert result.stderr.count("\n") == 1
    assert "--output" in result.stderr


def test_the_data_of_the_pictures_are_finite_and_name_claims_and_lists_that_exist() -> None:
    from symcheck.views import pictures

    envelopes, densities, stability = pictures.envelopes(), pictures.densities(), pictures.stability()
    json.dumps([envelopes, densities, stability], allow_nan=False)
    known = {obligation.id for paper in papers.load().values() for obligation in expand(paper)}
    sources_of_all = [id for plot in (*densities, stability) for id in plot["source"]]
    assert [id for id in sources_of_all if not {id, id.rstrip("abcdef")} & known] == []
    for each in envelopes:
        assert all(any(id.startswith(f"{each['paper']}:{name}.") for id in known) for name in each["lists"])
        assert len(each["vertices"]) - len(each["edges"]) + len(each["faces"]) == 2
        assert len(set(each["names"])) == len({tuple(signs) for signs in each["signs"]}) == len(each["vertices"])
