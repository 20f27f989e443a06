"""From the proof of a certificate to a proof script of Coq, rule by rule as in `symcheck/checker.py`.

The script says everything (cofactors, forms, which fact has which sign), so that Coq searches for nothing. What this
module gets wrong does not compile.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from fractions import Fraction
from math import prod
from typing import Any, NamedTuple

from symcheck.export.coq.printing import ATOM, name, spelled
from symcheck.export.coq.statements import Statement
from symcheck.export.coq.theorems import apply, missing
from symcheck.export.coq.terms import (
    NotExported,
    denominators,
    factors,
    is_number,
    letters,
    polynomial,
    rebuilt,
    substituted,
    subterms,
)
from symcheck.export.coq.values import OPAQUE, Values, turns
from symcheck.theorems import RELATIONS, Terms, conjuncts, contrary

BY_CONTRADICTION = {
    "!=": "", "<": "apply Rnot_ge_lt. ", "<=": "apply Rnot_gt_le. ", ">": "apply Rnot_le_gt. ", ">=": "apply Rnot_lt_ge. ",
}  # fmt: skip
ORDERS = {"<": "combine_lt", "<=": "combine_le", ">": "combine_lt", ">=": "combine_ge"}


class Known(NamedTuple):
    """An assumption in force: a relation great ~ small (">" and "<" alike), or another formula; and its name in Coq."""

    sign: str
    great: Any
    small: Any
    formula: Any
    hypothesis: str


class Sign(NamedTuple):
    """A proof term of 0 < t (level 2) or 0 <= t (level 1)."""

    level: int
    proof: str

    @property
    def weak(self) -> str:
        return f"(Rlt_le _ _ {self.proof})" if self.level == 2 else self.proof


class Script:
    """One proof being written."""

    def __init__(self, statement: Statement) -> None:
        self.statement, self.values = statement, Values()
        self.rewritten: dict[str, Any] = {}  # text of a term -> what it is rewritten to
        self.lines: list[str] = []
        self.state: dict[Any, Known] = {}
        self.own = 0  # how many of them are hypotheses
        self.nonzero: dict[str, tuple[str, Any]] = {}  # text -> name of the fact, term
        self.hints: list[str] = []
        self.divides = False
        self.count = 0
        self.atoms: dict[str, Any] = {}
        self.listed: list[tuple[Any, list[Any]]] = []  # numerators of divisors, and what they are divided by
        self.scope: set[str] = set(statement.variables)  # the letters there are
        self.seen: dict[int, Any] = {}  # functions by their values, as first met
        self.settled: set[str] = set()  # the functions of which everything is said

    def full(self, node: Any) -> Any:
        """A term or formula as it stands in Coq after the beginning: unfolded, without tangents and derivatives."""
        return self.worked(without_tangents(self.statement.definitions.unfolded(node)))

    def worked(self, node: Any) -> Any:
        if not self.rewritten or not isinstance(node, list):
            return node
        return self.rewritten.get(str(node)) or rebuilt(node, self.worked)

    # writing

    def emit(self, line: str) -> None:
        self.lines.append(line)

    def anew(self, stem: str) -> str:
        self.count += 1
        return f"{stem}{self.count}'"

    def text(self, term: Any) -> str:
        return spelled(term)

    def bracketed(self, term: Any) -> str:
        return spelled(term, ATOM)

    @property
    def algebra(self) -> str:
        """The tactic that ends every computation."""
        hints = f" [{' '.join(self.hints)}]" if self.hints else ""
        return f"field{hints}; nonzero" if self.divides else f"ring{hints}"

    def prove_aside(self, formula: Any, stem: str, by: str) -> str:
        """An auxiliary fact with a proof of one line; its name."""
        own = self.anew(stem)
        self.emit(f"assert ({own} : {spelled(formula)}) by ({by}).")
        return own

    # the beginning

    def write(self, proof: Any) -> str:
        """The whole script."""
        if reason := missing(proof):
            raise NotExported(reason)
        statement = self.statement
        self.emit(f"intros {' '.join(map(name, statement.variables))}." if statement.variables else "")
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
        if any(f"'{function}'" in str(spoken) for function in ("diff", "sin", "cos", *OPAQUE)):
            self.emit("unfold Rminus in *.")
        self.functions(spoken)
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
            self.state = {
                r: Known(known.sign, *map(self.worked, known[1:4]), known.hypothesis) for r, known in self.state.items()
            }
        self.divisors(spoken, proof)
        self.same_functions(spoken)
        for texts in proof.get("nonzero", []):
            top, *below = (polynomial(text, self.atoms)[0] for text in texts)
            self.listed.append((top, below))
        self.prove(goal, proof)
        return "\n".join(line for line in self.lines if line)

    def functions(self, spoken: list[Any]) -> None:
        """What is true of sines, cosines and roots of numbers by themselves."""
        angles: dict[str, Any] = {}
        for term in (t for each in spoken for t in subterms(each) if self.scope.issuperset(letters(t))):
            match term:
                case str():
                    kind, _, x = term.partition("_")
                    if kind in ("sin", "cos") and x:
                        angles.setdefault(spelled(x, ATOM), x)
                    elif kind == "sqrt" and x:
                        self.root(int(x))
                case ["sin" | "cos", angle]:
                    angles.setdefault(spelled(angle, ATOM), angle)
                case ["sqrt", inner] if is_number(inner):
                    self.root(inner)
        for angle in list(angles.values()):
            counts, rest = turns(angle)
            for x in (*(x for x, _ in counts), *([rest] if rest != 0 and counts else [])):
                angles.setdefault(spelled(x, ATOM), x)
        for shown, angle in angles.items():
            if shown in self.settled:
                continue
            self.settled.add(shown)
            counts, rest = turns(angle)
            if isinstance(angle, str) or (rest != 0 and not counts):
                self.hint(f"(circle {shown})")
            elif counts or rest == 0:
                self.turned(shown, counts, rest)

    def hint(self, proof: str) -> None:
        own = self.anew("e")
        self.emit(f"pose proof {proof} as {own}.")
        self.hints.append(own)

    def turned(self, shown: str, counts: list[tuple[str, int]], rest: Any) -> None:
        """The addition theorems for an angle."""
        parts = [name(x) if n > 0 else f"(- {name(x)})" for x, n in counts for _ in range(abs(n))]
        parts += [spelled(rest, ATOM)] if rest != 0 else []
        total = " + ".join(parts) or "0"
        cosine, sine = addition([(f"cos {p}", f"sin {p}") for p in parts])
        for function, value in (("cos", cosine), ("sin", sine)):
            own = self.anew("e")
            value = value.replace("cos (- ", "cos (").replace("sin (- ", "- sin (")
            self.emit(
                f"assert ({own} : {function} {shown} = {value}) by (replace {shown} with ({total}) by field; turn)."
            )
            self.hints.append(own)

    def root(self, number: Any) -> None:
        """The square of the root of a prime number, or the root of another number by those."""
        shown = spelled(number, ATOM)
        if f"sqrt {shown}" in self.settled:
            return
        self.settled.add(f"sqrt {shown}")
        if isinstance(number, int) and number > 1 and all(number % p for p in range(2, number)):
            self.hint(f"(root_of_number {shown} ltac:(lra))")
            return
        value = self.values.chance.rational(self.values.value(["^", ["sqrt", number], 2]))
        assert value is not None
        outer, inner = square_part(value)
        for p in inner:
            self.root(p)
        product = " * ".join(
            [
                f"{outer.numerator} / {outer.denominator}" if outer.denominator > 1 else f"{outer.numerator}",
                *(f"sqrt {p}" for p in inner),
            ]
        )
        by = f"apply (root_is (t := {shown}) (v := {product})); [ lra | repeat apply mul_nn; try apply sqrt_pos; lra | "
        own = self.anew("e")
        self.emit(f"assert ({own} : sqrt {shown} = {product}) by ({by}field{self.hinted()} ]).")
        if outer.denominator > 1:  # `ring` takes polynomials alone as hints
            self.emit(f"rewrite {own} in *.")
            self.rewritten[str(["sqrt", number])] = [
                "*",
                ["/", outer.numerator, outer.denominator],
                *(["sqrt", p] for p in inner),
            ]
            return
        self.hints.append(own)

    def hinted(self) -> str:
        return f" [{' '.join(self.hints)}]" if self.hints else ""

    def divisors(self, spoken: list[Any], proof: Any) -> None:
        """That no denominator is zero: by a premise, by a hypothesis, by a number or by a sign."""
        for divisor in (d for each in spoken for d in denominators(each) if self.scope.issuperset(letters(d))):
            if not isinstance(divisor, int) and self.text(divisor) not in self.nonzero:
                self.divisor(divisor)
        for term in proof.get("positive", ()):
            term = self.full(term)
            if self.text(term) not in self.nonzero and (found := self.sign(term)) is not None and found.level == 2:
                self.keep(term, self.prove_aside(["!=", term, 0], "n", f"exact (pos_nz {found.proof})"))

    def keep(self, term: Any, own: str) -> None:
        """A denominator that is not zero; and if it is a sum of fractions, its numerator, which `field` asks for."""
        self.nonzero[self.text(term)] = (own, term)
        several = list(factors(term))
        for k, each in enumerate(several if len(several) > 1 else ()):
            if not isinstance(each, int) and self.text(each) not in self.nonzero:
                rest = product([*several[:k], *several[k + 1 :]])
                by = f"apply (nz_of ({self.text(rest)}) {own}); {self.algebra}"
                self.nonzero[self.text(each)] = (self.prove_aside(["!=", each, 0], "n", by), each)
        top, below = fraction(term)
        if below and not isinstance(top, int) and self.text(top) not in self.nonzero:
            by = f"apply (nz_over (b := {self.text(product(below))}) {own}); [ nonzero | {self.algebra} ]"
            self.nonzero[self.text(top)] = (self.prove_aside(["!=", top, 0], "n", by), top)

    def divisor(self, term: Any) -> None:
        for known in self.state.values():
            if known.sign in ("!=", ">") and (k := self.ratio(difference(known), term)) is not None:
                fact = self.apart(known)
                by = f"apply (nz_of {ratio_text(k)} {fact}); {self.algebra}"
                self.keep(term, self.prove_aside(["!=", term, 0], "n", by))
                return
        for own, other in list(self.nonzero.values()):
            if (k := self.ratio(other, term)) is not None:
                self.keep(
                    term, self.prove_aside(["!=", term, 0], "n", f"apply (nz_of {ratio_text(k)} {own}); {self.algebra}")
                )
                return
        found = self.sign(term)
        if found is not None and found.level == 2:
            self.keep(term, self.prove_aside(["!=", term, 0], "n", f"exact (pos_nz {found.proof})"))
            return
        found = self.sign(["-", term])
        if found is not None and found.level == 2:
            self.keep(term, self.prove_aside(["!=", term, 0], "n", f"exact (neg_nz {found.proof})"))
            return
        if is_number(term):
            square = self.values.chance.rational(self.values.value(["^", term, 2]))
            if square:
                by = f"intro Z; assert (S : ({self.text(term)}) ^ 2 = 0) by (rewrite Z; ring); "
                by += f"assert (T : ({self.text(term)}) ^ 2 = {ratio_text(square)}) by ({self.algebra}); lra"
                self.keep(term, self.prove_aside(["!=", term, 0], "n", by))
                return

    def ratio(self, one: Any, other: Any) -> Fraction | None:
        """one / other, if that is a rational number and not zero."""
        return self.values.ratio(one, other) or None

    def apart(self, known: Known) -> str:
        """A proof that the difference of an assumption is not zero."""
        return f"(sub_nz {known.hypothesis})" if known.sign == "!=" else f"(pos_nz (lt_pos {known.hypothesis}))"

    def slope(self, slope: Any, term: Any) -> None:
        """A derivative, worked out."""
        _, body, x, order = slope
        kept, self.divides = self.divides, True
        self.bases(body)
        own, step = (
            self.anew("d"),
            f"apply is_derive_unique; unfold Rpower; auto_derive; [ conditions | powers; {self.algebra} ]",
        )
        if order == 1:
            self.emit(f"assert ({own} : {spelled(['=', slope, term])}) by ({step}).")
        elif order == 2:
            first = self.full(derivative(["diff", body, x, 1]))
            near = self.nearby(body, x)
            functions = " ".join(f"(fun {name(x)} => {spelled(t)})" for t in (near, first))
            self.emit(f"assert ({own} : {spelled(['=', slope, term])}).")
            self.emit(f"{{ apply (derive_twice {functions}).")
            self.emit("{ auto_derive; conditions. }")
            self.emit("{ conditions. }")
            at, positive = self.anew("x"), self.anew("s")
            self.emit(f"{{ intros {at} {positive}. cbv beta in {positive}. pose proof (pos_nz {positive}). {step}. }}")
            self.emit(f"{{ {step}. }} }}")
        else:
            raise NotExported("a derivative of third order")
        self.emit(f"rewrite {own} in *.")
        self.divides = kept

    def nearby(self, body: Any, x: str) -> Any:
        """What is positive at the letter and makes the function differentiable: the letter, or the base of a power."""
        if any(known.sign == ">" and known.great == x and known.small == 0 for known in self.state.values()):
            return x
        return next((t[1] for t in subterms(body) if isinstance(t, list) and t[0] == "pow" and x in letters(t[1])), 1)

    def bases(self, term: Any) -> None:
        """The bases of powers are positive: said once, as `auto_derive` asks for it."""
        for base in (t[1] for t in subterms(term) if isinstance(t, list) and t[0] in ("pow", "log", "sqrt")):
            found = self.sign(base)
            if found is not None and found.level == 1 and self.text(base) in self.nonzero:
                found = Sign(2, f"(nz_pos {found.proof} {self.nonzero[self.text(base)][0]})")
            if found is not None and found.level == 2 and self.text(base) not in self.settled:
                self.settled.add(self.text(base))
                self.prove_aside(["<", 0, base], "s", f"exact {found.proof}")

    def same_functions(self, spoken: list[Any]) -> None:
        """Functions of equal arguments that are written differently."""
        seen = self.seen
        for term in (t for each in spoken for t in subterms(each) if self.scope.issuperset(letters(t))):
            if isinstance(term, list) and term[0] in OPAQUE and not (term[0] == "sqrt" and is_number(term)):
                value = self.values.value(term)
                if term[0] == "pow" and (whole := self.ratio(term[2], 1)) is not None and whole.denominator == 1:
                    raise NotExported("a power whose exponent adds up to a whole number")
                first = seen.setdefault(value, term)
                if self.text(first) != self.text(term) and self.text(term) not in self.settled:
                    self.settled.add(self.text(term))
                    by = f"f_equal; {self.algebra}"
                    self.hints.append(self.prove_aside(["=", term, first], "e", by))

    # assumptions

    def assume(self, formula: Any, reference: Any = None) -> str:
        """Takes in an assumption, part by part; the pattern that takes it apart in Coq."""
        return self._pattern(self.full(formula), reference)

    def _pattern(self, formula: Any, reference: Any) -> str:
        if formula[0] == "and":
            parts = [self._pattern(part, None) for part in formula[1:]]
            if not parts:
                return "_"
            return parts[0] if len(parts) == 1 else f"[{' ['.join(parts[:-1])} {parts[-1]}{']' * (len(parts) - 1)}"
        own = self.anew("h")
        self.learn(formula, own, reference)
        return own

    def learn(self, formula: Any, own: str, reference: Any = None) -> None:
        sign, *content = formula
        great, small = content if sign in RELATIONS else (None, None)
        if sign in ("<", "<="):
            sign, great, small = sign.replace("<", ">"), small, great
        if reference is None:
            reference = ("here", len(self.state) - self.own)
        self.state[reference] = Known(sign, great, small, formula, own)

    def emit_later(self) -> None:
        """An assumption a >= b is turned round: 0 <= a - b is what is used of it."""
        for known in self.state.values():
            line = f"apply Rge_le in {known.hypothesis}."
            if known.formula[0] == ">=" and line not in self.lines:
                self.emit(line)

    def fact(self, reference: Any, signs: Iterable[str]) -> Known:
        known = self.state.get(tuple(reference))
        if known is None or known.sign not in signs:
            raise NotExported(f"the assumption {reference}")
        return known

    @contextmanager
    def inside(self) -> Iterator[None]:
        """Braces around a subgoal; what is learned in it is forgotten afterwards."""
        kept = dict(self.state), dict(self.nonzero), list(self.hints), set(self.scope), set(self.settled)
        self.emit("{")
        yield
        self.emit("}")
        self.state, self.nonzero, self.hints, self.scope, self.settled = kept

    def branch(self, goal: Any, proof: Any) -> None:
        """A subgoal of its own."""
        with self.inside():
            self.prove(goal, proof)

    # combinations of facts

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
            scale = scale * own // _gcd(scale, own)
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

    # signs

    def sign(self, term: Any) -> Sign | None:
        """A proof that a term is manifestly positive or not negative, found as the checker finds it."""
        match term:
            case int():
                if term < 0:
                    return None
                return Sign(2, f"(num_pos {term})") if term else Sign(1, "(Rle_refl 0)")
            case "pi":
                return Sign(2, "PI_RGT_0")
            case ["+", *parts]:
                found = self._of_sum(parts)
            case ["*", *parts]:
                found = self._of_product(term, parts)
            case ["/", top, bottom]:
                found = self._of_quotient(top, bottom)
            case ["^", base, int(n)] if n > 0:
                found = self._of_power(base, n)
            case ["sqrt", number] if is_number(number) and isinstance(number, int) and number > 0:
                return Sign(2, f"(sqrt_lt_R0 _ (num_pos {number}))")
            case str() if term[:5] == "sqrt_":
                return Sign(2, f"(sqrt_lt_R0 _ (num_pos {term[5:]}))")
            case _:
                found = None
        return found or self._known(term)

    def _of_sum(self, parts: list[Any]) -> Sign | None:
        found: Sign | None = None
        for k, part in enumerate(parts):
            other = self.sign(part)
            if other is None:
                return None
            if k == 0 or found is None:
                found = other
            else:
                kind = ("n" if found.level == 1 else "p") + ("n" if other.level == 1 else "p")
                found = Sign(max(found.level, other.level), f"(add_{kind} {found.proof} {other.proof})")
        return found

    def _of_product(self, term: Any, parts: list[Any]) -> Sign | None:
        single = [t for k, t in enumerate(parts) if parts.count(t) % 2 and t not in parts[:k]]
        distinct = [t for k, t in enumerate(parts) if t not in parts[:k]]
        squares = [["^", t, 2] for t in distinct for _ in range(parts.count(t) // 2)]
        arranged = [*squares, *single] if squares else parts
        found: Sign | None = None
        for part in arranged:
            other = self.sign(part)
            if other is None:
                return None
            if found is None:
                found = other
            elif found.level == other.level == 2:
                found = Sign(2, f"(mul_pp {found.proof} {other.proof})")
            else:
                found = Sign(1, f"(mul_nn {found.weak} {other.weak})")
        if found is None or not squares:
            return found
        kind = "eq_pos" if found.level == 2 else "eq_nn"
        relation = ["<" if found.level == 2 else "<=", 0, term]
        return Sign(found.level, self.prove_aside(relation, "s", f"refine ({kind} {found.proof} _); ring"))

    def _of_quotient(self, top: Any, bottom: Any) -> Sign | None:
        above, below = self.sign(top), self.sign(bottom)
        if above is None or below is None:
            return None
        if above.level == 2 and below.level == 1 and self.text(bottom) in self.nonzero:
            below = Sign(2, f"(nz_pos {below.proof} {self.nonzero[self.text(bottom)][0]})")
        if above.level == below.level == 2:
            return Sign(2, f"(div_pp {above.proof} {below.proof})")
        return Sign(1, f"(div_nn {above.weak} {below.weak})")

    def _of_power(self, base: Any, n: int) -> Sign | None:
        found = self.sign(base)
        if found is not None:
            kind = "pow_pp" if found.level == 2 else "pow_nn"
            return Sign(found.level, f"({kind} {n} {found.proof})")
        return Sign(1, f"(pow_even ({self.text(base)}) {n} eq_refl)") if n % 2 == 0 else None

    def _known(self, term: Any) -> Sign | None:
        value = self.values.value(term)
        for known in self.state.values():
            if known.sign not in (">", ">=") or self.values.value(difference(known)) != value:
                continue
            level = 3 - len(known.sign)
            if known.small == 0 and self.text(known.great) == self.text(term):
                return Sign(level, known.hypothesis)
            lemma, gap = ("eq_pos", "lt_pos") if level == 2 else ("eq_nn", "le_nn")
            by = f"refine ({lemma} ({gap} {known.hypothesis}) _); {self.algebra}"
            return Sign(level, self.prove_aside(["<" if level == 2 else "<=", 0, term], "s", by))
        return None

    # rules

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


def _gcd(a: int, b: int) -> int:
    return a if b == 0 else _gcd(b, a % b)


def difference(known: Known) -> Any:
    """great - small."""
    return known.great if known.small == 0 else ["+", known.great, ["-", known.small]]


def derivative(slope: Any) -> Any:
    """What the table of the checker says it is."""
    _, body, x, order = slope
    return Terms({}).derived(body, x, order)


def is_slope(term: Any) -> bool:
    return isinstance(term, list) and term[0] == "diff"


def fraction(term: Any) -> tuple[Any, list[Any]]:
    """A term as a numerator over factors of a common denominator, put together like `field` does."""
    match term:
        case ["+", *parts]:
            read = [fraction(part) for part in parts]
            common: list[Any] = []
            for _, below in read:
                common += [
                    b
                    for b in dict_of(below).values()
                    if below.count(b) > common.count(b)
                    for _ in range(below.count(b) - common.count(b))
                ]
            return ["+", *(product([top, *without(common, below)]) for top, below in read)], common
        case ["-", inner]:
            top, below = fraction(inner)
            return ["-", top], below
        case ["*", *parts]:
            read = [fraction(part) for part in parts]
            return product([top for top, _ in read]), [b for _, below in read for b in below]
        case ["/", above, bottom]:
            (top, below), (divisor, lifted) = fraction(above), fraction(bottom)
            return (term, []) if isinstance(divisor, int) else (product([top, *lifted]), [*below, divisor])
        case ["^", base, int(n)] if n > 0:
            top, below = fraction(base)
            return ["^", top, n], below * n
    return term, []


def dict_of(terms: list[Any]) -> dict[str, Any]:
    return {str(t): t for t in terms}


def without(terms: list[Any], taken: list[Any]) -> list[Any]:
    left = list(terms)
    for t in taken:
        left.remove(t)
    return left


def product(terms: list[Any]) -> Any:
    kept = [t for t in terms if t != 1]
    return 1 if not kept else kept[0] if len(kept) == 1 else ["*", *kept]


def ratio_text(k: Fraction) -> str:
    sign, k = ("-" if k < 0 else ""), abs(k)
    return f"({sign}{k.numerator})" if k.denominator == 1 else f"({sign}{k.numerator} / {k.denominator})"


def square_part(value: Fraction) -> tuple[Fraction, list[int]]:
    """The root of a positive number: a rational number, and the primes under the roots."""
    whole, outer, primes = value.numerator * value.denominator, 1, []
    p = 2
    while whole > 1:
        while whole % (p * p) == 0:
            whole, outer = whole // (p * p), outer * p
        if whole % p == 0:
            whole, primes = whole // p, [*primes, p]
        p += 1
    return Fraction(outer, value.denominator), primes


def addition(parts: list[tuple[str, str]]) -> tuple[str, str]:
    """Cosine and sine of a sum of angles, as texts."""
    if not parts:
        return "1", "0"
    cosine, sine = parts[0]
    for c, s in parts[1:]:
        cosine, sine = f"(({cosine}) * {c} - ({sine}) * ({s}))", f"(({sine}) * {c} + ({cosine}) * ({s}))"
    return cosine, sine


def without_tangents(node: Any) -> Any:
    """tan x = sin x / cos x, as Coq defines it."""
    match node:
        case ["tan", angle]:
            angle = without_tangents(angle)
            return ["/", ["sin", angle], ["cos", angle]]
        case list():
            return [without_tangents(child) for child in node]
    return node


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
