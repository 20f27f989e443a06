"""`symcheck look`: what is found in a document, what is said of it, and what never is."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest
from click.testing import CliRunner, Result
from documents import BAD, FAULTY, PLANTED, SOUND, Maker

from symcheck import look
from symcheck.cli import cli
from symcheck.document.sources import source

Placed = list[tuple[int, str, str, str]]  # line, number, label and LaTeX
BODY = r"\documentclass{article}\begin{document}" + "\n"

# documents with what is found in them
DOCUMENTS: dict[str, tuple[str, str, Placed]] = {
    "displays of LaTeX": (
        "a.tex",
        BODY + "\\[ a = 1 \\]\n$$b = 2$$\n\\begin{equation}c = 3\\label{c}\\end{equation}\n"
        "\\begin{displaymath} d = 4 \\end{displaymath}\n\\begin{equation*} e = 5 \\end{equation*}\n"
        "\\begin{multline} f = 6 \\\\ + 7 \\end{multline}",
        [
            (2, "", "", "a = 1"),
            (3, "", "", "b = 2"),
            (4, "1", "c", "c = 3"),
            (5, "", "", "d = 4"),
            (6, "", "", "e = 5"),
            (7, "2", "", r"f = 6 \\ + 7"),
        ],
    ),
    "subscripts with a backslash, and words with a sign": (
        "a.md",
        "Then $$m\\_1 = \\mathbf{a}\\_{2}$$\n\n$$\\text{v\\_max} = \\text{a\\_b}$$\n",
        [(1, "", "", r"m_1 = \mathbf{a}_{2}"), (3, "", "", r"\text{v\_max} = \text{a\_b}")],
    ),
    "rows with labels and numbers": (
        "a.tex",
        BODY + "\\begin{align}\na &= b \\label{a}\\\\\n&= c \\nonumber\\\\[2pt]\nd &= e & f &= g \\tag{A}\\\\\nh &= i\n"
        "\\end{align}\n\\begin{eqnarray} j &=& k \\\\ l &=& m \\end{eqnarray}\n"
        "\\begin{gather} n = 1 \\\\ o = 2 \\notag \\end{gather}\n"
        "\\begin{alignat}{2} p &= q &\\quad r &= s \\end{alignat}",
        [
            (3, "1", "a", "a = b = c"),
            (5, "A", "", "d = e"),
            (5, "A", "", "f = g"),
            (6, "2", "", "h = i"),
            (8, "3", "", "j = k"),
            (8, "4", "", "l = m"),
            (9, "5", "", "n = 1"),
            (9, "", "", "o = 2"),
            (10, "6", "", "p = q"),
            (10, "6", "", r"\quad r = s"),
        ],
    ),
    "numbers within sections, appendices and subequations": (
        "a.tex",
        "\\documentclass{article}\\numberwithin{equation}{section}\n\\section{A}\\begin{equation}a=1\\end{equation}\n"
        "\\section*{B}\\begin{subequations}\\begin{align}b=1\\\\c=1\\end{align}\\end{subequations}\n"
        "\\appendix\\section{C}\\begin{equation}d=1\\end{equation}\\setcounter{equation}{6}\n"
        "\\begin{equation}e=1\\end{equation}",
        [
            (2, "1.1", "", "a=1"),
            (3, "1.2a", "", "b=1"),
            (3, "1.2b", "", "c=1"),
            (4, "A.1", "", "d=1"),
            (5, "A.7", "", "e=1"),
        ],
    ),
    "no numbers in a part of a document": ("a.tex", r"\begin{equation} a = 1 \end{equation}", [(1, "", "", "a = 1")]),
    "inline relations, and no other formulas": (
        "a.tex",
        "Let $a = b$$c<d$ and \\(e \\le f\\), with $x$ and \\verb|$y=1$|. % $z = 1$\n\n\\begin{verbatim}\n$w=1$\n"
        "\\end{verbatim}\n\\begin{lstlisting}\n\\[ v = 1 \\]\n\\end{lstlisting}\n",
        [(1, "", "", "a = b"), (1, "", "", "c<d"), (1, "", "", r"e \le f")],
    ),
    "macros": (
        "a.tex",
        "\\usepackage{physics}\n\\newcommand{\\vect}[1]{\\mathbf{#1}}\\newcommand\\half[1][1]{\\frac{#1}{2}}\n"
        "\\def\\pair#1,#2;{(#1 + #2)}\\DeclareMathOperator{\\sinc}{sinc}\\let\\eps=\\varepsilon\n"
        "\\DeclarePairedDelimiter{\\size}{\\lvert}{\\rvert}\\newenvironment{eq}{\\begin{equation}}{\\end{equation}}\n"
        "\\renewcommand{\\vect}[1]{\\vec{#1}}\\providecommand{\\half}{no}\\newcommand{\\be}{\\[}\n"
        "\\begin{eq} \\vect a = \\half + \\half[3] \\end{eq}\n\\be \\pair b,c; = \\sinc\\eps \\]\n"
        "$\\size{x} = \\dv[2]{y}{t}$ \\iffalse $n = 0$ \\fi",
        [
            (6, "", "", r"\vec{a} = \frac{1}{2}+ \frac{3}{2}"),
            (7, "", "", r"(b + c) = \operatorname{sinc}\varepsilon"),
            (8, "", "", r"\left\lvert x\right\rvert = \frac{\mathrm{d}^{2} y}{\mathrm{d} t^{2}}"),
        ],
    ),
    "split and cases": (
        "a.tex",
        "\\[ \\begin{split} a &= b \\\\ &\\quad + c, \\end{split} \\]\n"
        "\\[ d = \\begin{cases} 1 & x > 0 \\\\ 2 & x < 0 \\end{cases} \\]\n"
        "\\[ \\begin{aligned} e &= 1, \\\\ f &= 2 \\end{aligned} \\quad (3.1) \\]",
        [
            (1, "", "", r"a = b \quad + c"),
            (2, "", "", r"d = \begin{cases} 1 & x > 0 \\ 2 & x < 0 \end{cases}"),
            (3, "3.1", "", "e = 1"),
            (3, "3.1", "", "f = 2"),
        ],
    ),
    "a product that goes on in the next row": (
        "a.tex",
        "\\begin{align} a &= b \\nonumber \\\\ & (c + d) \\\\ e &= f, \\\\ & g \\end{align}",
        [(1, "", "", "a = b (c + d)"), (1, "", "", "e = f"), (1, "", "", "g")],
    ),
    "arrows before what follows": (
        "a.tex",
        "\\begin{align} a + 1 &= b \\\\ \\Rightarrow \\quad a &= b - 1 \\\\ &\\therefore b = a + 1 \\end{align}\n"
        "\\[ \\rightarrow\\quad c = d \\]\n$\\to e = f$",
        [
            (1, "", "", "a + 1 = b"),
            (1, "", "", "a = b - 1"),
            (1, "", "", "b = a + 1"),
            (2, "", "", "c = d"),
            (3, "", "", r"\to e = f"),
        ],
    ),
    "Markdown": (
        "a.md",
        "---\ntitle: x\n---\n# A\nwith $a=b$ and \\(c=d\\) and `$no = 1$`\n\n$$ e = f \\tag{2} $$\n\n"
        "$$\ng = h\n$$ (gh)\n\n$$ i = j $$ {#eq-ij}\n\n```{math}\n:label: kl\nk = l\n```\n\n"
        "\\begin{align} m &= n \\\\ o &= p \\end{align}\n\n    $no = 2$\n\n\\[ q = r \\]\n\n"
        "::: {.note}\n{math}`s=t`\n:::\n",
        [
            (5, "", "", "a=b"),
            (5, "", "", "c=d"),
            (7, "2", "", "e = f"),
            (10, "", "gh", "g = h"),
            (13, "", "eq-ij", "i = j"),
            (17, "", "kl", "k = l"),
            (20, "", "", "m = n"),
            (20, "", "", "o = p"),
            (24, "", "", "q = r"),
            (27, "", "", "s=t"),
        ],
    ),
    "environments between dollars, in a list and in a text": (
        "a.md",
        "- text\n    $$\n    \\begin{equation}\n    a = 1\n    \\end{equation}\n    $$\n- more text $b = 2$\n\n"
        "words $$\\begin{equation} c = 3 \\end{equation}$$\n\n$$\\begin{align} d &= 4 \\\\ e &= 5 \\end{align}$$\n",
        [
            (4, "", "", "a = 1"),
            (7, "", "", "b = 2"),
            (9, "", "", "c = 3"),
            *[(11, "", "", x) for x in ("d = 4", "e = 5")],
        ],
    ),
    "directives of MyST between colons, in a list, in a note, and one that is never closed": (
        "a.md",
        "- text\n  :::{math}\n  :label: one\n  a = 1\n  :::\n\n::::{note}\n:::{math}\nb = 2\n:::\n::::\n\n"
        ":::{math}\nc = 3\n",
        [(4, "", "one", "a = 1"), (9, "", "", "b = 2"), (14, "", "", "c = 3")],
    ),
    "reStructuredText": (
        "a.rst",
        "A\n=\n\n.. math::\n   :label: ab\n\n   a = b\n\n   c &= d \\\\\n   &= e\n\nText :math:`f = g`, :ref:`ab`.\n\n"
        ".. py:function:: run(x)\n\n   .. math:: h = i\n\n::\n\n   :math:`no = 1`\n\n.. no comment :math:`no = 2`\n",
        [
            (7, "", "ab", "a = b"),
            (9, "", "ab", "c = d = e"),
            (12, "", "", "f = g"),
            (16, "", "", "h = i"),
        ],
    ),
    "formulas between tags of HTML, and none in comments": (
        "a.md",
        "<div class='box'>\n  The <b>period</b>:\n  $$T = 2 \\pi / n$$\n</div>\n\n<!-- $$a = 1$$ -->\n\n"
        "<table><tr><td>$x < y$</td></tr></table>\n",
        [(3, "", "", r"T = 2 \pi / n"), (8, "", "", "x < y")],
    ),
    "the equations of a derivation on one line, and implications of values and of inequalities": (
        "a.md",
        "$$a^2 + b^2 = c^2 \\quad\\Longrightarrow\\quad b^2 = c^2 - a^2$$\n\n"
        "$$x = 2 \\quad\\implies\\quad f(x) = 4$$\n\n"
        "$$a x - b = 0 \\quad\\Rightarrow\\quad x = b / a$$\n\n$$x > 0 \\quad\\Rightarrow\\quad x + 1 > 1$$\n\n"
        "$$a + b = c \\Rightarrow b = c - a$$\n",
        [
            (1, "", "", "a^2 + b^2 = c^2"),
            (1, "", "", "b^2 = c^2 - a^2"),
            (3, "", "", r"x = 2 \quad\implies\quad f(x) = 4"),
            (5, "", "", r"a x - b = 0 \quad\Rightarrow\quad x = b / a"),
            (7, "", "", r"x > 0 \quad\Rightarrow\quad x + 1 > 1"),
            (9, "", "", r"a + b = c \Rightarrow b = c - a"),
        ],
    ),
    "macros that a notebook prints": (
        "a.ipynb",
        json.dumps(
            {
                "cells": [
                    {"cell_type": "code", "source": "damaged", "outputs": 5},
                    {
                        "cell_type": "code",
                        "source": "show()",
                        "outputs": [
                            {"data": {"text/markdown": ["$\\def\\mf{\\mathbf}$ ", "$$z = 1$$"]}},
                            {"text": "x"},
                        ],
                    },
                    {"cell_type": "markdown", "source": "$$\\mf a = \\mf b$$"},
                ]
            }
        ),
        [(1, "", "", r"\mathbf a = \mathbf b")],
    ),
    "a notebook": (
        "a.ipynb",
        json.dumps(
            {
                "cells": [
                    {"cell_type": "code", "source": "$no = 1$"},
                    {"cell_type": "markdown", "source": ["Text\n", "$$a = b$$\n"]},
                    {"cell_type": "markdown", "source": "with $c = d$"},
                ]
            }
        ),
        [(2, "", "", "a = b"), (1, "", "", "c = d")],
    ),
    "displays within paragraphs and quotations": (
        "a.md",
        "It is\n\\[ a = b \\]\nand then\n\\[ c = d \\]\nfollows.\n\n> Said:\n> \\[ e = f\n>   > g \\]\n> and so.\n",
        [(2, "", "", "a = b"), (4, "", "", "c = d"), (8, "", "", "e = f > g")],
    ),
    "rows that begin with a letter in braces": (
        "a.tex",
        BODY + "\\begin{align}\n{\\vec x} &= a \\\\\n{\\vec y} &= b \\\\\n{} &= c\n\\end{align}",
        [(3, "1", "", r"{\vec x} = a"), (4, "2, 3", "", r"{\vec y} = b {} = c")],
    ),
}


@pytest.mark.parametrize(("name", "text", "expected"), DOCUMENTS.values(), ids=DOCUMENTS)
def test_the_formulas_of_a_document_have_lines_numbers_and_labels(
    name: str, text: str, expected: Placed, tmp_path: Path
) -> None:
    file = tmp_path / name
    file.write_text(text, encoding="utf-8")
    found = source(file).formulas
    assert [(each.line, each.number, each.label, each.latex) for each in found] == expected


def test_included_files_are_read_and_missing_ones_are_told(tmp_path: Path) -> None:
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts" / "one.tex").write_text("\n\\begin{equation}\\x = 1\\end{equation}", encoding="utf-8")
    main = tmp_path / "main.tex"
    main.write_text(
        "\\documentclass{article}\\newcommand{\\x}{y}\n\\input{parts/one}\\include{two}\n"
        "\\begin{equation}b = 1\\end{equation}",
        encoding="utf-8",
    )
    found = source(main)
    assert [(each.place, each.latex) for each in found.formulas] == [
        ("parts/one.tex, line 2 (1)", "y= 1"),
        ("line 3", "b = 1"),  # its number cannot be known
    ]
    assert found.notes == ("the document, line 2: \\include{two}: there is no such file",)


def test_planted_errors_are_found_from_the_source_alone(tmp_path: Path) -> None:
    file = tmp_path / "paper.tex"
    file.write_text(FAULTY, encoding="utf-8")
    found = {int(each.place.split()[1]): each for each in look(file).findings}
    told = {line: finding.message for line, finding in found.items()}
    assert told == PLANTED
    assert not any("refuted" in message for message in told.values())
    assert found[11].definitions == (r"line 9 (1.1): x(t) = A \cos \omega t + \frac{b}{2} t^2",)
    assert found[11].nearest == (r"x'(t) = -A \omega \sin\left(\omega t\right) + b t",)
    assert found[14].point == {"m": "3", "u": "2", "w": "1"}


def test_nothing_is_said_against_a_sound_document(tmp_path: Path) -> None:
    file = tmp_path / "paper.tex"
    file.write_text(SOUND, encoding="utf-8")
    found = look(file)
    assert found.findings == ()
    assert all(found.read[:-2])
    assert {"line 7 (2)", "line 16 (7)", "line 19 (9)"} <= {*found.follows}


def test_letters_are_inferred_from_the_whole_document_and_contradictions_told(tmp_path: Path) -> None:
    file = tmp_path / "paper.md"
    file.write_text(
        "$$a = f(x) + 1$$\n\n$$b = \\dot{q} + \\mathbf{v} \\cdot \\mathbf{w}$$\n\n$$c = 3 q$$\n\n"
        "$$\\mathbf{R} = \\begin{pmatrix} 1 & 2 \\\\ 3 & 4 \\end{pmatrix}$$\n\n$$d = \\sum_{v=1}^3 u_v$$\n\n"
        "$$\\dot f = g, \\quad f_0 = \\mathbf{R} \\mathbf{v} \\cdot \\mathbf{w}$$\n\n$$\\sum_{g=1}^3 u_g = \\dot{g}$$",
        encoding="utf-8",
    )
    letters = {each.letter: each for each in look(file).letters}
    assert letters["q"].phrase == "depends on t"
    assert letters["q"].count == 2
    assert letters["q"].first == "line 3"
    assert letters[r"\mathbf{R}"].phrase == "matrix"


CONTRADICTED = {  # what states nothing beside the second formula, and something beside the third
    "functions named d": (r"d(t) = f(t) + d_0", r"y = f(t)", None),
    "letters above that stand elsewhere without one below": (r"a_i = X_i^j b_j", r"y = X^j z", r"y = X z"),
    "letters and signs of a change": (r"V = \delta V_i", r"\delta = \frac{s}{T}", r"\alpha = \frac{s}{T}"),
    "powers above an index": (r"a_t = b_t I_t^\alpha", r"c = 2 b_t", None),
    "values of a matrix": (r"\det(J(\theta)) = 0", r"J = \begin{pmatrix} a & b \\ c & d \end{pmatrix}", None),
}


@pytest.mark.parametrize(("latex", "against", "beside"), CONTRADICTED.values(), ids=CONTRADICTED)
def test_a_formula_that_another_contradicts_states_nothing(
    latex: str, against: str, beside: str | None, tmp_path: Path
) -> None:
    file = tmp_path / "paper.md"
    for other, stated in ((against, False), (beside, True)):
        if other:
            file.write_text(f"$${latex}$$\n\n$${other}$$\n", encoding="utf-8")
            found = look(file)
            assert (found.read[0] and not any("line 1" in each.places for each in found.valueless)) is stated


def test_what_is_read_and_has_no_value_is_told_with_the_reason_once(tmp_path: Path) -> None:
    paper = tmp_path / "paper.md"
    paper.write_text(
        "$$\\nabla \\cdot \\mathbf{v} = 0$$\n\n$$\\langle x \\rangle = y$$\n\n$$z = 2 y$$\n", encoding="utf-8"
    )
    found = look(paper)
    assert found.read == (True, True, True)
    assert [(each.reason, each.places) for each in found.valueless] == [("has no algebraic form", ("line 1", "line 3"))]


def test_one_cause_is_told_once_with_its_places(tmp_path: Path) -> None:
    file = tmp_path / "paper.md"
    file.write_text("$$a = \\unknown b$$\n\n$$c = d$$\n\n$$e = 1 + \\unknown$$\n", encoding="utf-8")
    found = look(file)
    assert [(each.places, r"\unknown" in each.reason) for each in found.refusals] == [(("line 1", "line 5"), True)]
    assert found.read == (False, True, False)


def run(*args: str) -> Result:
    return CliRunner().invoke(cli, ["look", *args], prog_name="symcheck")


def test_the_command_prints_eighty_columns_and_exits_by_what_it_found(tmp_path: Path) -> None:
    for text, code in (("$$a = b + 1$$", 0), ("$$E = (a + b)^2 = a^2 + b^2 + a b$$", 1)):
        file = tmp_path / "paper.md"
        file.write_text(text, encoding="utf-8")
        result = run(str(file), "--jobs", "1")
        assert result.exit_code == code, result.stderr
        assert max(map(len, result.stdout.splitlines())) <= 80
        assert [*tmp_path.iterdir()] == [file]
    assert "\n  line 1: the links of this chain do not agree" in result.stdout
    data = json.loads(run(str(file), "--jobs", "1", "--json").stdout)
    assert data["findings"][0]["point"] == {"a": "3", "b": "2"}
    assert data["formulas"][0]["line"] == 1


@pytest.mark.parametrize(("name", "make"), BAD.values(), ids=BAD)
def test_what_is_no_document_ends_in_one_line(name: str, make: Maker, tmp_path: Path) -> None:
    file = tmp_path / name
    make(file)
    result = run(str(file), "--jobs", "1")
    assert result.exit_code == 2
    assert result.stdout == ""
    assert len(result.stderr.splitlines()) == 1
    assert name[:20] in result.stderr


def test_deep_formulas_are_refused_and_the_others_read(tmp_path: Path) -> None:
    file = tmp_path / "paper.tex"
    deep: Callable[[str, str, int], str] = lambda a, b, n: a * n + "x" + b * n  # noqa: E731
    formulas = [deep("{", "}", 5000), deep("(", ")", 3000), deep(r"\frac{1}{", "}", 2000), deep(r"\sqrt{", "}", 900)]
    file.write_text("\n\n".join(f"$$y = {each}$$" for each in formulas) + "\n\n$$a = b$$", encoding="utf-8")
    found = look(file)
    assert found.read == (False, False, False, False, True)
    assert found.findings == ()


def test_arguments_end_where_other_formulas_say(tmp_path: Path) -> None:
    (tmp_path / "paper.md").write_text(
        r"The beam is $$w = b \sinh n(L - x)$$ and $$v = b \sinh n L$$ and $$u = c \cos\beta (1 - k^2)$$ and"
        r" $$s = \cos\beta$$ but $$y = \sin\alpha (x - 1)$$",
        encoding="utf-8",
    )
    assert look(tmp_path / "paper.md").read == (True, True, True, True, False)


def test_bold_capitals_beside_functions_of_vectors_are_matrices(tmp_path: Path) -> None:
    (tmp_path / "paper.md").write_text(
        r"$$\hat{\mathbf{S}}_t = \mathbf{G}(\mathbf{x}_{t-1}, \mathbf{u}_t) \mathbf{S}_{t-1}"
        r" \mathbf{G}^T(\mathbf{x}_{t-1}, \mathbf{u}_t) + \mathbf{V}_t$$",
        encoding="utf-8",
    )
    assert look(tmp_path / "paper.md").read == (True,)
