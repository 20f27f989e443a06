"""A kernel: one expression of a paper's derivation that becomes a function of arrays."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from symcheck.core.claims import Hypothesis
from symcheck.core.lazy import lazy
from symcheck.core.verdicts import SymcheckError
from symcheck.kernels.specification import Argument as Argument
from symcheck.kernels.specification import Output as Output

sp = lazy("sympy")


@dataclass(frozen=True, kw_only=True)
class Kernel:
    """One declaration of `papers/<key>/kernels.py`; everything else is made from it.

    says        one sentence for the docstring
    derived     the derivation: outputs by name as SymPy expressions of the arguments
    claims      the relations of the ledger that rest on the same derivation ("2.12", "T3.1a"); they must be proved
    accurate    forms of some outputs that lose no digits where the derived one does; each is proved equal to it
    given       hypotheses of that proof, in the paper's notation
    ulp         the largest error in units of the last place, over the domain; `condition` says why it exceeds 4
    scale       the scale whose last place `ulp` counts, of outputs with a zero inside the domain; see `largest_addend`
    degenerate  what happens at the ends of the domain
    """

    says: str
    arguments: tuple[Argument, ...]
    outputs: tuple[Output, ...]
    derived: Callable[[], Mapping[str, Any]]
    claims: tuple[str, ...]
    accurate: Callable[[], Mapping[str, Any]] | None = None
    given: tuple[Hypothesis, ...] = ()
    ulp: int = 4
    condition: str = ""
    scale: Callable[[], Mapping[str, Any]] | None = None
    degenerate: str = ""

    def __post_init__(self) -> None:
        names = [argument.name for argument in self.arguments] + [output.name for output in self.outputs]
        if twice := sorted({name for name in names if names.count(name) > 1}):
            raise SymcheckError(f"a kernel declares {twice[0]} twice; give one of them another name")
        if not self.claims:
            raise SymcheckError(f"the kernel of {', '.join(names)} names no claims; name the relations it rests on")
        if self.scale and not self.condition:
            raise SymcheckError(f"the kernel of {', '.join(names)} counts ulp of a scale; say of which in condition=")
        if self.ulp > 4 and not self.condition:
            raise SymcheckError(f"the kernel of {', '.join(names)} allows {self.ulp} ulp; say why in condition=")


def largest_addend(expression: Any) -> Any:
    """The scale of a sum: the largest absolute value among its terms.

    Where terms cancel, rounding one of them changes all digits of the sum; no form of it is accurate in its own units.
    """
    return sp.Max(*(sp.Abs(term) for term in expression.as_ordered_terms()))
