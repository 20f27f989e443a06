"""The notebooks show what is true now, hold no mathematics of their own, and are what their sources say."""

from __future__ import annotations

import ast
import math
import os
import re
import subprocess
import sys
from collections.abc import Callable
from copy import deepcopy
from importlib import import_module
from pathlib import Path
from typing import Any

import nbformat
import pytest
from click.testing import CliRunner, Result
from declarations import formulas
from limits import interruptible
from nbformat.v4 import new_code_cell, new_notebook, new_output
from optimized import about_docstrings
from warm_cache import warm_cache

from symcheck.cli import cli
from symcheck.core.verdicts import SymcheckError, Verdict
from symcheck.core.words import term
from symcheck.numeric import wheels
from symcheck.papers import load
from symcheck.papers.mirer2009 import derivation
from symcheck.views.latex import is_formula, standing_alone
from symcheck.views.notebook import (
    committed,
    compare,
    counterexample,
    letters,
    live,
    records,
    relations,
    rules,
    show,
    source,
)
from symcheck.views.notebook.derivations import LONGEST
from symcheck.views.notebook.derivations import source as source_of
from symcheck.views.notebook.execute import in_kernel, in_process
from symcheck.views.notebook.output import Code, Heading, Math, Output, Prose, Table
from symcheck.views.steps import compared

NAMES = committed.names()
PAPERS = {name.partition("_")[2]: name for name in NAMES if name.partition("_")[2] in load()}
MOST_BYTES = 1_500_000
TITLE = "# A title\n\nWords.\n\n"


@pytest.fixture(autouse=True)
def cache_of_its_own(monkeypatch: pytest.MonkeyPatch, tmp_path_factory: pytest.TempPathFactory) -> None:
    """What the notebooks show is decided in this run, or by the gates before it."""
    monkeypatch.setenv("SYMCHECK_CACHE", warm_cache(tmp_path_factory.getbasetemp() / "notebooks"))


@about_docstrings  # a figure says what it shows in its docstring
@pytest.mark.whole
@pytest.mark.parametrize("name", NAMES)
def test_executed_in_this_process_a_notebook_shows_what_is_committed(name: str) -> None:
    assert committed.differences(name, committed.executed(name)) == []


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_executed_in_a_jupyter_kernel_a_notebook_shows_what_is_committed(name: str) -> None:
    assert committed.differences(name, committed.executed(name, kernel=True)) == []


@pytest.mark.parametrize("name", NAMES)
def test_a_committed_notebook_is_valid_normal_and_small(name: str) -> None:
    found = committed.committed(name)
    nbformat.validate(found)
    assert (found.nbformat, found.metadata) == (4, source.METADATA)
    assert [cell.metadata for cell in found.cells if cell.metadata] == []
    file = committed.folder() / f"{name}.ipynb"
    assert file.stat().st_size < MOST_BYTES
    assert file.read_text(encoding="utf-8") == nbformat.writes(found) + "\n"


@pytest.mark.parametrize("name", NAMES)
def test_no_cell_of_a_committed_notebook_holds_mathematics(name: str) -> None:
    faults = {"code": rules.faults_of_code, "markdown": rules.faults_of_prose}
    assert [told for cell in committed.committed(name).cells for told in faults[cell.cell_type](cell.source)] == []


def test_every_notebook_has_a_source() -> None:
    files = [file for file in committed.folder().rglob("*.ipynb") if ".ipynb_checkpoints" not in file.parts]
    assert sorted(file.relative_to(committed.folder()).with_suffix("").as_posix() for file in files) == NAMES


@pytest.mark.parametrize(("key", "name"), PAPERS.items())
def test_the_notebook_of_a_paper_shows_derivation_evidence_figures_and_what_is_not_proved(key: str, name: str) -> None:
    text = "\n".join(cell.source for cell in committed.built(name).cells)
    for needed in ("show.step(", "show.claim(", "show.erratum(", "show.proof(", "show.numbers(", "symcheck.numeric"):
        assert needed in text
    assert re.search(r"show\.(figure|drawing)\(", text)
    assert committed.built(name).cells[-1].source == f'show.not_proved("{key}")'


def test_every_paper_has_a_notebook() -> None:
    assert PAPERS.keys() == set(load())


@pytest.mark.parametrize("key", load())
def test_every_serious_erratum_is_shown(key: str) -> None:
    told = "\n".join(cell.source for cell in committed.built("6_errata").cells)
    serious = [record.id for record in records.serious(key)]
    assert serious
    assert [id for id in serious if f'show.erratum("{id}")' not in told] == []


