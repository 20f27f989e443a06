"""Groebner bases that remember where they come from (Buchberger's algorithm, degree reverse lexicographic order).

Every element knows the combination of earlier elements it was made of; the combination of the *inputs* is worked out
only for the elements a proof uses.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from heapq import heappop, heappush
from itertools import combinations

from symcheck.proof.algebra.flint import Poly

Monomial = tuple[int, ...]
LONG = 10  # terms: the S-polynomial of longer polynomials counts for several
PAIRS = 2000  # S-polynomials of one basis: the orthogonal matrices take fewer, and what takes more takes minutes


def leading(poly: Poly) -> Monomial:
    """Exponents of the leading term."""
    return tuple(int(e) for e in poly.monomial(0))


def divides(a: Monomial, b: Monomial) -> bool:
    """Whether monomial a divides monomial b."""
    return all(x <= y for x, y in zip(a, b, strict=True))


def lcm(a: Monomial, b: Monomial) -> Monomial:
    """Least common multiple of two monomials."""
    return tuple(map(max, a, b))


@dataclass
class Node:
    """A polynomial and the combination of earlier nodes it equals (none for an input)."""

    poly: Poly
    parents: list[tuple[Poly, int]] = field(default_factory=list)
    lead: Monomial = ()


class Basis:
    """The reduced Groebner basis of the inputs; `complete` is False if the limit of pairs was reached first."""

    def __init__(self, inputs: Sequence[Poly], pairs: int = PAIRS, settled: int = 0) -> None:
        """The first `settled` inputs are a reduced basis already: no pair of them is looked at again."""
        self.nodes = [Node(poly, [], leading(poly) if k < settled else ()) for k, poly in enumerate(inputs)]
        self.inputs = len(inputs)
        self.active: list[int] = list(range(settled))
        self.complete = True
        self._limit = pairs
        self._queue: list[tuple[int, Monomial, int, int]] = []
        self._done: set[tuple[int, int]] = set(combinations(range(settled), 2))
        fresh = [i for i in range(settled, self.inputs) if inputs[i] != 0]
        for index in sorted(fresh, key=lambda i: self._size(inputs[i])):
            self._insert(inputs[index], [(inputs[index] * 0 + 1, index)])
        self._run()
        self._interreduce()

    @staticmethod
    def _size(poly: Poly) -> tuple[int, Monomial]:
        return int(poly.total_degree()), leading(poly)

    def polys(self) -> list[Poly]:
        """The basis elements, monic."""
        return [self.nodes[i].poly for i in self.active]

    def reduce(self, poly: Poly, skip: int = -1) -> tuple[Poly, list[tuple[Poly, int]]]:
        """(remainder, quotients by node): poly = remainder + sum quotient * node."""
        quotients: list[tuple[Poly, int]] = []
        changed = poly != 0
        while changed and poly != 0:
            changed = False
            for index in self.active:
                if index == skip:
                    continue
                quotient, rest = divmod(poly, self.nodes[index].poly)
                if quotient != 0:
                    quotients.append((quotient, index))
                    poly, changed = rest, True
        return poly, quotients

    def express(self, quotients: list[tuple[Poly, int]]) -> dict[int, Poly]:
        """The combination of nodes as a combination of the inputs: {input: cofactor}."""
        total: dict[int, Poly] = {}
        for quotient, index in quotients:
            total[index] = total[index] + quotient if index in total else quotient
        result: dict[int, Poly] = {}
        while total:
            index = max(total)
            cofactor = total.pop(index)
            if cofactor == 0:
                continue
            if index < self.inputs:
                result[index] = cofactor
                continue
            for factor, parent in self.nodes[index].parents:
                product = factor * cofactor
                total[parent] = total[parent] + product if parent in total else product
        return result

    def _insert(self, poly: Poly, parents: list[tuple[Poly, int]]) -> None:
        """Adds what is left of a polynomial of the ideal, and takes out the elements it makes superfluous."""
        poly, quotients = self.reduce(poly)
        if poly == 0:
            return
        scale = poly.leading_coefficient()
        parents = [(p / scale, i) for p, i in parents] + [(-q / scale, i) for q, i in quotients]
        new, lead = len(self.nodes), leading(poly)
        self.nodes.append(Node(poly / scale, parents, lead))
        if poly.is_constant():
            self.active, self._queue = [new], []
            return
        outdated = [i for i in self.active if divides(lead, self.nodes[i].lead)]
        self.active = [i for i in self.active if i not in outdated]
        for i in self.active:
            common = lcm(lead, self.nodes[i].lead)
            heappush(self._queue, (sum(common), common, i, new))
        self.active.append(new)
        one = poly * 0 + 1
        for i in outdated:
            self._insert(self.nodes[i].poly, [(one, i)])

    def _run(self) -> None:
        work = 0  # S-polynomials, long ones counted for several
        while self._queue:
            _, common, i, j = heappop(self._queue)
            if i not in self.active or j not in self.active:
                continue
            self._done.add((i, j))
            if self._superfluous(i, j, common):
                continue
            work += 1 + (len(self.nodes[i].poly) + len(self.nodes[j].poly)) // LONG
            if work > self._limit:
                self.complete = False
                return
            self._insert_s_polynomial(i, j, common)

    def _superfluous(self, i: int, j: int, common: Monomial) -> bool:
        """Buchberger's product and chain criteria."""
        a, b = self.nodes[i].lead, self.nodes[j].lead
        if not any(x and y for x, y in zip(a, b, strict=True)):
            return True
        return any(
            k not in (i, j)
            and divides(self.nodes[k].lead, common)
            and (min(i, k), max(i, k)) in self._done
            and (min(j, k), max(j, k)) in self._done
            for k in self.active
        )

    def _insert_s_polynomial(self, i: int, j: int, common: Monomial) -> None:
        context = self.nodes[i].poly.context()
        left, right = (
            context.from_dict({tuple(c - e for c, e in zip(common, self.nodes[k].lead, strict=True)): 1})
            for k in (i, j)
        )
        self._insert(left * self.nodes[i].poly - right * self.nodes[j].poly, [(left, i), (-right, j)])

    def _interreduce(self) -> None:
        for position, index in enumerate(self.active):
            tree = self.nodes[index]
            rest, quotients = self.reduce(tree.poly, skip=index)
            if quotients:
                new = len(self.nodes)
                parents = [(tree.poly * 0 + 1, index)] + [(-q, i) for q, i in quotients]
                self.nodes.append(Node(rest, parents, tree.lead))
                self.active[position] = new


def components(polys: Sequence[Poly]) -> list[list[int]]:
    """Indices of the polynomials, grouped so that groups share no variable."""
    used = [{k for k, degree in enumerate(poly.degrees()) if degree} for poly in polys]
    groups: list[tuple[set[int], list[int]]] = []
    for index, support in enumerate(used):
        touching = [g for g in groups if g[0] & support]
        groups = [g for g in groups if not g[0] & support]
        members = sorted([i for g in touching for i in g[1]] + [index])
        groups.append((support.union(*(g[0] for g in touching)), members))
    return [members for _, members in groups]
