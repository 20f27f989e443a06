"""The compound pendulum, in printed order."""

from symcheck.core.claims import Erratum
from symcheck.core.problems import Applied
from symcheck.core.verdicts import Origin
from symcheck.papers.declare import claim, definition
from symcheck.papers.pendulum.hypotheses import body, gyration, positive_radius, pulled
from symcheck.proof import identity, nonnegative, theorems

SQUARE = r"\frac{(a - r)^2}{a}"

moment = definition("1", 6, r"I = I_c + m a^2")

length = definition("2", 10, r"l = \frac{I}{m a}.")

centre_of_oscillation = definition("3", 14, r"b = \frac{I_c}{m a}")

sum_of_distances = claim("4", 18, r"l = a + b.", given=[body], by=identity)

reversible = claim("5", 22, r"\frac{I_c + m b^2}{m b} = l.", given=[body], by=identity)

least_length = claim(
    "6",
    26,
    r"l \ge 3 r.",
    given=[body, gyration, positive_radius],
    by=nonnegative(),
    errata={"": Erratum(r"l \ge 2 r", "coefficient", Origin.PAPER, "with a = r the length is 2 r", (SQUARE,))},
)

deflection = claim(
    "7",
    31,
    r"\arctan\frac{F}{m g} \le \frac{F}{m g}.",
    given=[pulled],
    by=theorems(Applied("arctangent_below_number", (r"\frac{F}{m g}",))),
)
