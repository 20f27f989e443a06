"""From the proof of a certificate to a proof script of Coq, rule by rule as in `symcheck/checker/rules.py`.

The script says everything (cofactors, forms, which fact has which sign), so that Coq searches for nothing. What this
module gets wrong does not compile.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from functools import reduce
from math import lcm, prod

from symcheck.checker.rules import Reference
from symcheck.coq.assumptions import pattern
from symcheck.coq.functions import OPAQUE, Functions
from symcheck.coq.printing import name, spelled
from symcheck.coq.terms import Certificate, NotExported, Proof, denominators, nodes, polynomial, product, subterms
from symcheck.coq.theorems import Application, missing
from symcheck.coq.values import ratio, shown_ratio
from symcheck.core import calculus
from symcheck.core.calculus import substituted
from symcheck.core.formulas import contrary
from symcheck.core.terms import FORMULAS, JSON, Connective, Formula, Node, Quantified, Term, Value, node

BY_CONTRADICTION = {
    "!=": "", "<": "apply Rnot_ge_lt. ", "<=": "apply Rnot_gt_le. ",
    ">": "apply Rnot_le_gt. ", ">=": "apply Rnot_lt_ge. ",
}  # fmt: skip
ORDERS = {"<": "combine_lt", "<=": "combine_le", ">": "combine_lt", ">=": "combine_ge"}


class Script(Functions):
    """One proof, rule by rule."""

    def write(self, certificate: Certificate) -> str:
        """The whole script."""
        proof, statement = certificate["proof"], self.statement
        if reason := missing(proof):
            raise NotExported(reason)
        self.emit(f"intros {' '.join(statement.names)}." if statement.names else "")
        for x in statement.defined:
            own = self.anew("d")
            self.emit(f"intros {own}. subst {name(x)}.")
        for reference, formula in statement.hypotheses:
            self.emit(f"intros {self.assume(formula, reference)}.")
            self.emit_later()
        self.own = len(self.state)
        goal = self.full(statement.conclusion)
        facts = [known.formula for known in self.state.values()]
        spoken: list[Term] = [goal, *facts, *map(self.mentioned, mentioned(proof))]
        spoken += [known.sides[0] for known in self.facts(">")]
        self.divides = any(calculus.divisor(each) != 1 or each.tag in ("sqrt", "arctan") for each in nodes(*spoken))
        premises = []
        for divisor in statement.premises:
            own = self.anew("n")
            self.emit(f"intros {own}.")
            premises.append((own, self.full(divisor)))
        said = [*(f for _, f in statement.hypotheses), statement.conclusion, *self.definitions.terms.values()]
        if any(each.tag == "tan" for each in nodes(*said)):
            self.emit("unfold tan in *.")
        if any(each.tag in ("diff", "sin", "cos", "call", *OPAQUE) for each in nodes(*spoken)):
            self.emit("unfold Rminus in *.")
        self.functions(spoken)
        self.same_functions([t for t in subterms(*spoken) if not [*denominators(t)]])
        for own, divisor in premises:
            self.keep(divisor, own)
        self.slopes(spoken)
        if self.rewritten:
            goal, spoken = self.worked(goal), [*map(self.worked, spoken)]
            self.state = {n: known._replace(formula=self.worked(known.formula)) for n, known in self.state.items()}
        self.divisors(spoken)
        self.same_functions(spoken)
        for data in certificate.get("nonzero", ()):
            match self.read(data):
                case Value(tag="/", terms=(top, below)):
                    self.listed.append((top, below))
        self.prove(goal, proof)
        return "\n".join(line for line in self.lines if line)

    def mentioned(self, data: JSON) -> Term:
        """A term or formula that the proof brings in."""
        formula = isinstance(data, list) and data[0] in FORMULAS
        return self.full(self.definitions.formula(data)) if formula else self.read(data)

    def rests_on(self) -> set[Reference]:
        """The hypotheses that the script, now written, makes use of."""
        own = ("intros h", "apply Rge_le in")
        used = {name for line in self.lines if not line.startswith(own) for name in re.findall(r"\bh\d+'", line)}
        return {name for name, known in self.state.items() if known.hypothesis in used}

    def branch(self, goal: Formula, proof: Proof) -> None:
        """A subgoal of its own."""
        with self.inside():
            self.prove(goal, proof)

    def combination(self, proof: Proof) -> tuple[str, str]:
        """A proof that the multiplier is not zero, and one that the sum of cofactors times facts is zero."""
        apart = []
        for data in proof.get("times", ()):
            if isinstance(data, str):
                apart.append(self.cleared(data))
            elif data[0] == "positive":
                if not (shown := self.positive(self.read(data[1]))):
                    raise NotExported("a factor that is not manifestly positive")
                apart.append(f"(pos_nz {shown})")
            else:
                apart.append(self.fact(data, ("!=", ">")).apart)
        rows = []
        for data, *texts in proof["cofactors"]:
            polynomials = [polynomial(text, self.atoms) for text in texts]
            rows.append((self.fact(data, ("=",)), [p for p, _ in polynomials], prod(scale for _, scale in polynomials)))
        scale = lcm(*(own for *_, own in rows))
        if scale > 1:
            apart.append(f"(num_nz {scale})")
        multiplier = reduce(lambda one, other: f"(mul_nz {one} {other})", apart or ["one_nz"])
        total = "no_facts"
        for known, cofactors, own in reversed(rows):
            cofactor = product([scale // own, *cofactors])
            single = f"(fact ({spelled(cofactor)}) {known.hypothesis})"
            total = single if total == "no_facts" else f"(and_fact {single} {total})"
        return multiplier, total

    def combined(self, goal: Formula, proof: Proof, stem: str) -> str:
        """An auxiliary equation that is a combination of facts; its name."""
        multiplier, total = self.combination(proof)
        return self.prove_aside(goal, stem, f"refine (combine {multiplier} {total} _); {self.algebra}")

    def cleared(self, text: str) -> str:
        """A proof that a polynomial by which the equation is multiplied is not zero."""
        term, _ = polynomial(text, self.atoms)
        if shown := self.nonzero.get(spelled(term)):
            return shown[0]
        if own := self.divisor(term):
            return own
        for top, below in self.listed:
            if ratio(top, term) is not None:
                for own, other in list(self.nonzero.values()):
                    if (k := ratio(node("*", other, below), term)) is not None:
                        inverse = spelled(node("/", 1, below))
                        return self.apart(term, f"apply (nz_of ({shown_ratio(k)} * ({inverse})) {own}); {self.algebra}")
        raise NotExported(f"the factor {spelled(term)} is not shown to differ from zero")

    def prove(self, goal: Formula, proof: Proof) -> None:
        """One node of the proof."""
        rule = getattr(self, f"_{proof['rule']}", None)
        if rule is None:
            raise NotExported(f"the rule {proof['rule']}")
        kept = self.atoms
        if "atoms" in proof:
            self.atoms = {x: self.read(term) for x, term in proof["atoms"].items()}
        for term in map(self.read, proof.get("positive", ())):
            if spelled(term) not in self.nonzero and (shown := self.positive(term)):
                self.apart(term, f"exact (pos_nz {shown})")
        rule(goal, proof)
        self.atoms = kept

    def _identity(self, goal: Formula, proof: Proof) -> None:
        if not proof["cofactors"] and not proof.get("times"):
            self.emit(f"{self.algebra}.")
            return
        multiplier, total = self.combination(proof)
        self.emit(f"refine (combine {multiplier} {total} _). {self.algebra}.")

    def _nonnegative(self, goal: Formula, proof: Proof) -> None:
        form, strict = self.read(proof["form"]), len(goal.tag) == 1
        found = self.sign(form)
        if found is None or (strict and found.level < 2):
            raise NotExported("a form whose sign is not manifest")
        multiplier, total = self.combination(proof)
        sign = found.proof if strict else found.weak
        # the form is written down, as its sign may have been shown of another shape of it
        lemma = f"{ORDERS[goal.tag]} (f := {spelled(form)})"
        self.emit(f"refine ({lemma} {sign} {multiplier} {total} _). {self.algebra}.")

    def _implies(self, goal: Formula, proof: Proof) -> None:
        match goal:
            case Connective(formulas=(premise, conclusion)):
                self.emit(f"intros {self.assume(premise)}.")
            case _:
                conclusion = node("or")
                self.emit(f"{BY_CONTRADICTION[goal.tag]}intros {self.assume(contrary(goal))}.")
        self.emit_later()
        self.prove(conclusion, proof["then"])

    def _each(self, goal: Formula, proof: Proof) -> None:
        parts: Sequence[Formula] = ()
        match goal:
            case Connective(tag="and", formulas=parts):
                pass
            case Connective(formulas=(left, right)):
                parts = node("=>", left, right), node("=>", right, left)
        for k, (part, inner) in enumerate(zip(parts, proof["parts"], strict=True)):
            if k < len(parts) - 1:
                self.emit("split.")
            self.branch(part, inner)
        if not parts:
            self.emit("exact I.")

    def _choose(self, goal: Formula, proof: Proof) -> None:
        assert isinstance(goal, Connective)
        index, last = proof["index"], len(goal.formulas) - 1
        self.emit("right. " * index + ("left." if index < last else ""))
        self.prove(goal.formulas[index], proof["then"])

    def _cases_or(self, goal: Formula, proof: Proof) -> None:
        known = self.fact(proof["or"], ("or",))
        assert isinstance(known.formula, Connective)
        hypothesis, parts = known.hypothesis, known.formula.formulas
        for k, (part, inner) in enumerate(zip(parts, proof["cases"], strict=True)):
            last = k == len(parts) - 1
            rest = self.anew("c")
            if not last:
                self.emit(f"destruct {hypothesis} as [{rest}|{rest}].")
            with self.inside():
                pattern, own = self.assume(part), hypothesis if last else rest
                self.emit(f"destruct {own} as {pattern}." if pattern[0] == "[" else f"rename {own} into {pattern}.")
                self.emit_later()
                self.prove(goal, inner)
            hypothesis = rest

    def _split(self, goal: Formula, proof: Proof) -> None:
        form = self.read(proof["form"])
        powers = [power for power in form.outside if isinstance(power, Node)] if isinstance(form, Node) else []
        bases = [(base, exponent) for base, exponent in (power.terms for power in powers) if isinstance(exponent, int)]
        if not bases:
            raise NotExported("a product of nothing")
        self.divides = self.divides or any(isinstance(t, Node) and t.tag == "/" for t in subterms(*powers))
        whole = reduce(lambda rest, power: node("*", power, rest), reversed(powers))
        own = self.combined(node("=", whole, 0), proof, "p")
        for k, ((base, exponent), inner) in enumerate(zip(bases, proof["cases"], strict=True)):
            fact = self.anew("h")
            if k < len(bases) - 1:
                rest = self.anew("p")
                self.emit(f"destruct (first_zero {exponent} {own}) as [{fact}|{rest}].")
            else:
                self.emit(f"pose proof (pow_zero {exponent} {own}) as {fact}.")
                rest = own
            own = rest
            with self.inside():
                self.learn(node("=", base, 0), fact)
                self.prove(goal, inner)

    def _vanish(self, goal: Formula, proof: Proof) -> None:
        form = self.read(proof["form"])
        assert isinstance(form, Value)
        addends = form.terms
        names = [self.combined(node("=", form, 0), proof, "v")]
        for k in range(len(addends) - 1, 0, -1):
            front, last = self.sign(node("+", *addends[:k])), self.sign(addends[k])
            if front is None or last is None:
                raise NotExported("an addend that is not manifestly not negative")
            rest, zero = self.anew("v"), self.anew("h")
            self.emit(f"destruct (vanish_both {front.weak} {last.weak} {names[0]}) as [{rest} {zero}].")
            names = [rest, zero, *names[1:]]
        for addend, zero in zip(addends, names, strict=True):
            self.learn(node("=", addend, 0), zero)
        self.prove(goal, proof["then"])

    def _absurd(self, goal: Formula, proof: Proof) -> None:
        multiplier, total = self.combination(proof)
        self.emit(f"exfalso. refine (combine_false {multiplier} {total} _). {self.algebra}.")

    def _witness(self, goal: Formula, proof: Proof) -> None:
        assert isinstance(goal, Quantified)
        point = {x: self.read(term) for x, term in proof["point"].items()}
        for x in goal.bound:
            self.emit(f"exists ({spelled(point[x])}).")
        body = substituted(goal.body, point)
        self.functions([body])
        self.prove(body, proof["then"])

    def _every(self, goal: Formula, proof: Proof) -> None:
        body = self.opened(goal, proof["letters"])
        self.emit(f"intros {' '.join(map(name, proof['letters']))}.")
        self.functions([body])
        self.slopes([body])
        self.prove(self.worked(body), proof["then"])

    def opened(self, formula: Formula, new: Sequence[str]) -> Formula:
        """The body with new letters for those bound."""
        assert isinstance(formula, Quantified)
        self.scope.update(new)
        return substituted(formula.body, dict(zip(formula.bound, new, strict=True)))

    def _have(self, goal: Formula, proof: Proof) -> None:
        formula = self.full(self.definitions.formula(proof["formula"]))
        own = self.anew("t")
        self.emit(f"assert ({own} : {spelled(formula)}).")
        self.branch(formula, proof["proof"])
        self.known(formula, f"exact {own}")
        self.prove(goal, proof["then"])

    def _theorem(self, goal: Formula, proof: Proof) -> None:
        theorem = Application(self, proof)
        names = []
        for premise, inner in zip(theorem.premises, proof["premises"], strict=True):
            names.append(self.anew("t"))
            self.emit(f"assert ({names[-1]} : {spelled(premise)}).")
            self.branch(premise, inner)
        self.known(theorem.conclusion, theorem.by(names), proof.get("letters", []))
        self.prove(goal, proof["then"])

    def known(self, conclusion: Formula, by: str, new: Sequence[str] = ()) -> None:
        """One more assumption, with its proof; what it says to exist gets new letters."""
        self.same_functions([conclusion])
        fact = self.opened(conclusion, new) if new else conclusion
        self.emit(f"assert ({spelled(conclusion)}) as {pattern([*map(name, new), self.assume(fact)])} by ({by}).")
        self.functions([fact] if new else [])
        self.emit_later()


def mentioned(proof: JSON) -> Iterator[JSON]:
    """The terms and formulas that a proof brings in: forms, points, positive factors, what theorems speak of."""
    match proof:
        case ["positive", term]:
            yield term
        case list():
            for each in proof:
                yield from mentioned(each)
        case dict():
            for entry in proof.items():
                match entry:
                    case "form" | "formula", data:
                        yield data
                    case "positive", list(listed):
                        yield from listed
                    case "atoms" | "point" | "numbers" | "with", dict(named):
                        yield from (data["term"] if isinstance(data, dict) else data for data in named.values())
                    case _, data:
                        yield from mentioned(data)
