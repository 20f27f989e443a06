"""The rules of proof. A proof is a tree of steps {"rule": name, ...}; a step that has a key too many is refused.

What is assumed or known at a step is its *facts*: hypotheses ("hyp", name, k), denominators that do not vanish
("nonzero", k), coordinates of a point ("point", k), and what steps above assume, in their order: ("here", 0), ... Of an
equation, an order or an inequality the value of the difference is known. Cofactors are polynomials, printed.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

from symcheck.checker.algebra import Algebra, Divisors, Known, exact, sign
from symcheck.checker.residues import PRIME, Reject, inverse, polynomials, rational, require
from symcheck.checker.theorems import Argument, instance, shown
from symcheck.core.calculus import letters, substituted
from symcheck.core.fields import Fields, by_key, listed, raw, text
from symcheck.core.formulas import FALSE, conjuncts, contrary
from symcheck.core.terms import JSON, Connective, Formula, Quantified, Reader, Relation, T, Term, Value, node

Reference = tuple[str | int, ...]
STRICT, ORDERS = ("<", ">"), ("<", ">", "<=", ">=")
LIST = listed(raw)
LISTS = listed(LIST)
POLYNOMIAL = polynomials({})


def paired(parts: Sequence[T], proofs: list[JSON]) -> Iterable[tuple[T, JSON]]:
    """Each part with its own proof."""
    require(len(parts) == len(proofs), "{} proofs for {}", len(proofs), len(parts))
    return zip(parts, proofs, strict=True)


def reference(data: JSON) -> Reference:
    """A name and counters, such as ["hyp", "orthogonal", 2]."""
    found = [each for each in data if type(each) is str or type(each) is int] if isinstance(data, list) else []
    require(isinstance(data, list) and len(found) == len(data), "{} is no reference to a fact", data)
    return tuple(found)


class Prover:
    """Checks steps of a proof, with the facts that are in force at each."""

    def __init__(self, reader: Reader, known: Known, at: Algebra | None = None) -> None:
        self.reader, self.at = reader, at  # where letters have values
        self.algebra = Algebra(known)
        self.facts: dict[Reference, tuple[Formula, int]] = {}
        self.used: set[Reference] = set()
        self.depth = 0  # of the facts "here"
        self.around: list[Divisors] = []  # divisors met outside of what is being proved
        self.nonzero: set[int] = set()  # values that are not zero whatever a step assumes
        self.polynomial = POLYNOMIAL  # their values; see `prove`

    def value(self, term: Term) -> int:
        """The residue of a term."""
        return self.algebra.value(term) % PRIME

    def gap(self, relation: Relation) -> int:
        """By how much the larger side exceeds the smaller one, or the left one the right one."""
        left, right = self.algebra.residues(relation.terms)
        return (right - left if relation.tag[0] == "<" else left - right) % PRIME

    def learn(self, name: Reference, formula: Formula) -> None:
        """One more fact."""
        self.facts[name] = formula, self.gap(formula) if isinstance(formula, Relation) else 0

    def branch(
        self, goal: Formula, proof: JSON, *assumed: Formula, nonzero: Iterable[int] = (), proved: bool = False
    ) -> None:
        """Proves a goal under more assumptions, which are forgotten afterwards; `nonzero` are divisors they clear.

        Of what is proved, and not only assumed, the proof has cleared all divisors but those that it left over.
        """
        facts, depth = self.facts, self.depth
        around, self.algebra.divisors = self.algebra.divisors, {}
        self.around.append(around)
        self.facts = {**facts}
        for formula in (part for each in assumed for part in conjuncts(each)):
            self.learn(("here", self.depth), formula)
            self.depth += 1
        if proved:
            nonzero = [value for value in self.algebra.divisors if value not in around]
        self.prove(goal, proof)
        met, self.algebra.divisors = self.algebra.divisors, self.around.pop()
        cleared = {*nonzero, *(v for v, term in met.items() if self.is_known(v) or self.sign(term or 0) == 2)}
        around.update({value: term for value, term in met.items() if value not in cleared and not around.get(value)})
        self.facts, self.depth = facts, depth

    def opened(self, formula: Quantified, step: Fields, *beside: Formula) -> Formula:
        """The body with new letters for those bound: nothing is assumed or said of them here."""
        new = step.take("letters", listed(text), [])
        what = "said to exist" if formula.tag == "exists" else "bound"
        require(len(new) == len(formula.bound) == len({*new}), "other letters than are {}", what)
        taken = set().union(*map(letters, (formula, *beside, *(fact for fact, _ in self.facts.values()))))
        for x in new:
            require(self.reader.letter(x) not in taken and x not in self.reader.names, "the letter {} is taken", x)
        return substituted(formula.body, dict(zip(formula.bound, new, strict=True)))

    def fact(self, tags: tuple[str, ...], data: JSON, what: str = "{} is no such fact") -> tuple[Formula, int]:
        """A fact with one of the tags, and its value."""
        name = reference(data)
        if name not in self.facts or self.facts[name][0].tag not in tags:
            raise Reject(what.format(name))
        self.used.add(name)
        return self.facts[name]

    def positive(self, data: JSON) -> int:
        """The value of a term that is manifestly positive."""
        term = self.reader.term(data)
        require(self.sign(term) == 2, "{} is not manifestly positive", term)
        return self.value(term)

    def factor(self, data: JSON) -> int:
        """The value of what is not zero: by a fact, manifestly positive, or a denominator that was met, printed."""
        match data:
            case str():
                value = self.polynomial(data)
                met = (self.algebra.divisors, self.nonzero, *self.around)
                require(any(value in each for each in met), "{} is no denominator", data)
                return value
            case ["positive", term]:
                return self.positive(term)
        return self.fact(("!=", *STRICT), data)[1]

    def combination(self, value: int, step: Fields, what: str) -> None:
        """The value, times what is not zero, is the sum of cofactors times facts."""
        for data in step.take("times", LIST, []):
            value *= self.factor(data)
        for name, *factors in step.take("cofactors", LISTS, []):
            product = self.fact(("=",), name)[1]
            for factor in factors:
                product *= self.polynomial(text(factor))
            value -= product
        require(value % PRIME == 0, "{} is not the combination of facts it is said to be", what)

    def sign(self, term: Term) -> int:
        """2 if manifestly positive, 1 if manifestly not negative, else 0: by its form and by facts."""
        return sign(term, self.told)

    def told(self, term: Term, level: int) -> int:
        """The same of a term whose form tells so much."""
        match term:
            case Value(tag="^", terms=(base, int(n))) if n > 0 and n % 2 == 0:
                level = 1 + self.is_known(self.value(base))
            case Value(tag="sqrt", terms=(inner,)) if known := self.sign(inner):
                level = known if known == 2 else 2 * self.is_known(self.value(inner) % PRIME)
        value = self.value(term) % PRIME if level < 2 else 0
        if level < 2 and exact(term) and (number := rational(value)) and number[0] >= 0:
            return 1 + (number[0] > 0)
        if level:
            return level
        for name, (formula, gap) in self.facts.items():
            if value == gap and formula.tag in ORDERS:
                self.used.add(name)
                return 2 if formula.tag in STRICT else 1
        return 0

    def prove(self, goal: Formula, proof: JSON) -> None:
        """Checks one step, and with it the steps above it."""
        step = Fields(proof)
        kept = self.polynomial
        if "atoms" in step.data:  # terms that stand as letters in polynomials
            atoms = step.take("atoms", by_key(self.reader.term))
            self.polynomial = polynomials({x: self.value(term) for x, term in atoms.items()})
        if "positive" in step.data:  # denominators the proof brings in: by what is given alone
            facts, self.facts = self.facts, {n: fact for n, fact in self.facts.items() if n[0] != "here"}
            for value in map(self.positive, step.take("positive", LIST)):
                self.nonzero |= {value, PRIME - value}
            self.facts = facts
        rule = step.take("rule", text)
        require(rule in RULES, "there is no rule {}", rule)
        RULES[rule](self, goal, step)
        step.end()
        self.polynomial = kept

    def identity(self, goal: Formula, step: Fields) -> None:
        """l = r, as l - r is a combination of facts."""
        if not isinstance(goal, Relation) or goal.tag != "=":
            raise Reject("an identity is an equation")
        self.combination(self.gap(goal), step, "left - right")

    def nonnegative(self, goal: Formula, step: Fields) -> None:
        """An order, as larger - smaller is, up to facts, a form manifestly not negative (positive for <)."""
        if not isinstance(goal, Relation) or goal.tag not in ORDERS:
            raise Reject("only an order follows from a form of one sign")
        form = step.take("form", self.reader.term)
        require(self.sign(form) >= 3 - len(goal.tag), "the form is not manifestly of one sign")
        self.combination(self.gap(goal) - self.value(form), step, "the difference less the form")

    def implies(self, goal: Formula, step: Fields) -> None:
        """A => B under A. A relation, as its contrary leads to a contradiction."""
        match goal:
            case Relation():
                self.gap(goal)  # what it divides by is not cleared by its own contrary
                self.branch(FALSE, step.take("then", raw), contrary(goal))
            case Connective(tag="=>", formulas=(premise, conclusion)):
                self.branch(conclusion, step.take("then", raw), premise)
            case _:
                raise Reject("no implication and no relation")

    def each(self, goal: Formula, step: Fields) -> None:
        """All parts of an "and", both directions of an equivalence."""
        match goal:
            case Connective(tag="and", formulas=parts):
                pass
            case Connective(tag="<=>", formulas=(left, right)):
                parts = node("=>", left, right), node("=>", right, left)
            case _:
                raise Reject("nothing with parts")
        for part, proof in paired(parts, step.take("parts", LIST)):
            self.branch(part, proof)

    def choose(self, goal: Formula, step: Fields) -> None:
        """One part of an "or"."""
        index, parts = step.take("index", raw), goal.formulas if isinstance(goal, Connective) else ()
        if type(index) is not int or goal.tag != "or" or not 0 <= index < len(parts):
            raise Reject(f"there is no alternative {index}")
        self.branch(parts[index], step.take("then", raw))

    def cases_or(self, goal: Formula, step: Fields) -> None:
        """The goal in every case of a fact that is a disjunction."""
        formula, _ = self.fact(("or",), step.take("or", raw), "{} is no disjunction")
        assert isinstance(formula, Connective)
        for part, proof in paired(formula.formulas, step.take("cases", LIST)):
            self.branch(goal, proof, part)

    def split(self, goal: Formula, step: Fields) -> None:
        """A product of powers is zero: so one of their bases is."""
        form = step.take("form", self.reader.term)
        self.combination(self.value(form), step, "the product")
        factors = form.terms if isinstance(form, Value) and form.tag == "*" else (form,)
        for factor, proof in paired(factors, step.take("cases", LIST)):
            match factor:
                case Value(tag="^", terms=(base, int(n))) if n > 0:
                    self.branch(goal, proof, node("=", base, 0))
                case _:
                    self.branch(goal, proof, node("=", factor, 0))

    def vanish(self, goal: Formula, step: Fields) -> None:
        """A sum of addends that are manifestly not negative is zero: so each of them is."""
        form = step.take("form", self.reader.term)
        addends = form.terms if isinstance(form, Value) and form.tag == "+" else ()
        require(addends and all(map(self.sign, addends)), "an addend is not manifestly non-negative")
        self.combination(self.value(form), step, "the form")
        self.branch(goal, step.take("then", raw), *(node("=", addend, 0) for addend in addends))

    def absurd(self, goal: Formula, step: Fields) -> None:
        """Something that is not zero is a combination of facts: so anything follows."""
        self.combination(1, step, "the contradiction")

    def have(self, goal: Formula, step: Fields) -> None:
        """What is proved once may be used often."""
        formula = step.take("formula", self.reader.formula)
        self.branch(formula, step.take("proof", raw))
        self.branch(goal, step.take("then", raw), formula, proved=True)

    def theorem(self, goal: Formula, step: Fields) -> None:
        """The premises of a theorem have proofs; its conclusion is one more fact. What it says to exist is named."""
        name, given = step.take("of", text), step.take("with", by_key(self.argument), {})
        numbers = step.take("numbers", by_key(self.reader.term), {}) if name == "enclosure" else {}
        premises, conclusion = instance(name, given, {self.reader.letter(x): t for x, t in numbers.items()})
        for premise, proof in paired(premises, step.take("premises", LIST)):
            self.branch(premise, proof)
        nonzero = [value for value, term in self.met(shown(name, given)).items() if term is None]  # by the premises
        if isinstance(conclusion, Quantified):
            conclusion = self.opened(conclusion, step, goal)
        self.branch(goal, step.take("then", raw), conclusion, nonzero=nonzero)

    def met(self, terms: Iterable[Term]) -> Divisors:
        """What some terms divide by."""
        around, self.algebra.divisors = self.algebra.divisors, {}
        self.algebra.residues(terms)
        met, self.algebra.divisors = self.algebra.divisors, around
        return met

    def argument(self, data: JSON) -> Argument:
        """What a theorem is applied to: a term, or {"letter": x, "term": t} for a term in a letter."""
        if not isinstance(data, dict):
            return self.reader.term(data)
        step = Fields(data)
        own, reader = self.reader.without([step.take("letter", raw)])
        term = step.take("term", reader.term)
        step.end()
        return own, term

    def witness(self, goal: Formula, step: Fields) -> None:
        """Something exists, as it is so of these terms."""
        if not isinstance(goal, Quantified) or goal.tag != "exists":
            raise Reject("no existence")
        point = step.take("point", by_key(self.reader.term))
        require(point.keys() == {*goal.bound}, "values for other letters")
        self.branch(substituted(goal.body, point), step.take("then", raw))

    def every(self, goal: Formula, step: Fields) -> None:
        """Something is so of all, as it is of new letters."""
        if not isinstance(goal, Quantified) or goal.tag != "forall":
            raise Reject("nothing about all")
        self.branch(self.opened(goal, step), step.take("then", raw))

    def compute(self, goal: Formula, step: Fields) -> None:
        """A formula about numbers, or about letters that have values here; facts are parts of it, or values."""
        at, parts, granted = self.at or Algebra({}, {}), [goal], list[Formula]()
        if names := step.take("values", LIST, []):
            settled, point, parts = at.settled, at.point or {}, conjuncts(goal)
            shown = [substituted(part, point) for part in parts]
            at = Algebra({}, at.point)
            at.settled, at.asked = {**settled}, True
            for name in names:
                formula, _ = self.fact(("=", "forall", "or"), name, "{} is no value")
                here = substituted(formula, point)
                granted += [part for part, there in zip(parts, shown, strict=True) if there == here]
                if formula.tag == "=" and not letters(formula):
                    function, value = formula.outside
                    at.settled[self.value(function)] = at.value(value) % PRIME
                else:
                    require(here in shown, "{} is no value", formula)
        for part in parts:
            require(part in granted or at.holds(part), "{} is not so", part)
        if names:
            self.algebra.divisors.update({value: None for value, term in at.divisors.items() if term is None})

    def finish(self) -> None:
        """No denominator that was met may be zero."""
        for divisor, term in [*self.algebra.divisors.items()]:
            if term is None or not exact(term):
                shown = self.is_known(divisor) or divisor in self.nonzero or self.sign(term or 0) == 2
                shown = shown or self.not_zero_at_point(term or 0)
                shown = shown or (term is not None and rational(divisor) is not None)  # the same number everywhere
                require(shown, "a denominator may be zero: {}", term or "under a binder")

    def is_known(self, divisor: int) -> bool:
        """Whether a fact that is in force says that a value is not zero."""
        known = [(name, gap) for name, (formula, gap) in self.facts.items() if gap and formula.tag in ("!=", *STRICT)]
        by = next((name for name, gap in known if gap == divisor), None)
        if by is None and known and divisor:
            below = inverse(divisor)
            by = next((name for name, gap in known if rational(gap * below)), None)
        self.used |= {by} if by else set()
        return by is not None

    def not_zero_at_point(self, term: Term) -> bool:
        """Whether all letters of a term have values here, and the term is another number than zero."""
        at = self.at
        return at is not None and letters(term) <= (at.point or {}).keys() and at.holds(node("!=", term, 0))


RULES: dict[str, Callable[[Prover, Formula, Fields], None]] = {
    each.__name__: each
    for each in (
        Prover.identity, Prover.nonnegative, Prover.implies, Prover.each, Prover.choose, Prover.cases_or, Prover.split,
        Prover.vanish, Prover.absurd, Prover.have, Prover.theorem, Prover.witness, Prover.every, Prover.compute,
    )
}  # fmt: skip
