"""Terms that are manifestly positive or not negative, found as the checker finds them, with a proof term of Coq."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from symcheck.coq.assumptions import Assumptions
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


class Signs(Assumptions):
    """Signs from what is known."""

    def sign(self, term: Term) -> Sign | None:
        """A proof that a term is manifestly positive or not negative, found as the checker finds it."""
        match term:
            case int():
                if term < 0:
                    return None
                return Sign(2, f"(num_pos {term})") if term else Sign(1, "(Rle_refl 0)")
            case Value(tag="pi"):
                return Sign(2, "PI_RGT_0")
            case Value(tag="+", terms=parts):
                found = self._of_sum(parts)
            case Value(tag="*", terms=parts):
                found = self._of_product(term, parts)
            case Value(tag="/", terms=(top, bottom)):
                found = self._of_quotient(top, bottom)
            case Value(tag="^", terms=(base, int(n))) if n > 0:
                found = self._of_power(base, n)
            case Value(tag="sqrt", terms=(int(number),)) if number > 0:
                return Sign(2, f"(sqrt_lt_R0 _ (num_pos {number}))")
            case _:
                found = None
        return found or self._known(term)

    def positive(self, term: Term) -> str | None:
        """A proof term of 0 < t, if that is manifest."""
        found = self.sign(term)
        return found.proof if found and found.level == 2 else None

    def _of_sum(self, parts: Sequence[Term]) -> Sign | None:
        found: Sign | None = None
        for k, part in enumerate(parts):
            other = self.sign(part)
            if other is None:
                return None
            if k == 0 or found is None:
                found = other
            else:
                kind = ("n" if found.level == 1 else "p") + ("n" if other.level == 1 else "p")
                found = Sign(max(found.level, other.level), f"(add_{kind} {found.proof} {other.proof})")
        return found

    def _of_product(self, term: Term, parts: Sequence[Term]) -> Sign | None:
        single = [t for k, t in enumerate(parts) if parts.count(t) % 2 and t not in parts[:k]]
        distinct = [t for k, t in enumerate(parts) if t not in parts[:k]]
        squares: list[Term] = [node("^", t, 2) for t in distinct for _ in range(parts.count(t) // 2)]
        arranged = [*squares, *single] if squares else parts
        found: Sign | None = None
        for part in arranged:
            other = self.sign(part)
            if other is None:
                return None
            if found is None:
                found = other
            elif found.level == other.level == 2:
                found = Sign(2, f"(mul_pp {found.proof} {other.proof})")
            else:
                found = Sign(1, f"(mul_nn {found.weak} {other.weak})")
        if found is None or not squares:
            return found
        kind = "eq_pos" if found.level == 2 else "eq_nn"
        relation = node("<" if found.level == 2 else "<=", 0, term)
        return Sign(found.level, self.prove_aside(relation, "s", f"refine ({kind} {found.proof} _); ring"))

    def _of_quotient(self, top: Term, bottom: Term) -> Sign | None:
        above, below = self.sign(top), self.sign(bottom)
        if above is None or below is None:
            return None
        if above.level == 2 and below.level == 1 and spelled(bottom) in self.nonzero:
            below = Sign(2, f"(nz_pos {below.proof} {self.nonzero[spelled(bottom)][0]})")
        if above.level == below.level == 2:
            return Sign(2, f"(div_pp {above.proof} {below.proof})")
        return Sign(1, f"(div_nn {above.weak} {below.weak})")

    def _of_power(self, base: Term, n: int) -> Sign | None:
        found = self.sign(base)
        if found is not None:
            kind = "pow_pp" if found.level == 2 else "pow_nn"
            return Sign(found.level, f"({kind} {n} {found.proof})")
        return Sign(1, f"(pow_even ({spelled(base)}) {n} eq_refl)") if n % 2 == 0 else None

    def _known(self, term: Term) -> Sign | None:
        wanted = value(term)
        for known in self.facts(">", ">="):
            if value(known.difference) != wanted:
                continue
            level = 3 - len(known.sign)
            great, small = known.sides
            if small == 0 and spelled(great) == spelled(term):
                return Sign(level, known.hypothesis)
            lemma, gap = ("eq_pos", "lt_pos") if level == 2 else ("eq_nn", "le_nn")
            by = f"refine ({lemma} ({gap} {known.hypothesis}) _); {self.algebra}"
            return Sign(level, self.prove_aside(node("<" if level == 2 else "<=", 0, term), "s", by))
        return None
