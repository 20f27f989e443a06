"""Lines of a derivation, chains that are read in parts, kernels of an audit, and matrices whose sizes nobody prints."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

import pytest
from test_new import _apart, begun, run, verdicts  # noqa: F401

from symcheck import kernels, look
from symcheck.checker.__main__ import main as check_certificates
from symcheck.core.verdicts import SymcheckError
from symcheck.document.survey import apart, surveyed

# a trolley with a pendulum below it: each line follows from the one before it
TROLLEY = r"""# A trolley

The forces along the rail give

$$\begin{aligned}
m \frac{d}{dt} (\dot{x} + l \dot{\theta} \cos \theta) &= S \sin \theta \\
m (\ddot{x} + l \ddot{\theta} \cos \theta - l \dot{\theta}^2 \sin \theta) &= S \sin \theta \\
m \ddot{x} + m l \ddot{\theta} \cos \theta - m l \dot{\theta}^2 \sin \theta &= S \sin \theta \\
m \ddot{x} + m l \ddot{\theta} \cos \theta &= S \sin \theta + m l \dot{\theta}^2 \sin \theta
\end{aligned}$$
"""
SLIPS = {  # by line: what is printed there instead
    7: (r"\dot{\theta}^2 \sin", r"\dot{\theta}^2 \cos"),
    8: (r"+ m l \ddot", r"- m l \ddot"),
    9: (r"= S \sin \theta + m", r"= S \sin \theta - m"),
}
# equations beside each other of which none follows from another
SYSTEMS = [
    ("a + b = 2", "a - b = 0", "2 a + b = 3"),
    (r"\dot{u} = v", r"\dot{v} = -u", r"\dot{u} + \dot{v} = v - u"),
    ("A + B = 0", "A - B = 0", "A + 2 B = 0"),
    (r"m \ddot{x} = T - k x", r"m \ddot{x} = T + k x", r"\ddot{x} = k x"),
]


def document(*lines: str) -> str:
    return "We have\n\n$$\\begin{aligned}\n" + " \\\\\n".join(lines) + "\n\\end{aligned}$$\n"


def looked(folder: Path, text: str) -> list[str]:
    (folder / "notes.md").write_text(text, encoding="utf-8")
    return [finding.place for finding in look(folder / "notes.md").findings]


def test_each_line_of_a_derivation_follows_from_the_one_before_it(tmp_path: Path) -> None:
    audit = begun(tmp_path, TROLLEY, "notes.md")
    code = (audit / "audit.py").read_text(encoding="utf-8")
    assert [f'line {n}", follows=[line_{n - 1}]' in code for n in (7, 8, 9)] == [True] * 3
    assert [*verdicts(audit).values()].count("proved") == 3
    assert look(tmp_path / "notes.md").follows == ("line 7", "line 8", "line 9")


@pytest.mark.slow
@pytest.mark.parametrize("line", SLIPS)
def test_a_slip_in_a_derivation_is_found(line: int, tmp_path: Path) -> None:
    before, after = SLIPS[line]
    lines = TROLLEY.split("\n")
    audit = begun(tmp_path, TROLLEY, "notes.md")
    lines[line - 1] = lines[line - 1].replace(before, after)
    assert f"line {line}" in looked(tmp_path, "\n".join(lines))
    found = json.loads(run("check", audit, "--jobs", 0, "--json").stdout)["items"]
    assert line in [item["line"] for item in found if item["verdict"] == "refuted"]


@pytest.mark.slow
@pytest.mark.parametrize("lines", SYSTEMS)
def test_equations_of_a_system_are_not_taken_for_a_derivation(lines: tuple[str, ...], tmp_path: Path) -> None:
    assert looked(tmp_path, document(*lines)) == []
    assert "refuted" not in verdicts(begun(tmp_path / "own", document(*lines), "notes.md")).values()


def test_functions_in_letters_get_a_rule_where_they_are_printed_as_functions_too(tmp_path: Path) -> None:
    text = "We have\n\n$$a cos x + b \\cos x = {}$$\n\nand $s i n = sin$.\n"
    audit = begun(tmp_path, text.format(r"(a + b) \cos x"), "notes.md")
    assert r'rules=[r"cos -> \cos"],' in (audit / "audit.py").read_text(encoding="utf-8")
    (item,) = [
        each for each in json.loads(run("check", audit, "--jobs", 0, "--json").stdout)["items"] if each["verdict"]
    ]
    assert (item["verdict"], item["reading"]) == ("proved", "rewritten")


@pytest.mark.parametrize(
    ("factor", "doubtful"),
    [
        (r"L = r \dot{r} (\mathbf{a} \times \mathbf{b}) \cdot \mathbf{c}", r"L = r \dot{r} (a + b)"),
        (r"E = \mu \left[\frac{\mu + c}{h}\right]", r"E = \mu \left[\frac{c}{h}\right]"),
    ],
)
def test_brackets_with_what_no_function_takes_hold_a_factor(factor: str, doubtful: str) -> None:
    assert surveyed(factor).read
    assert "or times it" in surveyed(doubtful).reason


@pytest.mark.parametrize(
    ("chain", "parts"),
    [
        ("a = b = c", ["a = b", "b = c"]),
        (r"\left[a = b\right] = c = d", [r"\left[a = b\right] = c", "c = d"]),
        ("a = b", []),
        ("a = b, c = d = e", []),
        (r"a = b = \left(c", []),
        ("a = = b = c", []),
    ],
)
def test_a_chain_is_taken_apart_at_its_own_signs(chain: str, parts: list[str]) -> None:
    assert apart(chain) == parts


def test_a_chain_of_which_a_part_is_not_read_is_decided_in_the_others(tmp_path: Path) -> None:
    chain = r"E = \mu [\frac{a}{b}] = (a + b)^2 = a^2 + 2 a b + b^2"
    for text, verdict in ((chain, "proved"), (chain.replace("2 a b", "a b"), "refuted")):
        audit = begun(tmp_path / verdict, f"Then\n\n$${text}$$\n", "notes.md")
        assert verdicts(audit) == {"0.1a": "undecided", "0.1b": "undecided", "0.1c": verdict}


def test_what_cannot_be_read_beside_a_claim_is_left_out_and_refutes_nothing(tmp_path: Path) -> None:
    text = "Let\n\n$$c = a + b$$\n\n$$c^2 = {}$$\n"
    audit = begun(tmp_path, text.format("a^2 + 2 a b + b^2"), "notes.md")
    code = (audit / "audit.py").read_text(encoding="utf-8")
    odd = code.replace('source.definition("line 3")', r'source.definition("line 3", stated=r"c = \foo{a} \bar")')
    (audit / "audit.py").write_text(odd, encoding="utf-8")
    (item,) = [
        each for each in json.loads(run("check", audit, "--jobs", 0, "--json").stdout)["items"] if each["verdict"]
    ]
    assert item["verdict"] == "undecided"
    assert odd != code


LENS = r"""\documentclass{article}
\begin{document}
\begin{equation} f = \frac{1}{(n - 1) (c - h)}, \label{eq:focal} \end{equation}
again
\begin{equation} f = \frac{1}{n c - n h - c + h}. \label{eq:again} \end{equation}
\begin{equation} f + 1 = \frac{1 + (n - 1) (c - h)}{(n - 1) (c - h)} \label{eq:more} \end{equation}
\end{document}
"""


@pytest.fixture
def own(tmp_path: Path) -> Iterator[Path]:
    """A fresh audit of a lens, in a folder with a space."""
    yield begun(tmp_path / "my desk", LENS)
    import sys

    for name in [name for name in sys.modules if name.startswith("symcheck.generated.") and name.endswith("audit")]:
        del sys.modules[name]


def declared(audit: Path, line: str) -> None:
    file = audit / "audit.py"
    file.write_text(file.read_text(encoding="utf-8") + line + "\n", encoding="utf-8")


def test_a_kernel_is_made_of_an_audited_relation(own: Path, tmp_path: Path) -> None:
    declared(own, 'length = source.kernel(again, "Focal length.", domain={"n": ("1", "")})')
    assert run("generate", own, "--jobs", 0).exit_code == 0
    length = kernels.find(str(own), "length")
    assert length(n=1.5, c=4.0, h=-1.0) == pytest.approx(0.4, rel=1e-15)
    assert [each.domain for each in length.specification.arguments if each.name == "n"] == ["1 < n"]
    assert run("generate", own, "--check", "--jobs", 0).exit_code == 0
    assert check_certificates([str(own / "generated")]) == 0
    assert "proved" in run("show", f"{own}:length", "--jobs", 0).stdout
    other = begun(tmp_path / "elsewhere", LENS)
    declared(other, 'length = source.kernel(again, "Focal length.")')
    assert run("generate", other, "--jobs", 0).exit_code == 0
    with pytest.raises(SymcheckError, match="rename one of the folders"):
        kernels.find(str(other), "length")


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ('k = source.kernel(focal, "F.")', "which is None; only what is proved is generated"),
        ('k = source.kernel(more, "F.")', "a kernel is made of `letter = formula` of numbers"),
        ('k = source.kernel(again, "F.", link="b")', "has no link 'b'"),
        ('k = source.kernel(again, "F.", domain={"z": ("0", "")})', "z is no argument of what is printed there"),
    ],
)
def test_what_is_no_kernel_is_told(line: str, said: str, own: Path) -> None:
    declared(own, line)
    done = run("generate", own, "--jobs", 0)
    assert done.exit_code == 2
    assert said in done.stderr


def test_matrices_of_unprinted_sizes_are_proved_for_all_sizes(tmp_path: Path) -> None:
    text = (
        "We have\n\n$$(\\mathbf{A} \\mathbf{B})^T = \\mathbf{B}^T \\mathbf{A}^T$$\n\nand\n\n"
        "$$(\\mathbf{A} \\mathbf{B})^{-1} = \\mathbf{B}^{-1} \\mathbf{A}^{-1}$$\n"
    )
    audit = begun(tmp_path, text, "notes.md")
    assert [*verdicts(audit).values()] == ["proved", "proved"]
    assert run("generate", audit, "--jobs", 0).exit_code == 0
    assert "A is n x m, B is m x p" in run("show", f"{audit}:0.1", "--jobs", 0).stdout
    generated = audit / "generated"
    assert check_certificates([str(generated)]) == 0
    file = generated / "certificates" / "audit.json"
    whole = file.read_text(encoding="utf-8")
    assert '"A":["n","m"],"B":["m","p"]' in whole
    for right, wrong in (
        ('"A":["n","m"],"B":["m","p"]', '"A":[1,1],"B":[1,1]'),
        ('"A":["n","n"]', '"A":[1,1]'),
    ):
        file.write_text(whole.replace(right, wrong), encoding="utf-8")
        assert check_certificates([str(generated)]) == 1


# words between two displays, and whether the second is to follow from the first
WORDS = {
    "Hence": True,
    "Collecting like terms, we get": True,
    "Dividing by $m$ gives": True,
    "In the second case": False,
    "The escape velocity is": False,
    "Neglecting friction, this becomes": False,
}


@pytest.mark.slow
@pytest.mark.parametrize("words", WORDS)
def test_what_words_say_to_follow_is_expected_to(words: str, tmp_path: Path) -> None:
    text = f"We find\n\n$$m a = m (g - c)$$\n\n{words}\n\n$$m a = m (g + c)$$\n"
    assert looked(tmp_path, text) == (["line 7"] if WORDS[words] else [])


REFERRING = r"""\documentclass{article}
\begin{document}
\begin{equation} a c = b + 2 g h \label{eq:first} \end{equation}
and
\begin{equation} b = g (h - 1). \label{eq:second} \end{equation}
WORDS
\begin{equation} a c = RESULT. \end{equation}
\end{document}
"""


@pytest.mark.slow
@pytest.mark.parametrize(
    ("words", "result", "found"),
    [
        (r"Substituting \eqref{eq:second} into~(\ref{eq:first}) gives", "g (3 h - 1)", []),
        (r"Substituting \eqref{eq:second} into~(\ref{eq:first}) gives", "g (3 h + 1)", ["line 7 (3)"]),
        (r"Substituting \eqref{eq:second} into~(\ref{eq:first}) gives", "2 g h^3", []),  # no slip would explain it
        (r"Substituting \eqref{eq:second}, and neglecting a term of~(\ref{eq:first}), gives", "g (3 h + 1)", []),
        (r"Unlike \eqref{eq:second} and~(\ref{eq:first}) is", "g (3 h + 1)", []),
    ],
)
def test_a_display_follows_from_those_that_it_is_said_to(
    words: str, result: str, found: list[str], tmp_path: Path
) -> None:
    text = REFERRING.replace("WORDS", words).replace("RESULT", result)
    (tmp_path / "paper.tex").write_text(text, encoding="utf-8")
    seen = look(tmp_path / "paper.tex")
    assert [finding.place for finding in seen.findings] == found
    assert seen.follows == (("line 7 (3)",) if result == "g (3 h - 1)" else ())
    refuted = [*verdicts(begun(tmp_path, text)).values()].count("refuted")
    assert refuted == len(found)


@pytest.mark.slow
def test_what_follows_from_something_unprinted_disagrees_and_is_not_refuted(tmp_path: Path) -> None:
    words = r"Substituting \eqref{eq:other} into~(\ref{eq:first}) gives"
    text = REFERRING.replace("WORDS", words).replace("RESULT", "g (3 h + 1)")
    (tmp_path / "paper.tex").write_text(text, encoding="utf-8")
    assert [finding.place for finding in look(tmp_path / "paper.tex").findings] == ["line 7 (3)"]
    assert "refuted" not in verdicts(begun(tmp_path, text)).values()
