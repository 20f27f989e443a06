"""Printed terms as sums of products of some of their letters, each with what it is multiplied with."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable

from symcheck.core.verdicts import NoForm
from symcheck.reading import Tree, to_latex
from symcheck.reading.tree import Add, Div, Mul, Name, Neg, Number, Pow, nodes

Monomial = tuple[str, ...]  # letters in alphabetical order, each as often as it is a factor
HIGHEST = 6  # power of what is expanded
ONE = Number("1")


def expanded(tree: Tree, own: Callable[[Tree], str], put: Callable[[Tree], Tree]) -> list[tuple[Monomial, Tree]]:
    """The products in a term, each with what it is multiplied with; NoForm if it is no sum of products.

    Parameters
    ----------
    tree
        The term.
    own
        The name of a letter that stands in the products, "" for everything else.
    put
        What to print for a part in which none of these letters stands.
    """

    def below(part: Tree) -> list[tuple[Monomial, Tree]]:
        return expanded(part, own, put)

    if not any(map(own, nodes(tree))):
        return [((), put(tree))]
    if name := own(tree):
        return [((name,), ONE)]
    match tree:
        case Add(terms):
            return [each for term in terms for each in below(term)]
        case Neg(value):
            return [(monomial, Neg(each)) for monomial, each in below(value)]
        case Div(top, bottom) if not any(map(own, nodes(bottom))):
            return [(monomial, Div(each, put(bottom))) for monomial, each in below(top)]
        case Mul(factors):
            found: list[tuple[Monomial, Tree]] = [((), ONE)]
            for factor in factors:
                more = below(factor)
                found = [(tuple(sorted(a + b)), Mul((x, y))) for a, x in found for b, y in more]
            return found
        case Pow(base, Number(text)) if text.isdigit() and 0 < int(text) <= HIGHEST:
            return below(Mul((base,) * int(text)))
    raise NoForm(f"{to_latex(tree)} is no sum of products of numbers and of letters that vary")


def total(addends: list[tuple[Monomial, Tree]], of: Callable[[Monomial], Tree]) -> Tree:
    """The sum of products, with something for the letters of each."""
    return Add((Number("0"), *(Mul((each, of(monomial))) for monomial, each in addends)))


class Named:
    """Letters for what stands for products: the first is m_1."""

    def __init__(self, letter: str) -> None:
        self.letter, self.names = letter, dict[Monomial, str]()

    def __call__(self, monomial: Monomial) -> Tree:
        number = len(self.names) + 1
        name = f"{self.letter}_{number}" if number < 10 else f"{self.letter}_{{{number}}}"
        return Name(self.names.setdefault(monomial, name))

    def shown(self) -> dict[str, str]:
        """The product for which each letter is, as X^2 Y."""
        return {
            name: " ".join(_power(*each) for each in Counter(product).items()) for product, name in self.names.items()
        }

    def even(self) -> list[tuple[Monomial, str]]:
        """The products that are squares, with their letters."""
        return [each for each in self.names.items() if all(n % 2 == 0 for n in Counter(each[0]).values())]


def _power(x: str, n: int) -> str:
    return x if n == 1 else f"{x}^{n}"
