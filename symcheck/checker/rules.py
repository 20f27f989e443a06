"""The rules of proof. A proof is a tree of steps {"rule": name, ...}; a step that has a key too many is refused.

What is assumed or known at a step is its *facts*: hypotheses ("hyp", name, k), coordinates of a point ("point", k), and
what steps above assume, in their order: ("here", 0), ... A fact is an equation (its difference is zero), an order or an
inequality (the sign of its difference is known), or any other formula. Cofactors are polynomials, printed.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from re import findall
from typing import NamedTuple

from symcheck.checker.algebra import Algebra, Inexact
from symcheck.checker.enclosures import between, enclosed
from symcheck.checker.residues import require
from symcheck.checker.theorems import Argument, instance
from symcheck.core.terms import (
    JSON,
    Call,
    Connective,
    Formula,
    Node,
    Quantified,
    Reader,
    Relation,
    Term,
    Value,
    letters,
    node,
    substituted,
)

TYPE_CHECKING = False
if TYPE_CHECKING:
    from symcheck.core.terms import T

Reference = tuple[str | int, ...]
SIGNS = {"=": {0}, "!=": {-1, 1}, "<": {-1}, "<=": {-1, 0}, ">": {1}, ">=": {0, 1}}  # of left - right
CONTRARY = {"=": "!=", "!=": "=", "<": ">=", "<=": ">", ">": "<=", ">=": "<", "and": "or", "or": "and"}


def conjuncts(formula: Formula) -> list[Formula]:
    """The formula taken apart at "and"."""
    return [p for f in formula[1:] for p in conjuncts(f)] if formula[0] == "and" else [formula]  # type: ignore[arg-type]


def contrary(formula: Formula) -> Formula:
    """What is true if and only if the formula is not."""
    match formula:
        case Relation(left=left, right=right):
            return node(CONTRARY[formula.tag], left, right)
        case Connective(tag="and" | "or", formulas=parts):
            return node(CONTRARY[formula.tag], *map(contrary, parts))
        case Connective(tag="=>", formulas=(premise, conclusion)):
            return node("and", premise, contrary(conclusion))
        case Connective(formulas=(left, right)):
            return node("or", node("and", left, contrary(right)), node("and", right, contrary(left)))
        case Quantified(tag=tag, letters=xs, body=body):
            return node("forall" if tag == "exists" else "exists", xs, contrary(body))
    raise AssertionError(formula)


def sides(formula: Formula) -> list[Term]:
    """Both sides of every relation in a formula that stands under no quantifier."""
    if isinstance(formula, Relation):
        return [formula.left, formula.right]
    return [t for part in formula.formulas for t in sides(part)] if isinstance(formula, Connective) else []


class Fact(NamedTuple):
    """A sign ("=", ">", ...) with the value of the difference, or a formula that is no relation."""

    sign: str
    value: int
    formula: Formula | None = None
    names: frozenset[str] = frozenset()  # where there is no formula: the letters of the polynomial that is zero


class Step:
    """One node of a proof as JSON; what is taken out of it must be all there is."""

    def __init__(self, data: JSON, reader: Reader) -> None:
        require(isinstance(data, dict), "{} is no step of a proof", data)
        self.data, self.reader = dict(data) if isinstance(data, dict) else {}, reader

    def take(self, key: str) -> JSON:
        require(key in self.data, "a step without {}", key)
        return self.data.pop(key)

    def items(self, key: str) -> list[JSON]:
        """A list, empty if it is not there."""
        found = self.data.pop(key, [])
        require(isinstance(found, list), "{} is no list", key)
        return found if isinstance(found, list) else []

    def text(self, key: str) -> str:
        return string(self.take(key))

    def number(self, key: str) -> int:
        found = self.take(key)
        require(type(found) is int, "{} is no whole number", found)
        return found if isinstance(found, int) else 0

    def texts(self, key: str) -> list[str]:
        return [*map(string, self.items(key))]

    def term(self, key: str) -> Term:
        return self.reader.term(self.take(key))

    def references(self, key: str) -> list[Reference]:
        return [*map(reference, self.items(key))]

    def mapping(self, key: str) -> dict[str, JSON]:
        found = self.data.pop(key, {})
        require(isinstance(found, dict), "{} is no object", key)
        return found if isinstance(found, dict) else {}

    def end(self) -> None:
        require(not self.data, "a step of a proof has the superfluous {}", [*self.data])


def paired(parts: Iterable[T], proofs: list[JSON]) -> list[tuple[T, JSON]]:
    """Each part with its own proof."""
    listed = [*parts]
    require(len(listed) == len(proofs), "{} proofs for {}", len(proofs), len(listed))
    return [*zip(listed, proofs, strict=True)]


def string(data: JSON) -> str:
    require(isinstance(data, str), "{} is no text", data)
    return data if isinstance(data, str) else ""


def reference(data: JSON) -> Reference:
    """A name and counters, such as ["hyp", "orthogonal", 2]."""
    listed = data if isinstance(data, list) else [data]
    found = tuple(each for each in listed if type(each) is str or type(each) is int)
    require(len(found) == len(listed), "{} is no reference to a fact", data)
    return found


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

    def learn(self, name: Reference, formula: Formula) -> None:
        """One more fact."""
        if isinstance(formula, Relation):
            large, small = formula.left, formula.right
            if formula.tag[0] == "<":
                large, small = small, large
            gap = (self.algebra.value(large) - self.algebra.value(small)) % self.algebra.prime
            self.facts[name] = Fact(formula.tag.replace("<", ">"), gap, formula)
        else:
            self.facts[name] = Fact(formula.tag, 0, formula)

    def branch(self, goal: Formula, proof: JSON, assumed: Iterable[Formula] = (), zero: str | None = None) -> None:
        """Proves a goal under more assumptions, which are forgotten afterwards."""
        before = self.depth
        for formula in assumed:
            self.learn(("here", self.depth), formula)
            self.depth += 1
        if zero is not None:
            names = frozenset(x for n in findall(r"[A-Za-z]\w*", zero) for x in letters(self.algebra.atoms.get(n, n)))
            self.facts["here", self.depth] = Fact("=", self.algebra.polynomial(zero), None, names)
            self.depth += 1
        self.prove(goal, proof)
        while self.depth > before:
            self.depth -= 1
            del self.facts["here", self.depth]

    def fresh(self, x: str, *beside: Formula) -> None:
        """Rejects unless nothing is assumed of a letter, nor said of it in the formulas beside."""
        spoken = [*beside, *self.listed.values(), *(fact.formula for fact in self.facts.values() if fact.formula)]
        taken = set().union(*map(letters, spoken), *(fact.names for fact in self.facts.values()))
        require(self.reader.letter(x) not in taken and x not in self.reader.names, "the letter {} is taken", x)

    def known(self, signs: tuple[str, ...], name: Reference) -> int:
        """The value of a fact with one of the signs."""
        fact = self.facts.get(name)
        require(fact and fact.sign in signs, "{} is no such fact", name)
        self.used.add(name)
        return fact.value if fact else 0

    def nonzero(self, data: JSON) -> int:
        """The value of what is not zero by a fact, or is manifestly positive."""
        if isinstance(data, list) and data[:1] == ["positive"] and len(data) == 2:
            term = self.reader.term(data[1])
            require(self.sign(term) == 2, "{} is not manifestly positive", term)
            return self.algebra.value(term)
        return self.known(("!=", ">"), reference(data))

    def combination(self, value: int, step: Step, what: str) -> None:
        """The value, times denominators and things that are not zero, is the sum of cofactors times facts."""
        algebra = self.algebra
        for text in step.texts("clear"):
            divisor = algebra.polynomial(text)
            met = divisor in algebra.divisors or divisor in self.tops or divisor in self.positive
            require(met, "{} is no denominator", text)
            value *= divisor
        for data in step.items("times"):
            value *= self.nonzero(data)
        for entry in step.items("cofactors"):
            name, *factors = entry if isinstance(entry, list) and entry else [None]
            product = self.known(("=",), reference(name))
            for factor in factors:
                product *= algebra.polynomial(string(factor))
            value -= product
        require(value % algebra.prime == 0, "{} is not the combination of facts it is said to be", what)

    def sign(self, term: Term) -> int:
        """2 if manifestly positive, 1 if manifestly not negative, else 0."""
        result = 0
        match term:
            case int():
                return (term >= 0) + (term > 0)
            case ("+", *parts) if parts:
                result = max(levels := [self.sign(part) for part in parts]) * all(levels)  # type: ignore[arg-type]
            case ("*", *parts):  # equal factors pair up to squares
                single: list[Term] = []
                for t in parts:
                    (single.remove if t in single else single.append)(t)  # type: ignore[arg-type]
                result = min([1 if len(single) < len(parts) else 2, *map(self.sign, single)])
            case ("/", top, bottom):
                result = min(self.sign(top), 2 * bool(self.sign(bottom)))  # type: ignore[arg-type]
            case ("^", base, int(n)) if n > 0:
                result = self.sign(base) or int(n % 2 == 0)  # type: ignore[arg-type]
        if result:
            return result
        value = self.algebra.value(term) % self.algebra.prime
        for name, fact in self.facts.items():
            if value == fact.value and fact.sign in (">", ">="):
                self.used.add(name)
                return 3 - len(fact.sign)
        return 0

    def prove(self, goal: Formula, proof: JSON) -> None:
        """Checks one step, and with it the steps above it."""
        step = Step(proof, self.reader)
        named = step.mapping("atoms")
        kept = self.algebra.naming({x: self.reader.term(data) for x, data in named.items()}) if named else None
        self.manifest(step)
        rule = step.text("rule")
        require(rule in RULES, "there is no rule {}", rule)
        RULES[rule](self, goal, step)
        step.end()
        if kept is not None:
            self.algebra.naming(kept)

    def manifest(self, step: Step) -> None:
        """Denominators a proof brings in, as terms that are manifestly positive by what is given alone."""
        facts, self.facts = self.facts, {n: fact for n, fact in self.facts.items() if n[0] != "here"}
        for data in step.items("positive"):
            term = self.reader.term(data)
            require(self.sign(term) == 2, "{} is not manifestly positive", term)
            value = self.algebra.value(term) % self.algebra.prime
            self.positive |= {value: term, self.algebra.prime - value: term}
        self.facts = facts

    def identity(self, goal: Formula, step: Step) -> None:
        """l = r, as l - r is a combination of facts."""
        require(goal.tag == "=", "an identity is an equation")
        self.combination(self.algebra.value(goal[1]) - self.algebra.value(goal[2]), step, "left - right")  # type: ignore[arg-type]

    def nonnegative(self, goal: Formula, step: Step) -> None:
        """An order, as larger - smaller is, up to facts, a form manifestly not negative (positive for <)."""
        require(goal.tag in ("<", "<=", ">", ">="), "only an order follows from a form of one sign")
        large, small = goal[2:0:-1] if goal.tag[0] == "<" else goal[1:]
        form = step.term("form")
        require(self.sign(form) >= 3 - len(goal.tag), "the form is not manifestly of one sign")
        gap = self.algebra.value(large) - self.algebra.value(small) - self.algebra.value(form)  # type: ignore[arg-type]
        self.combination(gap, step, "the difference less the form")

    def implies(self, goal: Formula, step: Step) -> None:
        """A => B under A. A relation, as its contrary leads to a contradiction."""
        if isinstance(goal, Relation):
            self.branch(node("or"), step.take("then"), conjuncts(contrary(goal)))
        else:
            require(goal.tag == "=>", "no implication and no relation")
            premise, conclusion = goal.formulas  # type: ignore[attr-defined]
            self.branch(conclusion, step.take("then"), conjuncts(premise))

    def each(self, goal: Formula, step: Step) -> None:
        """All parts of an "and", both directions of an equivalence."""
        require(goal.tag in ("and", "<=>"), "nothing with parts")
        parts = [*goal[1:]] if goal.tag == "and" else [node("=>", *goal[1:]), node("=>", *goal[:0:-1])]
        for part, proof in paired(parts, step.items("parts")):
            self.branch(part, proof)  # type: ignore[arg-type]

    def choose(self, goal: Formula, step: Step) -> None:
        """One part of an "or"."""
        index, parts = step.number("index"), goal[1:] if goal.tag == "or" else ()
        require(0 <= index < len(parts), "there is no alternative {}", index)
        self.branch(parts[index], step.take("then"))  # type: ignore[arg-type]

    def cases_or(self, goal: Formula, step: Step) -> None:
        """The goal in every case of a fact that is a disjunction."""
        name = reference(step.take("or"))
        fact = self.facts.get(name)
        require(fact and fact.sign == "or" and fact.formula, "{} is no disjunction", name)
        self.used.add(name)
        for part, proof in paired(fact.formula[1:], step.items("cases")):  # type: ignore[union-attr, index]
            self.branch(goal, proof, conjuncts(part))

    def split(self, goal: Formula, step: Step) -> None:
        """What is not zero times a product of powers is a combination of facts: so one of the bases is zero."""
        bases: list[str] = []
        value = 1
        for entry in step.items("factors"):
            text, exponent = entry if isinstance(entry, list) and len(entry) == 2 else (None, None)
            bases.append(string(text))
            require(type(exponent) is int and 0 < exponent < 1000, "the exponent {}", exponent)
            value *= self.algebra.polynomial(bases[-1]) ** (exponent if isinstance(exponent, int) else 0)
        self.combination(value, step, "the product")
        for base, proof in paired(bases, step.items("cases")):
            self.branch(goal, proof, zero=base)

    def vanish(self, goal: Formula, step: Step) -> None:
        """A sum of addends that are manifestly not negative is zero: so each of them is."""
        form = step.term("form")
        addends = form[1:] if isinstance(form, Node) and form.tag == "+" else ()
        require(addends and all(map(self.sign, addends)), "an addend is not manifestly non-negative")  # type: ignore[arg-type]
        self.combination(self.algebra.value(form), step, "the form")
        self.branch(goal, step.take("then"), [node("=", addend, 0) for addend in addends])

    def absurd(self, goal: Formula, step: Step) -> None:
        """Something that is not zero is a combination of facts: so anything follows."""
        self.combination(1, step, "the contradiction")

    def have(self, goal: Formula, step: Step) -> None:
        """What is proved once may be used often."""
        formula = self.reader.formula(step.take("formula"))
        self.branch(formula, step.take("proof"))
        self.branch(goal, step.take("then"), conjuncts(formula))

    def theorem(self, goal: Formula, step: Step) -> None:
        """The premises of a theorem have proofs; its conclusion is one more fact. What it says to exist is named."""
        premises, conclusion = self.applied(step.text("of"), step)
        for premise, proof in paired(premises, step.items("premises")):
            self.branch(premise, proof)
        if isinstance(conclusion, Quantified):
            new = step.texts("letters")
            require(len(new) == len(conclusion.letters) == len({*new}), "other letters than are said to exist")
            for x in new:
                self.fresh(x, goal, conclusion)
            conclusion = substituted(conclusion.body, dict(zip(conclusion.letters, new, strict=True)))
        self.branch(goal, step.take("then"), conjuncts(conclusion))

    def applied(self, name: str, step: Step) -> tuple[Iterable[Formula], Formula]:
        """A theorem with what it is applied to; equal arguments have equal values; a number lies between decimals."""
        given: dict[str, Argument] = {}
        for parameter, data in step.mapping("with").items():
            if isinstance(data, dict):
                inner = Step(data, self.reader)
                x = self.reader.letter(inner.take("letter"))
                given[parameter] = (x,), self.reader.without(x).term(inner.take("term"))
                inner.end()
            else:
                given[parameter] = self.reader.term(data)
        if name == "congruence":
            return congruence(given.pop("s", 0), given.pop("t", 0), *given)
        if name == "enclosure":
            numbers = {x: self.reader.term(t) for x, t in step.mapping("numbers").items()}
            premises, order = enclosure(given.pop("t"), given.pop("digits"), numbers)
            require(not given, "{} is nothing that has digits", [*given])
            return premises, node("and", *order)
        return instance(name, given)

    def witness(self, goal: Formula, step: Step) -> None:
        """Something exists, as it is so of these terms."""
        require(goal.tag == "exists" and isinstance(goal, Quantified), "no existence")
        point = {self.reader.letter(x): self.reader.term(data) for x, data in step.mapping("point").items()}
        require(point.keys() == {*goal[1]}, "values for other letters")  # type: ignore[misc]
        self.branch(substituted(goal[2], point), step.take("then"))  # type: ignore[arg-type]

    def every(self, goal: Formula, step: Step) -> None:
        """Something is so of all, as it is of new letters."""
        require(goal.tag == "forall", "nothing about all")
        new, bound = step.texts("letters"), goal.letters  # type: ignore[attr-defined]
        require(len(new) == len(bound) == len({*new}), "other letters than are bound")
        for x in new:
            self.fresh(x, goal)
        self.branch(substituted(goal[2], dict(zip(bound, new, strict=True))), step.take("then"))  # type: ignore[arg-type]

    def compute(self, goal: Formula, step: Step) -> None:
        """A formula about numbers, or about letters that have values here; values of functions are facts."""
        at = Algebra(self.reader.names, self.at.point if self.at else {})
        at.settled = {**self.at.settled} if self.at else {}
        for name in step.references("values"):
            fact = self.facts.get(name)
            require(fact and fact.sign == "=" and fact.formula and not letters(fact.formula), "{} is no value", name)
            assert fact
            assert isinstance(fact.formula, Relation)
            self.used.add(name)
            at.settled[self.algebra.value(fact.formula.left) % at.prime] = at.value(fact.formula.right) % at.prime
        require(truth(goal, at), "{} is not so", goal)

    def finish(self) -> None:
        """No denominator that was met may be zero."""
        algebra = self.algebra
        known = [(n, fact.value) for n, fact in self.facts.items() if fact.value and fact.sign in ("!=", ">")]
        for divisor in (value for value, varies in algebra.divisors.items() if varies):
            inverse = algebra.chance.inverse(divisor)
            by = next((name for name, value in known if algebra.chance.rational(value * inverse)), None)
            require(by or divisor in self.listed or divisor in self.positive, "a denominator may be zero")
            self.used |= {by} if by else set()


def truth(formula: Formula, at: Algebra) -> bool:
    """Whether a formula holds where all its letters have values."""
    if isinstance(formula, Relation):
        return compared(formula, at) in SIGNS[formula.tag]
    require(isinstance(formula, Connective), "{} is not about numbers", formula)
    parts = [truth(part, at) for part in formula[1:]]  # type: ignore[arg-type]
    if formula.tag in ("and", "or"):
        return all(parts) if formula.tag == "and" else any(parts)
    return parts[0] == parts[1] if formula.tag == "<=>" else parts[1] or not parts[0]


def compared(relation: Relation, at: Algebra) -> int:
    """The sign of left - right: from the exact difference, or else by interval arithmetic, or 0 by algebra."""
    try:
        gap = (at.value(relation.left) - at.value(relation.right)) % at.prime
        number = (gap, 1) if relation.tag in ("=", "!=") else at.chance.rational(gap)
        if number:
            return (number[0] > 0) - (number[0] < 0)
    except Inexact:
        pass
    difference = substituted(node("+", relation.left, node("-", relation.right)), at.point or {})
    digits = enclosed(difference)
    if digits.low <= 0 <= digits.high and digits.low < digits.high:
        require(Algebra({}).value(difference) % at.prime == 0, "too few digits to compare {} and {}", *relation[1:])
        return 0
    return (digits.low > 0) - (digits.high < 0)


def congruence(one: Argument, other: Argument, *more: str) -> tuple[Iterable[Formula], Formula]:
    """Equal arguments give equal values of a function."""
    require(not more, "congruence is about s and t alone")
    for term in (one, other):
        require(isinstance(term, (Value, Call)), "{} is no function of values", term)
    assert isinstance(one, (Value, Call))
    assert isinstance(other, (Value, Call))
    same = one[: len(one) - len(one.arguments)] == other[: len(other) - len(other.arguments)]
    require(same and len(one) == len(other), "{} and {} are not the same function", one, other)
    pairs = zip(one.arguments, other.arguments, strict=True)
    return [node("=", *pair) for pair in pairs], node("=", one, other)


def enclosure(term: Argument, digits: Argument, numbers: Mapping[str, Term]) -> tuple[list[Formula], list[Formula]]:
    """A number lies between two decimals, by interval arithmetic; its letters stand for what the premises say."""
    require(isinstance(term, (int, str, Node)) and type(digits) is int, "no term with digits")
    assert isinstance(term, (int, str, Node))
    assert isinstance(digits, int)
    number = term
    for _ in numbers:  # what a letter stands for may contain others
        number = substituted(number, numbers)
    low, high = between(number, digits)
    return [node("=", Reader.letter(x), t) for x, t in numbers.items()], [node("<=", low, term), node("<=", term, high)]


RULES: dict[str, Callable[[Prover, Formula, Step], None]] = {
    each.__name__: each
    for each in (
        Prover.identity, Prover.nonnegative, Prover.implies, Prover.each, Prover.choose, Prover.cases_or, Prover.split,
        Prover.vanish, Prover.absurd, Prover.have, Prover.theorem, Prover.witness, Prover.every, Prover.compute,
    )
}  # fmt: skip
