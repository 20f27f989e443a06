"""Whether a certificate shows what it says: its verdict, from its own proof or point and from proved lemmas."""

from __future__ import annotations

import marshal
from collections.abc import Iterable, Iterator
from functools import lru_cache

from symcheck.checker.algebra import Algebra, Known, exact
from symcheck.checker.residues import PRIME, Reject, require
from symcheck.checker.rules import Prover, Reference, paired
from symcheck.core.calculus import Unknown, conditions, domain, functions, letters, nodes, owed, strict, substituted
from symcheck.core.fields import Fields, by_key, listed, raw, text
from symcheck.core.formulas import FALSE, conjuncts, contrary
from symcheck.core.terms import (
    JSON,
    Connective,
    End,
    Formula,
    Malformed,
    Node,
    Quantified,
    Reader,
    Relation,
    Term,
    node,
)

MALFORMED = (LookupError, TypeError, ValueError, AttributeError, ArithmeticError, RecursionError, AssertionError)


class Context:
    """Definitions and hypotheses: many certificates have the same ones, which are read and computed once for all."""

    def __init__(self, definitions: JSON, hypotheses: JSON) -> None:
        self.reader, known = reader(key(definitions))
        self.hypotheses: dict[Reference, Formula] = {
            ("hyp", name, k): formula
            for name, formulas in by_key(listed(self.reader.formula))(hypotheses).items()
            for k, formula in enumerate(formulas)
        }
        self.assumed = [part for each in self.hypotheses.values() for part in conjuncts(each)]
        sides = (side for each in self.assumed if isinstance(each, Relation) for side in each.terms)
        self.known = known | unknown(*self.assumed, *sides)
        parts = nodes(*self.assumed)
        self.binders = [part for part in parts if part.inside]
        self.conditions, self.owed = conditions(parts), owed(*self.binders)
        self.points: dict[bytes, tuple[dict[str, Term], Known]] = {}

    def point(self, written: bytes) -> tuple[dict[str, Term], Known]:
        """The coordinates of a point and what is known of the values there."""
        if written not in self.points:
            values = by_key(self.reader.term)(marshal.loads(written))
            for x, number in values.items():
                closed = isinstance(number, int) or not letters(number) | functions(number)
                free = closed and self.reader.letter(x) not in self.reader.names
                require(free, "a coordinate is no number, or of a defined letter: {} = {}", x, number)
            for each in domain(*values.values(), divisors=True):
                require(Algebra({}, {}).holds(each), "a coordinate has no value: {} is not so", each)
            self.points[written] = values, {each: {} for each in self.known}
        return self.points[written]


def key(data: JSON) -> bytes:
    """Data as a key, the same for the same data alone."""
    return marshal.dumps(data, 2)


def unknown(*trees: Term) -> Known:
    """Of the values of these nodes nothing is known yet."""
    return {id(tree): {} for tree in trees if isinstance(tree, Node)}


@lru_cache(4096)
def reader(written: bytes) -> tuple[Reader, Known]:
    """A reader that knows the definitions, and what is known of their values."""
    found = Reader()
    for name, term in listed(listed(raw, 2))(marshal.loads(written)):
        found.define(text(name), term)
    return found, unknown(*found.names.values())


@lru_cache(4096)
def context(written: bytes) -> Context:
    """The context of definitions and hypotheses."""
    return Context(*marshal.loads(written))


