"""What the words of a document say that letters measure, and what is told of formulas whose terms cannot fit."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from click.testing import CliRunner

from symcheck import look
from symcheck.cli.program import cli
from symcheck.document.look import UNITS
from symcheck.document.sources import source
from symcheck.document.units import stated

pytest.importorskip("pint")

SAID = {
    "where $m$ is the mass in kg, $v$ is the speed in m/s, and $E$ the energy in J.": {"m": "kg", "v": "m/s", "E": "J"},
    "$A$ - area [m^2]": {"A": "m^2"},
    r"where $g = 9.81$ m/s$^2$ and $\rho = 1000\,\mathrm{kg/m^3}$ is": {"g": "m/s^2", r"\rho": "kg/m^3"},
    "$v$ is the velocity [m s$^{-1}$]": {"v": "m s^-1"},
    "$x$ and $y$ are lengths in metres, $c$ in metres per second.": {
        "x": "metres",
        "y": "metres",
        "c": "metres/second",
    },
    r"$\alpha$ is dimensionless, $\beta$ [-]": {r"\alpha": "1", r"\beta": "1"},
    "the mass $m$ (kg) and speed $v$ (km/h)": {"m": "kg", "v": "km/h"},
    "$k$: heat conductivity [W/(m K)]": {"k": "W/(m K)"},
    r"$\mu$ [Pa s] is the viscosity; $\sigma$ (N/m²)": {r"\mu": "Pa s", r"\sigma": "N/m^2"},
    "$f(t)$ is a force [N]": {"f": "N"},
    r"$\rho$ is the density $[\frac{kg}{m^3}]$, $A$ is the area $[m^2]$": {r"\rho": "kg/(m^3)", "A": "m^2"},
    "$g$ [m/s2], $h$ [W m-2 K-1]": {"g": "m/s^2", "h": "W m^-2 K^-1"},
    # what is no unit, or not certainly one of this letter
    "see the field $E$ [1], and $x$ in a bar": {},
    "$a$ and $b$ are in kg and m respectively": {},
    "$n$ is the number of turns in seconds": {},
    "$p$ is a polynomial in s, $q$ is as in A": {},
    "The rate $r$ in percent": {},
    "the angles $a$ (see [m]). It is in kg": {},
    "$d$ is the distance covered in s": {},
    "the product of the voltage $V$ and the number of cells $N$ [V]": {},
    "$x$ in $[a, b]$": {},
}


@pytest.mark.parametrize(("text", "units"), SAID.items(), ids=SAID)
def test_units_are_read_from_words(text: str, units: dict[str, str]) -> None:
    assert dict(stated(text)) == units


UNITS_OF = {
    "paper.md": "$$E = \\frac{1}{2} m v$$\n\nwhere $m$ is the mass in kg, $v$ the speed in m/s, $E$ the energy [J].\n",
    "paper.rst": (
        "Motion\n======\n\n.. math::\n\n   E = \\frac{1}{2} m v\n\n"
        "- :math:`E` - energy [J]\n- :math:`m` - mass [kg]\n- :math:`v` - speed [m/s]\n"
    ),
    "paper.tex": (
        "\\documentclass{article}\\usepackage{siunitx}\\begin{document}\n"
        "\\section{Nomenclature}\n\\begin{itemize}\\item $m$ mass \\SI{}{}(\\si{kg})\n\\item $v$ speed (\\si{m/s})\n"
        "\\item $E$ kinetic energy [J]\\end{itemize}\n\\section{Motion}\n"
        "Then\n\\[ E = \\frac{1}{2} m v. \\]\n\\end{document}\n"
    ),
}


@pytest.mark.parametrize("name", UNITS_OF)
def test_what_cannot_measure_the_same_is_told_with_the_terms_and_the_units(name: str, tmp_path: Path) -> None:
    file = tmp_path / name
    file.write_text(UNITS_OF[name], encoding="utf-8")
    (finding,) = look(file).findings
    assert finding.message == UNITS
    assert finding.dimensions == ("E measures kg m^2/s^2", "1/2*m*v measures kg m/s")
    said = " ".join(finding.units)
    assert all(each in said for each in ("m in kg", "v in m/s", "E in J"))
    file.write_text(UNITS_OF[name].replace("m v", "m v^2"), encoding="utf-8")
    assert not look(file).findings


KEPT = "where $m$ is the mass in kg, $v$ the speed in m/s, $t$ the time in s, $E$ the energy [J], $x$ is in metres"
SOUND = {
    "numbers in a formula of one letter": r"$$x = 3 t^2 - 2 t$$ $$x = t^3$$",
    "numbers that measure something": r"$$E = 4.9 m t$$ $$E = 10 m t$$ $$x = (1 - t/60) x_0$$",
    "functions of numbers": r"$$x = x_0 \cos t$$ $$x = x_0 e^{-t}$$",
    "values": r"$$v = 3, \quad E = 0$$ $$m = 2 t + 20$$",
    "letters of which nothing is said": r"$$E = m c^2 + k T$$ $$x = a t^2$$",
    "what fits": r"$$E = \frac{1}{2} m v^2$$ $$x = \int_0^t v\,ds$$",
    "another letter in a sum": r"$$x_n = \sum_{m=1}^n m v_m$$",
}


@pytest.mark.parametrize("formulas", SOUND.values(), ids=SOUND)
def test_nothing_that_may_fit_is_accused(formulas: str, tmp_path: Path) -> None:
    file = tmp_path / "paper.md"
    text = "\n\n".join(f"$${each}$$" for each in formulas.split("$$") if each.strip())
    file.write_text(f"{text}\n\n{KEPT}.\n", encoding="utf-8")
    assert not [each for each in look(file).findings if each.message == UNITS]


ELSEWHERE = {
    "another section": "# One\n\n{said}\n\n# Two\n\n$$E = m v$$\n",
    "scaled quantities": "All in natural units, {said}\n\n$$E = m v$$\n",
    "two units": "{said}, and $m$ [m]\n\n$$E = m v$$\n",
}


@pytest.mark.parametrize("text", ELSEWHERE.values(), ids=ELSEWHERE)
def test_a_unit_holds_where_it_is_said(text: str, tmp_path: Path) -> None:
    file = tmp_path / "paper.md"
    file.write_text(text.format(said=KEPT), encoding="utf-8")
    assert not [each for each in look(file).findings if each.message == UNITS]
    file.write_text(f"# One\n\n{KEPT}\n\n$$E = m v$$\n", encoding="utf-8")
    assert [each.message for each in look(file).findings] == [UNITS]


def test_what_defines_a_letter_tells_what_it_measures(tmp_path: Path) -> None:
    file = tmp_path / "paper.md"
    file.write_text(f"$$p = m v$$\n\n$$E = p + m v^2$$\n\n{KEPT}\n", encoding="utf-8")
    (finding,) = look(file).findings
    assert (finding.place, finding.definitions) == ("line 3", ("line 1: p = m v",))


def test_an_audit_has_the_units_of_the_words_and_tells_what_does_not_fit(tmp_path: Path) -> None:
    file = tmp_path / "paper.md"
    file.write_text(UNITS_OF["paper.md"], encoding="utf-8")
    assert source(file).told
    runner, folder = CliRunner(), tmp_path / "audit_paper"
    assert runner.invoke(cli, ["new", str(file), "--out", str(folder), "--jobs", "1"]).exit_code == 0
    assert 'letter("m", unit="kg"),' in (folder / "audit.py").read_text(encoding="utf-8")
    checked = runner.invoke(cli, ["check", str(folder), "--jobs", "0"])
    assert "Dimensions that do not fit: 1" in checked.stdout
    assert "1/2*m*v measures kg m/s" in " ".join(checked.stdout.split())
    (record,) = json.loads(runner.invoke(cli, ["check", str(folder), "--jobs", "0", "--json"]).stdout)["items"]
    assert record["dimension"]["verdict"] == "inconsistent"
    told = runner.invoke(cli, ["check", str(folder), "--jobs", "0", "--format", "plain"]).stdout
    assert told == f"{file}:1: dimensions: 0.1: E measures kg m^2/s^2, 1/2*m*v measures kg m/s\n"
