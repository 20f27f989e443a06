"""What is said before a proof begins: of sines, cosines, roots, derivatives, and of everything that is divided by."""

from __future__ import annotations

from typing import Any

from symcheck.export.coq.arithmetic import addition, derivative, fraction, product, ratio_text, square_part
from symcheck.export.coq.assumptions import difference
from symcheck.export.coq.printing import ATOM, name, spelled
from symcheck.export.coq.signs import Sign, Signs
from symcheck.export.coq.terms import NotExported, denominators, factors, is_number, letters, subterms
from symcheck.export.coq.values import OPAQUE, turns


class Functions(Signs):
    """Facts about functions and denominators."""

    def functions(self, spoken: list[Any]) -> None:
        """What is true of sines, cosines and roots of numbers by themselves."""
        angles: dict[str, Any] = {}
        for term in (t for each in spoken for t in subterms(each) if self.scope.issuperset(letters(t))):
            match term:
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
        value = self.values.rational(self.values.value(["^", ["sqrt", number], 2]))
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
            square = self.values.rational(self.values.value(["^", term, 2]))
            if square:
                by = f"intro Z; assert (S : ({self.text(term)}) ^ 2 = 0) by (rewrite Z; ring); "
                by += f"assert (T : ({self.text(term)}) ^ 2 = {ratio_text(square)}) by ({self.algebra}); lra"
                self.keep(term, self.prove_aside(["!=", term, 0], "n", by))
                return

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
            if isinstance(term, list) and term[0] in (*OPAQUE, "call") and not (term[0] == "sqrt" and is_number(term)):
                value = self.values.value(term)
                if term[0] == "pow" and (whole := self.ratio(term[2], 1)) is not None and whole.denominator == 1:
                    raise NotExported("a power whose exponent adds up to a whole number")
                first = seen.setdefault(value, term)
                if self.text(first) != self.text(term) and self.text(term) not in self.settled:
                    self.settled.add(self.text(term))
                    by = f"f_equal; {self.algebra}"
                    self.hints.append(self.prove_aside(["=", term, first], "e", by))