class Certificate:
    """What is stated, definitions unfolded, and the evidence: a proof with witnesses, or a point."""

    def __init__(self, step: Fields) -> None:
        self.step, self.verdict = step, step.take("verdict", text)
        self.context = context(key([step.take("definitions", raw, []), step.take("hypotheses", raw, {})]))
        read = self.context.reader.formula
        self.nonzero = [read(["!=", term, 0]) for term in step.take("nonzero", listed(raw), [])]
        self.lemmas = [(text(name), read(stated)) for name, stated in step.take("lemmas", listed(listed(raw, 2)), [])]
        self.claim = read(step.take("claim", raw))
        self.assumed = [*self.context.assumed, *self.nonzero]
        parts = nodes(*self.nonzero, self.claim)
        own = [part for part in parts if part.inside]
        self.conditions = dict.fromkeys((*self.context.conditions, *conditions(parts)))
        self.owed = dict.fromkeys((*self.context.owed, *owed(*own)))
        parts = nodes(*(formula for _, formula in self.lemmas))
        self.binders = [*self.context.binders, *own, *(part for part in parts if part.inside)]

    def supported(self, proved: Iterable[tuple[str, Certificate]]) -> bool:
        """Whether each lemma is part of a statement that is proved under no more than is assumed here.

        What a lemma says of a letter holds of what the letter is defined to be here.
        """
        mean, names = self.context.reader.names, [name for name, _ in self.lemmas]
        stated = [
            (name, part)
            for name, lemma in proved
            if name in names and all(substituted(each, mean) in self.assumed for each in lemma.assumed)
            for part in conjuncts(substituted(lemma.claim, mean))
        ]
        return all(lemma in stated for lemma in self.lemmas)

    def check(self) -> None:
        """Rejects unless the evidence shows the verdict; lemmas are taken for granted."""
        require(self.verdict in ("proved", "refuted"), "the verdict {}", self.verdict)
        if self.verdict == "proved":
            require(summed(*self.binders), "a sum between ends that may not be whole")
            self.check_proof()
            self.check_witnesses()
        else:
            self.check_point()
        self.step.end()

    def check_proof(self) -> None:
        """The claim follows, no denominator vanishes, each hypothesis is used."""
        prover = Prover(self.context.reader, self.context.known)
        for name, formula in self.context.hypotheses.items():
            prover.learn(name, formula)
        if self.nonzero:
            self.assume(prover)
        facts, goal = [formula for _, formula in self.lemmas], strict(self.claim)
        goal = node("=>", node("and", *facts), goal) if facts else goal
        prover.prove(goal, self.step.take("proof", raw))
        prover.finish()
        unused = self.context.hypotheses.keys() - prover.used
        require(not unused or facts, "a hypothesis is not used: {}", unused)

    def assume(self, prover: Prover) -> None:
        """The terms listed are denominators of the statement, so that they may be assumed not to vanish."""
        met = {*self.denominators(self.claim), *prover.algebra.divisors}
        for k, formula in enumerate(self.nonzero):
            term = formula.outside[0]
            value = Algebra(self.context.known).value(term) % PRIME
            require(value in met, "{} is no denominator of the statement", term)
            prover.learn(("nonzero", k), formula)
            if isinstance(term, Node) and term.tag == "/":  # nor does the numerator vanish
                prover.nonzero.add(prover.value(term.outside[0]))

    def denominators(self, formula: Formula, bound: frozenset[str] = frozenset()) -> Iterator[int]:
        """The values of denominators; of those under quantifiers, if they are the same for all letters bound there."""
        if isinstance(formula, Relation):
            inner = Algebra(self.context.known)
            inner.residues(formula.terms)
            yield from (v for v, term in inner.divisors.items() if not (letters(term) & bound if term else bound))
        else:
            for part in (*formula.inside, *formula.outside):
                assert isinstance(part, Node)
                yield from self.denominators(part, bound.union(formula.bound))

    def check_witnesses(self) -> None:
        """Everything that is assumed holds somewhere, the premises of each implication too, and all terms have values.

        What does so without letters needs no point.
        """
        varying = [each for each in self.conditions if letters(each) or functions(each)]
        for each in self.conditions:
            require(each in varying or Algebra({}, {}).holds(each), "a term has no value, as {} is not so", each)
        needed = [[*premises, *varying] for premises in supposed(self.claim)]
        points = self.step.take("witnesses", listed(raw), [])
        rests = self.assumed or self.owed or needed != [[]]
        require(points or not rests, "no point where all that is assumed holds")
        for formulas, point in paired(needed, points) if points else ():
            self.hold(formulas, Fields(point))

    def check_point(self) -> None:
        """The hypotheses hold at the point, the claim does not, and what else is shown of the point is so."""
        require(not self.lemmas, "a point needs no lemmas")
        step = Fields(self.step.take("point", raw))
        shown = step.take("shown", listed(self.context.reader.formula), [])
        self.hold([strict(contrary(strict(self.claim))), *shown], step, refuting=True)

    def hold(self, shown: list[Formula], step: Fields, refuting: bool = False) -> None:
        """Rejects unless all that is assumed, and more, holds at a point: it is computed, or has a proof."""
        formulas = [*self.assumed, *shown]
        reader, (values, known) = self.context.reader, self.context.point(key(step.take("values", raw, {})))
        if computed := "proof" not in step.data:
            at = Algebra(known, values)
        else:  # the letters that are not mentioned are free for use
            mentioned = set().union(*map(letters, (*formulas, *self.owed)))
            require(mentioned <= values.keys(), "no value for {}", ", ".join(sorted(mentioned - values.keys())))
            at = Algebra({}, {x: number for x, number in values.items() if x in mentioned})
        calls = step.take("calls", listed(listed(reader.term, 2)), [])
        if calls:
            at.known = {}
        prover = Prover(reader, self.context.known, at)
        for call, value in calls:
            distinct = isinstance(call, Node) and call.tag == "call" and all(map(exact, call.outside))
            require(distinct, "{} is no function at a point", call)  # what is exact is told apart
            place = prover.algebra.value(call)
            require(place not in at.settled, "{} has two values", call)
            at.settled[place] = at.value(value) % PRIME
        # a hypothesis about a function speaks of all its values, a point of a few
        general = set().union(*map(functions, self.context.hypotheses.values())) if calls and refuting else set()
        require(not general, "what is assumed of {} is not only so at one point", general)
        for k, (x, number) in enumerate(values.items()):
            if not computed and x in mentioned:
                prover.learn(("point", k), node("=", x, number))
        for each in domain(*formulas, divisors=True) if refuting and not computed else ():
            require(at.holds(each), "a term has no value at the point: {} is not so", each)
        broken = frozenset(x for x, number in values.items() if not isinstance(number, int))
        ends = (refuting and computed) or summed(*self.binders, *shown, broken=broken)  # to compute finds the ends
        require(ends, "a sum between ends that may not be whole")
        if not refuting or not computed:  # to compute finds values
            more = owed(*formulas) if refuting else [*self.owed]
            formulas = [node("and", *formulas), *more] if more else formulas
        prover.prove(node("and", *formulas), step.take("proof", raw, {"rule": "compute"}))
        prover.finish()
        step.end()


