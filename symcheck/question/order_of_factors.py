r"""Whether an equation relies on the order of factors, which matters for matrices, operators and quaternions.

Capital letters, letters with a hat and those with a dagger may be such; letters with subscripts and Greek ones beside
them, as in \sigma_x \sigma_y = \sigma_y \sigma_x, where nothing else is said than that their order makes no difference.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable
from fractions import Fraction
from itertools import combinations, pairwise

from symcheck.reading import Tree, to_latex
from symcheck.reading.tree import Add, Call, Chain, Div, Mul, Name, Neg, Number, Pow, Root, Sqrt, walk

MAX_POWER = 4  # of a sum in capital letters; more is hardly ever printed
Word = tuple[str, ...]  # factors in order; those whose order makes no difference before them, sorted
Polynomial = dict[Word, Fraction]
Ordered = Callable[[str], bool]  # whether the order of a letter among others makes a difference
# a letter that may be an operator: with a hat or a dagger
_OPERATOR = re.compile(r"\\(?:wide)?hat\b|\\dag(?:ger)?\b")
# a letter that is often one of several matrices: a capital or Greek one with a subscript
_MEMBER = re.compile(r"(?:[A-Z]|\\[a-z]+)_")


def relying_on_order(tree: Tree, scalars: set[str]) -> list[str]:
    """The letters that may be no numbers, if sides of an equation are equal only if these commute."""
    if not isinstance(tree, Chain) or set(tree.signs) != {"="}:
        return []
    letters = sorted(_letters(tree))
    spelled = {re.sub(r"[\s{}]", "", x): x for x in letters}
    plain = {x for short, x in spelled.items() if rf"{short}^\dagger" in spelled}  # those of which the adjoint occurs

    def is_strong(letter: str) -> bool:
        alone = len(letter) == 1 and letter.isupper()
        return letter not in scalars and (alone or letter in plain or bool(_OPERATOR.search(letter)))

    def is_weak(letter: str) -> bool:
        return is_strong(letter) or (letter not in scalars and bool(_MEMBER.match(letter)))

    for one, other in pairwise(tree.members):
        ordered = is_weak if _is_of_order_alone(one, other) else is_strong
        if _relies(one, other, ordered):
            return [x for x in letters if ordered(x)]
    return []


def commuted(tree: Tree, known: set[str]) -> list[str]:
    """The letters that are no numbers if a printed difference as `a b - b a` is not zero, but for those known."""
    sums = (part for _, part in walk(tree) if isinstance(part, Add))
    return next((sorted(found) for found in (_commuted(part) - known for part in sums) if len(found) > 1), [])


def _commuted(tree: Add) -> set[str]:
    """The letters of two products that are printed with other signs and in another order, as those of a commutator."""
    terms = [(isinstance(term, Neg), term.value if isinstance(term, Neg) else term) for term in tree.terms]
    products = [(sign, term) for sign, term in terms if isinstance(term, Mul)]
    for (sign, one), (other_sign, other) in combinations(products, 2):
        if sign != other_sign and one != other and Counter(one.factors) == Counter(other.factors):
            return _letters(one)
    return set()


def _letters(tree: Tree) -> set[str]:
    return {part.letter for _, part in walk(tree) if isinstance(part, Name)}


def _is_of_order_alone(one: Tree, other: Tree) -> bool:
    """Are both sides products, or is it said that a difference is zero?"""
    return (isinstance(one, Mul) and isinstance(other, Mul)) or Number("0") in (one, other)


def _relies(one: Tree, other: Tree, ordered: Ordered) -> bool:
    a, b = (_expanded(side, ordered) for side in (one, other))
    if a is None or b is None or a == b:
        return False
    return _expanded(one, _never) == _expanded(other, _never)


def _never(letter: str) -> bool:
    return False


def _expanded(tree: Tree, ordered: Ordered) -> Polynomial | None:
    """A polynomial as its words with their coefficients; None if it is something else."""
    match tree:
        case Number(text):
            return {(): Fraction(text)} if Fraction(text) else {}
        case Name(letter):
            return {(letter,): Fraction(1)}
        case Neg(value):
            inner = _expanded(value, ordered)
            return None if inner is None else {word: -n for word, n in inner.items()}
        case Add(terms):
            return _sum([_expanded(term, ordered) for term in terms])
        case Mul(factors):
            return _product([_expanded(factor, ordered) for factor in factors], ordered)
        case Pow(base, Number(text)) if text.isdigit() and 0 < int(text) <= MAX_POWER:
            return _product([_expanded(base, ordered)] * int(text), ordered)
        case Pow(Mul(factors), Neg(Number("1"))):
            return _product([_expanded(Pow(each, Neg(Number("1"))), ordered) for each in reversed(factors)], ordered)
        case Pow(Name(letter), Neg(Number("1"))):
            return {(f"{letter}^-1",): Fraction(1)}
        case Pow(Mul(factors), exponent) if sum(any(map(ordered, _letters(each))) for each in factors) < 2:
            return _product([_expanded(Pow(each, exponent), ordered) for each in factors], ordered)
        case Pow(_, exponent) if not any(map(ordered, _letters(exponent))):
            return {(to_latex(tree),): Fraction(1)}
        case Div(top, bottom) if not any(map(ordered, _letters(bottom))):
            return _product([_over(bottom), _expanded(top, ordered)], ordered)
        case Call() | Sqrt() | Root() if not any(map(ordered, _letters(tree))):
            return {(to_latex(tree),): Fraction(1)}
    return None


def _over(bottom: Tree) -> Polynomial | None:
    """The reciprocal of what commutes."""
    if isinstance(bottom, Number):
        return {(): 1 / Fraction(bottom.text)} if Fraction(bottom.text) else None
    return {(f"1/{to_latex(bottom)}",): Fraction(1)}


def _sum(parts: list[Polynomial | None]) -> Polynomial | None:
    total: Counter[Word] = Counter()
    for part in parts:
        if part is None:
            return None
        total.update(part)
    return {word: Fraction(n) for word, n in total.items() if n}


def _product(parts: list[Polynomial | None], ordered: Ordered) -> Polynomial | None:
    product: Polynomial = {(): Fraction(1)}
    for part in parts:
        if part is None:
            return None
        terms = [{_sorted(a + b, ordered): m * n} for a, m in product.items() for b, n in part.items()]
        if (product_ := _sum([*terms])) is None:
            return None
        product = product_
    return product


def _sorted(word: Word, ordered: Ordered) -> Word:
    """The word with what commutes in front, and what cancels left out."""
    free = sorted(x for x in word if not _has_order(x, ordered))
    kept: list[str] = []
    for x in word:
        if not _has_order(x, ordered):
            continue
        if kept and (kept[-1] == f"{x}^-1" or x == f"{kept[-1]}^-1"):
            kept.pop()
        else:
            kept.append(x)
    return (*free, *kept)


def _has_order(factor: str, ordered: Ordered) -> bool:
    """Is it a letter of which the order matters, or a power of one or of a product with one?"""
    if ordered(factor):
        return True
    base = factor.rpartition("^")[0]
    return bool(base) and any(ordered(x) for x in re.findall(_IN_POWER, base))


# a letter with its subscript, in what stands under an exponent
_IN_POWER = re.compile(r"\\?[A-Za-z]+(?:_(?:\{[^{}]*\}|\w))?")