# --- what a cell may hold

FORBIDDEN = {
    "def f(x): return x": "functiondef",
    "class A: pass": "classdef",
    "f = lambda x: x\nshow.claim(f)": "lambda",
    "import sympy\nshow.ledger()": "imports sympy",
    "from sympy import symbols\nsymbols('x')": "imports from sympy",
    "from numpy import linalg\nshow.numbers()": "imports linalg of NumPy",
    "from scipy.optimize import fsolve\nfsolve(f, 0)": "imports from scipy.optimize",
    "from symcheck.papers.mirer2009 import derivation\nderivation.sp.Symbol('x')": "reaches for sp",
    "derivation._triple('I')": "reaches for _triple",
    "x = a * b\nshow.numbers(x)": "binop",
    "show.numbers(a == b)": "compare",
    "show.numbers([x for x in y])": "listcomp",
    "for x in y: show.claim(x)": "for",
    "show.numbers('x = 1')": "holds the formula",
    r"show.numbers(r'\frac{a}{b}')": "holds the formula",
    "eval('1')": "calls eval",
    "exec('1')": "calls exec",
    "__import__('sympy')": "reaches for __import__",
    "x = show.claim('mirer2009:2.12')": "shows nothing",
    "": "shows nothing",
    "(": "is not valid Python",
    "f'{a}'": "joinedstr",
    "show.numbers(y := 1)": "namedexpr",
}


@pytest.mark.parametrize(("cell", "fault"), FORBIDDEN.items())
def test_a_cell_that_defines_or_computes_is_refused(cell: str, fault: str, tmp_path: Path) -> None:
    assert any(fault in told for told in rules.faults_of_code(cell))
    if cell:
        (tmp_path / "bad.md").write_text(f"{TITLE}```python\n{cell}\n```\n", encoding="utf-8")
        with pytest.raises(SymcheckError, match=re.escape("bad.md: ")):
            source.notebook(tmp_path / "bad.md")


ALLOWED = (
    'from symcheck.views.notebook import show\n\nshow.claim("mirer2009:2.12")',
    "from numpy import radians\n\nfour = wheels.four_wheels(*radians([67, 32]))\nshow.numbers(counts=four.counts[-1])",
)


@pytest.mark.parametrize("cell", ALLOWED)
def test_a_cell_that_calls_and_names_is_accepted(cell: str) -> None:
    assert list(rules.faults_of_code(cell)) == []


@pytest.mark.parametrize("prose", ["$$x$$", "where $x = 1$", r"so $a \le b$", r"\[x\]", r"$x \to 0$", "$a<b$"])
def test_prose_that_states_a_relation_is_refused(prose: str) -> None:
    assert list(rules.faults_of_prose(prose))


def test_prose_may_name_letters() -> None:
    assert list(rules.faults_of_prose(r"The angles $a$ and $\alpha_1$, at 0 < 1.")) == []


# --- what readers try


def test_a_changed_relation_is_decided_anew_and_the_recorded_one_stays() -> None:
    changes: tuple[tuple[str, dict[str, Any]], ...] = (
        ("proved", {}),
        ("proved", {"printed": {"I_3 I_1 a_{22}^2": "I_1 I_3 a_{22}^2"}}),
        ("refuted", {"printed": {"a_{23}^2": "a_{32}^2"}}),
        ("refuted", {"without": ["orthogonal"]}),
    )
    for verdict, change in changes:
        text = repr(show.changed("mirer2009:2.12", **change))
        assert text.startswith(f"changed (2.12) — **{verdict}**"), change
        assert ("fails there" in text) == (verdict == "refuted")
        assert " holds" in text.split("checker: ")[1]
    assert "— **proved** by `identity`" in repr(show.claim("mirer2009:2.12"))


@pytest.mark.parametrize(
    ("id", "change", "told"),
    [
        ("mirer2009:2.12", {"printed": {"a_{99}": "x"}}, "'a_{99}' is not printed in mirer2009:2.12; there stands J_1"),
        ("mirer2009:2.12", {"without": ["gravity"]}, "is not given 'gravity'; it is given 'orthogonal'"),
        ("mirer2009:1.0.1", {}, "claims nothing"),
        ("mirer2009:2.12", {"printed": {"J_1 J_3 =": "J_1 J_3 + ="}}, "+= assigns a value"),
    ],
)
def test_a_change_that_cannot_be_made_is_told_in_one_line(id: str, change: dict[str, Any], told: str) -> None:
    with pytest.raises(SymcheckError, match=re.escape(told)) as error:
        show.changed(id, **change)
    assert "\n" not in str(error.value)


