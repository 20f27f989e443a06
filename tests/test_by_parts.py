"""Integrals of unknown functions, and brackets with the ends of an integral."""

from __future__ import annotations

import pytest

from symcheck import decide

F_AND_G = {"f": "function of x", "g": "function of x"}


@pytest.mark.parametrize(
    ("true", "false"),
    [
        (
            r"\int_a^b f'(x)g(x)\,dx = f(b)g(b)-f(a)g(a)-\int_a^b f(x)g'(x)\,dx",
            r"\int_a^b f'(x)g(x)\,dx = f(b)g(b)-f(a)g(a)+\int_a^b f(x)g'(x)\,dx",
        ),
        (
            r"\int_a^b f'(x)g(x)\,dx = \left[f(x)g(x)\right]_a^b-\int_a^b f(x)g'(x)\,dx",
            r"\int_a^b f'(x)g(x)\,dx = \left[f(x)g(x)\right]_a^b+\int_a^b f(x)g'(x)\,dx",
        ),
        (
            r"\int_a^b x f'(x)\,dx = b f(b)-a f(a)-\int_a^b f(x)\,dx",
            r"\int_a^b x f'(x)\,dx = b f(b)-a f(a)+\int_a^b f(x)\,dx",
        ),
        (
            r"\int_a^b f(x)f''(x)\,dx = f(b)f'(b)-f(a)f'(a)-\int_a^b f'(x)^2\,dx",
            r"\int_a^b f(x)f''(x)\,dx = f(b)f'(b)-f(a)f'(a)+\int_a^b f'(x)^2\,dx",
        ),
        (
            r"\int_a^b f(x)\,dx+\int_b^c f(x)\,dx = \int_a^c f(x)\,dx",
            r"\int_a^b f(x)\,dx+\int_b^c f(x)\,dx = \int_c^a f(x)\,dx",
        ),
        (
            r"\int_a^b f(x)\,dx = \int_{a+c}^{b+c} f(x-c)\,dx",
            r"\int_a^b f(x)\,dx = -\int_{a+c}^{b+c} f(x-c)\,dx",
        ),
        (
            r"\int_a^b\left(\alpha f(x)+\beta g(x)\right)dx = \alpha\int_a^b f(x)\,dx+\beta\int_a^b g(x)\,dx",
            r"\int_a^b\left(\alpha f(x)+\beta g(x)\right)dx = \alpha\int_a^b f(x)\,dx-\beta\int_a^b g(x)\,dx",
        ),
    ],
)
def test_laws_of_integrals_of_all_functions_are_decided(true: str, false: str) -> None:
    assert decide(true).verdict == "proved"
    assert decide(false).verdict == "refuted"


@pytest.mark.parametrize(
    ("relation", "given"),
    [
        (r"\int_0^1 f(x)\,dx = 1", ""),
        (r"\int_0^1 x f(x)\,dx = \int_0^1 f(x)\,dx", ""),  # some functions are so
        (r"\int_0^t f(\tau)\,d\tau = f(t)", ""),
        (r"\int_a^b f'(x)\,dx = f(b)+C", ""),
        (r"\int_a^c f(x)\,dx = \int_c^b f(x)\,dx", ""),  # where c is
        (r"\int_{-a}^a f(x)\,dx = 2\int_0^a f(x)\,dx", "f(-x) = f(x)"),
        (r"\int_a^b \frac{f'(x)}{f(x)}\,dx = \ln f(b)+\ln f(a)", "f(x) > 0"),
    ],
)
def test_what_may_say_which_function_is_meant_is_not_refuted(relation: str, given: str) -> None:
    assert decide(relation, given=given).verdict not in ("proved", "refuted")


@pytest.mark.parametrize(
    ("relation", "verdict"),
    [
        (r"\int_0^1 x^2\,dx = \left[\frac{x^3}{3}\right]_0^1", "proved"),
        (r"\int_0^1 x^2\,dx = \left.\frac{x^3}{2}\right|_{x=0}^{x=1}", "refuted"),
        (r"\int_1^2\frac{dx}{x} = [\ln x]_1^2", "proved"),
        (r"\int_0^1 x^2\,dx = \left.\frac{x^3}{2}\right|_1^2", "undecided"),  # these are other ends
    ],
)
def test_brackets_with_the_ends_of_the_integral_are_taken_at_its_letter(relation: str, verdict: str) -> None:
    assert decide(relation).verdict == verdict


def test_functions_are_taken_of_the_letter_that_is_said() -> None:
    claim = r"\int_a^b f'g\,dx = \left.fg\right|_a^b-\int_a^b fg'\,dx"
    assert decide(claim, letters=F_AND_G).verdict == "proved"
