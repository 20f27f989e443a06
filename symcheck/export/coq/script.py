"""From the proof of a certificate to a proof script of Coq, rule by rule as in `symcheck/checker.py`.

The script says everything (cofactors, forms, which fact has which sign), so that Coq searches for nothing. What this
module gets wrong does not compile.
"""

from __future__ import annotations

from math import lcm, prod
from typing import Any

from symcheck.export.coq.arithmetic import derivative, is_slope, product, ratio_text
from symcheck.export.coq.assumptions import Known
from symcheck.export.coq.functions import Functions
from symcheck.export.coq.printing import name
from symcheck.export.coq.terms import NotExported, denominators, letters, polynomial, substituted, subterms
from symcheck.export.coq.theorems import apply, missing
from symcheck.export.coq.values import OPAQUE
from symcheck.proof.theorems import conjuncts, contrary

BY_CONTRADICTION = {
    "!=": "", "<": "apply Rnot_ge_lt. ", "<=": "apply Rnot_gt_le. ",
    ">": "apply Rnot_le_gt. ", ">=": "apply Rnot_lt_ge. ",
}  # fmt: skip
ORDERS = {"<": "combine_lt", "<=": "combine_le", ">": "combine_lt", ">=": "combine_ge"}


class Script(Functions):
    """One proof, rule by rule."""

    def write(self, proof: Any) -> str:
        """The whole script."""
        if reason := missing(proof):
            raise NotExported(reason)
        statement = self.statement
        self.emit(f"intros {' '.join(statement.names)}." if statement.names else "")
        for x in statement.defined:
            own = self.anew("d")
            self.emit(f"intros {own}. subst {name(x)}.")
        for reference, formula in statement.hypotheses:
            self.emit(f"intros {self.assume(formula, reference)}.")
            self.emit_later()
        self.own = len(self.state)
        self.atoms = {x: self.full(term) for x, term in proof.get("atoms", {}).items()}
        goal = self.full(statement.conclusion)
        spoken = [goal, *(known.formula for known in self.state.values()), *map(self.full, terms_in(proof))]
        spoken += [known.great for known in self.state.values() if known.sign == ">"]
        spoken += list(self.atoms.values())
        self.divides = any("/" in str(each) or "^', -" in str(each) or "tan" in str(each) for each in spoken)
        self.divides = self.divides or "'sqrt'" in str(spoken)
        premises = []
        for divisor in statement.premises:
            own = self.anew("n")
            self.emit(f"intros {own}.")
            premises.append((own, self.full(divisor)))
        if "'tan'" in str(
            [f for _, f in statement.hypotheses] + [statement.conclusion, list(statement.definitions.terms.values())]
        ):
            self.emit("unfold tan in *.")
        if any(f"'{function}'" in str(spoken) for function in ("diff", "sin", "cos", "call", *OPAQUE)):
            self.emit("unfold Rminus in *.")
        self.functions(spoken)
        self.same_functions([t for each in spoken for t in subterms(each) if not [*denominators(t)]])
        for own, divisor in premises:
            self.keep(divisor, own)
        slopes = {
            str(t): t for each in spoken for t in subterms(each) if is_slope(t) and self.scope.issuperset(letters(t))
        }
        if slopes:
            worked = [self.full(derivative(t)) for t in slopes.values()]
            self.functions(worked)
            self.divisors([*spoken, *worked], proof)
            for slope, term in zip(slopes.values(), worked, strict=True):
                self.slope(slope, term)
            self.rewritten |= dict(zip(slopes, worked, strict=True))
        if self.rewritten:
            goal, spoken = self.worked(goal), [*map(self.worked, spoken)]
            self.state = {reference: self.reworked(known) for reference, known in self.state.items()}
        self.divisors(spoken, proof)
        self.same_functions(spoken)
        for texts in proof.get("nonzero", []):
            top, *below = (polynomial(text, self.atoms)[0] for text in texts)
            self.listed.append((top, below))
        self.prove(goal, proof)
        return "\n".join(line for line in self.lines if line)

    def branch(self, goal: Any, proof: Any) -> None:
        """A subgoal of its own."""
        with self.inside():
            self.prove(goal, proof)

    def reworked(self, known: Known) -> Known:
        """An assumption after derivatives are worked out."""
        great, small, formula = (self.worked(part) for part in known[1:4])
        return known._replace(great=great, small=small, formula=formula)

    def combination(self, proof: Any) -> tuple[str, str]:
        """A proof that the multiplier is not zero, and one that the sum of cofactors times facts is zero."""
        apart = []
        for text in proof.get("clear", ()):
            apart.append(self.cleared(text))
        for reference in proof.get("times", ()):
            if reference[0] == "positive":
                found = self.sign(self.full(reference[1]))
                if found is None or found.level < 2:
                    raise NotExported("a factor that is not manifestly positive")
                apart.append(f"(pos_nz {found.proof})")
            else:
                apart.append(self.apart(self.fact(reference, ("!=", ">"))))
        rows = []
        for reference, *texts in proof["cofactors"]:
            known = self.fact(reference, ("=",))
            polynomials = [polynomial(text, self.atoms) for text in texts]
            rows.append((known, [p for p, _ in polynomials], prod(scale for _, scale in polynomials)))
        scale = 1
        for *_, own in rows:
            scale = lcm(scale, own)
        if scale > 1:
            apart.append(f"(num_nz {scale})")
        multiplier = apart[0] if apart else "one_nz"
        for each in apart[1:]:
            multiplier = f"(mul_nz {multiplier} {each})"
        total = "no_facts"
        for known, cofactors, own in reversed(rows):
            cofactor = product([scale // own, *cofactors])
            single = f"(fact ({self.text(cofactor)}) {known.hypothesis})"
            total = single if total == "no_facts" else f"(and_fact {single} {total})"
        return multiplier, total

    def cleared(self, text: str) -> str:
        """A proof that a polynomial by which the equation is multiplied is not zero."""
        term, _ = polynomial(text, self.atoms)
        shown = self.text(term)
        if shown in self.nonzero:
            return self.nonzero[shown][0]
        for own, other in list(self.nonzero.values()):
            if (k := self.ratio(other, term)) is not None:
                made = self.prove_aside(["!=", term, 0], "n", f"apply (nz_of {ratio_text(k)} {own}); {self.algebra}")
                self.keep(term, made)
                return made
        for top, below in self.listed:
            if self.ratio(top, term) is not None:
                for own, other in list(self.nonzero.values()):
                    whole = ["*", other, *below]
                    if below and (k := self.ratio(whole, term)) is not None:
                        inverse = ["/", 1, ["*", *below]]
                        by = f"apply (nz_of ({ratio_text(k)} * ({self.text(inverse)})) {own}); {self.algebra}"
                        made = self.prove_aside(["!=", term, 0], "n", by)
                        self.keep(term, made)
                        return made
        found = self.sign(term)
        if found is not None and found.level == 2:
            return f"(pos_nz {found.proof})"
        raise NotExported(f"the factor {shown} is not shown to differ from zero")

    def prove(self, goal: Any, proof: Any) -> None:
        """One node of the proof."""
        rule = getattr(self, f"_{proof['rule']}", None)
        if rule is None:
            raise NotExported(f"the rule {proof['rule']}")
        rule(goal, proof)

    def _identity(self, goal: Any, proof: Any) -> None:
        if not proof["cofactors"] and not proof.get("clear") and not proof.get("times"):
            self.emit(f"{self.algebra}.")
            return
        multiplier, total = self.combination(proof)
        self.emit(f"refine (combine {multiplier} {total} _). {self.algebra}.")

    def _nonnegative(self, goal: Any, proof: Any) -> None:
        form = self.full(proof["form"])
        found = self.sign(form)
        if found is None:
            raise NotExported("a form whose sign is not manifest")
        lemma = ORDERS[goal[0]]
        if len(goal[0]) == 1 and found.level < 2:
            raise NotExported("a form that is not manifestly positive")
        multiplier, total = self.combination(proof)
        sign = found.proof if len(goal[0]) == 1 else found.weak
        # the form is written down, as its sign may have been shown of another shape of it
        self.emit(f"refine ({lemma} (f := {self.text(form)}) {sign} {multiplier} {total} _). {self.algebra}.")

    def _implies(self, goal: Any, proof: Any) -> None:
        if goal[0] == "=>":
            self.emit(f"intros {self.assume(goal[1])}.")
            self.emit_later()
            self.prove(goal[2], proof["then"])
            return
        opposite = contrary(goal)
        self.emit(f"{BY_CONTRADICTION[goal[0]]}intros {self.assume(opposite)}.")
        self.emit_later()
        self.prove(["or"], proof["then"])

    def _each(self, goal: Any, proof: Any) -> None:
        parts = goal[1:] if goal[0] == "and" else [["=>", *goal[1:]], ["=>", *goal[:0:-1]]]
        for k, (part, inner) in enumerate(zip(parts, proof["parts"], strict=True)):
            if k < len(parts) - 1:
                self.emit("split.")
            self.branch(part, inner)
        if not parts:
            self.emit("exact I.")

    def _choose(self, goal: Any, proof: Any) -> None:
        index, last = proof["index"], len(goal) - 2
        self.emit("right. " * index + ("left." if index < last else ""))
        self.prove(goal[1 + index], proof["then"])

    def _cases_or(self, goal: Any, proof: Any) -> None:
        known = self.fact(proof["or"], ("or",))
        hypothesis, parts = known.hypothesis, known.formula[1:]
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

    def _split(self, goal: Any, proof: Any) -> None:
        bases = [(self.base(text), exponent) for text, exponent in proof["factors"]]
        product: Any = 1
        for base, exponent in reversed(bases):
            power = ["^", base, exponent]
            product = ["*", power, product] if product != 1 else power
        if not bases:
            raise NotExported("a product of nothing")
        multiplier, total = self.combination(proof)
        own = self.prove_aside(["=", product, 0], "p", f"refine (combine {multiplier} {total} _); {self.algebra}")
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
                self.learn(["=", base, 0], fact)
                self.prove(goal, inner)

    def base(self, text: str) -> Any:
        """A polynomial with its own coefficients."""
        term, scale = polynomial(text, self.atoms)
        if scale > 1:
            self.divides = True
        return term if scale == 1 else ["/", term, scale]

    def _vanish(self, goal: Any, proof: Any) -> None:
        addends = self.full(proof["form"])[1:]
        multiplier, total = self.combination(proof)
        form = ["+", *addends] if len(addends) > 1 else addends[0]
        signs = [self.sign(addend) for addend in addends]
        own = self.prove_aside(["=", form, 0], "v", f"refine (combine {multiplier} {total} _); {self.algebra}")
        names = [own]
        for k in range(len(addends) - 1, 0, -1):
            front = self._of_sum(addends[:k])
            last = signs[k]
            if front is None or last is None:
                raise NotExported("an addend that is not manifestly not negative")
            rest, zero = self.anew("v"), self.anew("h")
            self.emit(f"destruct (vanish_both {front.weak} {last.weak} {names[0]}) as [{rest} {zero}].")
            names = [rest, zero, *names[1:]]
        for addend, zero in zip(addends, names, strict=True):
            for part in conjuncts(["=", addend, 0]):
                self.learn(part, zero)
        self.prove(goal, proof["then"])

    def _absurd(self, goal: Any, proof: Any) -> None:
        multiplier, total = self.combination(proof)
        self.emit(f"exfalso. refine (combine_false {multiplier} {total} _). {self.algebra}.")

    def _witness(self, goal: Any, proof: Any) -> None:
        point = {x: self.full(term) for x, term in proof["point"].items()}
        for x in goal[1]:
            self.emit(f"exists ({self.text(point[x])}).")
        body = substituted(goal[2], point)
        self.functions([body])
        self.prove(body, proof["then"])

    def _theorem(self, goal: Any, proof: Any) -> None:
        apply(self, goal, proof)


def terms_in(node: Any) -> list[Any]:
    """The terms that a proof brings in: forms, points, positive factors, what theorems speak of."""
    if isinstance(node, dict):
        own = [node["form"]] if "form" in node else [*node.get("point", {}).values()]
        own += [t for t in node.get("of", ())[1:] if isinstance(t, list)]
        own += list(node.get("positive", ()))
        return own + [
            t
            for key, value in node.items()
            if key not in ("of", "form", "point", "positive", "atoms")
            for t in terms_in(value)
        ]
    if isinstance(node, list):
        if len(node) == 2 and node[0] == "positive":
            return [node[1]]
        return [t for child in node for t in terms_in(child)]
    return []