def test_the_answer_of_an_exercise_is_folded_away() -> None:
    shown = show.exercise("mirer2009:2.13.1c")
    markdown = shown._repr_mimebundle_()["text/markdown"]
    question, answer = markdown.split("<details><summary>The answer</summary>")
    assert "wrong letter" in answer
    assert "wrong letter" not in question
    assert not {"proved", "refuted"} & set(re.findall(r"\w+", question))
    assert answer.rstrip().endswith("</details>")
    with pytest.raises(SymcheckError, match="is not an erratum"):
        show.exercise("mirer2009:2.12")


def test_without_a_kernel_sliders_show_what_they_say_first() -> None:
    angles = {"a": (20, 60, 80), "b": (10, 45, 80)}
    shown = show.sliders("axes", wheels.four_wheels, degrees=angles)
    assert shown.parts == show.numbers(axes=wheels.four_wheels(math.radians(60), math.radians(45))).parts
    assert live.VIEW not in shown._repr_mimebundle_()
    drawn = show.sliders("reach", wheels.four_wheels, wheels.envelope, wheels.plot_envelope, degrees=angles)
    assert list(drawn._repr_mimebundle_()) == ["image/png", "text/plain"]
    with pytest.raises(SymcheckError, match="a is to be 90 first, which is not between 20 and 80"):
        show.sliders("axes", wheels.four_wheels, degrees={**angles, "a": (20, 90, 80)})


