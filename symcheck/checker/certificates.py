"""Whether a certificate shows what it says: its verdict, from its own proof or point and from proved lemmas."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator
from functools import lru_cache

from symcheck.checker.algebra import Algebra, exact
from symcheck.checker.residues import PRIME, Reject, require
from symcheck.checker.rules import LIST, Prover, Step, fit, paired, truth
from symcheck.checker.theorems import instance
from symcheck.core.calculus import Unknown, domain, functions, letters, substituted
from symcheck.core.formulas import FALSE, conjuncts, contrary, sides
from symcheck.core.terms import (
    JSON,
    Call,
    Connective,
    Formula,
    Malformed,
    Node,
    Quantified,
    Reader,
    Relation,
    Term,
    Value,
    node,
)

MALFORMED = (LookupError, TypeError, ValueError, AttributeError, ArithmeticError, RecursionError, AssertionError)


@lru_cache(1024)
def reader(definitions: str) -> Reader:
    """A reader that knows the definitions, a JSON text: many certificates have the same ones, read once for all."""
    found = Reader()
    for name, term in json.loads(definitions):
        found.define(fit(str, name), term)
    return found


class Certificate:
    """What is stated, definitions unfolded, and the evidence: a proof with witnesses, or a point."""

    def __init__(self, data: JSON) -> None:
        self.step = step = Step(data)
        self.id, self.verdict = fit(str, step.take("id")), fit(str, step.take("verdict"))
        free = step.texts("free")  # defined letters of which lemmas say all that the proof knows
        definitions = step.lists("definitions", 2)
        self.whole = reader(json.dumps(definitions))
        self.reader = reader(json.dumps([each for each in definitions if each[0] not in free])) if free else self.whole
        require({*free} <= self.whole.names.keys(), "{} are not all defined", free)
        self.own = {x: self.whole.names[x] for x in free}
        self.hypotheses = {
            ("hyp", name, k): self.read(formula)
            for name, formulas in step.mapping("hypotheses").items()
            for k, formula in enumerate(fit(LIST, formulas))
        }
        self.nonzero = [self.read(["!=", term, 0]) for term in step.items("nonzero")]
        self.lemmas = [(fit(str, name), self.read(formula)) for name, formula in step.lists("lemmas", 2)]
        self.claim = self.read(step.take("claim"))

    def read(self, data: JSON) -> Formula:
        """A formula; no binder binds a letter that stands for something."""
        found = self.reader.formula(data)
        same = not self.own or self.unfolded(found) == self.whole.formula(data)
        require(same, "{} is bound in {}", [*self.own], found)
        return found

    def unfolded(self, formula: Formula) -> Formula:
        """The formula with all definitions unfolded."""
        return substituted(formula, self.own) if self.own else formula

    def assumed(self) -> list[Formula]:
        """Hypotheses, and what must not vanish, definitions unfolded."""
        return [part for each in (*self.hypotheses.values(), *self.nonzero) for part in conjuncts(self.unfolded(each))]

    def supported(self, proved: Iterable[Certificate]) -> bool:
        """Whether each lemma is part of a statement that is proved under no more than is assumed here.

        What a lemma says of a letter holds of what the letter is defined to be here.
        """
        mean, assumed, names = self.whole.names, self.assumed(), [name for name, _ in self.lemmas]
        stated = [
            (lemma.id, part)
            for lemma in proved
            if lemma.id in names and all(substituted(each, mean) in assumed for each in lemma.assumed())
            for part in conjuncts(substituted(lemma.unfolded(lemma.claim), mean))
        ]
        return all((name, self.unfolded(formula)) in stated for name, formula in self.lemmas)

    def check(self) -> None:
        """Rejects unless the evidence shows the verdict; lemmas are taken for granted."""
        require(self.verdict in ("proved", "refuted"), "the verdict {}", self.verdict)
        (self.check_proof if self.verdict == "proved" else self.check_point)()
        self.step.end()

    def check_proof(self) -> None:
        """The claim follows, no denominator vanishes, each hypothesis is used, all that is assumed holds somewhere."""
        prover = Prover(self.reader)
        for name, formula in self.hypotheses.items():
            prover.learn(name, formula)
        for term in sides(self.claim) if self.nonzero else ():
            prover.value(term)
        aside = Algebra(self.reader.names)  # what the terms listed are divided by is not the statement's own
        listed = [formula.outside[0] for formula in self.nonzero]
        prover.listed = dict(zip(aside.residues(listed), listed, strict=True))
        prover.tops = {*aside.residues(t.terms[0] for t in listed if isinstance(t, Value) and t.tag == "/")}
        met = {*prover.algebra.divisors, *self.quantified(self.claim)} if self.nonzero else set()
        superfluous = prover.listed.keys() - met
        require(not superfluous, "{} is no denominator of the statement", [prover.listed[v] for v in superfluous])
        facts = [formula for _, formula in self.lemmas]
        goal = node("=>", node("and", *facts), self.claim) if facts else self.claim
        prover.prove(goal, self.step.take("proof"))
        prover.finish()
        require(prover.used >= self.hypotheses.keys() or facts, "a hypothesis is not used")
        self.check_witnesses()

    def quantified(self, formula: Formula, bound: frozenset[str] = frozenset()) -> Iterator[int]:
        """The values of denominators under quantifiers that are the same for all values of the letters bound there."""
        if isinstance(formula, Relation) and bound:
            inner = Algebra(self.reader.names)
            inner.residues(formula.terms)
            yield from (v for v, term in inner.divisors.items() if term is not None and not letters(term) & bound)
        elif not isinstance(formula, Relation):
            for part in (*formula.inside, *formula.outside):
                assert isinstance(part, Node)
                yield from self.quantified(part, bound.union(formula.bound))

    def check_witnesses(self) -> None:
        """Everything that is assumed holds somewhere, the premises of each implication too, and all terms have values.

        What does so without letters needs no point.
        """
        assumed, claim = self.assumed(), self.unfolded(self.claim)
        conditions = domain(*assumed, claim)
        varying = [each for each in conditions if letters(each) or functions(each)]
        for each in conditions:
            require(each in varying or truth(each, Algebra({}, {})), "a term has no value, as {} is not so", each)
        needed = [[*assumed, *premises, *varying] for premises in supposed(claim)]
        points = self.step.items("witnesses")
        require(points or needed == [[]], "no point where all that is assumed holds")
        for formulas, point in paired(needed, points) if points else ():
            self.hold(formulas, Step(point))

    def check_point(self) -> None:
        """The hypotheses hold at the point, the claim does not; its sides have the stated values there."""
        require(not self.lemmas, "a point needs no lemmas")
        step = Step(self.step.take("point"))
        claim, stated = self.unfolded(self.claim), step.items("sides")
        shown = step.lists("enclosed", 4, "term with digits and two ends")
        own, another = [*claim.outside] if stated else [], "a side has another value at the point"
        require(len(own) == len(stated), another)
        values = [self.valued(*pair) for pair in zip(own, stated, strict=True)]
        shows = values if "proof" in step.data else []  # where values of functions are proved, they are with the rest
        at = self.hold([*self.assumed(), contrary(claim), *shows], step, refuting=True)
        require(shows or all(truth(each, at) for each in values), another)
        for data, digits, low, high in shown:
            term = substituted(self.whole.term(data), at.point or {})
            order = node("<=", self.whole.term(low), term), node("<=", term, self.whole.term(high))
            lies = instance("enclosure", {"t": term, "digits": self.whole.term(digits)})[1]
            require(lies == node("and", *order), "{} lies elsewhere", data)

    def valued(self, side: Term, data: JSON) -> Formula:
        """That a side of the claim has this value; a formula is true or false."""
        if not isinstance(side, (Relation, Connective, Quantified)):
            return node("=", side, self.whole.term(data))
        require(isinstance(data, bool), "{} is no truth value", data)
        return side if data else contrary(side)

    def hold(self, formulas: list[Formula], step: Step, refuting: bool = False) -> Algebra:
        """Rejects unless the formulas hold at a point; gives the values there."""
        read = self.whole
        values = {read.letter(x): read.term(data) for x, data in step.mapping("values").items()}
        closed = not any(letters(t) or functions(t) for t in values.values()) and not values.keys() & read.names.keys()
        require(closed, "a coordinate is no number, or of a defined letter")
        for each in domain(*values.values(), divisors=True):
            require(truth(each, Algebra({}, {})), "a coordinate has no value: {} is not so", each)
        proof = step.data.pop("proof", None)
        mentioned = set().union(*map(letters, formulas))
        require(mentioned <= values.keys(), "no value for {}", ", ".join(sorted(mentioned - values.keys())))
        spoken = {*values} if proof is None else mentioned
        at = Algebra(read.names, {x: number for x, number in values.items() if x in spoken})  # others are free for use
        prover = Prover(read, at)
        for data, value in step.lists("calls", 2):
            call = read.term(data)
            known = isinstance(call, Call) and all(map(exact, call.terms))  # two numbers are told apart
            require(known, "{} is no function at a point", data)
            place = prover.algebra.value(call)
            require(place not in at.settled, "{} has two values", data)
            at.settled[place] = at.value(read.term(value)) % PRIME
        # a hypothesis about a function speaks of all its values, a point of a few
        general = set().union(*map(functions, self.hypotheses.values())) if refuting else set()
        require(not (at.settled and general), "what is assumed of {} is not only so at one point", general)
        for k, (x, number) in enumerate(values.items()):
            if x in spoken and proof is not None:
                prover.learn(("point", k), node("=", x, number))
        for each in domain(*formulas, divisors=True) if refuting and proof is not None else ():
            require(truth(each, at), "a term has no value at the point: {} is not so", each)  # to compute finds values
            if each.tag == "!=":  # what is not zero at the point may be divided by in all that is proved of it
                aside = Algebra(read.names)
                aside.value(node("/", 1, *each.outside[:1]))
                prover.listed |= {value: term for value, term in aside.divisors.items() if term is not None}
        prover.prove(node("and", *formulas), {"rule": "compute"} if proof is None else proof)
        prover.finish()
        step.end()
        return at


def supposed(claim: Formula) -> list[list[Formula]]:
    """What must hold somewhere lest the claim be empty: nothing, or the premises of each of its implications."""
    match claim:
        case Connective(tag="and", formulas=parts):
            return [premises for part in parts for premises in supposed(part) if premises] or [[]]
        case Connective(tag="=>", formulas=(premise, conclusion)) if conclusion not in (FALSE, node("=", 0, 1)):
            return [[premise, *others] for others in supposed(conclusion)]  # else: the premise never holds
        case Quantified(tag="forall", bound=xs, body=body):
            return [each and [node("exists", xs, node("and", *each))] for each in supposed(body)]
    return [[]]


def check_all(certificates: Iterable[JSON]) -> Iterator[str | None]:
    """For each certificate None if it holds, else the reason why it does not; lemmas are looked for among all."""
    read: list[tuple[Certificate | None, str | None]] = [*map(attempt, certificates)]
    proved = [each for each, reason in read if each and not reason and each.verdict == "proved"]
    open_ = [each for each in proved if each.lemmas]
    held = [each for each in proved if not each.lemmas]
    while new := [each for each in open_ if each.supported(held)]:
        held += new
        open_ = [each for each in open_ if each not in new]
    for each, reason in read:
        yield reason or ("a lemma is not proved, or under other assumptions" if each in open_ else None)


def attempt(data: JSON) -> tuple[Certificate | None, str | None]:
    """The certificate, and the reason why it does not hold, if so."""
    try:
        found = Certificate(data)
        found.check()
    except (Reject, Unknown, Malformed) as error:
        return None, str(error)
    except MALFORMED as error:
        return None, f"malformed ({type(error).__name__}: {error})"
    return found, None


def check(certificate: JSON) -> str | None:
    """None if a certificate without lemmas proves (or refutes) its claim, else the reason why it does not."""
    return next(check_all([certificate]))
