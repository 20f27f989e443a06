"""The rules of proof. A proof is a tree of steps {"rule": name, ...}; a step that has a key too many is refused.

What is assumed or known at a step is its *facts*: hypotheses ("hyp", name, k), coordinates of a point ("point", k), and
what steps above assume, in their order: ("here", 0), ... A fact is an equation (its difference is zero), an order or an
inequality (the sign of its difference is known), or any other formula. Cofactors are polynomials, printed.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from re import findall
from typing import NamedTuple, TypeVar

from symcheck.checker.algebra import Algebra, Inexact, exact
from symcheck.checker.enclosures import enclosed
from symcheck.checker.residues import PRIME, Reject, inverse, polynomials, rational, require
from symcheck.checker.theorems import Argument, instance
from symcheck.core.calculus import letters, substituted
from symcheck.core.formulas import FALSE, conjuncts, contrary
from symcheck.core.terms import JSON, Connective, Formula, Quantified, Reader, Relation, Term, Value, node

T = TypeVar("T")
Reference = tuple[str | int, ...]
SIGNS = {"=": {0}, "!=": {-1, 1}, "<": {-1}, "<=": {-1, 0}, ">": {1}, ">=": {0, 1}}  # of left - right
LIST: type[list[JSON]] = list
DICT: type[dict[str, JSON]] = dict
KINDS = {int: "whole number", str: "text", list: "list", dict: "object"}
POLYNOMIAL = polynomials({})


def fit(kind: type[T], data: JSON, name: str | None = None) -> T:
    """The data, which may have a name, if they are of this type; a truth value is no number."""
    if not isinstance(data, kind) or isinstance(data, bool):
        raise Reject(f"{str(name or data)[:200]} is no {KINDS[kind]}")
    return data


def paired(parts: Sequence[T], proofs: list[JSON]) -> Iterable[tuple[T, JSON]]:
    """Each part with its own proof."""
    require(len(parts) == len(proofs), "{} proofs for {}", len(proofs), len(parts))
    return zip(parts, proofs, strict=True)


def reference(data: JSON) -> Reference:
    """A name and counters, such as ["hyp", "orthogonal", 2]."""
    found = [each for each in data if type(each) is str or type(each) is int] if isinstance(data, list) else []
    require(isinstance(data, list) and len(found) == len(data), "{} is no reference to a fact", data)
    return tuple(found)


class Step:
    """One node of a proof as JSON; what is taken out of it must be all there is."""

    def __init__(self, data: JSON) -> None:
        require(isinstance(data, dict), "{} is no step of a proof", data)
        self.data = {**fit(DICT, data)}

    def take(self, key: str) -> JSON:
        require(key in self.data, "a step without {}", key)
        return self.data.pop(key)

    def items(self, key: str) -> list[JSON]:
        """A list, empty if it is not there."""
        return fit(LIST, self.data.pop(key, []), key)

    def texts(self, key: str) -> list[str]:
        return [fit(str, each) for each in self.items(key)]

    def lists(self, key: str, count: int | None = None, what: str = "pair") -> list[list[JSON]]:
        """A list of lists, all of so many entries."""
        listed = [fit(LIST, each) for each in self.items(key)]
        for each in listed:
            require(count in (None, len(each)), "{} is no {}", each, what)
        return listed

    def mapping(self, key: str) -> dict[str, JSON]:
        """An object, empty if it is not there."""
        return fit(DICT, self.data.pop(key, {}), key)

    def end(self) -> None:
        require(not self.data, "a step of a proof has the superfluous {}", [*self.data])


class Fact(NamedTuple):
    """A sign ("=", ">", ...) with the value of the difference, or a formula that is no relation."""

    sign: str
    value: int
    formula: Formula | None = None
    names: frozenset[str] = frozenset()  # where there is no formula: the letters of the polynomial that is zero


class Prover:
    """Checks steps of a proof, with the facts that are in force at each."""

    def __init__(self, reader: Reader, at: Algebra | None = None) -> None:
        self.reader, self.at = reader, at  # where letters have values
        self.algebra = Algebra(reader.names)
        self.facts: dict[Reference, Fact] = {}
        self.used: set[Reference] = set()
        self.depth = 0  # of the facts "here"
        self.listed: dict[int, Term] = {}  # values of denominators of the statement that are assumed not to vanish
        self.tops: set[int] = set()  # values of numerators in these
        self.positive: dict[int, Term] = {}  # and of others that are manifestly not zero
        self.atoms: dict[str, Term] = {}  # terms that stand as letters in polynomials
        self.polynomial = POLYNOMIAL

    def value(self, term: Term) -> int:
        """The residue of a term."""
        return self.algebra.value(term) % PRIME

    def gap(self, relation: Relation) -> int:
        """By how much the larger side exceeds the smaller one, or the left one the right one."""
        left, right = self.algebra.residues(relation.terms)
        return (right - left if relation.tag[0] == "<" else left - right) % PRIME

    def learn(self, name: Reference, formula: Formula) -> None:
        """One more fact."""
        if isinstance(formula, Relation):
            self.facts[name] = Fact(formula.tag.replace("<", ">"), self.gap(formula), formula)
        else:
            self.facts[name] = Fact(formula.tag, 0, formula)

    def branch(self, goal: Formula, proof: JSON, assumed: Iterable[Formula] = (), zero: str | None = None) -> None:
        """Proves a goal under more assumptions, which are forgotten afterwards."""
        facts, depth = self.facts, self.depth
        self.facts = {**facts}
        for formula in (part for each in assumed for part in conjuncts(each)):
            self.learn(("here", self.depth), formula)
            self.depth += 1
        if zero is not None:
            names = (letters(self.atoms.get(name, name)) for name in findall(r"[A-Za-z]\w*", zero))
            self.facts["here", self.depth] = Fact("=", self.polynomial(zero), None, frozenset().union(*names))
            self.depth += 1
        self.prove(goal, proof)
        self.facts, self.depth = facts, depth

    def opened(self, formula: Quantified, step: Step, *beside: Formula) -> Formula:
        """The body with new letters for those bound: nothing is assumed or said of them here."""
        new = [*step.texts("letters")]
        what = "said to exist" if formula.tag == "exists" else "bound"
        require(len(new) == len(formula.bound) == len({*new}), "other letters than are {}", what)
        facts = (fact.formula for fact in self.facts.values() if fact.formula)
        spoken: list[Term] = [formula, *beside, *self.listed.values(), *facts]
        taken = set().union(*map(letters, spoken), *(fact.names for fact in self.facts.values()))
        for x in new:
            require(self.reader.letter(x) not in taken and x not in self.reader.names, "the letter {} is taken", x)
        return substituted(formula.body, dict(zip(formula.bound, new, strict=True)))

    def fact(self, signs: tuple[str, ...], name: Reference, what: str = "{} is no such fact") -> Fact:
        """A fact with one of the signs."""
        fact = self.facts.get(name)
        if not fact or fact.sign not in signs:
            raise Reject(what.format(name))
        self.used.add(name)
        return fact

    def positive_term(self, data: JSON) -> tuple[int, Term]:
        """The value of a term that is manifestly positive, and the term."""
        term = self.reader.term(data)
        require(self.sign(term) == 2, "{} is not manifestly positive", term)
        return self.value(term), term

    def combination(self, value: int, step: Step, what: str) -> None:
        """The value, times denominators and things that are not zero, is the sum of cofactors times facts."""
        for text in step.texts("clear"):
            divisor = self.polynomial(text)
            met = divisor in self.algebra.divisors or divisor in self.tops or divisor in self.positive
            require(met, "{} is no denominator", text)
            value *= divisor
        for data in step.items("times"):
            match data:
                case ["positive", term]:
                    value *= self.positive_term(term)[0]
                case _:
                    value *= self.fact(("!=", ">"), reference(data)).value
        for name, *factors in step.lists("cofactors"):
            product = self.fact(("=",), reference(name)).value
            for factor in factors:
                product *= self.polynomial(fit(str, factor))
            value -= product
        require(value % PRIME == 0, "{} is not the combination of facts it is said to be", what)

    def sign(self, term: Term) -> int:
        """2 if manifestly positive, 1 if manifestly not negative, else 0."""
        result = 0
        match term:
            case int():
                return (term >= 0) + (term > 0)
            case Value(tag="pi"):
                return 2
            case Value(tag="+", terms=parts) if parts:
                result = max(levels := [*map(self.sign, parts)]) * all(levels)
            case Value(tag="*", terms=parts):  # equal factors pair up to squares
                single: list[Term] = []
                for t in parts:
                    (single.remove if t in single else single.append)(t)
                result = min([1 if len(single) < len(parts) else 2, *map(self.sign, single)])
            case Value(tag="/", terms=(top, bottom)):
                result = min(self.sign(top), 2 * bool(self.sign(bottom)))
            case Value(tag="^", terms=(base, int(n))) if n > 0:
                result = self.sign(base) or int(n % 2 == 0)
        value = self.value(term) if result < 2 else 0
        if result < 2 and exact(term) and (number := rational(value)):
            return (number[0] >= 0) + (number[0] > 0)
        if result:
            return result
        for name, fact in self.facts.items():
            if value == fact.value and fact.sign in (">", ">="):
                self.used.add(name)
                return 3 - len(fact.sign)
        return 0

    def prove(self, goal: Formula, proof: JSON) -> None:
        """Checks one step, and with it the steps above it."""
        step = Step(proof)
        kept = self.atoms, self.polynomial
        if atoms := step.mapping("atoms"):
            self.atoms = {x: self.reader.term(data) for x, data in atoms.items()}
            self.polynomial = polynomials({x: self.value(term) for x, term in self.atoms.items()})
        if shown := step.items("positive"):  # denominators the proof brings in: shown by what is given alone
            facts, self.facts = self.facts, {n: fact for n, fact in self.facts.items() if n[0] != "here"}
            for value, term in map(self.positive_term, shown):
                self.positive |= {value: term, PRIME - value: term}
            self.facts = facts
        rule = fit(str, step.take("rule"))
        require(rule in RULES, "there is no rule {}", rule)
        RULES[rule](self, goal, step)
        step.end()
        self.atoms, self.polynomial = kept

    def identity(self, goal: Formula, step: Step) -> None:
        """l = r, as l - r is a combination of facts."""
        if not isinstance(goal, Relation) or goal.tag != "=":
            raise Reject("an identity is an equation")
        self.combination(self.gap(goal), step, "left - right")

    def nonnegative(self, goal: Formula, step: Step) -> None:
        """An order, as larger - smaller is, up to facts, a form manifestly not negative (positive for <)."""
        if not isinstance(goal, Relation) or goal.tag[0] not in "<>":
            raise Reject("only an order follows from a form of one sign")
        form = self.reader.term(step.take("form"))
        require(self.sign(form) >= 3 - len(goal.tag), "the form is not manifestly of one sign")
        self.combination(self.gap(goal) - self.value(form), step, "the difference less the form")

    def implies(self, goal: Formula, step: Step) -> None:
        """A => B under A. A relation, as its contrary leads to a contradiction."""
        match goal:
            case Relation():
                self.branch(FALSE, step.take("then"), [contrary(goal)])
            case Connective(tag="=>", formulas=(premise, conclusion)):
                self.branch(conclusion, step.take("then"), [premise])
            case _:
                raise Reject("no implication and no relation")

    def each(self, goal: Formula, step: Step) -> None:
        """All parts of an "and", both directions of an equivalence."""
        match goal:
            case Connective(tag="and", formulas=parts):
                pass
            case Connective(tag="<=>", formulas=(left, right)):
                parts = node("=>", left, right), node("=>", right, left)
            case _:
                raise Reject("nothing with parts")
        for part, proof in paired(parts, step.items("parts")):
            self.branch(part, proof)

    def choose(self, goal: Formula, step: Step) -> None:
        """One part of an "or"."""
        index, parts = fit(int, step.take("index")), goal.formulas if isinstance(goal, Connective) else ()
        require(goal.tag == "or" and 0 <= index < len(parts), "there is no alternative {}", index)
        self.branch(parts[index], step.take("then"))

    def cases_or(self, goal: Formula, step: Step) -> None:
        """The goal in every case of a fact that is a disjunction."""
        formula = self.fact(("or",), reference(step.take("or")), "{} is no disjunction").formula
        assert isinstance(formula, Connective)
        for part, proof in paired(formula.formulas, step.items("cases")):
            self.branch(goal, proof, [part])

    def split(self, goal: Formula, step: Step) -> None:
        """What is not zero times a product of powers is a combination of facts: so one of the bases is zero."""
        bases, value = [], 1
        for text, exponent in step.lists("factors", 2):
            bases.append(fit(str, text))
            require(type(exponent) is int and 0 < exponent < 1000, "the exponent {}", exponent)
            value *= self.polynomial(bases[-1]) ** fit(int, exponent)
        self.combination(value, step, "the product")
        for base, proof in paired(bases, step.items("cases")):
            self.branch(goal, proof, zero=base)

    def vanish(self, goal: Formula, step: Step) -> None:
        """A sum of addends that are manifestly not negative is zero: so each of them is."""
        form = self.reader.term(step.take("form"))
        addends = form.terms if isinstance(form, Value) and form.tag == "+" else ()
        require(addends and all(map(self.sign, addends)), "an addend is not manifestly non-negative")
        self.combination(self.value(form), step, "the form")
        self.branch(goal, step.take("then"), [node("=", addend, 0) for addend in addends])

    def absurd(self, goal: Formula, step: Step) -> None:
        """Something that is not zero is a combination of facts: so anything follows."""
        self.combination(1, step, "the contradiction")

    def have(self, goal: Formula, step: Step) -> None:
        """What is proved once may be used often."""
        formula = self.reader.formula(step.take("formula"))
        self.branch(formula, step.take("proof"))
        self.branch(goal, step.take("then"), [formula])

    def theorem(self, goal: Formula, step: Step) -> None:
        """The premises of a theorem have proofs; its conclusion is one more fact. What it says to exist is named."""
        premises, conclusion = self.applied(fit(str, step.take("of")), step)
        for premise, proof in paired(premises, step.items("premises")):
            self.branch(premise, proof)
        if isinstance(conclusion, Quantified):
            conclusion = self.opened(conclusion, step, goal)
        self.branch(goal, step.take("then"), [conclusion])

    def applied(self, name: str, step: Step) -> tuple[list[Formula], Formula]:
        """Premises and conclusion of a theorem with what it is applied to."""
        given: dict[str, Argument] = {}
        for parameter, data in step.mapping("with").items():
            if isinstance(data, dict):
                inner = Step(data)
                own, reader = self.reader.without([inner.take("letter")])
                given[parameter] = own, reader.term(inner.take("term"))
                inner.end()
            else:
                given[parameter] = self.reader.term(data)
        listed = step.mapping("numbers") if name == "enclosure" else {}
        numbers = {self.reader.letter(x): self.reader.term(data) for x, data in listed.items()}
        return instance(name, given, numbers)

    def witness(self, goal: Formula, step: Step) -> None:
        """Something exists, as it is so of these terms."""
        if not isinstance(goal, Quantified) or goal.tag != "exists":
            raise Reject("no existence")
        point = {self.reader.letter(x): self.reader.term(data) for x, data in step.mapping("point").items()}
        require(point.keys() == {*goal.bound}, "values for other letters")
        self.branch(substituted(goal.body, point), step.take("then"))

    def every(self, goal: Formula, step: Step) -> None:
        """Something is so of all, as it is of new letters."""
        if not isinstance(goal, Quantified) or goal.tag != "forall":
            raise Reject("nothing about all")
        self.branch(self.opened(goal, step), step.take("then"))

    def compute(self, goal: Formula, step: Step) -> None:
        """A formula about numbers, or about letters that have values here; values of functions are facts."""
        at = Algebra(self.reader.names, self.at.point if self.at else {})
        at.settled = {**self.at.settled} if self.at else {}
        for name in map(reference, step.items("values")):
            formula = self.fact(("=",), name, "{} is no value").formula
            if not isinstance(formula, Relation) or letters(formula):
                raise Reject(f"{name} is no value")
            function, value = formula.terms
            at.settled[self.value(function)] = at.value(value) % PRIME
        require(truth(goal, at), "{} is not so", goal)

    def finish(self) -> None:
        """No denominator that was met may be zero."""
        known = [(n, fact.value) for n, fact in self.facts.items() if fact.value and fact.sign in ("!=", ">")]
        for divisor, term in [*self.algebra.divisors.items()]:
            if term and exact(term):
                continue
            by = next((name for name, value in known if rational(value * inverse(divisor))), None)
            shown = by or divisor in self.listed or divisor in self.positive or self.sign(term or 0) == 2
            require(shown, "a denominator may be zero")
            self.used |= {by} if by else set()


def truth(formula: Formula, at: Algebra) -> bool:
    """Whether a formula holds where all its letters have values."""
    if isinstance(formula, Relation):
        return compared(formula, at) in SIGNS[formula.tag]
    if not isinstance(formula, Connective):
        raise Reject(f"{formula} is not about numbers")
    parts = [truth(part, at) for part in formula.formulas]
    if formula.tag in ("and", "or"):
        return all(parts) if formula.tag == "and" else any(parts)
    return parts[0] == parts[1] if formula.tag == "<=>" else parts[1] or not parts[0]


def compared(relation: Relation, at: Algebra) -> int:
    """The sign of left - right: from the exact difference, or else by interval arithmetic, or 0 by algebra."""
    left, right = relation.terms
    try:
        gap = (at.value(left) - at.value(right)) % PRIME
        number = (gap, 1) if relation.tag in ("=", "!=") else rational(gap)
        if number:
            return (number[0] > 0) - (number[0] < 0)
    except Inexact:
        pass
    difference = substituted(node("+", left, node("-", right)), at.point or {})
    digits = enclosed(difference)
    if digits.low <= 0 <= digits.high and digits.low < digits.high:
        require(Algebra({}).value(difference) % PRIME == 0, "too few digits to compare {} and {}", left, right)
        return 0
    return (digits.low > 0) - (digits.high < 0)


RULES: dict[str, Callable[[Prover, Formula, Step], None]] = {
    each.__name__: each
    for each in (
        Prover.identity, Prover.nonnegative, Prover.implies, Prover.each, Prover.choose, Prover.cases_or, Prover.split,
        Prover.vanish, Prover.absurd, Prover.have, Prover.theorem, Prover.witness, Prover.every, Prover.compute,
    )
}  # fmt: skip