def test_a_slider_that_is_moved_shows_what_comes_of_it(capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("ipywidgets")
    widget = show.sliders("axes", wheels.six_wheels, degrees={"a": (20, 60, 80)}).widget()
    capsys.readouterr()
    widget.children[0].value = 30
    assert f"{-math.cos(math.radians(30)):.6g}" in capsys.readouterr().out


def test_a_formula_that_is_written_in_below_a_cell_is_decided(capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("ipywidgets")
    widget = show.changed("mirer2009:2.12").widget()
    formula, orthogonal, button, _ = widget.children
    for text, told in (
        (formula.value, "changed (2.12) — **proved**"),
        (formula.value.replace("a_{23}^2", "a_{32}^2"), "changed (2.12) — **refuted**"),
        (formula.value.replace("=", "+ =", 1), "+= assigns a value"),
    ):
        formula.value = text
        capsys.readouterr()
        button.click()
        assert told in capsys.readouterr().out
    formula.value, orthogonal.value = text.replace("+ =", "="), False
    button.click()
    assert "without: A is orthogonal" in capsys.readouterr().out


def test_what_no_program_can_set_as_a_formula_is_shown_as_it_is() -> None:
    parts = (Math("printed", "(р = IT}, р„ = /Л„)"), Math("read", "p = i"), Math("right", "p = -i"))
    markdown = Output(parts)._repr_mimebundle_()["text/markdown"]
    assert markdown.startswith("*printed:*\n\n```text\n(р = IT}, р„ = /Л„)\n```\n\n$\\begin{array}")
    assert markdown.count("displaystyle") == 2


ROW = re.compile(
    r"\\textsf\{[^}]*\} & \\displaystyle (.*?)(?: \\\\\[6pt\] |\\end\{array\}\$)", re.DOTALL
)  # of a display


@pytest.mark.parametrize("name", NAMES)
def test_every_formula_of_a_notebook_can_be_set(name: str) -> None:
    texts = [
        output.data.get("text/markdown", "")
        for cell in committed.committed(name).cells
        for output in cell.get("outputs", ())
    ]
    assert [row for text in texts for row in ROW.findall(text) if not is_formula(row)] == []
    cells = [cell for text in texts for line in text.splitlines() for cell in re.split(r" ?\| ?|<br>", line)]
    formulas = [cell[1:-1] for cell in cells if re.fullmatch(r"\$[^$]+\$", cell) and "array" not in cell]
    assert [each for each in formulas if standing_alone(each) != each] == []


def test_a_step_shows_how_it_is_derived() -> None:
    shown = show.step(derivation.control_torque)
    [code] = [part for part in shown.parts if isinstance(part, Code)]
    assert code.text.startswith("def control_torque()")
    assert "torque -= gain * rate.dot(axis) * axis" in code.text
    assert '"""' not in code.text
    assert f"```python\n{code.text}\n```" in shown._repr_mimebundle_()["text/markdown"]


@pytest.mark.parametrize("key", load())
def test_the_source_of_every_derivation_is_python_without_its_docstring(key: str) -> None:
    module = import_module(f"symcheck.papers.{key}.derivation")
    functions = [each for name, each in vars(module).items() if callable(each) and not name.startswith("_")]
    own = [each for each in functions if getattr(each, "__module__", "") == module.__name__]
    assert own
    for each in own:
        text = source_of(each)
        assert text.startswith(f"def {each.__name__}(")
        assert '"""' not in text
        assert len(text.splitlines()) <= LONGEST + 1
        ast.parse(text if "more lines" not in text else "pass")


def test_every_notebook_of_a_paper_has_something_to_change() -> None:
    for name in PAPERS.values():
        cells = [cell.source for cell in committed.committed(name).cells]
        assert any(cell.startswith("show.changed(") for cell in cells), name
    shown = [name for name in NAMES if any("show.exercise(" in cell.source for cell in committed.committed(name).cells)]
    assert len(shown) >= 4


# --- sources and ids


def test_a_cell_that_is_added_changes_the_ids_of_no_other_section(tmp_path: Path) -> None:
    file, code = tmp_path / "x.md", '```python\nshow.claim("mirer2009:2.12")\n```\n'

    def ids(text: str) -> list[str]:
        file.write_text(text, encoding="utf-8")
        return [cell.id for cell in source.notebook(file).cells]

    before = ids(f"# One\n\nWords.\n\n{code}\n## Two: $x$\n\n{code}")
    after = ids(f"# One\n\nWords.\n\n{code}\n{code}\n## Two: $x$\n\n{code}")
    assert before == ["one-1", "one-2", "two-x-1", "two-x-2"]
    assert after == ["one-1", "one-2", "one-3", "two-x-1", "two-x-2"]


# --- when a notebook is stale


def shown(text: str) -> Any:
    cell = new_code_cell("show.numbers()", id="one-1", execution_count=1)
    cell.outputs = [new_output("execute_result", {"text/plain": text}, execution_count=1)]
    return new_notebook(cells=[cell], metadata=source.METADATA)


def changed(change: Callable[[Any], None]) -> list[str]:
    before = shown("x | 0.123456")
    after = deepcopy(before)
    change(after)
    return list(compare.differences(after, before))


def test_an_unchanged_notebook_is_not_stale() -> None:
    assert changed(lambda notebook: None) == []


CHANGES: dict[str, Callable[[Any], None]] = {
    "has another source": lambda notebook: notebook.cells[0].update(source="show.claim()"),
    "is new": lambda notebook: notebook.cells.append(new_code_cell("show.claim()", id="one-2")),
    "is not in its source any more": lambda notebook: notebook.cells.clear(),
    "its metadata differ": lambda notebook: notebook.metadata.update(author="somebody"),
    "shows something of another kind": lambda notebook: notebook.cells[0].outputs[0].data.update({"text/html": "x"}),
    "shows other text/plain": lambda notebook: notebook.cells[0].outputs[0].data.update({"text/plain": "y | 0.123456"}),
}


@pytest.mark.parametrize(("told", "change"), CHANGES.items())
def test_every_change_of_a_notebook_is_reported(told: str, change: Callable[[Any], None]) -> None:
    assert [told in line for line in changed(change)] == [True]


@pytest.mark.parametrize(
    ("new", "old", "same"),
    [
        ("0.123456", "0.123457", True),
        ("1.5e-07", "1.50001e-07", True),
        ("0.123456", "0.124456", False),
        ("12", "13", False),
        ("3/7", "3/8", False),
        ("a 1.5", "b 1.5", False),
        ("1.5", "1.5 1.5", False),
    ],
)
def test_values_are_compared_but_not_the_last_digit_of_decimals(new: str, old: str, same: bool) -> None:
    assert compare.same(new, old) is same


# --- execution


def a_notebook(*cells: str) -> Any:
    return new_notebook(cells=[new_code_cell(cell, id=f"c-{n}") for n, cell in enumerate(cells)])


NUMBERS = "from symcheck.views.notebook import show\n\nshow.numbers(x=1)"
SLIDER = """from symcheck.numeric import wheels

show.sliders("axes", wheels.six_wheels, degrees={"a": (20, 60, 80)})"""


def test_process_and_kernel_fill_in_the_same_outputs(tmp_path: Path) -> None:
    cells = (NUMBERS, 'show.claim("mirer2009:2.1.6")', SLIDER)
    fast, real = in_process(a_notebook(*cells)), in_kernel(a_notebook(*cells), tmp_path)
    assert [cell.outputs for cell in fast.cells] == [cell.outputs for cell in real.cells]
    assert list(compare.differences(fast, fast)) == []


INTERRUPTED = """
import os, signal, sys
from pathlib import Path
from nbformat.v4 import new_code_cell, new_notebook
from symcheck.views.notebook import committed
interrupt = f"import os, signal, time; os.kill({os.getpid()}, signal.SIGINT); time.sleep(60)"
committed.built = lambda name: new_notebook(cells=[new_code_cell(interrupt, id="c-0")])
committed.names = lambda only: ["one"]
from symcheck.cli import main
sys.argv = ["symcheck", "notebooks", "--kernel"]
main()
"""


def test_an_interrupted_kernel_is_one_line(root: Path) -> None:
    found = subprocess.run(
        [sys.executable, "-c", INTERRUPTED],
        env={**os.environ, "PYTHONPATH": str(root)},
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
        preexec_fn=interruptible,
    )
    assert (found.stderr, found.returncode) == ("symcheck: interrupted\n", 130)


def test_a_folder_that_cannot_be_written_is_one_line(monkeypatch: pytest.MonkeyPatch) -> None:
    def refused(name: str, executed: Any) -> None:
        raise PermissionError(13, "Permission denied")  # permissions mean nothing to root

    monkeypatch.setattr(committed, "names", lambda only: ["one"])
    monkeypatch.setattr(committed, "executed", lambda *_: a_notebook())
    monkeypatch.setattr(committed, "write", refused)
    result = CliRunner().invoke(cli, ["notebooks", "--write"], prog_name="symcheck")
    said = "cannot be written (Permission denied); make the folder writable, or leave --write out\n"
    assert (result.exit_code, result.stderr) == (2, f"symcheck: {committed.folder()} {said}")


@pytest.mark.parametrize(
    ("cell", "told"),
    [
        (
            "from symcheck.views.notebook import show\nshow.claim('mirer2009:9.99')",
            "c-0 fails with SymcheckError: mirer2009",
        ),
        ("1", "c-0 ends in a int"),
        ("x = 1", "c-0 shows nothing"),
    ],
)
def test_a_cell_that_fails_is_named(cell: str, told: str) -> None:
    with pytest.raises(SymcheckError, match=re.escape(told)):
        in_process(a_notebook(cell))


def test_progress_counts_the_cells_of_code() -> None:
    seen: list[tuple[int, int]] = []
    in_process(a_notebook(NUMBERS, NUMBERS), lambda done, total: seen.append((done, total)))
    assert seen == [(1, 2), (2, 2)]


# --- counterexamples


@pytest.mark.parametrize("key", load())
def test_evaluated_anew_a_counterexample_has_the_values_of_its_certificate(key: str) -> None:
    count = 0
    for record in records.serious(key):
        for certificate in record.certificates:
            if certificate["verdict"] == Verdict.REFUTED:
                evaluation = counterexample.Evaluation(certificate, records.notation(record.id))
                assert not evaluation.holds()
                sides = [*map(term, compared(certificate["point"]))]
                if len(sides) == 2 and all(re.fullmatch(r"-?\d+(/\d+)?", side) for side in sides):
                    [told] = evaluation.compared()
                    assert [str(told.left), str(told.right)] == sides
                    count += 1
    assert count


def test_a_point_at_which_the_relation_holds_refutes_nothing() -> None:
    [record] = records.records("poloskov2004:2.3.2")
    [certificate] = record.certificates
    harmless = deepcopy(certificate)
    harmless["point"]["values"]["t"] = 1
    assert counterexample.Evaluation(harmless, records.notation(record.id)).holds()
    assert not counterexample.Evaluation(certificate, records.notation(record.id)).holds()


def test_a_certificate_that_does_not_hold_is_said_not_to() -> None:
    [record] = records.records("mirer2009:2.12")
    [certificate] = record.certificates
    false = {**deepcopy(certificate), "claim": ["=", certificate["claim"][1], 0]}
    assert relations.checked([certificate]).endswith("holds")
    assert relations.checked([certificate, certificate]) == "all 2 certificates hold"
    assert relations.checked([certificate, false]).startswith("a certificate does not hold: ")


def test_a_right_relation_is_not_an_erratum() -> None:
    with pytest.raises(SymcheckError, match=re.escape("mirer2009:2.12 is not an erratum")):
        show.erratum("mirer2009:2.12")


# --- display


@pytest.mark.parametrize("key", load())
def test_a_long_formula_is_broken_and_loses_nothing(key: str) -> None:
    broken = 0
    for _, item in records.declared(key):
        for formula in formulas(item):
            lines = letters.split(formula)
            assert "".join("".join(lines).split()) == "".join(formula.split())
            assert len(lines) == 1 or [line for line in lines if line.count("{") != line.count("}")] == []
            broken += len(lines) > 1
    assert broken


def test_a_command_takes_no_more_room_than_what_stands_behind_it() -> None:
    assert (
        letters.width(r"\varepsilon \sin {\psi} \cos {\psi}") == letters.width(r"\varepsilon\sin{\psi}\cos{\psi}") == 9
    )
    assert letters.width(r"\Omega d_{13}") == 4
    terms = " + ".join([r"a d_{11} \varepsilon \sin {\psi} \cos {\psi}"] * 9)
    assert max(map(letters.width, letters.split(terms))) <= letters.WIDTH
    assert len(letters.split(terms)) == 2


def test_letters_are_those_of_the_paper() -> None:
    mirer, wheels = load()["mirer2009"].notation, load()["ignatov2005"].notation
    assert letters.letter("domega_3", mirer) == r"\dot{\omega}_{3}"
    assert letters.letter("kbar_1", mirer) == r"\bar{k}_{1}"
    assert letters.letter("e_12", wheels) == "e_{12}"  # a component is no vector
    assert letters.letter("nowhere", mirer) == "nowhere"


def test_words_are_shown_as_they_are_written() -> None:
    bundle = Output(
        (Heading("**a**"), Prose("given", "x_1 * y < 2$"), Table(("p|q",), (("$|x|$",), ("a|b\nc",))), Math("m", "x"))
    )
    found = bundle._repr_mimebundle_()
    assert r"*given:* x\_1 \* y \< 2\$" in found["text/markdown"]
    assert r"| $\vert x\vert $ |" in found["text/markdown"]
    assert r"| a\|b<br>c |" in found["text/markdown"]
    assert "given: x_1 * y < 2$" in found["text/plain"]
    assert found["text/latex"] == r"\[x\]"


# --- the command line


@pytest.fixture
def notebooks(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[..., Result]:
    """Run `symcheck notebooks` on a folder with one small source."""
    (tmp_path / "sources").mkdir()
    (tmp_path / "sources" / "1_small.md").write_text(f"{TITLE}```python\n{NUMBERS}\n```\n", encoding="utf-8")
    monkeypatch.setattr(committed, "folder", lambda: tmp_path)
    return lambda *arguments: CliRunner().invoke(cli, ["notebooks", *arguments], prog_name="symcheck")


def test_what_is_written_is_what_is_shown(notebooks: Callable[..., Result], tmp_path: Path) -> None:
    missing = notebooks()
    assert (missing.exit_code, "1_small.ipynb is missing" in missing.stderr) == (2, True)
    assert notebooks("--write").exit_code == 0
    assert (again := notebooks()).exit_code == 0, again.output
    assert again.stdout == "1_small: 1 cell, 0 differ\n"


def test_a_stale_notebook_is_named(notebooks: Callable[..., Result], tmp_path: Path) -> None:
    notebooks("--write")
    file = tmp_path / "1_small.ipynb"
    file.write_text(file.read_text(encoding="utf-8").replace("x | 1", "x | 2"), encoding="utf-8")
    stale = notebooks("--only", "1")
    assert stale.exit_code == 1
    assert "notebooks/1_small.ipynb: cell a-title-2 shows other text/" in stale.stderr
    assert "symcheck notebooks --write" in stale.stderr


def test_a_notebook_that_is_not_there_or_damaged_is_bad_input(notebooks: Callable[..., Result], tmp_path: Path) -> None:
    unknown = notebooks("--only", "nothing")
    assert (unknown.exit_code, "did you mean 1_small?" in unknown.stderr) == (2, True)
    (tmp_path / "1_small.ipynb").write_text("{", encoding="utf-8")
    damaged = notebooks()
    assert (damaged.exit_code, "1_small.ipynb is damaged" in damaged.stderr) == (2, True)
