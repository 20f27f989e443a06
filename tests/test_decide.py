"""`symcheck decide`: what is true is proved, what is false beside it is refuted, and nothing is said of the rest."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from click.testing import CliRunner

from symcheck.checker import check
from symcheck.cli.program import cli
from symcheck.question import Status, decide

NATURAL = r"n \in \mathbb{N}"
PAIRS: dict[str, tuple[str, str, tuple[str, ...], tuple[str, ...]]] = {  # what is true and what is false: where, given
    "an exponential of a sum": (r"e^x e^y = e^{x + y}", r"e^x + e^y = e^{x + y}", (), ()),
    "a positive exponential": (r"e^x > 0", r"e^x > 1", (), ()),
    "hyperbolic functions": (r"\cosh^2 x - \sinh^2 x = 1", r"\cosh^2 x + \sinh^2 x = 1", (), ()),
    "a logarithm of a product": (r"\ln(x y) = \ln x + \ln y", r"\ln(x + y) = \ln x + \ln y", (), ()),
    "a root of a square": (r"\sqrt{x^2} = |x|", r"\sqrt{x^2} = x", (), ()),
    "a root of a square under a condition": (r"\sqrt{x^2} = x", r"\sqrt{x^2} = -x", (), ("x > 0",)),
    "a fraction": (r"\frac{x^2}{x} = x", r"\frac{x^2}{x} = 2 x", (), ()),
    "half an angle": (r"2 \sin^2 \frac{x}{2} = 1 - \cos x", r"2 \sin^2 \frac{x}{2} = 1 + \cos x", (), ()),
    "an inverse function": (r"\sin(\arcsin x) = x", r"\arcsin(\sin x) = x", (), ()),
    "the slope of a logarithm": (r"\frac{d}{dx} \ln x = \frac{1}{x}", r"\frac{d}{dx} \ln x = x", (), ()),
    "an order": (r"a^2 + b^2 \ge 2 a b", r"a^2 + b^2 > 2 a b", (), ()),
    "an integral": (r"\int_1^2 \frac{1}{x} dx = \ln 2", r"\int_1^2 \frac{1}{x} dx = \frac{7}{10}", (), ()),
    "an integral between letters": (
        r"\int_a^b x dx = \frac{b^2 - a^2}{2}",
        r"\int_a^b x dx = \frac{b^2 + a^2}{2}",
        (),
        (),
    ),
    "a sum of numbers": (r"\sum_{i=1}^{3} i^2 = 14", r"\sum_{i=1}^{3} i^2 = 15", (), ()),
    "a sum to a letter": (
        r"\sum_{k=1}^{n} k = \frac{n (n + 1)}{2}",
        r"\sum_{k=1}^{n} k = \frac{n (n - 1)}{2}",
        (),
        (NATURAL,),
    ),
    "a sum that is not empty": (r"\sum_{k=1}^{n} 1 = n", r"\sum_{k=1}^{n} 1 = n + 1", (), ()),
    "energy": (r"\frac{d}{dt}(\dot x^2 + x^2) = 0", r"\frac{d}{dt}(\dot x^2 - x^2) = 0", (r"\ddot x + x = 0",), ()),
    "a function that is defined": (r"f'(x) = 2 x", r"f'(x) = x", ("f(x) = x^2",), ()),
    "a product of vectors": (
        r"\vec a \times \vec b = -\vec b \times \vec a",
        r"\vec a \times \vec b = \vec b \times \vec a",
        (),
        (),
    ),
    "a determinant": (
        r"\det(A B) = \det A \det B",
        r"\det(A + B) = \det A + \det B",
        (),
        (r"A \in \mathbb{R}^{2 \times 2}", r"B \in \mathbb{R}^{2 \times 2}"),
    ),
    "Euler's formula": (r"e^{i x} = \cos x + i \sin x", r"e^{i x} = \cos x - i \sin x", (), ()),
}
WHOLE = r"n \in \mathbb{Z}"
TRUE_OF_WHOLE_NUMBERS: dict[str, tuple[str, ...]] = {  # with conditions; each is false of some other number
    r"\sin(\pi n) = 0": (WHOLE,),
    r"e^{2 \pi i n} = 1": (WHOLE,),
    r"n \le n^2": (WHOLE,),
    r"n = 0": (WHOLE, r"0 \le n", "n < 1"),
    r"2 n \ne 1": (WHOLE,),
    r"n \ne \frac{1}{2}": (NATURAL,),
}
FALSE_OF_WHOLE_NUMBERS = (r"e^{\pi i n} = 1", r"\sin \frac{\pi n}{2} = 0", r"\cos(\pi n) = 1", r"n^2 \le n", r"2n = n")
WITHOUT_A_VALUE = (r"\sqrt{-1} = i", r"(-1)^{1/2} = i", r"\sqrt{-1} = x", r"\ln(-1) = x")
FALSE_OR_OPEN: dict[str, tuple[str, tuple[str, ...], tuple[str, ...]]] = {  # false, without a value, or about nothing
    "an integral through a double pole": (r"\int_{-1}^{1} \frac{1}{x^2} dx = -2", (), ()),
    "an integral through a pole": (r"\int_{-1}^{1} \frac{1}{x} dx = 0", (), ()),
    "an integral through the poles of a tangent": (r"\int_0^{2\pi} \tan x dx = 0", (), ()),
    "an integral of which the antiderivative jumps": (r"\int_0^{\pi} \frac{1}{\cos^2 x} dx = 0", (), ()),
    "an endless sum that diverges": (r"\sum_{n=1}^{\infty} n = -\frac{1}{12}", (), ()),
    "an endless sum that converges for some": (r"\sum_{n=0}^{\infty} x^n = \frac{1}{1 - x}", (), ()),
    "conditions that contradict each other": ("x = 1", (), ("x > 0", "x < 0")),
    "a fraction where it has no value": (r"\frac{x^2}{x} = 0", (), ("x = 0",)),
    "a value of a solution": ("f(0) = 1", ("f'(x) = f(x)",), ()),
    "zero is one": ("0 = 1", (), ()),
}


@pytest.mark.parametrize("name", PAIRS)
def test_what_is_true_is_proved_and_the_false_one_beside_it_is_refuted(name: str) -> None:
    true, false, where, given = PAIRS[name]
    right, wrong = decide(true, where, given), decide(false, where, given)
    assert (right.verdict, wrong.verdict) == (Status.PROVED, Status.REFUTED), (right.reason, wrong.reason)
    for answer in (right, wrong):
        assert answer.certificate
        assert [*map(check, answer.certificate)] == [None] * len(answer.certificate)
        assert json.loads(json.dumps(answer.as_json()))["verdict"] == answer.verdict


@pytest.mark.parametrize("name", FALSE_OR_OPEN)
def test_what_is_false_or_has_no_value_is_never_proved(name: str) -> None:
    assert decide(*FALSE_OR_OPEN[name]).verdict in (Status.REFUTED, Status.UNDECIDED)


@pytest.mark.parametrize("relation", TRUE_OF_WHOLE_NUMBERS)
def test_what_is_true_of_whole_numbers_is_not_refuted_by_others(relation: str) -> None:
    assert decide(relation, given=TRUE_OF_WHOLE_NUMBERS[relation]).verdict in (Status.PROVED, Status.UNDECIDED)


@pytest.mark.parametrize("relation", FALSE_OF_WHOLE_NUMBERS)
def test_what_is_false_of_a_whole_number_is_refuted_by_it(relation: str) -> None:
    answer = decide(relation, given=WHOLE)
    assert answer.verdict is Status.REFUTED
    assert answer.counterexample["n"].lstrip("-").isdigit()
    assert [*map(check, answer.certificate)] == [None]


def test_a_whole_power_is_not_taken_for_one_of_positive_numbers() -> None:
    assert decide("x^n > 0", given=WHOLE).verdict is Status.UNDECIDED
    assert decide("x^n > 0", given=(WHOLE, "x > 0")).verdict is Status.PROVED


@pytest.mark.parametrize("relation", WITHOUT_A_VALUE)
def test_what_has_no_value_is_no_statement(relation: str) -> None:
    answer = decide(relation)
    assert answer.verdict is Status.UNREADABLE
    assert answer.reason


@pytest.mark.parametrize(
    ("relation", "condition"),
    [(r"\frac{x}{x} = 1", "x ≠ 0"), (r"e^{\ln x} = x", "x > 0"), (r"\sum_{k=1}^{n} 1 = n", "1 ≤ n")],
)
def test_it_is_said_where_the_printed_terms_have_values(relation: str, condition: str) -> None:
    assert decide(relation).used == (condition,)


@pytest.mark.parametrize(
    ("arguments", "code", "said"),
    [
        ([], 2, "give one relation, or --batch with a file"),
        (["x = y", "--letter", "foo"], 2, "'foo' is not of the form LETTER=WHAT"),
        (["x = y", "--batch", "-"], 2, "give one relation, or --batch with a file"),
        (["--batch", "nowhere.jsonl"], 2, "nowhere.jsonl cannot be read"),
        (["--batch", "-", "--resume"], 2, "--resume goes on with the file of --output"),
        (["x ="], 2, "the formula breaks off"),
        (["0 = 0"], 0, "proved"),
        (["0 = 1"], 1, "refuted"),
        (["e^x \\ge 1 + x"], 3, "undecided"),
    ],
)
def test_exit_codes_and_errors_of_one_line(
    arguments: list[str], code: int, said: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    outcome = CliRunner().invoke(cli, ["decide", *arguments], input="")
    assert outcome.exit_code == code
    assert said in outcome.output
    if code == 2:
        assert len(outcome.stderr.splitlines()) <= 1


def test_a_symbol_that_all_papers_use_alike_is_not_refuted_as_a_letter() -> None:
    relation, letters = r"\delta_{ij} \delta_{jk} = \delta_{ik}", (r"\delta_{ij}", r"\delta_{jk}", r"\delta_{ik}")
    assert decide(relation).verdict is Status.UNDECIDED
    assert decide(r"\delta_{ij}^2 = \delta_{ij}", letters=dict.fromkeys(letters, "scalar")).verdict is Status.REFUTED
    assert decide(r"\delta_{11} x = x").verdict is Status.REFUTED