def summed(*trees: Term, broken: frozenset[str] = frozenset()) -> bool:
    """Whether all sums and products have ends that are whole, where all letters but some are."""
    for part in nodes(*trees):
        if part.inside:
            counted = part.tag in ("sum", "product")
            inner = broken.difference(part.bound) if counted else broken.union(part.bound)
            ends = not counted or all(isinstance(each, End) or integer(each, broken) for each in part.outside)
            if not ends or not summed(*part.inside, broken=inner):
                return False
    return True


def integer(term: Term, broken: frozenset[str]) -> bool:
    """Whether a term is put together by addition and multiplication of whole numbers, as letters are but for some."""
    if isinstance(term, Node):
        return term.tag in ("+", "-", "*") and all(integer(each, broken) for each in term.outside)
    return isinstance(term, int) or term not in broken


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


def check_all(certificates: Iterable[object]) -> Iterator[str | None]:
    """Check certificates, whose lemmas are looked for among all of them.

    Parameters
    ----------
    certificates
        Certificates as `json` reads them from a file of ``generated/certificates``.

    Yields
    ------
    str or None
        For each certificate None if it holds, else the reason why it does not.

    See Also
    --------
    check : For a single certificate.
    """
    checked: dict[bytes, object] = {}
    read = [attempt(each, checked) for each in certificates]
    proved = [(name, each) for name, each in read if isinstance(each, Certificate) and each.verdict == "proved"]
    open_ = [(name, each) for name, each in proved if each.lemmas]
    held = [(name, each) for name, each in proved if not each.lemmas]
    while new := [(name, each) for name, each in open_ if each.supported(held)]:
        held += new
        open_ = [each for each in open_ if each not in new]
    for found in read:
        unproved = "a lemma is not proved, or under other assumptions" if found in open_ else None
        yield found[1] if isinstance(found[1], str) else unproved


def attempt(data: object, checked: dict[bytes, object]) -> tuple[str, object]:
    """A certificate by its id, or the reason why it does not hold; what differs in the id alone is checked once."""
    name = ""
    try:
        step = Fields(data)
        name, written = step.take("id", text), key(step.data)
        if written not in checked:
            if "matrices" in step.data:  # for which there are modules that other certificates do not need
                from symcheck.checker.matrices import MatrixCertificate
            found = MatrixCertificate(step) if "matrices" in step.data else Certificate(step)
            found.check()
            checked[written] = found
    except (Reject, Unknown, Malformed) as error:
        return name, str(error)
    except MALFORMED as error:
        return name, f"malformed ({type(error).__name__}: {error})"
    return name, checked[written]


def check(certificate: object) -> str | None:
    """Check one certificate, which may use no lemmas.

    Parameters
    ----------
    certificate
        A certificate as `json` reads it, or as `symcheck.proof.certificate` makes it.

    Returns
    -------
    str or None
        None if it proves, or refutes, its claim; else the reason why it does not. No certificate raises.

    See Also
    --------
    check_all : For certificates that use one another as lemmas.

    Examples
    --------
    >>> square = ["^", ["+", "x", 1], 2]
    >>> for middle in (2, 3):
    ...     claim = ["=", square, ["+", ["^", "x", 2], ["*", middle, "x"], 1]]
    ...     proof = {"rule": "identity", "cofactors": []}
    ...     print(check({"id": "mine", "claim": claim, "verdict": "proved", "proof": proof}))
    None
    left - right is not the combination of facts it is said to be
    """
    return next(check_all([certificate]))
