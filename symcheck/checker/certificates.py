"""Whether a certificate shows what it says: its verdict, from its own proof or point and from proved lemmas."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from symcheck.checker.algebra import Algebra, exact
from symcheck.checker.residues import Reject, require
from symcheck.checker.rules import Prover, Step, conjuncts, contrary, enclosure, paired, sides, string, truth
from symcheck.core.calculus import Unknown
from symcheck.core.terms import (
    JSON,
    Call,
    Formula,
    Malformed,
    Power,
    Quotient,
    Reader,
    Term,
    Value,
    children,
    functions,
    letters,
    node,
    substituted,
)

TYPE_CHECKING = False
if TYPE_CHECKING:
    from symcheck.core.terms import T

MALFORMED = (LookupError, TypeError, ValueError, AttributeError, ArithmeticError, RecursionError, AssertionError)


class Certificate:
    """What is stated, definitions unfolded, and the evidence: a proof with witnesses, or a point."""

    def __init__(self, data: JSON) -> None:
        whole, partial = Reader(), Reader()
        step = Step(data, whole)
        self.id, self.verdict = step.text("id"), step.text("verdict")
        free = step.texts("free")  # defined letters of which the proof knows what lemmas say, and nothing else
        for entry in step.items("definitions"):
            name, term = pair(entry)
            whole.define(string(name), term)
            if name not in free:
                partial.define(string(name), term)
        require({*free} <= whole.names.keys(), "{} are not all defined", free)
        self.reader, own = (partial, {x: whole.names[x] for x in free}) if free else (whole, {})

        def same(found: T, meant: T) -> T:
            require(not own or substituted(found, own) == meant, "{} is bound in {}", free, found)
            return found

        def read(formula: JSON) -> Formula:
            return same(self.reader.formula(formula), whole.formula(formula))

        self.hypotheses = {
            ("hyp", name, k): read(formula)
            for name, formulas in step.mapping("hypotheses").items()
            for k, formula in enumerate(formulas if isinstance(formulas, list) else [formulas])
        }
        self.nonzero = [same(self.reader.term(term), whole.term(term)) for term in step.items("nonzero")]
        self.lemmas = [(string(name), read(formula)) for name, formula in map(pair, step.items("lemmas"))]
        self.claim = read(step.take("claim"))
        self.own, self.step, self.whole = own, step, whole

    def unfolded(self, formula: Formula) -> Formula:
        return substituted(formula, self.own) if self.own else formula

    def assumed(self) -> set[Formula | Term]:
        """Hypotheses, and what must not vanish, definitions unfolded."""
        hypotheses = [part for formula in self.hypotheses.values() for part in conjuncts(self.unfolded(formula))]
        return {*hypotheses, *(substituted(term, self.own) for term in self.nonzero)}

    def supported(self, proved: Iterable[Certificate]) -> bool:
        """Whether each lemma is part of a statement that is proved under no more than is assumed here."""
        assumed = self.assumed()
        return all(
            any(
                name == lemma.id
                and self.unfolded(formula) in [*conjuncts(lemma.unfolded(lemma.claim)), lemma.unfolded(lemma.claim)]
                and lemma.assumed() <= assumed
                for lemma in proved
            )
            for name, formula in self.lemmas
        )

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
            prover.algebra.value(term)
        aside = Algebra(self.reader.names)  # what the terms listed are divided by is not the statement's own
        prover.listed = {aside.value(term) % aside.prime: term for term in self.nonzero}
        prover.tops = {aside.value(t.top) % aside.prime for t in self.nonzero if isinstance(t, Quotient)}
        superfluous = prover.listed.keys() - prover.algebra.divisors.keys()
        require(not superfluous, "{} is no denominator of the statement", [prover.listed[v] for v in superfluous])
        facts = [formula for _, formula in self.lemmas]
        goal = node("=>", node("and", *facts), self.claim) if facts else self.claim
        prover.prove(goal, self.step.take("proof"))
        prover.finish()
        require(prover.used >= self.hypotheses.keys() or facts, "a hypothesis is not used")
        assumed = [*self.hypotheses.values(), *(node("!=", term, 0) for term in self.nonzero)]
        needed = [self.unfolded(node("and", *assumed, *premises)) for premises in supposed(self.claim)]
        points = self.step.items("witnesses")
        require(points or needed == [node("and")], "no point where all that is assumed holds")
        for formula, point in paired(needed, points) if points else ():
            self.hold(formula, Step(point, self.whole))

    def check_point(self) -> None:
        """The hypotheses hold at the point, the claim does not; its sides have the stated values there."""
        require(not self.lemmas, "a point needs no lemmas")
        step = Step(self.step.take("point"), self.whole)
        stated, shown = [*map(self.whole.term, step.items("sides"))], step.items("enclosed")
        assumed = [*self.hypotheses.values(), *(node("!=", term, 0) for term in self.nonzero)]
        formulas = [self.unfolded(formula) for formula in (*assumed, contrary(self.claim))]
        at = self.hold(node("and", *formulas), step, refuting=True)
        if stated:
            same = [at.value(t) % at.prime for t in stated] == [at.value(t) % at.prime for t in sides(self.claim)]
            require(same, "a side has another value at the point")
        for entry in shown:
            require(isinstance(entry, list) and len(entry) == 4, "{} is no term with digits and two ends", entry)
            data, digits, low, high = entry if isinstance(entry, list) else []
            term = substituted(self.whole.term(data), at.point or {})
            order = [node("<=", self.whole.term(low), term), node("<=", term, self.whole.term(high))]
            require(enclosure(term, self.whole.term(digits), {})[1] == order, "{} lies elsewhere", data)

    def hold(self, formula: Formula, step: Step, refuting: bool = False) -> Algebra:
        """Rejects unless the formula holds at a point; gives the values there."""
        read = self.whole
        values = {read.letter(x): read.term(data) for x, data in step.mapping("values").items()}
        closed = not any(letters(t) or functions(t) for t in values.values()) and not values.keys() & read.names.keys()
        require(closed, "a coordinate is no number, or of a defined letter")
        missing = letters(formula) - values.keys()
        require(not missing, "no value for {}", ", ".join(sorted(missing)))
        at = Algebra(read.names, values)
        prover = Prover(read, at)
        for call, value in map(pair, step.items("calls")):
            term = read.term(call)
            known = isinstance(term, Call) and all(map(exact, term.arguments))  # two numbers are told apart
            require(known, "{} is no function at a point", call)
            place = prover.algebra.value(term)
            require(place not in at.settled, "{} has two values", call)
            at.settled[place] = at.value(read.term(value)) % at.prime
        # a hypothesis about a function speaks of all its values, a point of a few
        spoken = set().union(*(functions(f) for f in self.hypotheses.values())) if refuting else set()
        require(not (at.settled and spoken), "what is assumed of {} is not only so at one point", spoken)
        proof = step.data.pop("proof", None)
        for k, (x, number) in enumerate(values.items() if proof is not None else ()):
            prover.learn(("point", k), node("=", x, number))
        for condition in domains(formula) if refuting and proof is not None else ():  # to compute is to find values
            require(truth(condition, at), "a term has no value at the point: {} is not so", condition)
        prover.prove(formula, {"rule": "compute"} if proof is None else proof)
        prover.finish()
        step.end()
        return at


def pair(data: JSON) -> tuple[JSON, JSON]:
    require(isinstance(data, list) and len(data) == 2, "{} is no pair", data)
    return (data[0], data[1]) if isinstance(data, list) else (None, None)


def domains(tree: Term | Formula) -> Iterator[Formula]:
    """What must be so lest a term have no value. Of what stands under a binder nothing is asked."""
    for child, inside in children(tree) if isinstance(tree, tuple) else ():
        yield from () if inside else domains(child)
    match tree:
        case Quotient(bottom=divisor):
            yield node("!=", divisor, 0)
        case Power(base=divisor, exponent=n) if n < 0:
            yield node("!=", divisor, 0)
        case Value(tag="tan", arguments=(angle,)):
            yield node("!=", node("cos", angle), 0)
        case Value(tag="sqrt", arguments=(t,)):
            yield node(">=", t, 0)
        case Value(tag="log" | "gamma" | "pow", arguments=(t, *_)):
            yield node(">", t, 0)
        case Value(tag="arcsin" | "arccos", arguments=(t,)):
            yield node("<=", node("^", t, 2), 1)


def supposed(claim: Formula) -> list[list[Formula]]:
    """What must hold somewhere lest the claim be empty: nothing, or the premises of each of its implications."""
    match claim:
        case ("and", *parts):
            each = [premises for part in parts for premises in supposed(part)]  # type: ignore[arg-type]
            return [premises for premises in each if premises] or [[]]
        case ("=>", premise, conclusion):
            return [[premise, *others] for others in supposed(conclusion)]  # type: ignore[arg-type, list-item]
        case ("forall", letters, body):
            each = supposed(body)  # type: ignore[arg-type]
            return [[node("exists", letters, node("and", *premises))] if premises else [] for premises in each]
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
