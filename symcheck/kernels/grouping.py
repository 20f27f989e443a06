"""Sums and products in the order in which a mix of arguments takes least time.

x u v is x (u v) where u and v are numbers and x is an array: one operation on arrays instead of two. SymPy gives the
factors and terms in any order; this one keeps those of one shape together, numbers first. A product is rounded as often
in any order. Of a sum that is so only if no partial sum is larger than what the terms come to: sums of terms that are
not negative are put in order, with one term subtracted at the end, which costs half a unit of the last place at most.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator, Sequence
from operator import add, mul, sub, truediv
from typing import NamedTuple

from symcheck.kernels.tracing import Operand, Pattern, Step, Trace

PRODUCT = frozenset({"multiply", "divide", "negative"})
SUM = frozenset({"add", "subtract"})
POSITIVE = frozenset({"exp", "sqrt", "gamma_ratio", "expm1_ratio", "log1p_ratio"})
ON_FLOATS = {"add": add, "subtract": sub, "multiply": mul, "divide": truediv}
KEEPING = frozenset({"add", "multiply", "divide", "power"})  # not negative of what is not negative


def patterns_of(traced: Trace, patterns: Sequence[Pattern]) -> list[Pattern]:
    """Which axes each value has, of arguments that have these."""
    found = [*patterns]
    for step in traced.steps:
        bits = [each for x in step.operands if type(x) is int and (each := found[x]) is not None]
        union = 0
        for each in bits:
            union |= each
        found.append(union if bits else None)
    return found


def grouped(traced: Trace, patterns: Sequence[Pattern], positive: Collection[int]) -> Trace:
    """The same values by fewer operations on arrays; `positive` are the places of arguments that are not negative."""
    return _Grouping(traced, patterns, positive).result()


class _Parts(NamedTuple):
    """A product or a sum that is not put together yet: what it is of, for each pattern the value of its own parts.

    above  the factors or the terms
    below  what it is divided by, or what is subtracted from it
    """

    above: dict[Pattern, Operand]
    below: dict[Pattern, Operand]


class _Grouping:
    def __init__(self, traced: Trace, patterns: Sequence[Pattern], positive: Collection[int]) -> None:
        self.traced, self.before = traced, patterns_of(traced, patterns)
        self.steps: list[Step] = []
        self.patterns = [*patterns]
        self.held: list[_Parts | Operand] = [*range(traced.arity)]
        self.not_negative = self._signs(positive)
        self.families = [*map(self._family, range(traced.arity + len(traced.steps)))]
        uses = Counter([x for step in traced.steps for x in step.operands if type(x) is int] + [*traced.outputs])
        users = {x: place for place, step in self._places() for x in step.operands if type(x) is int}
        self.inner = {
            x
            for x, user in users.items()
            if uses[x] == 1 and self.families[x] and self.families[x] == self.families[user] and self._opens(x, user)
        }

    def _places(self) -> Iterator[tuple[int, Step]]:
        return enumerate(self.traced.steps, self.traced.arity)

    def _signs(self, positive: Collection[int]) -> list[bool]:
        """Which values are not negative, as far as their operations show."""
        found = [place in positive for place in range(self.traced.arity)]
        for step in self.traced.steps:
            every = all(found[x] if type(x) is int else x >= 0 for x in step.operands)
            square = step.function == "multiply" and len({*step.operands}) == 1
            found.append(step.function in POSITIVE or square or (step.function in KEEPING and every))
        return found

    def _family(self, place: int) -> str:
        """Whether a value may be part of a product or a sum that is put in order."""
        if place < self.traced.arity:
            return ""
        step = self.traced.steps[place - self.traced.arity]
        if step.function in PRODUCT:
            return "product"
        first = step.operands[0]
        ordered = self.not_negative[place] or (
            step.function == "subtract" and (self.not_negative[first] if type(first) is int else first >= 0)
        )
        return "sum" if step.function in SUM and ordered else ""

    def _opens(self, x: int, user: int) -> bool:
        """Whether a sum or a product in another may be taken apart: not where a sum is subtracted."""
        step = self.traced.steps[user - self.traced.arity]
        return step.function != "subtract" or step.operands[0] == x

    def result(self) -> Trace:
        """The operations in their new order."""
        useful = {place for place, _ in self._places() if place not in self.inner and self._gains(place)}
        final = {*self.traced.outputs}
        root: dict[int, int] = {}
        for place, step in reversed([*self._places()]):
            root.setdefault(place, place)
            root |= {x: root[place] for x in step.operands if type(x) is int and x in self.inner}
        for place, step in self._places():
            if root[place] not in useful:
                found = self._step(step.function, *map(self._whole, step.operands))
                self.held.append(found)
                continue
            count = len(self.patterns)
            parts = self._joined(step)
            if place in self.inner:
                self.held.append(parts)
                continue
            found = self._together(parts, self.families[place])
            new = type(found) is int and found >= count
            self.held.append(found if new or place not in final else self._step("multiply", found, 1.0))
        return Trace(self.traced.arity, tuple(self.steps), tuple(int(self._whole(x)) for x in self.traced.outputs))

    def _gains(self, place: int) -> bool:
        """Whether two parts or more have fewer axes than the whole."""
        if not self.families[place] or self.before[place] is None:
            return False
        return sum(pattern != self.before[place] for pattern in self._leaves(place)) > 1

    def _leaves(self, place: int) -> Iterator[Pattern]:
        step = self.traced.steps[place - self.traced.arity]
        if step.function == "negative":
            yield None
        for x in step.operands:
            if x in self.inner:
                yield from self._leaves(int(x))
            else:
                yield self.before[x] if type(x) is int else None

    def _step(self, function: str, *operands: Operand) -> Operand:
        """The value of an operation."""
        bits = [self.patterns[x] for x in operands if type(x) is int]
        known = [each for each in bits if each is not None]
        union = 0
        for each in known:
            union |= each
        self.patterns.append(union if known else None)
        self.steps.append(Step(function, operands))
        return len(self.patterns) - 1

    def _pattern(self, x: Operand) -> Pattern:
        return self.patterns[x] if type(x) is int else None

    def _whole(self, x: Operand) -> Operand:
        """A value that stands alone."""
        if type(x) is not int:
            return x
        found = self.held[x]
        assert not isinstance(found, _Parts)
        return found

    def _parts(self, x: Operand) -> _Parts:
        found = self.held[x] if type(x) is int else x
        return found if isinstance(found, _Parts) else _Parts({self._pattern(found): found}, {})

    def _joined(self, step: Step) -> _Parts:
        """The parts of an operation, each with those of the same axes."""
        first = self._parts(step.operands[0])
        if step.function == "negative":
            return _Parts(self._merged("multiply", {None: -1.0}, first.above), first.below)
        second = self._parts(step.operands[1])
        if step.function in ("divide", "subtract"):
            second = _Parts(second.below, second.above)
        joined = "multiply" if step.function in PRODUCT else "add"
        return _Parts(*(self._merged(joined, x, y) for x, y in zip(first, second, strict=True)))

    def _merged(
        self, function: str, first: dict[Pattern, Operand], second: dict[Pattern, Operand]
    ) -> dict[Pattern, Operand]:
        found = {**first}
        for pattern, x in second.items():
            found[pattern] = self._applied(function, found[pattern], x) if pattern in found else x
        return found

    def _applied(self, function: str, x: Operand, y: Operand) -> Operand:
        """An operation, without those that change nothing."""
        if function == "multiply":
            for one, other in ((x, y), (y, x)):
                if one == 1.0 and type(one) is float:
                    return other
                if one == -1.0 and type(one) is float:
                    return -other if type(other) is float else self._step("negative", other)
        if type(x) is type(y) is float:
            folded: float = ON_FLOATS[function](x, y)
            return folded
        return self._step(function, x, y)

    def _together(self, parts: _Parts, family: str) -> Operand:
        """The value of some parts: those with the fewest axes first."""
        join, inverse = ("multiply", "divide") if family == "product" else ("add", "subtract")
        above: Operand | None = None
        below: Operand | None = None
        for pattern in sorted({*parts.above, *parts.below}, key=lambda x: (x is not None, (x or 0).bit_count())):
            for own, sign in ((parts.above, True), (parts.below, False)):
                if pattern in own:
                    before = above if sign else below
                    joined = own[pattern] if before is None else self._applied(join, before, own[pattern])
                    above, below = (joined, below) if sign else (above, joined)
            if type(above) is float and abs(above) == 1.0 and below is not None and family == "product":
                below, above = self._applied(join, above, below), None  # 1/u is rounded once more than needed
            if above is not None and below is not None:
                above, below = self._applied(inverse, above, below), None
        if below is not None:  # of a product: a sum has what it is subtracted from
            above = self._step("divide", 1.0, below)
        assert above is not None
        return above
