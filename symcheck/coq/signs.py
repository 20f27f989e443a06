"""Terms that are manifestly positive or not negative, found as the checker finds them, with a proof term of Coq."""

from __future__ import annotations

from collections.abc import Iterable
from functools import reduce
from typing import NamedTuple

from symcheck.coq.assumptions import State
from symcheck.coq.printing import spelled
from symcheck.coq.values import value
from symcheck.core.terms import Term, Value, node


class Sign(NamedTuple):
    """A proof term of 0 < t (level 2) or 0 <= t (level 1)."""

    level: int
    proof: str

    @property
    def weak(self) -> str:
        return f"(Rlt_le _ _ {self.proof})" if self.level == 2 else self.proof


def sign(state: State, term: Term) -> Sign | None:
    """A proof that a term is manifestly positive or not negative, if the checker finds it so."""
    found: Sign | None = None
    match term:
        case int():
            if term < 0:
                return None
            return Sign(2, f"(num_pos {term})") if term else Sign(1, "(Rle_refl 0)")
        case Value(tag="pi"):
            return Sign(2, "PI_RGT_0")
        case Value(tag="+", terms=parts) if terms := _all(state, parts):
            found = reduce(_sum, terms)
        case Value(tag="*"):
            found = _of_product(state, term)
        case Value(tag="/", terms=(top, bottom)):
            found = _of_quotient(state, top, bottom)
        case Value(tag="^", terms=(base, int(n))) if n > 0:
            found = _of_power(state, base, n)
        case Value(tag="sqrt", terms=(inner,)) if radicand := positive(state, inner):
            return Sign(2, f"(sqrt_lt_R0 _ {radicand})")
    return found or _by_fact(state, term)


def positive(state: State, term: Term) -> str | None:
    """A proof term of 0 < t, if that is manifest."""
    found = sign(state, term)
    return found.proof if found and found.level == 2 else None


def _all(state: State, terms: Iterable[Term]) -> list[Sign]:
    """The signs of all terms; empty if one has none."""
    found = []
    for term in terms:
        if (one := sign(state, term)) is None:
            return []
        found.append(one)
    return found


def _sum(one: Sign, other: Sign) -> Sign:
    kind = "".join("n" if sign.level == 1 else "p" for sign in (one, other))
    return Sign(max(one.level, other.level), f"(add_{kind} {one.proof} {other.proof})")


def _product(one: Sign, other: Sign) -> Sign:
    if one.level == other.level == 2:
        return Sign(2, f"(mul_pp {one.proof} {other.proof})")
    return Sign(1, f"(mul_nn {one.weak} {other.weak})")


def _of_product(state: State, term: Value) -> Sign | None:
    """Equal factors pair up to squares."""
    parts = term.terms
    distinct = list(dict.fromkeys(parts))
    squares: list[Term] = [node("^", t, 2) for t in distinct for _ in range(parts.count(t) // 2)]
    single = [t for t in distinct if parts.count(t) % 2]
    if not (terms := _all(state, [*squares, *single] if squares else parts)):
        return None
    found = reduce(_product, terms)
    if not squares:
        return found
    kind, relation = ("eq_pos", "<") if found.level == 2 else ("eq_nn", "<=")
    by = f"refine ({kind} {found.proof} _); ring"
    return Sign(found.level, state.prove_aside(node(relation, 0, term), "s", by))


def _of_quotient(state: State, top: Term, bottom: Term) -> Sign | None:
    above, below = sign(state, top), sign(state, bottom)
    if above is None or below is None:
        return None
    if above.level == 2:
        below = not_zero(state, bottom, below)
    if above.level == below.level == 2:
        return Sign(2, f"(div_pp {above.proof} {below.proof})")
    return Sign(1, f"(div_nn {above.weak} {below.weak})")


def not_zero(state: State, term: Term, sign: Sign) -> Sign:
    """The sign of a term; if it is known not to vanish, it is positive and not only not negative."""
    if sign.level == 1 and spelled(term) in state.nonzero:
        return Sign(2, f"(nz_pos {sign.proof} {state.nonzero[spelled(term)][0]})")
    return sign


def _of_power(state: State, base: Term, n: int) -> Sign | None:
    if found := sign(state, base):
        return Sign(found.level, f"({'pow_pp' if found.level == 2 else 'pow_nn'} {n} {found.proof})")
    return Sign(1, f"(pow_even ({spelled(base)}) {n} eq_refl)") if n % 2 == 0 else None


def _by_fact(state: State, term: Term) -> Sign | None:
    wanted = value(term)
    for known in state.facts(">", ">="):
        if value(known.difference) != wanted:
            continue
        level = 3 - len(known.sign)
        great, small = known.sides
        if small == 0 and spelled(great) == spelled(term):
            return Sign(level, known.hypothesis)
        lemma, gap, relation = ("eq_pos", "lt_pos", "<") if level == 2 else ("eq_nn", "le_nn", "<=")
        by = f"refine ({lemma} ({gap} {known.hypothesis}) _); {state.algebra}"
        return Sign(level, state.prove_aside(node(relation, 0, term), "s", by))
    return None
