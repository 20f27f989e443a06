"""Forged certificates, by hand: each claims what is false, or is not shown by its evidence. With the true reason."""

from __future__ import annotations

from typing import Any, NamedTuple

JSON = Any
NOT_EQUAL = "left - right is not the combination of facts it is said to be"
NOT_THE_FORM = "the difference less the form is not the combination of facts it is said to be"
NO_SIGN = "the form is not manifestly of one sign"
NO_CONTRADICTION = "the contradiction is not the combination of facts it is said to be"
NO_PRODUCT = "the product is not the combination of facts it is said to be"
MAY_BE_ZERO = "a denominator may be zero"
NO_LEMMA = "a lemma is not proved, or under other assumptions"
NO_POINT = "no point where all that is assumed holds"
NO_EQUATION = "an identity is an equation"
NO_ADDEND = "an addend is not manifestly non-negative"
OTHER_LETTERS = "values for other letters"
NO_COORDINATE = "a coordinate is no number, or of a defined letter"


class Forgery(NamedTuple):
    """Why it is rejected (what the reason says), the certificate, and others that are given with it."""

    reason: str
    certificate: JSON
    others: tuple[JSON, ...] = ()


def proved(claim: JSON, proof: JSON, h: JSON = (), **more: JSON) -> JSON:
    """A certificate of a proof; `h` is the one hypothesis, at `at` all letters have values that satisfy it."""
    at = more.pop("at", None)
    witness = {} if at is None else {"witnesses": [{"values": at}]}
    made = {"id": "t", "verdict": "proved", "claim": claim, "definitions": [], "hypotheses": {"h": [*h]} if h else {}}
    return {**made, "proof": proof, **witness, **more}


def refuted(claim: JSON, values: JSON, h: JSON = (), **more: JSON) -> JSON:
    point = {"values": values, **{key: more.pop(key) for key in ("proof", "calls", "shown") if key in more}}
    made = {"id": "t", "verdict": "refuted", "claim": claim, "definitions": [], "hypotheses": {"h": [*h]} if h else {}}
    return {**made, "point": point, **more}


def here(k: int = 0) -> JSON:
    return ["here", k]


def hyp(k: int = 0) -> JSON:
    return ["hyp", "h", k]


def by(*names: JSON, factor: str = "1") -> JSON:
    return {"rule": "identity", "cofactors": [[name, factor] for name in names]}


def above(form: JSON, *cofactors: JSON) -> JSON:
    return {"rule": "nonnegative", "form": form, "cofactors": [*cofactors]}


def implies(then: JSON) -> JSON:
    return {"rule": "implies", "then": then}


def each(*parts: JSON) -> JSON:
    return {"rule": "each", "parts": [*parts]}


def theorem(of: str, given: JSON, premises: JSON, then: JSON, **more: JSON) -> JSON:
    return {"rule": "theorem", "of": of, "with": given, "premises": premises, "then": then, **more}


def have(formula: JSON, proof: JSON, then: JSON) -> JSON:
    return {"rule": "have", "formula": formula, "proof": proof, "then": then}


def absurd(times: JSON = (), *cofactors: JSON) -> JSON:
    return {"rule": "absurd", "times": [*times], "cofactors": [*cofactors]}


def split(factors: JSON, cofactors: JSON, *cases: JSON) -> JSON:
    form = ["*", *(["^", base, exponent] for base, exponent in factors)]
    return {"rule": "split", "form": form, "cofactors": cofactors, "cases": [*cases]}


def witness(point: JSON, then: JSON) -> JSON:
    return {"rule": "witness", "point": point, "then": then}


def every(letters: JSON, then: JSON) -> JSON:
    return {"rule": "every", "letters": letters, "then": then}


def choose(index: JSON, then: JSON) -> JSON:
    return {"rule": "choose", "index": index, "then": then}


def cases(name: JSON, *proofs: JSON) -> JSON:
    return {"rule": "cases_or", "or": name, "cases": [*proofs]}


def vanish(form: JSON, cofactors: JSON, then: JSON) -> JSON:
    return {"rule": "vanish", "form": form, "cofactors": cofactors, "then": then}


def compute(*values: JSON) -> JSON:
    return {"rule": "compute", "values": [*values]}


def of(x: str, term: JSON) -> JSON:
    """A term in a letter."""
    return {"letter": x, "term": term}


def sq(t: JSON) -> JSON:
    return ["^", t, 2]


def f(*t: JSON, orders: JSON = None) -> JSON:
    return ["call", "f", orders or [0] * len(t), *t]


def minus(s: JSON, t: JSON) -> JSON:
    return ["+", s, ["-", t]]


UNDER_A_BINDER = "a denominator may be zero: under a binder"
HOLE: JSON = ["*", 2, "t", ["+", 1, ["*", 0, ["/", 1, ["+", "r", ["/", -1, 2]]]]]]
POLE: JSON = ["integral", ["/", 1, ["+", "r", ["/", -1, 2]]], "r", 0, 1]
ID: JSON = {"rule": "identity", "cofactors": []}
ZERO_IS_ONE: JSON = ["=", 0, 1]
PI: JSON = ["pi"]
HALF_GAMMA: JSON = ["gamma", ["/", 1, 2]]
HALF_PI: JSON = ["/", PI, 2]
SIN, COS = ["sin", "x"], ["cos", "x"]
OO, NOO = ["infinity"], ["-infinity"]
SIDE = {"x": 1, "y": 1}
NEGATIVE_SQUARE = have(["<", 0, 0], above(["+", ["-", sq("y")], sq("y")]), absurd([here(1)]))


def integral(t: JSON, x: str = "x", low: JSON = 0, high: JSON = 1) -> JSON:
    return ["integral", t, x, low, high]


INVERSE: JSON = ["/", 1, "x"]
INVERSES = integral(INVERSE, "x", 1, 2)
Y_IS_POSITIVE = above(["+", minus("y", 1), 1])  # where 1 <= y
THROUGH_ZERO = integral(INVERSE, "x", -1, 1)


def antiderivative(
    s: JSON,
    t: JSON,
    then: JSON,
    f: JSON = INVERSE,
    g: JSON = ("log", "x"),
    smooth: JSON = (Y_IS_POSITIVE,),
    ordered: JSON = 1,
    last: JSON = ID,
) -> JSON:
    """The integral of a term in x from another one, that of 1/x from the logarithm unless others are given."""
    proofs = [above(ordered), *(every(["y"], implies(proof)) for proof in smooth), every(["y"], implies(last))]
    given = {"f": of("x", f), "g": of("x", [*g] if isinstance(g, tuple) else g), "s": s, "t": t}
    return theorem("antiderivative", given, proofs, then)


def rising(
    of_: str,
    s: JSON,
    t: JSON,
    g: JSON = ("exp", "x"),
    last: JSON = ("exp", "z"),
    smooth: JSON = (),
    ordered: JSON = None,
    then: JSON = None,
) -> JSON:
    """The order of two values of a term in x, the exponential unless another is given, whose derivative is `last`."""
    body, derived = ([*each] if isinstance(each, tuple) else each for each in (g, last))
    ends = above(minus(t, s) if ordered is None else ordered)
    proofs = [ends, *(every(["z"], implies(proof)) for proof in smooth), every(["z"], implies(above(derived)))]
    gap = minus(put(body, t), put(body, s))
    return theorem(of_, {"g": of("x", body), "s": s, "t": t}, proofs, above(gap) if then is None else then)


def put(tree: JSON, x: JSON) -> JSON:
    """The term with something in the place of its letter x."""
    return x if tree == "x" else [tree[0], *(put(part, x) for part in tree[1:])] if isinstance(tree, list) else tree


def constant(c: JSON, then: JSON, s: JSON = 0, t: JSON = 1) -> JSON:
    return theorem("constant", {"c": c, "s": s, "t": t}, [], then)


SQUARED = above(sq("x"))
NO_CIRCLE = minus(["*", sq(["cos", ["arctan", "x"]]), ["+", 1, sq("x")]], 1)  # zero
INVERTED: JSON = ["exists", ["z"], ["=", ["*", "z", "x"], 1]]
NOT_EVEN = implies(absurd([], [here(2), "1"]))
EULER_NUMBER: JSON = ["/", 2718281828459045235360287471352662497757247093699959, 10**51]
RULES: dict[str, Forgery] = {
    # identity
    "an identity that is none": Forgery(NOT_EQUAL, proved(["=", "x", "y"], ID)),
    "an identity of an order": Forgery(NO_EQUATION, proved(["<", 0, 0], ID)),
    "an identity of numbers": Forgery(NOT_EQUAL, proved(ZERO_IS_ONE, ID)),
    "an identity of an implication": Forgery(NO_EQUATION, proved(["=>", ["=", 0, 0], ["=", "x", "y"]], ID)),
    "a fact that nobody stated": Forgery("('hyp', 'h', 0) is no such fact", proved(["=", "x", 0], by(hyp()))),
    "the claim as a fact for itself": Forgery("('here', 0) is no such fact", proved(["=", "x", 0], by(here()))),
    "an order taken for an equation": Forgery(
        "('hyp', 'h', 0) is no such fact", proved(["=", "x", 0], by(hyp()), [[">", "x", 0]], at={"x": 1})
    ),
    "an inequality taken for an equation": Forgery(
        "('hyp', 'h', 0) is no such fact", proved(["=", "x", 0], by(hyp()), [["!=", "x", 0]], at={"x": 1})
    ),
    "a fact counted from behind": Forgery(
        "('here', -1) is no such fact", proved(["=>", ["=", "x", 0], ["=", "y", 0]], implies(by(["here", -1])))
    ),
    "a fact beyond the last one": Forgery(
        "('here', 1) is no such fact", proved(["=>", ["=", "x", 0], ["=", "y", 0]], implies(by(here(1))))
    ),
    "a fact of a hypothesis beyond its last part": Forgery(
        "('hyp', 'h', 1) is no such fact", proved(["=", "x", 0], by(hyp(1)), [["=", "x", 0]], at={"x": 0})
    ),
    "a fact named by a truth value": Forgery(
        "['hyp', 'h', False] is no reference to a fact",
        proved(["=", "x", 0], by(["hyp", "h", False]), [["=", "x", 0]], at={"x": 0}),
    ),
    "a fact named by a fraction": Forgery(
        "['hyp', 'h', 0.0] is no reference to a fact",
        proved(["=", "x", 0], by(["hyp", "h", 0.0]), [["=", "x", 0]], at={"x": 0}),
    ),
    "a fact named by an object": Forgery(
        "[{'hyp': 0}] is no reference to a fact", proved(["=", "x", 0], by([{"hyp": 0}]))
    ),
    "a cofactor that is another": Forgery(
        NOT_EQUAL, proved(["=", "x", 1], by(hyp(), factor="2"), [["=", "x", 1]], at={"x": 1})
    ),
    "a cofactor divided by a letter": Forgery(
        "the factor 1/x", proved(["=", 1, 0], by(hyp(), factor="1/x"), [["=", "x", 0]], at={"x": 0})
    ),
    "a cofactor divided by zero": Forgery(
        "division by zero", proved(["=", "x", 0], by(hyp(), factor="1/0"), [["=", "x", 0]], at={"x": 0})
    ),
    "a cofactor with a negative power": Forgery(
        "the factor x^-1", proved(["=", 1, 0], by(hyp(), factor="x^-1"), [["=", "x", 0]], at={"x": 0})
    ),
    "a cofactor that is a number": Forgery(
        "1 is no text",
        proved(["=", "x", 0], {"rule": "identity", "cofactors": [[hyp(), 1]]}, [["=", "x", 0]], at={"x": 0}),
    ),
    "a cofactor in brackets": Forgery(
        "the factor (1)", proved(["=", "x", 0], by(hyp(), factor="(1)"), [["=", "x", 0]], at={"x": 0})
    ),
    "a cofactor without a letter": Forgery(
        "the factor ", proved(["=", "x", 0], by(hyp(), factor=""), [["=", "x", 0]], at={"x": 0})
    ),
    "cofactors that are no list": Forgery(
        "{'here': 0} is no list", proved(ZERO_IS_ONE, {"rule": "identity", "cofactors": {"here": 0}})
    ),
    "a denominator that nobody met": Forgery(
        "y is no denominator", proved(["=", "x", 0], {"rule": "identity", "times": ["y"]})
    ),
    "cleared by zero": Forgery("0 is no denominator", proved(ZERO_IS_ONE, {"rule": "identity", "times": ["0"]})),
    "cleared by a letter that is zero": Forgery(
        MAY_BE_ZERO,
        proved(
            ["=", ["/", 1, "x"], 2],
            {"rule": "identity", "times": ["x"], "cofactors": [[hyp(), "1"]]},
            [["=", minus(1, ["*", 2, "x"]), 0]],
            at={"x": ["/", 1, 2]},
        ),
    ),
    "times what may be zero": Forgery(
        "('hyp', 'h', 0) is no such fact",
        proved(["=", 1, 0], {"rule": "identity", "times": [hyp()], "cofactors": []}, [[">=", "x", 0]], at={"x": 1}),
    ),
    "times what is zero": Forgery(
        "('hyp', 'h', 0) is no such fact",
        proved(
            ["=", 1, 0],
            {"rule": "identity", "times": [hyp()], "cofactors": [[hyp(), "1"]]},
            [["=", "x", 0]],
            at={"x": 0},
        ),
    ),
    "times a square, which may be zero": Forgery(
        "('^', 'x', 2) is not manifestly positive",
        proved(
            ["=", 1, 0],
            {"rule": "identity", "times": [["positive", sq("x")]], "cofactors": [[hyp(), "x"]]},
            [["=", "x", 0]],
            at={"x": 0},
        ),
    ),
    "times zero, said to be positive": Forgery(
        "0 is not manifestly positive", proved(ZERO_IS_ONE, {"rule": "identity", "times": [["positive", 0]]})
    ),
    # nonnegative
    "the sign of a free letter": Forgery(NO_SIGN, proved([">=", "x", 0], above("x"))),
    "a square said to be positive": Forgery(NO_SIGN, proved([">", sq("x"), 0], above(sq("x")))),
    "the root of what may be zero": Forgery(
        NO_SIGN, proved([">", ["sqrt", "x"], 0], above(["sqrt", "x"]), [[">=", "x", 0]], at={"x": 1})
    ),
    "the root of what may be negative": Forgery(
        NO_SIGN, proved([">", ["sqrt", "x"], 0], above(["sqrt", "x"]), [["!=", "x", 0]], at={"x": 1})
    ),
    "a difference of squares": Forgery(
        NO_SIGN, proved([">=", minus(sq("x"), sq("y")), 0], above(minus(sq("x"), sq("y"))))
    ),
    "a cube": Forgery(NO_SIGN, proved([">=", ["^", "x", 3], 0], above(["^", "x", 3]))),
    "a power of zero": Forgery(NO_SIGN, proved([">", ["^", "x", 0], 1], above(["^", "x", 0]))),
    "a product of two letters": Forgery(NO_SIGN, proved([">=", ["*", "x", "y"], 0], above(["*", "x", "y"]))),
    "three times the same factor": Forgery(
        NO_SIGN, proved([">=", ["*", "x", "x", "x"], 0], above(["*", "x", "x", "x"]))
    ),
    "an empty sum said to be positive": Forgery(NO_SIGN, proved([">", 0, 0], above(["+"]))),
    "a negative number": Forgery(NO_SIGN, proved([">=", -1, 0], above(-1))),
    "zero said to be positive": Forgery(NO_SIGN, proved([">", 0, 0], above(0))),
    "the form of another order": Forgery(NOT_THE_FORM, proved([">", "x", 0], above(1))),
    "an order from larger to smaller": Forgery(NOT_THE_FORM, proved(["<", 1, 0], above(1))),
    "an equation by its sign": Forgery(
        "only an order follows from a form of one sign", proved(["=", sq("x"), 0], above(sq("x")))
    ),
    "an inequality by its sign": Forgery(
        "only an order follows from a form of one sign", proved(["!=", "x", 0], above(1))
    ),
    "a root that nobody said to be positive": Forgery(NO_SIGN, proved([">=", ["sqrt", "x"], 0], above(["sqrt", "x"]))),
    "an exponential that is greater than one": Forgery(
        NO_SIGN, proved([">", ["exp", "x"], 1], above(minus(["exp", "x"], 1)))
    ),
    "an exponential that is negative": Forgery(NO_SIGN, proved(["<", ["exp", "x"], 0], above(["-", ["exp", "x"]]))),
    "a logarithm that nobody said to be positive": Forgery(
        NO_SIGN, proved([">", ["log", "x"], 0], above(["log", "x"]), at={"x": 2})
    ),
    "a square that may be zero": Forgery(NO_SIGN, proved([">", sq("x"), 0], above(sq("x")))),
    "a square of what is not zero elsewhere": Forgery(
        NO_SIGN,
        proved(["and", ["=>", ["!=", "x", 0], [">", sq("x"), 0]], [">", sq("x"), 0]], each(implies(SQUARED), SQUARED)),
    ),
    "a cube of what is not zero": Forgery(
        NO_SIGN, proved([">", ["^", "x", 3], 0], above(["^", "x", 3]), [["!=", "x", 0]], at={"x": 1})
    ),
    "an exponential less another number": Forgery(
        NO_SIGN, proved([">", minus(["exp", "x"], 1), 0], above(minus(["exp", "x"], 1)))
    ),
    "the root of a negative number squared": Forgery(
        "the root of (-1, 1): only of products of primes up to 43", proved([">=", -1, 0], above(sq(["sqrt", -1])))
    ),
    "an order that is not strict used as if it were": Forgery(
        NO_SIGN, proved([">", "x", 0], above("x"), [[">=", "x", 0]], at={"x": 1})
    ),
    "a positive bottom that is negative": Forgery(
        NO_SIGN, proved([">", ["/", 1, "x"], 0], above(["/", 1, "x"]), nonzero=["x"], at={"x": 1})
    ),
    "a sign that a fact gives to its negative": Forgery(
        NO_SIGN, proved([">", ["-", "x"], 0], above(["-", "x"]), [[">", "x", 0]], at={"x": 1})
    ),
    # implies, each, choose
    "the converse": Forgery(NOT_EQUAL, proved(["=>", ["=", sq("x"), 1], ["=", "x", 1]], implies(by(here())))),
    "implication with the premise of another": Forgery(
        "('here', 0) is no such fact",
        proved(["and", ["=>", ["=", "x", 0], ["=", "x", 0]], ["=", "x", 0]], each(implies(by(here())), by(here()))),
    ),
    "no implication": Forgery("no implication and no relation", proved(["or", ["=", "x", 0]], implies(by(here())))),
    "the contrary as a proof": Forgery(NO_EQUATION, proved(["=", "x", 0], implies(by(here())))),
    "a relation by its contrary without a contradiction": Forgery(
        "('here', 0) is no such fact", proved([">", "x", 0], implies(absurd([], [here(), "1"])))
    ),
    "a conclusion that is a disjunction of nothing": Forgery(
        "there is no alternative 0", proved(["or"], choose(0, ID))
    ),
    "a part of a conjunction left out": Forgery("1 proofs for 2", proved(["and", ["=", 0, 0], ZERO_IS_ONE], each(ID))),
    "one proof too many": Forgery("2 proofs for 1", proved(["and", ["=", 0, 0]], each(ID, ID))),
    "one direction only": Forgery("1 proofs for 2", proved(["<=>", ZERO_IS_ONE, ["=", 0, 0]], each(implies(ID)))),
    "directions exchanged": Forgery(
        NOT_EQUAL,
        proved(
            ["<=>", ["=", "x", 1], ["=", sq("x"), 1]], each(implies(by(here())), implies(by(here(), factor="x + 1")))
        ),
    ),
    "parts of what has none": Forgery("nothing with parts", proved(ZERO_IS_ONE, each())),
    "the last alternative by a negative index": Forgery(
        "there is no alternative -1", proved(["or", ZERO_IS_ONE, ["=", 0, 0]], choose(-1, ID))
    ),
    "an alternative beyond the last": Forgery("there is no alternative 1", proved(["or", ZERO_IS_ONE], choose(1, ID))),
    "an alternative counted by a truth value": Forgery(
        "there is no alternative True", proved(["or", ZERO_IS_ONE, ["=", 0, 0]], choose(True, ID))
    ),
    "an alternative of a conjunction": Forgery(
        "there is no alternative 0", proved(["and", ["=", 0, 0], ZERO_IS_ONE], choose(0, ID))
    ),
    # cases_or
    "a case left out": Forgery(
        "1 proofs for 2",
        proved(["=>", ["or", ["=", "x", 0], ["=", "x", 1]], ["=", "x", 0]], implies(cases(here(), by(here(1))))),
    ),
    "the fact of one case in the next": Forgery(
        NOT_EQUAL,
        proved(
            ["=>", ["or", ["=", "x", 0], ["=", "y", 0]], ["=", "x", 0]],
            implies(cases(here(), by(here(1)), by(here(1)))),
        ),
    ),
    "cases of an equation": Forgery(
        "('here', 0) is no disjunction", proved(["=>", ["=", "x", 0], ["=", "y", 0]], implies(cases(here())))
    ),
    "cases of a fact that is not there": Forgery(
        "('hyp', 'h', 0) is no disjunction", proved(["=", "y", 0], cases(hyp()))
    ),
    "no cases of a conjunction": Forgery(
        "('hyp', 'h', 0) is no disjunction",
        proved(["=", "y", 0], cases(hyp()), [["and", ["=", "x", 0], ["=", "x", 0]]], at=SIDE),
    ),
    # split
    "a factor left out": Forgery(
        NO_PRODUCT,
        proved(
            ["=>", ["=", ["*", "x", "y"], 0], ["=", "x", 0]], implies(split([["x", 1]], [[here(), "1"]], by(here(1))))
        ),
    ),
    "a case of a factor left out": Forgery(
        "1 proofs for 2",
        proved(
            ["=>", ["=", ["*", "x", "y"], 0], ["=", "x", 0]],
            implies(split([["x", 1], ["y", 1]], [[here(), "1"]], by(here(1)))),
        ),
    ),
    "the second factor taken for the first": Forgery(
        NOT_EQUAL,
        proved(
            ["=>", ["=", ["*", "x", "y"], 0], ["=", "x", 0]],
            implies(split([["x", 1], ["y", 1]], [[here(), "1"]], by(here(1)), by(here(1)))),
        ),
    ),
    "power zero": Forgery(
        NO_PRODUCT, proved(["=>", ["=", 1, 1], ["=", "x", 0]], implies(split([["x", 0]], [], by(here(1)))))
    ),
    "a negative power": Forgery(
        NO_PRODUCT, proved(["=>", ["=", 1, 1], ["=", "x", 0]], implies(split([["x", -1]], [], by(here(1)))))
    ),
    "half a power": Forgery(
        "0.5 is no whole number that fits",
        proved(["=>", ["=", 1, 1], ["=", "x", 0]], implies(split([["x", 0.5]], [], by(here(1))))),
    ),
    "a power that is a truth value": Forgery(
        "True is no whole number that fits",
        proved(["=>", ["=", "x", 0], ["=", "x", 0]], implies(split([["x", True]], [[here(), "1"]], by(here(1))))),
    ),
    "a product of no factors": Forgery(NO_PRODUCT, proved(ZERO_IS_ONE, split([], []))),
    "a product that is not zero": Forgery(NO_PRODUCT, proved(["=", "x", 0], split([["x", 1]], [], by(here())))),
    # vanish
    "addends of two signs vanish": Forgery(
        NO_ADDEND,
        proved(
            ["=>", ["=", ["+", "x", "y"], 0], ["=", "x", 0]],
            implies(vanish(["+", "x", "y"], [[here(), "1"]], by(here(1)))),
        ),
    ),
    "addends vanish in a sum that is not zero": Forgery(
        "the form is not the combination of facts it is said to be",
        proved(["=", "x", 0], vanish(["+", sq("x"), sq("y")], [], by(here()))),
    ),
    "a product vanishes as a sum": Forgery(
        NO_ADDEND,
        proved(
            ["=>", ["=", ["*", sq("x"), sq("y")], 0], ["=", "x", 0]],
            implies(vanish(["*", sq("x"), sq("y")], [[here(), "1"]], by(here(1)))),
        ),
    ),
    "an empty sum vanishes": Forgery(NO_ADDEND, proved(ZERO_IS_ONE, vanish(["+"], [], by(here())))),
    "a letter vanishes with its square": Forgery(
        NO_ADDEND,
        proved(
            ["=>", ["=", ["+", sq("x"), "x"], 0], ["=", "x", 0]],
            implies(vanish(["+", sq("x"), "x"], [[here(), "1"]], by(here(2)))),
        ),
    ),
    # absurd
    "a contradiction from nothing": Forgery(NO_CONTRADICTION, proved(ZERO_IS_ONE, absurd())),
    "a contradiction from zero that is not zero": Forgery(
        "('hyp', 'h', 0) is no such fact",
        proved(ZERO_IS_ONE, absurd([hyp()], [hyp(), "1"]), [[">", "x", 0]], at={"x": 1}),
    ),
    "a contradiction from an order": Forgery(
        "('hyp', 'h', 0) is no such fact", proved(ZERO_IS_ONE, absurd([], [hyp(), "1"]), [["<", "x", 1]], at={"x": 0})
    ),
    "a contradiction times what may be zero": Forgery(
        "('hyp', 'h', 0) is no such fact", proved(ZERO_IS_ONE, absurd([hyp()]), [[">=", 0, 0]], at={})
    ),
    # have
    "a lemma that is not proved": Forgery(NOT_EQUAL, proved(ZERO_IS_ONE, have(ZERO_IS_ONE, ID, by(here())))),
    "a lemma by itself": Forgery(
        "('here', 0) is no such fact", proved(ZERO_IS_ONE, have(ZERO_IS_ONE, by(here()), by(here())))
    ),
    "a lemma under an assumption used without it": Forgery(
        "('here', 0) is no such fact",
        proved(["=", "x", 0], have(["=>", ["=", "x", 0], ["=", "x", 0]], implies(by(here())), by(here()))),
    ),
    "a lemma that is no formula": Forgery(
        "['+', 0, 1] is no formula", proved(ZERO_IS_ONE, have(["+", 0, 1], ID, by(here())))
    ),
    "what a lemma assumed": Forgery(
        "('here', 0) is no such fact",
        proved(["=", "x", 0], have(["=>", ["=", "x", 0], ["=", 0, 0]], implies(ID), by(here()))),
    ),
    # witness, every
    "another bound letter": Forgery(OTHER_LETTERS, proved(["exists", ["x"], ["=", "x", 1]], witness({"y": 1}, ID))),
    "no witness": Forgery(OTHER_LETTERS, proved(["exists", ["x"], ZERO_IS_ONE], witness({}, ID))),
    "a witness too many": Forgery(
        OTHER_LETTERS, proved(["exists", ["x"], ["=", "x", 1]], witness({"x": 1, "y": 1}, ID))
    ),
    "a witness that does not do": Forgery(NOT_EQUAL, proved(["exists", ["x"], ["=", "x", 1]], witness({"x": 2}, ID))),
    "infinity as a witness": Forgery(
        "['infinity'] is no term", proved(["exists", ["x"], ["=", ["/", 1, "x"], 0]], witness({"x": OO}, ID))
    ),
    "a truth value as a witness": Forgery(
        "True is no letter", proved(["exists", ["x"], ["=", "x", 1]], witness({"x": True}, ID))
    ),
    "nothing as a witness": Forgery(
        "None is no letter", proved(["exists", ["x"], ["=", "x", 0]], witness({"x": None}, ID))
    ),
    "a formula as a witness": Forgery(
        "['=', 0, 0] is no term", proved(["exists", ["x"], ["=", "x", 0]], witness({"x": ["=", 0, 0]}, ID))
    ),
    "a witness divided by what may be zero": Forgery(
        MAY_BE_ZERO, proved(["exists", ["z"], ["=", ["*", "z", "x"], 1]], witness({"z": ["/", 1, "x"]}, ID))
    ),
    "a witness with a power that divides": Forgery(
        MAY_BE_ZERO, proved(["exists", ["z"], ["=", ["*", "z", "x"], 1]], witness({"z": ["^", "x", -1]}, ID))
    ),
    "a witness with a real power that divides": Forgery(
        MAY_BE_ZERO, proved(["exists", ["z"], ["=", ["*", "z", "x"], 1]], witness({"z": ["pow", "x", -1]}, ID))
    ),
    "a witness for all": Forgery("no existence", proved(["forall", ["x"], ["=", "x", 1]], witness({"x": 1}, ID))),
    "a witness captured by an inner binder": Forgery(
        "the letter y is taken",
        proved(["exists", ["x"], ["forall", ["y"], ["=", "x", "y"]]], witness({"x": "y"}, every(["y"], ID))),
    ),
    "a witness captured by an inner binder, renamed": Forgery(
        NOT_EQUAL, proved(["exists", ["x"], ["forall", ["y"], ["=", "x", "y"]]], witness({"x": "y"}, every(["z"], ID)))
    ),
    "a witness captured by an integral": Forgery(
        NOT_EQUAL, proved(["exists", ["y"], ["=", integral("y"), integral("x")]], witness({"y": "x"}, ID))
    ),
    "every letter is one that a hypothesis speaks of": Forgery(
        "the letter x is taken",
        proved(["forall", ["y"], ["=", "y", 0]], every(["x"], by(hyp())), [["=", "x", 0]], at={"x": 0}),
    ),
    "every letter is in the claim": Forgery(
        "the letter x is taken", proved(["forall", ["y"], ["=", "y", "x"]], every(["x"], ID))
    ),
    "every letter is one that an assumption speaks of": Forgery(
        "the letter x is taken",
        proved(["=>", ["=", "x", 0], ["forall", ["y"], ["=", "y", 0]]], implies(every(["x"], by(here()))), at={"x": 0}),
    ),
    "every letter is in a polynomial that is zero": Forgery(
        "the letter x is taken",
        proved(
            ["=>", ["=", ["*", "x", "x"], 0], ["or", ["forall", ["y"], ["=", "y", 0]]]],
            implies(split([["x", 2]], [[here(), "1"]], choose(0, every(["x"], by(here(1)))))),
            at={"x": 0},
        ),
    ),
    "every letter is in a sine that is zero": Forgery(
        "the letter x is taken",
        proved(
            ["=>", ["=", ["*", 2, SIN], 0], ["forall", ["y"], ["=", ["sin", "y"], 0]]],
            implies(split([[SIN, 1]], [[here(), "1/2"]], every(["x"], by(here(1))))),
            at={"x": 0},
        ),
    ),
    "every letter is in a listed denominator": Forgery(
        "the letter x is taken",
        proved(
            ["and", ["=", ["/", "x", "x"], 1], ["forall", ["y"], ["=", ["/", "y", "y"], 1]]],
            each(ID, every(["x"], ID)),
            nonzero=["x"],
            at={"x": 1},
        ),
    ),
    "every letter is defined": Forgery(
        "the letter d is taken", proved(["forall", ["y"], ["=", "y", 1]], every(["d"], ID), definitions=[["d", 1]])
    ),
    "two letters are one": Forgery(
        "other letters than are bound", proved(["forall", ["x", "y"], ["=", "x", "y"]], every(["z", "z"], ID))
    ),
    "too few letters": Forgery(
        "other letters than are bound", proved(["forall", ["x", "y"], ["=", "x", "y"]], every(["z"], ID))
    ),
    "a number for every letter": Forgery("0 is no text", proved(["forall", ["y"], ["=", "y", 0]], every([0], ID))),
    "nothing for every letter": Forgery("'' is no letter", proved(["forall", ["y"], ["=", "y", 0]], every([""], ID))),
    "a word for every letter": Forgery("'0' is no letter", proved(["forall", ["y"], ["=", "y", 0]], every(["0"], ID))),
    "every letter of what exists": Forgery(
        "nothing about all", proved(["exists", ["y"], ZERO_IS_ONE], every(["z"], ID))
    ),
    # compute
    "a sum that is another": Forgery("('=', ('+', 2, 2), 5) is not so", proved(["=", ["+", 2, 2], 5], compute())),
    "an order of numbers": Forgery(
        "('<', ('sqrt', 2), ('/', 7, 5)) is not so", proved(["<", ["sqrt", 2], ["/", 7, 5]], compute())
    ),
    "a letter without a value": Forgery("no value for x", proved(["=", "x", "x"], compute())),
    "a value that is no value": Forgery(
        "('=', 'x', 1) is no value", proved(["=", 1, 1], compute(hyp()), [["=", "x", 1]], at={"x": 1})
    ),
    "a value that is an order": Forgery(
        "('hyp', 'h', 0) is no value", proved(["=", f(0), 1], compute(hyp()), [["<", f(0), 1]])
    ),
    "a function without a value": Forgery("the digits of ('call', 'f', (0,), 0)", proved(["=", f(0), f(0)], compute())),
    "pi is a fraction": Forgery("('=', ('pi',), ('/', 22, 7)) is not so", proved(["=", PI, ["/", 22, 7]], compute())),
    "pi is a fraction with many digits": Forgery(
        "('=', ('pi',), ('/', 314159265358979323846264338327950288419716939937510,",
        proved(["=", PI, ["/", 314159265358979323846264338327950288419716939937510, 10**50]], compute()),
    ),
    "a quantifier over numbers": Forgery(
        "('exists', ('x',), ('=', 0, 0)) is not about numbers", proved(["exists", ["x"], ["=", 0, 0]], compute())
    ),
    "a number divided by zero": Forgery("division by zero", proved(["=", ["/", 0, 0], 1], compute())),
    "a sine divided by zero": Forgery("division by zero", proved(["=", ["/", ["sin", PI], ["sin", PI]], 1], compute())),
    "the root of a negative number": Forgery(
        "the root of what may be negative", proved(["=", sq(["sqrt", -2]), -2], compute())
    ),
    "the logarithm of a negative number": Forgery(
        "the logarithm of what may not be positive", proved(["=", ["log", -1], ["log", -1]], compute())
    ),
    "the logarithm of zero": Forgery(
        "the logarithm of what may not be positive", proved(["<", ["log", 0], 0], compute())
    ),
    "the root of a negative number as a power": Forgery(
        "the logarithm of what may not be positive", proved([">", ["pow", -1, ["/", 1, 2]], -2], compute())
    ),
    "an exponential that is too small": Forgery(
        "('<', ('exp', 1), ('/', 271, 100)) is not so", proved(["<", ["exp", 1], ["/", 271, 100]], compute())
    ),
    "an exponential that is not that number": Forgery(
        "too few digits to compare ('exp', 1)", proved(["=", ["exp", 1], EULER_NUMBER], compute())
    ),
    "an exponential that is too large": Forgery(
        "an exponent that is too large", proved([">", ["exp", 10**6], 1], compute())
    ),
    "a logarithm divided by zero": Forgery(
        "a division by what may be zero", proved(["=", ["/", 0, ["log", 1]], 0], compute())
    ),
    "a sum through a pole": Forgery(
        "may be zero under a binder", proved(["<", ["sum", ["/", 1, minus("k", 2)], "k", 1, 3], 1], compute())
    ),
    "a finite sum that is another": Forgery("is not so", proved(["=", ["sum", "k", "k", 1, 4], 9], compute())),
    "a sum to what is no whole number": Forgery(
        "a sum between ends that may not be whole", proved(["<", ["sum", "k", "k", 1, ["/", 5, 2]], 9], compute())
    ),
    "a sum to the root of four": Forgery(
        "a sum between ends that may not be whole", proved(["<", ["sum", "k", "k", 1, ["sqrt", 4]], 9], compute())
    ),
    "a point where a sum ends at a half": Forgery(
        "an end of a sum that is no whole number", refuted(["=", ["sum", 1, "k", 1, "n"], 1], {"n": ["/", 1, 2]})
    ),
    "a sum of too many addends": Forgery(
        "a sum of more than 1000 terms", proved(["<", 0, ["sum", 1, "k", 1, 10**9]], compute())
    ),
    "the digits of an endless sum": Forgery(
        "the digits of ('infinity',)", proved(["<", 0, ["sum", ["^", 2, -2], "k", 1, OO]], compute())
    ),
    "the digits of an endless integral": Forgery(
        "the digits of ('infinity',)", proved(["<", 0, integral(["exp", ["-", "x"]], "x", 0, OO)], compute())
    ),
    "the digits of an integral through a pole": Forgery(
        "may be zero under a binder", proved(["<", integral(["^", "x", -2], "x", -1, 1), 0], compute())
    ),
    "the digits of an integral through a pole that cancels": Forgery(
        "may be zero under a binder", proved(["<", integral(["*", 0, INVERSE], "x", -1, 1), 1], compute())
    ),
    "the digits of an integral through a tangent's pole": Forgery(
        "may be zero under a binder", proved(["<", integral(["tan", "x"], "x", 0, 2), 9], compute())
    ),
    "the enclosure of an integral through a pole": Forgery(
        "a division by what may be zero",
        proved(["<=", 0, 1], theorem("enclosure", {"t": THROUGH_ZERO, "digits": 1}, [], above(1))),
    ),
    "the enclosure of an integral through a pole that cancels": Forgery(
        "a division by what may be zero",
        proved(
            ["<=", 0, 1],
            theorem("enclosure", {"t": integral(["*", 0, INVERSE], "x", -1, 1), "digits": 1}, [], above(1)),
        ),
    ),
    "the enclosure of a sum through a pole": Forgery(
        "a division by what may be zero",
        proved(
            ["<=", 0, 1],
            theorem("enclosure", {"t": ["sum", ["/", 0, minus("k", 2)], "k", 1, 3], "digits": 1}, [], above(1)),
        ),
    ),
    "the digits of an integral through a logarithm": Forgery(
        "the logarithm of what may not be positive", proved(["<", integral(["log", "x"], "x", -1, 1), 0], compute())
    ),
    "the digits of an integral that is another": Forgery(
        "is not so", proved(["<", integral(["exp", "x"]), ["/", 1718, 1000]], compute())
    ),
    "the digits of an integral the other way": Forgery(
        "is not so", proved(["<", 0, integral(["exp", "x"], "x", 1, 0)], compute())
    ),
    "a derivative where there is no function": Forgery(
        "the logarithm of what may not be positive",
        proved(
            ["=", ["diff", ["log", "x"], "x", 1, -1], -1],
            theorem("enclosure", {"t": ["diff", ["log", "x"], "x", 1, -1], "digits": 3}, [], by(here())),
        ),
    ),
    "the arcsine of two": Forgery("the root of what may be negative", proved(["<", ["arcsin", 2], 4], compute())),
}

ADDITION: dict[str, Forgery] = {
    f"exponentials: {name}": Forgery(NOT_EQUAL, proved(["=", left, right], ID))
    for name, left, right in (
        ("of a sum as a sum", ["exp", ["+", "x", "y"]], ["+", ["exp", "x"], ["exp", "y"]]),
        ("of a product as a product", ["exp", ["*", "x", "y"]], ["*", ["exp", "x"], ["exp", "y"]]),
        ("of twice a number", ["exp", ["*", 2, "x"]], ["*", 2, ["exp", "x"]]),
        ("of half a number", ["exp", ["/", "x", 2]], ["/", ["exp", "x"], 2]),
        ("of the contrary", ["exp", ["-", "x"]], ["-", ["exp", "x"]]),
        ("that are even", ["exp", ["-", "x"]], ["exp", "x"]),
        ("of a product, that are even", ["exp", ["-", ["*", "x", "y"]]], ["exp", ["*", "x", "y"]]),
        ("of part of a product, that are even", ["exp", ["-", ["/", "x", 3]]], ["exp", ["/", "x", 3]]),
        ("of zero", ["exp", minus("x", "x")], 0),
        ("of half a turn", ["exp", PI], -1),
        ("of a whole turn", ["exp", ["+", "x", ["*", 2, PI]]], ["exp", "x"]),
        ("of a square", ["exp", sq("x")], sq(["exp", "x"])),
        ("of an inverse", ["exp", ["/", 1, ["exp", "x"]]], ["/", 1, ["exp", ["exp", "x"]]]),
        ("of a logarithm", ["exp", ["log", "x"]], "x"),
    )
}
ADDITION |= {
    f"angles: {name}": Forgery(NOT_EQUAL, proved(["=", left, right], ID))
    for name, left, right in (
        ("the sine of a product, that is even", ["sin", ["-", ["*", "x", "y"]]], ["sin", ["*", "x", "y"]]),
        ("the cosine of a product, that is odd", ["cos", ["-", ["*", "x", "y"]]], ["-", ["cos", ["*", "x", "y"]]]),
        ("the sine of twice a product", ["sin", ["*", 2, "x", "y"]], ["*", 2, ["sin", ["*", "x", "y"]]]),
        ("the sine of a product", ["sin", ["*", "x", "y"]], ["*", ["sin", "x"], ["sin", "y"]]),
        ("the sine of a root", ["sin", ["*", ["sqrt", 2], "x"]], ["*", ["sqrt", 2], ["sin", "x"]]),
        ("the sine of half a number", ["sin", ["/", "x", 2]], ["/", ["sin", "x"], 2]),
    )
}

BINDERS: dict[str, Forgery] = {
    "the letter sin_x for a sine": Forgery(NOT_EQUAL, proved(["=", "sin_x", SIN], ID)),
    "the letter pi for the number": Forgery(NOT_EQUAL, proved(["=", "pi", PI], ID)),
    "the letter sqrt_2 for the root": Forgery(NOT_EQUAL, proved(["=", sq("sqrt_2"), 2], ID)),
    "the circle of letters": Forgery(NOT_EQUAL, proved(["=", ["+", sq("sin_x"), sq("cos_x")], 1], ID)),
    "the letter infinity": Forgery(NOT_EQUAL, proved(["=", integral(1, high="infinity"), integral(1, high=OO)], ID)),
    "a polynomial in sin_x for the sine": Forgery(
        NOT_EQUAL, proved(["=", ["*", SIN, "y"], 0], by(hyp(), factor="sin_x"), [["=", "y", 0]], at={"x": 1, "y": 0})
    ),
    "an integral by one of two letters": Forgery(
        NOT_EQUAL, proved(["=", integral(["*", "x", "y"], "x"), integral(["*", "x", "y"], "y")], ID)
    ),
    "nested integrals by the same letters exchanged": Forgery(
        NOT_EQUAL,
        proved(
            [
                "=",
                integral(integral(["*", "x", sq("y")], "y"), "x", 0, 2),
                integral(integral(["*", sq("x"), "y"], "y"), "x", 0, 2),
            ],
            ID,
        ),
    ),
    "nested integrals of one letter": Forgery(
        NOT_EQUAL, proved(["=", integral(integral("x", "x"), "x", 0, 2), integral(integral("y", "x"), "y", 0, 2)], ID)
    ),
    "an inner letter taken for the outer one": Forgery(
        NOT_EQUAL, proved(["=", integral(integral("x", "y"), "x"), integral(integral("y", "y"), "x")], ID)
    ),
    "an inner letter of the same name taken for the outer one": Forgery(
        NOT_EQUAL,
        proved(
            [
                "=",
                integral(["*", "x", integral("x", "x", 0, 2)], "x"),
                integral(["*", "x", integral("y", "x", 0, 2)], "y"),
            ],
            ID,
        ),
    ),
    "bodies at another depth": Forgery(
        NOT_EQUAL,
        proved(
            [
                "=",
                integral(["*", "x", integral("y", "y", 0, 2)], "x"),
                integral(["*", "y", integral("y", "y", 0, 2)], "x"),
            ],
            ID,
        ),
    ),
    "a bound letter that goes free": Forgery(
        NOT_EQUAL, proved(["=", integral("x", "x"), ["*", "x", integral(1, "x")]], ID)
    ),
    "an integral with an end that is bound": Forgery(
        NOT_EQUAL, proved(["=", integral(integral(1, "y", 0, "x"), "x"), integral(integral(1, "y", 0, "y"), "x")], ID)
    ),
    "an integral and its body": Forgery(NOT_EQUAL, proved(["=", integral("y", "x"), "y"], ID)),
    "an integral turned round": Forgery(
        NOT_EQUAL, proved(["=", integral("x", "x", 0, 1), integral("x", "x", 1, 0)], ID)
    ),
    "an integral to infinity and to minus infinity": Forgery(
        NOT_EQUAL, proved(["=", integral("x", "x", 0, OO), integral("x", "x", 0, NOO)], ID)
    ),
    "an integral and whether it diverges": Forgery(
        NOT_EQUAL, proved(["=", integral("x"), ["diverges", "x", "x", 0, 1]], ID)
    ),
    "a mean and an integral": Forgery(NOT_EQUAL, proved(["=", ["mean", "x", "x"], integral("x", "x", 0, 1)], ID)),
    "a sum and a product": Forgery(NOT_EQUAL, proved(["=", ["sum", "k", "k", 1, 3], ["product", "k", "k", 1, 3]], ID)),
    "a sum over another letter": Forgery(
        NOT_EQUAL, proved(["=", ["sum", "k", "k", 1, 3], ["sum", "x", "k", 1, 3]], ID)
    ),
    "the mean of a letter that is not bound": Forgery(
        NOT_EQUAL, proved(["=", ["mean", ["sin", "y"], "x"], ["mean", SIN, "x"]], ID)
    ),
    "a derivative by a letter that is not there": Forgery(
        NOT_EQUAL, proved(["=", ["diff", sq("x"), "y", 1, "x"], ["*", 2, "x"]], ID)
    ),
    "a derivative at another place": Forgery(
        NOT_EQUAL, proved(["=", ["diff", sq("x"), "x", 1, "y"], ["*", 2, "x"]], ID)
    ),
    "a derivative at a place that is put in before": Forgery(
        NOT_EQUAL, proved(["=", ["diff", sq("x"), "x", 1, 3], 0], ID)
    ),
    "a derivative of another order": Forgery(
        NOT_EQUAL, proved(["=", ["diff", ["^", "x", 3], "x", 2, "x"], ["*", 3, sq("x")]], ID)
    ),
    "a derivative of order zero": Forgery(
        "0 is no whole number that fits", proved(["=", ["diff", "x", "x", 0, 3], 3], ID)
    ),
    "a derivative of order true": Forgery(
        "True is no whole number that fits", proved(["=", ["diff", "x", "x", True, 3], 1], ID)
    ),
    "a derivative by a number": Forgery("0 is no letter", proved(["=", ["diff", "x", 0, 1, 3], 0], ID)),
    "a derivative in an integral by its letter": Forgery(
        NOT_EQUAL, proved(["=", integral(["diff", ["*", "x", "y"], "y", 1, 0], "x"), integral("y", "x")], ID)
    ),
    "a derivative in an integral at the outer letter": Forgery(
        NOT_EQUAL, proved(["=", integral(["diff", sq("x"), "x", 1, "y"], "x"), integral(["*", 2, "x"], "x")], ID)
    ),
    "a derivative of an integral": Forgery(
        NOT_EQUAL,
        proved(["=", ["diff", integral(["*", "x", "y"], "x"), "y", 1, 0], 0], ID),
    ),
    "a derivative of an integral by its own end": Forgery(
        NOT_EQUAL,
        proved(["=", ["diff", integral(1, "x", 0, "y"), "y", 1, 0], 0], ID),
    ),
    "a derivative of an unknown function at its place": Forgery(
        NOT_EQUAL, proved(["=", ["diff", f(sq("x")), "x", 1, 1], f(1, orders=[1])], ID)
    ),
    "derivatives by different arguments": Forgery(
        NOT_EQUAL, proved(["=", f("x", "y", orders=[1, 0]), f("x", "y", orders=[0, 1])], ID)
    ),
    "arguments of a function exchanged": Forgery(NOT_EQUAL, proved(["=", f("x", "y"), f("y", "x")], ID)),
    "an argument of a function dropped": Forgery(NOT_EQUAL, proved(["=", f("x"), f("y")], ID)),
    "a function and its derivative": Forgery(NOT_EQUAL, proved(["=", f("x", orders=[1]), f("x")], ID)),
    "a function without orders": Forgery(
        "the orders [] of the function f", proved(["=", ["call", "f", [], "x"], 0], ID)
    ),
    "a function of nothing": Forgery(
        "the orders None of the function None", proved(["=", ["call", "f", []], ["call", "f", []]], ID)
    ),
    "a function of negative order": Forgery(
        "the orders [-1] of the function f", proved(["=", ["call", "f", [-1], "x"], 0], ID)
    ),
    "a function and the letter of its name": Forgery(NOT_EQUAL, proved(["=", f("x"), ["*", "f", "x"]], ID)),
    "a letter in place of a bound letter": Forgery("['x'] is no letter", proved(["=", ["mean", 1, ["x"]], 1], ID)),
    "a number in place of a bound letter": Forgery("0 is no letter", proved(["=", ["mean", 1, 0], 1], ID)),
    "infinity as a term": Forgery("['infinity'] is no term", proved(["=", OO, OO], ID)),
    "infinity as a place": Forgery("['infinity'] is no term", proved(["=", ["diff", "x", "x", 1, OO], 1], ID)),
    "an endless sum that is said to be zero": Forgery(NOT_EQUAL, proved(["=", ["sum", 1, "k", 1, OO], 0], ID)),
    "an endless sum without its first addend": Forgery(
        NOT_EQUAL, proved(["=", ["sum", 1, "k", 1, OO], ["+", 1, ["sum", 1, "k", 2, OO]]], ID)
    ),
    "a factor drawn out of an endless sum": Forgery(
        NOT_EQUAL, proved(["=", ["sum", 2, "k", 1, OO], ["*", 2, ["sum", 1, "k", 1, OO]]], ID)
    ),
    "an endless sum for one that ends": Forgery(
        NOT_EQUAL, proved(["=", ["sum", "k", "k", 1, OO], ["sum", "k", "k", 1, "n"]], ID)
    ),
    "an endless sum of nothing": Forgery(NOT_EQUAL, proved(["=", ["sum", 0, "k", 1, OO], 0], ID)),
    "an endless sum of ones": Forgery(
        "the digits of ('infinity',)", proved([">", ["sum", 1, "k", 1, OO], 0], compute())
    ),
    "infinity as the end of a product": Forgery(
        "['infinity'] is no term", proved(["=", ["product", 1, "k", 1, OO], 1], ID)
    ),
    "a fraction in floating point": Forgery("0.5 is no letter", proved(["=", 0.5, ["/", 1, 2]], ID)),
    "a truth value as a number": Forgery("True is no letter", proved(["=", True, 1], ID)),
    "nothing as a number": Forgery("None is no letter", proved(["=", None, 0], ID)),
    "an exponent in floating point": Forgery(
        "2.0 is no whole number that fits", proved(["=", ["^", "x", 2.0], sq("x")], ID)
    ),
    "an exponent that is a letter": Forgery(
        "'y' is no whole number that fits", proved(["=", ["^", "x", "y"], ["^", "x", "y"]], ID)
    ),
    "a relation with three sides": Forgery("= with 3 fields", proved(["=", 0, 0, 1], ID)),
    "an unknown function of the language": Forgery(
        "['sinh', 'x'] is no term", proved(["=", ["sinh", "x"], ["sinh", "x"]], ID)
    ),
    "a sine of two arguments": Forgery("sin with 2 fields", proved(["=", ["sin", "x", "y"], SIN], ID)),
    "the same letter bound twice": Forgery(
        "['x', 'x'] are no letters", proved(["exists", ["x", "x"], ["=", "x", 0]], witness({"x": 0}, ID))
    ),
    "no letter bound": Forgery("[] are no letters", proved(["exists", [], ["=", 0, 0]], witness({}, ID))),
    "a term for a claim": Forgery("['+', 0, 0] is no formula", proved(["+", 0, 0], ID)),
    "a letter for a claim": Forgery("x is no formula", proved("x", ID)),
}

ANALYSIS: dict[str, Forgery] = {
    "a fraction of what may be zero": Forgery(MAY_BE_ZERO, proved(["=", ["/", "x", "x"], 1], ID)),
    "a fraction of zero": Forgery("division by zero", proved(["=", ["/", 0, 0], 1], ID)),
    "a fraction of a difference that is zero": Forgery(
        "division by zero", proved(["=", ["/", 1, minus("x", "x")], 1], ID)
    ),
    "a fraction of a hidden zero": Forgery(
        "division by zero", proved(["=", ["/", 1, minus(["+", sq(SIN), sq(COS)], 1)], 1], ID)
    ),
    "a tangent where the cosine may be zero": Forgery(MAY_BE_ZERO, proved(["=", ["*", ["tan", "x"], COS], SIN], ID)),
    "a fraction under a binder": Forgery(MAY_BE_ZERO, proved(["=", integral(["/", "x", "x"]), integral(1)], ID)),
    "a fraction under a binder, the letter listed": Forgery(
        "x is no denominator of the statement",
        proved(["=", integral(["/", "x", "x"]), integral(["/", "x", "x"])], ID, nonzero=["x"], at={"x": 1}),
    ),
    "a fraction under a binder, the letter positive": Forgery(
        MAY_BE_ZERO, proved(["=", integral(["/", "x", "x"]), integral(1)], ID, [[">", "x", 0]], at={"x": 1})
    ),
    "a root that hides a sign": Forgery(NOT_EQUAL, proved(["=", ["sqrt", sq("x")], "x"], ID)),
    "a root of a product": Forgery(
        NOT_EQUAL, proved(["=", ["sqrt", ["*", "x", "y"]], ["*", ["sqrt", "x"], ["sqrt", "y"]]], ID)
    ),
    "a root squared": Forgery(NOT_EQUAL, proved(["=", sq(["sqrt", "x"]), "x"], ID)),
    "two roots that are not the same": Forgery(
        NOT_EQUAL, proved(["=", ["sqrt", ["+", "x", 378610]], ["sqrt", ["+", "x", 2312624]]], ID)
    ),
    "the root of a prime beyond the table": Forgery(
        "the root of (47, 1): only of products of primes up to 43", proved(["=", sq(["sqrt", 47]), 47], ID)
    ),
    "the negative root": Forgery(NOT_EQUAL, proved(["=", ["sqrt", 4], -2], ID)),
    "a real power with a fraction": Forgery(NOT_EQUAL, proved(["=", ["pow", sq("x"), ["/", 1, 2]], "x"], ID)),
    "the sine of a multiple": Forgery(NOT_EQUAL, proved(["=", ["sin", ["*", 2, "x"]], ["*", 2, SIN]], ID)),
    "half an angle": Forgery(NOT_EQUAL, proved(["=", ["sin", ["/", "x", 2]], ["sqrt", ["/", minus(1, COS), 2]]], ID)),
    "a third of a half turn": Forgery(NOT_EQUAL, proved(["=", ["sin", ["/", PI, 3]], ["/", 1, 2]], ID)),
    "the cosine of an angle twice, the other way": Forgery(NOT_EQUAL, proved(["=", ["cos", ["*", -2, "x"]], 1], ID)),
    "the sine of an angle three times, the other way": Forgery(
        NOT_EQUAL, proved(["=", ["sin", ["*", -3, "x"]], ["-", SIN]], ID)
    ),
    "an eighth of a turn the other way": Forgery(
        NOT_EQUAL, proved(["=", ["sin", ["+", "x", HALF_PI]], ["-", COS]], ID)
    ),
    "the sine of a product": Forgery(NOT_EQUAL, proved(["=", ["sin", ["*", "x", "y"]], ["*", SIN, ["sin", "y"]]], ID)),
    "the angle of a tangent": Forgery(
        NOT_EQUAL, proved(["=", ["arctan", ["tan", "x"]], "x"], ID, nonzero=[COS], at={"x": 0})
    ),
    "the angle of a sine": Forgery(NOT_EQUAL, proved(["=", ["arcsin", SIN], "x"], ID)),
    "twice an arctangent": Forgery(NOT_EQUAL, proved(["=", ["cos", ["*", 2, ["arctan", 2]]], ["/", 3, 5]], ID)),
    "an exponent beyond the bound": Forgery(
        "the exponent 1000000", proved(["=", ["^", ["^", ["^", "x", 10**6], 10**6], 10**6], 0], ID)
    ),
    "an exponent beyond the bound by names": Forgery(
        "the exponent 1000",
        proved(
            ["and", *[["=", f"d{k}", f"d{k}"] for k in range(1, 6)]],
            each(*[ID] * 5),
            definitions=[["d1", ["^", "x", 1000]], *[[f"d{k + 1}", ["^", f"d{k}", 1000]] for k in range(1, 6)]],
        ),
    ),
    "an exponent beyond the bound by a real power": Forgery(
        "the exponent 10000000", proved(["=", ["pow", ["pow", "x", 10**7], 10**7], 0], ID)
    ),
    "an exponent beyond the bound in a divisor": Forgery(
        "the exponent 10000000", proved(["=", ["/", 1, ["^", ["^", "x", 10**7], 10**7]], 0], ID)
    ),
    "a multiple of an angle beyond the bound": Forgery(
        "the multiple 1000000 of an angle", proved(["=", ["sin", ["*", 10**6, "x"]], 0], ID)
    ),
    "a term beyond all bounds": Forgery(
        "a term that is too large",
        proved(
            ["=", "d40", 0],
            ID,
            definitions=[["d0", ["+", "x", "x"]], *[[f"d{k + 1}", ["+", f"d{k}", f"d{k}"]] for k in range(40)]],
        ),
    ),
    "a function without a rate": Forgery(
        "the derivative of ('gamma', 'x')", proved(["=", ["diff", ["gamma", "x"], "x", 1, 1], 1], ID)
    ),
    "the rate of an arcsine at its end": Forgery(
        "division by zero", proved(["=", ["diff", ["arcsin", "x"], "x", 1, 1], 0], ID)
    ),
    "the rate of an arccosine with the other sign": Forgery(
        NOT_EQUAL, proved(["=", ["diff", ["arccos", "x"], "x", 1, 0], 1], ID)
    ),
    "the rate of an integral without its end": Forgery(
        NOT_EQUAL, proved(["=", ["diff", integral(f("x"), high="y"), "y", 1, "y"], f(0)], ID)
    ),
    "the rate of an integral by a letter of its integrand alone": Forgery(
        NOT_EQUAL,
        proved(["=", ["diff", integral(["*", "x", "y"], high="y"), "y", 1, "y"], integral("x", high="y")], ID),
    ),
    "the rate of an integral of what may not be smooth": Forgery(
        "the derivative of ('integral'", proved(["=", ["diff", integral(["sqrt", "y"]), "y", 1, 0], 0], ID)
    ),
    "the rate of an endless integral": Forgery(
        "the derivative of ('integral'",
        proved(["=", ["diff", integral("y", high=["infinity"]), "y", 1, "y"], integral(1, high=["infinity"])], ID),
    ),
    "a square under a binder taken for positive": Forgery(
        MAY_BE_ZERO, proved(["=", integral(["/", sq("x"), sq("x")]), integral(1)], ID)
    ),
    "the derivative of a root where it has none": Forgery(
        "division by zero", proved(["=", ["diff", ["sqrt", "x"], "x", 1, 0], 0], ID)
    ),
    "the derivative of a logarithm where it has none": Forgery(
        MAY_BE_ZERO, proved(["=", ["*", "x", ["diff", ["log", "x"], "x", 1, "x"]], 1], ID)
    ),
    # positive
    "positive by what is assumed in a branch": Forgery(
        "x is not manifestly positive",
        proved(
            ["and", ["=>", [">", "x", 0], ["=", 0, 0]], ["exists", ["z"], ["=", ["*", "z", "x"], 1]]],
            each(implies({**ID, "positive": ["x"]}), witness({"z": ["/", 1, "x"]}, ID)),
            witnesses=[{"values": {"x": 1}}],
        ),
    ),
    "positive by a letter's square": Forgery(
        "('^', 'x', 2) is not manifestly positive",
        proved(
            ["exists", ["z"], ["=", ["*", "z", sq("x")], 1]],
            {**witness({"z": ["/", 1, sq("x")]}, ID), "positive": [sq("x")]},
        ),
    ),
    "positive by itself": Forgery(
        "('/', 'x', 'x') is not manifestly positive",
        proved(
            ["exists", ["z"], ["=", ["*", "z", "x"], 1]],
            {**witness({"z": ["/", 1, "x"]}, ID), "positive": [["/", "x", "x"]]},
        ),
    ),
    "positive by a divisor that may be zero": Forgery(
        MAY_BE_ZERO,
        proved(
            ["exists", ["z"], ["=", ["*", "z", "x"], 1]],
            {**witness({"z": ["/", 1, "x"]}, ID), "positive": [["/", 1, sq("x")]]},
        ),
    ),
    "positive by a theorem in a branch": Forgery(
        "('gamma', ('/', 1, 2)) is not manifestly positive",
        proved(
            ["exists", ["z"], ["=", ["*", "z", HALF_GAMMA], 1]],
            theorem("gamma_values", {}, [], {**witness({"z": ["/", 1, HALF_GAMMA]}, ID), "positive": [HALF_GAMMA]}),
        ),
    ),
    "nonzero in another branch": Forgery(
        MAY_BE_ZERO,
        proved(
            ["and", ["=>", ["!=", "x", 0], ["=", "x", "x"]], ["exists", ["z"], ["=", ["*", "z", "x"], 1]]],
            each(implies(ID), witness({"z": ["/", 1, "x"]}, ID)),
            at={"x": 1},
        ),
    ),
    "nonzero outside of its branch": Forgery(
        MAY_BE_ZERO,
        proved(
            ["and", ["=>", ["!=", "x", 0], INVERTED], INVERTED],
            each(implies(witness({"z": INVERSE}, ID)), witness({"z": INVERSE}, ID)),
        ),
    ),
    "nonzero in one case of two": Forgery(
        MAY_BE_ZERO,
        proved(INVERTED, theorem("dichotomy", {"t": "x"}, [], cases(here(), *[witness({"z": INVERSE}, ID)] * 2))),
    ),
    "nonzero before it is assumed": Forgery(
        MAY_BE_ZERO,
        proved(
            ["and", ["=", ["/", "x", "x"], 1], ["=>", ["!=", "x", 0], ["=", ["/", "x", "x"], 1]]], each(ID, implies(ID))
        ),
    ),
    "another letter that is not zero in the branch": Forgery(
        MAY_BE_ZERO, proved(["=>", ["!=", "y", 0], INVERTED], implies(witness({"z": INVERSE}, ID)), at={"x": 0, "y": 1})
    ),
    "not negative, for not zero, in a branch": Forgery(
        MAY_BE_ZERO, proved(["=>", [">=", "x", 0], INVERTED], implies(witness({"z": INVERSE}, ID)), at={"x": 1})
    ),
    "a product that is not zero for its factor and one more": Forgery(
        MAY_BE_ZERO,
        proved(
            ["=>", ["!=", ["*", "x", "y"], 0], ["exists", ["z"], ["=", ["*", "z", minus("x", 1)], 1]]],
            implies(witness({"z": ["/", 1, minus("x", 1)]}, ID)),
            at={"x": 1, "y": 1},
        ),
    ),
    "nonzero for one letter of two that are called alike": Forgery(
        MAY_BE_ZERO,
        proved(
            [
                "and",
                ["forall", ["x"], ["=>", [">", "x", 0], ["=", ["/", "x", "x"], 1]]],
                ["forall", ["x"], ["=", ["/", "x", "x"], 1]],
            ],
            each(every(["y"], implies(ID)), every(["y"], ID)),
        ),
    ),
    "a denominator cleared by the contrary of the goal": Forgery(
        MAY_BE_ZERO,
        proved(["=", ["/", sq("y"), "y"], 0], implies(absurd([here()], [hyp(), "1"])), [["=", "y", 0]], at={"y": 0}),
    ),
    "a denominator of one branch met in another": Forgery(
        MAY_BE_ZERO,
        proved(["and", ["=", ["/", 0, "x"], 0], ["=", 0, 0]], each(ID, {"rule": "identity", "times": ["x"]})),
    ),
    "atoms that are no terms": Forgery(
        "['=', 0, 1] is no term", proved(ZERO_IS_ONE, {**ID, "atoms": {"s": ["=", 0, 1]}})
    ),
    "atoms that are a list": Forgery("['s'] is no object", proved(ZERO_IS_ONE, {**ID, "atoms": ["s"]})),
    "an atom that is infinity": Forgery("['infinity'] is no term", proved(ZERO_IS_ONE, {**ID, "atoms": {"s": OO}})),
    "an atom divided by what may be zero": Forgery(
        MAY_BE_ZERO,
        proved(
            ["=>", ["=", "x", 0], ZERO_IS_ONE],
            implies({**by(here(), factor="-s"), "atoms": {"s": ["/", 1, "x"]}}),
            at={"x": 0},
        ),
    ),
    "an atom of an outer step in a branch without it": Forgery(
        NOT_EQUAL,
        proved(
            ["and", ["=>", ["=", "y", 0], ["=", 0, 0]], ["=>", ["=", "y", 0], ["=", "y", SIN]]],
            each({**implies(ID), "atoms": {"s": SIN}}, implies(by(here(), factor="s"))),
            witnesses=[{"values": {"y": 0}}] * 2,
        ),
    ),
}

CERTIFICATES: dict[str, Forgery] = {
    "another verdict": Forgery("the verdict true", {**proved(["=", 0, 0], ID), "verdict": "true"}),
    "no verdict": Forgery(
        "a step without verdict", {k: v for k, v in proved(["=", 0, 0], ID).items() if k != "verdict"}
    ),
    "no name": Forgery("a step without id", {k: v for k, v in proved(["=", 0, 0], ID).items() if k != "id"}),
    "a number for a name": Forgery("7 is no text", {**proved(["=", 0, 0], ID), "id": 7}),
    "no claim": Forgery("a step without claim", {k: v for k, v in proved(["=", 0, 0], ID).items() if k != "claim"}),
    "no proof": Forgery("a step without proof", {k: v for k, v in proved(["=", 0, 0], ID).items() if k != "proof"}),
    "a point for a proof": Forgery("a step without proof", {**refuted(["=", 0, 0], {}), "verdict": "proved"}),
    "a proof for a point": Forgery("a step without point", {**proved(["=", 0, 0], ID), "verdict": "refuted"}),
    "a proof and a point": Forgery(
        "a step of a proof has the superfluous ['point']", {**proved(["=", "x", "x"], ID), "point": {"values": {}}}
    ),
    "a key too many": Forgery(
        "a step of a proof has the superfluous ['trusted']", proved(["=", 0, 0], ID, trusted=True)
    ),
    "a step with a key too many": Forgery(
        "a step of a proof has the superfluous ['trusted']", proved(["=", 0, 0], {**ID, "trusted": True})
    ),
    "a step with the key of another rule": Forgery(
        "a step of a proof has the superfluous ['then']", proved(["=", 0, 0], {**ID, "then": ID})
    ),
    "an unknown rule": Forgery("there is no rule trust me", proved(ZERO_IS_ONE, {"rule": "trust me"})),
    "a rule that is a method": Forgery("there is no rule finish", proved(ZERO_IS_ONE, {"rule": "finish"})),
    "a rule that is none": Forgery("None is no text", proved(ZERO_IS_ONE, {"rule": None})),
    "a proof without a rule": Forgery("a step without rule", proved(ZERO_IS_ONE, {})),
    "a proof that is a list": Forgery(
        "[{'rule': 'identity', 'cofactors': []}] is no step of a proof", proved(ZERO_IS_ONE, [ID])
    ),
    "a proof that is nothing": Forgery("None is no step of a proof", proved(["=", 0, 0], None)),
    "a certificate that is a list": Forgery("[] is no step of a proof", []),
    "a certificate that is nothing": Forgery("None is no step of a proof", None),
    "a hypothesis that is not used": Forgery(
        "a hypothesis is not used", proved(["=", "y", "y"], ID, [["=", "x", 0]], at=SIDE)
    ),
    "hypotheses that are a list": Forgery(
        "[['=', 'x', 0]] is no object", {**proved(["=", 0, 0], ID), "hypotheses": [["=", "x", 0]]}
    ),
    "a hypothesis that is no list": Forgery(
        "= is no formula", {**proved(["=", "x", 0], by(hyp())), "hypotheses": {"h": ["=", "x", 0]}}
    ),
    "hypotheses that contradict each other": Forgery(
        "('and', ('=', 'x', 0), ('=', 'x', 1)) is not so",
        proved(ZERO_IS_ONE, absurd([], [hyp(), "1"], [hyp(1), "-1"]), [["=", "x", 0], ["=", "x", 1]], at={"x": 0}),
    ),
    "hypotheses that contradict each other in the reals": Forgery(
        "('and', ('<', ('^', 'x', 2), 0)) is not so",
        proved(
            ["=", "y", 7],
            implies(have(["<", 0, 0], above(["+", ["-", sq("x")], sq("x")]), absurd([here(1)]))),
            [["<", sq("x"), 0]],
            at={"x": 1, "y": 1},
        ),
    ),
    "hypotheses that contradict each other, without a point": Forgery(
        NO_POINT, proved(ZERO_IS_ONE, absurd([], [hyp(), "1"], [hyp(1), "-1"]), [["=", "x", 0], ["=", "x", 1]])
    ),
    "a premise that nothing satisfies": Forgery(
        "('and', ('<', ('^', 'y', 2), 0)) is not so",
        proved(["=>", ["<", sq("y"), 0], ["=", "y", 5]], implies(NEGATIVE_SQUARE), at={"y": 0}),
    ),
    "a premise that nothing satisfies, without a point": Forgery(
        NO_POINT, proved(["=>", ["<", sq("y"), 0], ["=", "y", 5]], implies(NEGATIVE_SQUARE))
    ),
    "a premise under all that nothing satisfies": Forgery(
        NO_POINT,
        proved(["forall", ["y"], ["=>", ["<", sq("y"), 0], ["=", "y", 5]]], every(["y"], implies(NEGATIVE_SQUARE))),
    ),
    "a premise in a part that nothing satisfies": Forgery(
        "('and', ('<', ('^', 'y', 2), 0)) is not so",
        proved(
            ["and", ["=", 0, 0], ["=>", ["<", sq("y"), 0], ["=", "y", 5]]],
            each(ID, implies(NEGATIVE_SQUARE)),
            at={"y": 1},
        ),
    ),
    "a premise that the hypotheses forbid": Forgery(
        "('and', ('=', 'x', 0), ('=', 'x', 1)) is not so",
        proved(
            ["=>", ["=", "x", 1], ["=", "y", 5]],
            implies(absurd([], [here(), "-1"], [hyp(), "1"])),
            [["=", "x", 0]],
            at={"x": 1, "y": 1},
        ),
    ),
    "a second premise that nothing satisfies": Forgery(
        "('and', ('=', 'x', 1), ('=', 'x', 2)) is not so",
        proved(
            ["=>", ["=", "x", 1], ["=>", ["=", "x", 2], ["=", "y", 5]]],
            implies(implies(absurd([], [here(), "1"], [here(1), "-1"]))),
            at={"x": 1},
        ),
    ),
    "two implications and one point": Forgery(
        "1 proofs for 2",
        proved(
            ["and", ["=>", ["=", "x", 1], ["=", "x", 1]], ["=>", ["=", "x", 0], ["=", "x", 0]]],
            each(implies(by(here())), implies(by(here()))),
            at={"x": 1},
        ),
    ),
    "a point for nothing assumed": Forgery(
        "2 proofs for 1", proved(["=", 0, 0], ID, witnesses=[{"values": {}}, {"values": {}}])
    ),
    "a denominator that is zero by a hypothesis": Forgery(
        NOT_EQUAL,
        proved(
            ["=", ["/", minus("x", "y"), minus("y", "x")], 7],
            by(hyp(), factor="0"),
            [["=", "x", "y"]],
            nonzero=[minus("y", "x")],
            at=SIDE,
        ),
    ),
    "a denominator that is zero by a hypothesis, cleared": Forgery(
        "('and', ('=', 'x', 'y'), ('!=', ('+', 'y', ('-', 'x')), 0)) is not so",
        proved(
            ["=", ["/", minus("x", "y"), minus("y", "x")], 7],
            {"rule": "identity", "times": ["y - x"], "cofactors": [[hyp(), "8"]]},
            [["=", "x", "y"]],
            nonzero=[minus("y", "x")],
            at=SIDE,
        ),
    ),
    "a denominator that is not one": Forgery(
        "x is no denominator of the statement", proved(["=", "x", "x"], ID, nonzero=["x"], at={"x": 1})
    ),
    "a denominator of the proof that is listed": Forgery(
        "x is no denominator of the statement",
        proved(
            ["exists", ["z"], ["=", ["*", "z", "x"], 1]], witness({"z": ["/", 1, "x"]}, ID), nonzero=["x"], at={"x": 1}
        ),
    ),
    "a multiple of a denominator listed": Forgery(
        "('*', 'x', 'y') is no denominator of the statement",
        proved(["=", ["/", "x", "x"], 1], ID, nonzero=[["*", "x", "y"]], at=SIDE),
    ),
    "a denominator listed that hides another one": Forgery(
        MAY_BE_ZERO,
        proved(
            ["and", ["=", ["/", "y", "y"], 1], ["exists", ["z"], ["=", ["*", "z", "x"], 1]]],
            each(ID, witness({"z": "d"}, ID)),
            definitions=[["d", ["/", 1, "x"]]],
            nonzero=[["+", "y", ["*", 0, "d"]]],
            at=SIDE,
        ),
    ),
    "a denominator listed that is no term": Forgery(
        "['=', 'x', 0] is no term", proved(["=", ["/", "x", "x"], 1], ID, nonzero=[["=", "x", 0]], at={"x": 1})
    ),
    "denominators that are no list": Forgery(
        "{'x': 1} is no list", proved(["=", ["/", "x", "x"], 1], ID, nonzero={"x": 1}, at={"x": 1})
    ),
    "a denominator captured by a binder": Forgery(
        "('integral', 'y', 'y', 0, 1) is no denominator of the statement",
        proved(
            ["=", ["/", integral("z", "y"), integral("z", "y")], 1],
            ID,
            definitions=[["d", "y"]],
            nonzero=[integral("d", "y")],
            at=SIDE,
        ),
    ),
    "a definition captured by a binder": Forgery(
        NOT_EQUAL, proved(["=", integral("d", "x"), ["*", "d", integral(1, "x")]], ID, definitions=[["d", "x"]])
    ),
    "a definition captured by a quantifier": Forgery(
        NOT_EQUAL,
        proved(
            ["exists", ["x"], ["=", "x", ["+", "d", 1]]],
            witness({"x": ["+", "d", 1]}, ID),
            definitions=[["d", "x"]],
        ),
    ),
    "a definition captured in a hypothesis": Forgery(
        "('and', ('=', ('integral', 'x', 'x', 0, 1), 0)) is not so",
        proved(
            ["=", integral("d", "x"), 0],
            by(hyp()),
            [["=", integral("d", "x"), 0]],
            definitions=[["d", "x"]],
            at={"x": 0},
        ),
    ),
    "a definition captured in a lemma": Forgery(
        NO_LEMMA,
        proved(
            ["=", integral("d", "x"), 0],
            implies(by(here())),
            definitions=[["d", "x"]],
            lemmas=[["l", ["=", integral("d", "x"), 0]]],
        ),
        ({**proved(["=", integral("y", "x"), 0], by(hyp()), [["=", "y", 0]], at={"y": 0}), "id": "l"},),
    ),
    "a definition that is said not to hold": Forgery(
        "a step of a proof has the superfluous ['free']",
        proved(["=", "d", 1], ID, definitions=[["d", 1]], free=["d"]),
    ),
    "a letter of a cofactor taken for the definition": Forgery(
        NOT_EQUAL,
        proved(
            ["=", ["*", "d", "y"], 0],
            by(hyp(), factor="d"),
            [["=", "y", 0]],
            definitions=[["d", "x"]],
            at={"x": 1, "y": 0},
        ),
    ),
    "a definition given twice": Forgery(
        "d is defined twice", proved(["=", "d", 2], ID, definitions=[["d", 1], ["d", 2]])
    ),
    "a definition by what comes later": Forgery(
        NOT_EQUAL, proved(["=", "d", 1], ID, definitions=[["d", "e"], ["e", 1]])
    ),
    "a definition by itself": Forgery(NOT_EQUAL, proved(["=", 0, 1], ID, definitions=[["d", ["+", "d", 1]]])),
    "a definition that is no pair": Forgery(
        "['d', 1, 2] is no pair", proved(["=", "d", 1], ID, definitions=[["d", 1, 2]])
    ),
    "a number is defined": Forgery("0 is no text", proved(ZERO_IS_ONE, ID, definitions=[[0, 1]])),
    "pi is defined": Forgery(NOT_EQUAL, proved(["=", PI, 3], ID, definitions=[["pi", 3]])),
    "a letter under a binder taken for the definition": Forgery(
        NOT_EQUAL, proved(["=", integral("d", "d"), integral(1, "d")], ID, definitions=[["d", 1]])
    ),
    "a letter that exists taken for the definition": Forgery(
        NOT_EQUAL, proved(["forall", ["d"], ["=", "d", 1]], every(["z"], ID), definitions=[["d", 1]])
    ),
    # lemmas
    "a lemma from nowhere": Forgery(
        NO_LEMMA, proved(["=", "x", 0], implies(by(here())), lemmas=[["l", ["=", "x", 0]]])
    ),
    "a lemma that is refuted": Forgery(
        NO_LEMMA,
        proved(["=", "x", 0], implies(by(here())), lemmas=[["l", ["=", "x", 0]]]),
        ({**refuted(["=", "x", 0], {"x": 1}), "id": "l"},),
    ),
    "a lemma that is refuted and has a key proof": Forgery(
        NO_LEMMA,
        proved(["=", "x", 0], implies(by(here())), lemmas=[["l", ["=", "x", 0]]]),
        ({**refuted(["=", "x", 0], {"x": 1}), "id": "l", "proof": ID},),
    ),
    "a lemma whose proof fails": Forgery(
        NO_LEMMA,
        proved(["=", "x", 0], implies(by(here())), lemmas=[["l", ["=", "x", 0]]]),
        ({**proved(["=", "x", 0], ID), "id": "l"},),
    ),
    "a lemma by another name": Forgery(
        NO_LEMMA,
        proved(["=", "x", "x"], implies(by(here())), lemmas=[["l", ["=", "x", "x"]]]),
        ({**proved(["=", "x", "x"], ID), "id": "m"},),
    ),
    "a lemma that says something else": Forgery(
        NO_LEMMA,
        proved(["=", "x", 0], implies(by(here())), lemmas=[["l", ["=", "x", 0]]]),
        ({**proved(["=", "x", "x"], ID), "id": "l"},),
    ),
    "a lemma under a hypothesis that is not assumed": Forgery(
        NO_LEMMA,
        proved(["=", "x", 0], implies(by(here())), lemmas=[["l", ["=", "x", 0]]]),
        ({**proved(["=", "x", 0], by(hyp()), [["=", "x", 0]], at={"x": 0}), "id": "l"},),
    ),
    "a lemma under a hypothesis of the same name": Forgery(
        NO_LEMMA,
        proved(["=", "x", 0], implies(by(here())), [["=", "y", 0]], lemmas=[["l", ["=", "x", 0]]], at={"y": 0}),
        ({**proved(["=", "x", 0], by(hyp()), [["=", "x", 0]], at={"x": 0}), "id": "l"},),
    ),
    "a lemma under a denominator that is not assumed": Forgery(
        MAY_BE_ZERO,
        proved(
            ["exists", ["z"], ["=", ["*", "z", "x"], 1]],
            implies(witness({"z": ["/", 1, "x"]}, ID)),
            lemmas=[["l", ["=", ["/", "x", "x"], 1]]],
        ),
        ({**proved(["=", ["/", "x", "x"], 1], ID, nonzero=["x"], at={"x": 1}), "id": "l"},),
    ),
    "a lemma's denominator that is not assumed": Forgery(
        MAY_BE_ZERO,
        proved(["=", "y", "y"], implies(ID), lemmas=[["l", ["=", ["/", "x", "x"], 1]]]),
        ({**proved(["=", ["/", "x", "x"], 1], ID, nonzero=["x"], at={"x": 1}), "id": "l"},),
    ),
    "a lemma under another definition": Forgery(
        NO_LEMMA,
        proved(["=", "d", 1], implies(by(here())), definitions=[["d", 2]], lemmas=[["l", ["=", "d", 1]]]),
        ({**proved(["=", "d", 1], ID, definitions=[["d", 1]]), "id": "l"},),
    ),
    "a lemma under another definition, in a cofactor": Forgery(
        NO_LEMMA,
        proved(
            ["=", ["*", "d", "d"], "d"],
            implies({**by(here(), factor="d"), "atoms": {"d": "d"}}),
            definitions=[["d", 2]],
            lemmas=[["l", ["=", "d", 1]]],
        ),
        ({**proved(["=", "d", 1], ID, definitions=[["d", 1]]), "id": "l"},),
    ),
    "a lemma with a definition that is none here": Forgery(
        NO_LEMMA,
        proved(["=", "d", 1], implies(by(here())), lemmas=[["l", ["=", "d", 1]]]),
        ({**proved(["=", "d", 1], ID, definitions=[["d", 1]]), "id": "l"},),
    ),
    "the lemma is the theorem": Forgery(
        NO_LEMMA, proved(ZERO_IS_ONE, implies(by(here())), lemmas=[["t", ZERO_IS_ONE]])
    ),
    "two lemmas in a circle": Forgery(
        NO_LEMMA,
        proved(ZERO_IS_ONE, implies(by(here())), lemmas=[["l", ZERO_IS_ONE]]),
        ({**proved(ZERO_IS_ONE, implies(by(here())), lemmas=[["t", ZERO_IS_ONE]]), "id": "l"},),
    ),
    "three lemmas in a circle": Forgery(
        NO_LEMMA,
        proved(ZERO_IS_ONE, implies(by(here())), lemmas=[["l", ZERO_IS_ONE]]),
        (
            {**proved(ZERO_IS_ONE, implies(by(here())), lemmas=[["m", ZERO_IS_ONE]]), "id": "l"},
            {**proved(ZERO_IS_ONE, implies(by(here())), lemmas=[["t", ZERO_IS_ONE]]), "id": "m"},
        ),
    ),
    "a hypothesis of a lemma forgotten along a chain": Forgery(
        NO_LEMMA,
        proved(["=", "x", 0], implies(by(here())), lemmas=[["l", ["=", "x", 0]]]),
        (
            {**proved(["=", "x", 0], implies(by(here())), lemmas=[["m", ["=", "x", 0]]]), "id": "l"},
            {**proved(["=", "x", 0], by(hyp()), [["=", "x", 0]], at={"x": 0}), "id": "m"},
        ),
    ),
    "an alternative of a lemma": Forgery(
        NO_LEMMA,
        proved(ZERO_IS_ONE, implies(by(here())), lemmas=[["l", ZERO_IS_ONE]]),
        ({**proved(["or", ZERO_IS_ONE, ["=", 0, 0]], choose(1, ID)), "id": "l"},),
    ),
    "the conclusion of a lemma without its premise": Forgery(
        NO_LEMMA,
        proved(["=", "x", 0], implies(by(here())), lemmas=[["l", ["=", "x", 0]]]),
        ({**proved(["=>", ["=", "x", 0], ["=", "x", 0]], implies(by(here())), at={"x": 0}), "id": "l"},),
    ),
    "a lemma about another letter": Forgery(
        NO_LEMMA,
        proved(["=", "y", 1], implies(by(here())), lemmas=[["l", ["=", "y", 1]]]),
        ({**proved(["=", "x", 1], by(hyp()), [["=", "x", 1]], at={"x": 1}), "id": "l"},),
    ),
    "a refutation with a lemma": Forgery(
        "a point needs no lemmas", refuted(["=", "x", 0], {"x": 1}, lemmas=[["l", ZERO_IS_ONE]])
    ),
    # refutations
    "a point where the claim holds": Forgery("('and', ('!=', 'x', 1)) is not so", refuted(["=", "x", 1], {"x": 1})),
    "a point where a sum ends between whole numbers": Forgery(
        "a sum between ends that may not be whole",
        refuted(["!=", ["sum", "a", "k", 1, "x"], ["sum", "a", "k", 1, "x"]], {"a": 1, "x": ["/", 1, 2]}, proof=ID),
    ),
    "a point where a product ends at a root": Forgery(
        "a sum between ends that may not be whole",
        refuted(
            ["!=", ["product", "a", "k", 1, "x"], ["product", "a", "k", 1, "x"]], {"a": 2, "x": ["sqrt", 2]}, proof=ID
        ),
    ),
    "a point where a hypothesis does not hold": Forgery(
        "('and', ('=', 'x', 1), ('!=', 'x', 1)) is not so", refuted(["=", "x", 1], {"x": 0}, [["=", "x", 1]])
    ),
    "a point where what is listed is zero": Forgery(
        "('and', ('!=', 'x', 0), ('!=', 'x', 1)) is not so", refuted(["=", "x", 1], {"x": 0}, nonzero=["x"])
    ),
    "a point where a denominator is zero": Forgery(
        "division by zero", refuted(["=", ["/", 1, "x"], ["/", 1, "x"]], {"x": 0})
    ),
    "a point where a denominator is zero beside what is false": Forgery(
        "division by zero", refuted(["and", ["!=", "x", 0], ["=", ["/", 1, "x"], ["/", 1, "x"]]], {"x": 0})
    ),
    "a point where a denominator is zero, by a proof": Forgery(
        "a term has no value at the point: ('!=', 'x', 0) is not so",
        refuted(
            ["and", ["!=", "x", 0], ["=", ["/", 1, "x"], ["/", 1, "x"]]],
            {"x": 0},
            proof=each(choose(0, by(["point", 0]))),
        ),
    ),
    "a point where a root is none": Forgery(
        "the root of what may be negative", refuted([">=", ["sqrt", "x"], 0], {"x": -1})
    ),
    "a point where a root is none, by a proof": Forgery(
        "a term has no value at the point: ('>=', 'x', 0) is not so",
        refuted(
            ["=>", ["=", ["sqrt", "x"], ["sqrt", "x"]], [">=", "x", 0]],
            {"x": -1},
            proof=each(each(ID, above(1, [["point", 0], "-1"]))),
        ),
    ),
    "a point where a logarithm is none, by a proof": Forgery(
        "a term has no value at the point: ('>', 'x', 0) is not so",
        refuted(
            ["=>", ["=", ["log", "x"], ["log", "x"]], [">", "x", 0]],
            {"x": 0},
            proof=each(each(ID, above(0, [["point", 0], "-1"]))),
        ),
    ),
    "a point where an arcsine is none, by a proof": Forgery(
        "a term has no value at the point: ('<=', ('^', 'x', 2), 1) is not so",
        refuted(
            ["=>", ["=", ["arcsin", "x"], ["arcsin", "x"]], ["<=", "x", 1]],
            {"x": 2},
            proof=each(each(ID, above(1, [["point", 0], "1"]))),
        ),
    ),
    "a point where a tangent is none, by a proof": Forgery(
        "a term has no value at the point: ('!=', ('cos', 'x'), 0) is not so",
        refuted(
            ["and", ["!=", "x", HALF_PI], ["=", ["tan", "x"], ["tan", "x"]]],
            {"x": HALF_PI},
            proof=each(choose(0, by(["point", 0]))),
        ),
    ),
    "a point where a power is none, by a proof": Forgery(
        "a term has no value at the point: ('>', 'x', 0) is not so",
        refuted(
            ["and", [">", "x", 0], ["=", ["pow", "x", ["/", 1, 2]], ["pow", "x", ["/", 1, 2]]]],
            {"x": -1},
            proof=each(choose(0, above(1, [["point", 0], "-1"]))),
        ),
    ),
    "a letter without a coordinate": Forgery("no value for y", refuted(["=", "x", "y"], {"x": 1})),
    "a letter without a coordinate, by a proof": Forgery(
        "no value for y", refuted(["!=", "y", "y"], {"x": 1}, proof=each(ID))
    ),
    "infinity as a coordinate": Forgery(
        "['infinity'] is no term", refuted(["=", ["+", "x", 1], ["+", "x", 1]], {"x": OO})
    ),
    "a truth value as a coordinate": Forgery("True is no letter", refuted(["=", "x", 0], {"x": True})),
    "nothing as a coordinate": Forgery("None is no letter", refuted(["=", "x", 1], {"x": None})),
    "a letter as a coordinate": Forgery(NO_COORDINATE, refuted(["=", "x", "y"], {"x": "y", "y": 1})),
    "a function as a coordinate": Forgery(NO_COORDINATE, refuted(["=", "x", f(0)], {"x": f(1)})),
    "a zero fraction as a coordinate": Forgery("a coordinate has no value", refuted(["=", "x", 1], {"x": ["/", 0, 0]})),
    "an imaginary coordinate": Forgery("a coordinate has no value", refuted([">=", sq("x"), 0], {"x": ["sqrt", -1]})),
    "a coordinate of a defined letter": Forgery(
        NO_COORDINATE, refuted(["=", "d", 1], {"d": 2}, definitions=[["d", 1]])
    ),
    "a value for a sine": Forgery(
        "('and', ('!=', ('+', ('^', ('sin', 'x'), 2), ('^', ('cos', 'x'), 2)), 1)) is not so",
        refuted(["=", ["+", sq(SIN), sq(COS)], 1], {"x": 0, "sin_x": 5, "cos_x": 0}),
    ),
    "a value for a constant": Forgery("('and', ('>=', ('pi',), 4)) is not so", refuted(["<", PI, 4], {"pi": 5})),
    "a coordinate for a bound letter": Forgery(
        "the digits of ('mean', ('sin', 'x'), 'x')", refuted(["=", ["mean", SIN, "x"], 0], {"x": 1})
    ),
    "a value of a function at two places that are one": Forgery(
        "('call', 'f', (0,), ('sqrt', 4)) has two values",
        refuted(["=", f(2), f(["sqrt", 4])], {}, calls=[[f(2), 0], [f(["sqrt", 4]), 1]]),
    ),
    "a value of a function at two places that are one angle": Forgery(
        "('call', 'f', (0,), ('arctan', 1)) is no function at a point",
        refuted(
            ["=", integral(f(["arctan", 1])), integral(f(["/", PI, 4]))],
            {},
            calls=[[f(["arctan", 1]), 0], [f(["/", PI, 4]), 1]],
            proof=constant(0, constant(1, compute(here(), here(1)))),
        ),
    ),
    "two values of a function": Forgery(
        "('call', 'f', (0,), 1) has two values", refuted(["=", f(1), f(1)], {}, calls=[[f(1), 0], [f(1), 1]])
    ),
    "a value of a sine that is said": Forgery(
        "('sin', 1) is no function at a point", refuted(["<=", ["sin", 1], 1], {}, calls=[[["sin", 1], 2]])
    ),
    "a value of a function at a letter": Forgery(
        "('call', 'f', (0,), 'x') is no function at a point", refuted(["=", f("x"), 1], {"x": 1}, calls=[[f("x"), 2]])
    ),
    "a value of a function that has none": Forgery(
        "['infinity'] is no term", refuted(["=", f(1), 1], {}, calls=[[f(1), OO]])
    ),
    "a value of a function that is not listed": Forgery(
        "the digits of ('call', 'f', (0,), 1)", refuted(["=", f(1), f(2)], {}, calls=[[f(1), 0]])
    ),
    "a value of a function that a hypothesis speaks of": Forgery(
        "what is assumed of {'f'} is not only so at one point",
        refuted(["=", f(2), 0], {}, [["=", f(1), 0]], calls=[[f(1), 0], [f(2), 1]]),
    ),
    "a value of a function that a hypothesis speaks of at all places": Forgery(
        "what is assumed of {'f'} is not only so at one point",
        refuted(["=", f(2), 0], {}, [["forall", ["x"], ["=", f("x"), 0]]], calls=[[f(2), 1]]),
    ),
    "a hypothesis about a letter at one place": Forgery(
        "what is assumed of {'f'} is not only so at one point",
        refuted(["=", f(2), 0], {"x": 1}, [["=", f("x"), 0]], calls=[[f(1), 0], [f(2), 1]]),
    ),
    "an integral at a point": Forgery(
        "('and', ('!=', ('integral', 'x', 'x', 0, 1), ('/', 1, 2))) is not so",
        refuted(["=", integral("x"), ["/", 1, 2]], {}),
    ),
    "a fraction that vanishes under a binder at a point": Forgery(
        MAY_BE_ZERO,
        refuted(
            ["=", integral(["/", NO_CIRCLE, NO_CIRCLE]), 2],
            {},
            proof=constant(1, compute(here())),
        ),
    ),
    "a claim about all at a point": Forgery(
        "('forall', ('x',), ('!=', ('^', 'x', 2), 2)) is not about numbers",
        refuted(["exists", ["x"], ["=", sq("x"), 2]], {"x": 1}),
    ),
    "a claim about all at a point, by a proof": Forgery(
        "no value for x",
        refuted(["exists", ["x"], ["=", sq("x"), 2]], {"x": 1}, proof=each(every(["x"], compute()))),
    ),
    "a side shown with another value": Forgery(
        "('and', ('!=', 'x', 0), ('=', 'x', 2)) is not so", refuted(["=", "x", 0], {"x": 1}, shown=[["=", "x", 2]])
    ),
    "sides exchanged": Forgery(
        "('and', ('!=', 'x', 0), ('=', 'x', 0), ('=', 0, 1)) is not so",
        refuted(["=", "x", 0], {"x": 1}, shown=[["=", "x", 0], ["=", 0, 1]]),
    ),
    "a premise shown to be false that is true": Forgery(
        "('=>', ('=', 'x', 1), ('or',))) is not so",
        refuted(["=>", ["=", "x", 1], ["=", "x", 2]], {"x": 1}, shown=[["=>", ["=", "x", 1], ["or"]]]),
    ),
    "a value shown that is no formula": Forgery("1 is no formula", refuted(["=", "x", 0], {"x": 1}, shown=[1])),
    "a value shown that the proof leaves out": Forgery(
        "1 proofs for 2",
        refuted(
            ["=", "x", 0],
            {"x": 1},
            shown=[["=", "x", 1]],
            proof=each(implies(absurd([], [here(), "-1"], [["point", 0], "1"]))),
        ),
    ),
    "digits of something else": Forgery(
        "('<=', ('/', 85, 100), ('sin', 'x'))) is not so",
        refuted(["=", ["sin", "x"], 0], {"x": 1}, shown=[["<=", SIN, ["/", 86, 100]], ["<=", ["/", 85, 100], SIN]]),
    ),
    "digits with two ends in one": Forgery(
        "<= with 3 fields",
        refuted(["=", ["sin", "x"], 0], {"x": 1}, shown=[["<=", ["/", 84, 100], SIN, ["/", 85, 100]]]),
    ),
    "a point that is a list": Forgery("[] is no step of a proof", {**refuted(["=", "x", 0], {"x": 1}), "point": []}),
    "a point with a key too many": Forgery(
        "a step of a proof has the superfluous ['trusted']",
        {**refuted(["=", "x", 0], {"x": 1}), "point": {"values": {"x": 1}, "trusted": 1}},
    ),
    "no point": Forgery(
        "a step without point", {k: v for k, v in refuted(["=", "x", 0], {"x": 1}).items() if k != "point"}
    ),
    "a proof at a point that is nothing": Forgery("0 is no step of a proof", refuted(["=", "x", 0], {"x": 1}, proof=0)),
    "a proof at a point of something else": Forgery(NO_EQUATION, refuted(["=", "x", "x"], {"x": 1}, proof=ID)),
    "a coordinate that is another by a proof": Forgery(
        "('point', 1) is no such fact",
        refuted(["=", "x", 1], {"x": 1}, proof=each(implies(absurd([], [["point", 0], "1"], [["point", 1], "1"])))),
    ),
    "digits too few to compare": Forgery(
        "too few digits to compare ('arctan', 1) and ('/', ('pi',), 4)", refuted(["=", ["arctan", 1], ["/", PI, 4]], {})
    ),
    # witnesses
    "a witness with a letter that has no value": Forgery(
        "no value for y", proved(["=", "x", "y"], by(hyp()), [["=", "x", "y"]], at={"x": 1})
    ),
    "a witness that is no number": Forgery(
        NO_COORDINATE, proved(["=", "x", "y"], by(hyp()), [["=", "x", "y"]], at={"x": "y", "y": 1})
    ),
    "a witness at infinity": Forgery(
        "['infinity'] is no term", proved([">", "x", 0], above("x"), [[">", "x", 0]], at={"x": OO})
    ),
    "a witness with more to show": Forgery(
        "a step of a proof has the superfluous ['shown']",
        proved(["=", "x", "y"], by(hyp()), [["=", "x", "y"]], witnesses=[{"values": SIDE, "shown": []}]),
    ),
    "a witness without coordinates": Forgery(
        "no value for x", proved(["=", "x", "y"], by(hyp()), [["=", "x", "y"]], witnesses=[{}])
    ),
    "a witness whose proof is wrong": Forgery(
        NOT_EQUAL,
        proved(
            ["=", "x", "y"],
            by(hyp()),
            [["=", "x", "y"]],
            witnesses=[{"values": {"x": 1, "y": 2}, "proof": each(by(["point", 0]))}],
        ),
    ),
    "witnesses that are no list": Forgery(
        "{'values': {'x': 1, 'y': 1}} is no list",
        proved(["=", "x", "y"], by(hyp()), [["=", "x", "y"]], witnesses={"values": SIDE}),
    ),
    "a witness of functions with two values at one place": Forgery(
        "('call', 'f', (0,), 1) has two values",
        proved(
            ZERO_IS_ONE,
            absurd([hyp()], [hyp(1), "1"]),
            [["!=", f(1), 0], ["=", f(1), 0]],
            witnesses=[{"values": {}, "calls": [[f(1), 0], [f(1), 1]]}],
        ),
    ),
}


BACK = absurd([], [here(), "1"])
FROM = {"p": 1, "q": 1, "r": 1, "k": 0, "u": 0, "c": 1}
FRACTION = of("x", ["pow", ["+", sq("x"), 1], -1])

DISTANCE = ["sqrt", sq(minus("k", ["/", 3, 2]))]  # from 3/2


def counted(t: JSON, order: JSON, then: JSON) -> JSON:
    """The sum of so many ones."""
    given = {"f": of("k", 1), "g": of("k", "k"), "s": 1, "t": t}
    return theorem("telescope", given, [order, ID, every(["x"], implies(ID))], then)


ONES = ["sum", 1, "k", 1, "n"]
NO_BASE = minus(["sqrt", sq("x")], "x")  # zero for all positive x
AHEAD = sq(minus(["+", "x", 1], ["/", 3, 2]))
THEOREMS: dict[str, Forgery] = {
    "the exponential of the logarithm of what may be negative": Forgery(
        NO_SIGN, proved(["=", ["exp", ["log", "x"]], "x"], theorem("exp_of_log", {"t": "x"}, [above("x")], by(here())))
    ),
    "the exponential of a logarithm as another number": Forgery(
        NOT_EQUAL, proved(["=", ["exp", ["log", 2]], 3], theorem("exp_of_log", {"t": 2}, [above(2)], by(here())))
    ),
    "the logarithm of one for that of zero": Forgery(
        NOT_EQUAL, proved(["=", ["log", 0], 0], theorem("log_of_one", {}, [], by(here())))
    ),
    "the logarithm of an exponential for that of its argument": Forgery(
        NOT_EQUAL, proved(["=", ["log", "x"], "x"], theorem("log_of_exp", {"t": "x"}, [], by(here())))
    ),
    "the logarithm of a product of negative factors": Forgery(
        NO_SIGN,
        proved(
            ["=", ["log", ["*", "x", "y"]], ["+", ["log", "x"], ["log", "y"]]],
            theorem("log_of_product", {"s": "x", "t": "y"}, [above("x"), above("y")], by(here())),
            [[">", ["*", "x", "y"], 0]],
            at=SIDE,
        ),
    ),
    "the logarithm of a sum as that of a product": Forgery(
        NOT_EQUAL,
        proved(
            ["=", ["log", 5], ["+", ["log", 2], ["log", 3]]],
            theorem("log_of_product", {"s": 2, "t": 3}, [above(2), above(3)], by(here())),
        ),
    ),
    "the logarithm of a power of a negative base": Forgery(
        NOT_THE_FORM,
        proved(
            ["=", ["log", ["pow", -1, 2]], ["*", 2, ["log", -1]]],
            theorem("log_of_power", {"t": -1, "u": 2}, [above(1)], by(here())),
        ),
    ),
    "the logarithm of a square for that of a root": Forgery(
        NOT_EQUAL,
        proved(
            ["=", ["log", "x"], ["*", 2, ["log", sq("x")]]],
            theorem("log_of_root", {"t": "x"}, [above("x")], by(here())),
            [[">", "x", 0]],
            at={"x": 1},
        ),
    ),
    "the logarithm of the root of what may be zero": Forgery(
        NO_SIGN,
        proved(
            ["=", ["*", 2, ["log", ["sqrt", "x"]]], ["log", "x"]],
            theorem("log_of_root", {"t": "x"}, [above("x")], by(here())),
            [[">=", "x", 0]],
            at={"x": 1},
        ),
    ),
    "a power as the exponential of the logarithm of a negative base": Forgery(
        NO_SIGN,
        proved(
            ["=", ["pow", "x", "y"], ["exp", ["*", "y", ["log", "x"]]]],
            theorem("power_as_exp", {"b": "x", "u": "y"}, [above("x")], by(here())),
        ),
    ),
    "the sine of an arctangent as the tangent": Forgery(
        NOT_EQUAL,
        proved(["=", ["sin", ["arctan", "x"]], "x"], theorem("circular_of_arctan", {"t": "x"}, [], by(here()))),
    ),
    "the sine of an arcsine beyond one": Forgery(
        NOT_THE_FORM,
        proved(["=", ["sin", ["arcsin", 2]], 2], theorem("circular_of_arcsin", {"t": 2}, [above(0)], by(here()))),
    ),
    "the cosine of an arcsine with the other sign": Forgery(
        NOT_EQUAL,
        proved(
            ["=", ["cos", ["arcsin", "x"]], ["-", ["sqrt", minus(1, sq("x"))]]],
            theorem("circular_of_arcsin", {"t": "x"}, [above(minus(1, sq("x")))], by(here(1))),
            [["<=", sq("x"), 1]],
            at={"x": 0},
        ),
    ),
    "the cosine of an arccosine beyond one": Forgery(
        NOT_THE_FORM,
        proved(["=", ["cos", ["arccos", 2]], 2], theorem("circular_of_arccos", {"t": 2}, [above(0)], by(here()))),
    ),
    "a sum up to before its beginning": Forgery(
        NOT_THE_FORM,
        proved(
            ["=", ["sum", 1, "k", 1, -2], -2],
            theorem(
                "telescope",
                {"f": of("k", 1), "g": of("k", "k"), "s": 1, "t": -2},
                [above(0), ID, every(["x"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "a sum that begins with another number": Forgery(
        NOT_EQUAL,
        proved(
            ["=", ["sum", "k", "k", 1, 3], 7],
            theorem(
                "telescope",
                {"f": of("k", "k"), "g": of("k", ["+", ["/", ["*", "k", ["+", "k", 1]], 2], 1]), "s": 1, "t": 3},
                [above(3), ID, every(["x"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "an exponential that grows": Forgery(
        NO_SIGN,
        proved(
            ["=", integral(["exp", "x"], high=OO), -1],
            theorem(
                "decaying",
                {"f": of("x", ["exp", "x"]), "g": of("x", 1), "a": -1, "s": 0},
                [above(-1), every(["y"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "a decaying integral by another derivative": Forgery(
        NOT_EQUAL,
        proved(
            ["=", integral(["exp", ["-", "x"]], high=OO), 2],
            theorem(
                "decaying",
                {"f": of("x", ["exp", ["-", "x"]]), "g": of("x", -2), "a": 1, "s": 0},
                [above(1), every(["y"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "an exponential that outweighs what decays": Forgery(
        "is no polynomial",
        proved(
            ["=", integral(["exp", "x"], high=OO), -1],
            theorem(
                "decaying",
                {"f": of("x", ["exp", "x"]), "g": of("x", ["exp", ["*", 2, "x"]]), "a": 1, "s": 0},
                [above(1), every(["y"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "a decaying integral across a pole": Forgery(
        "is no polynomial",
        proved(
            [
                "=",
                integral(["-", ["*", ["exp", ["-", "x"]], ["+", ["/", 1, "x"], ["^", "x", -2]]]], low=-1, high=OO),
                ["exp", 1],
            ],
            theorem(
                "decaying",
                {
                    "f": of("x", ["-", ["*", ["exp", ["-", "x"]], ["+", ["/", 1, "x"], ["^", "x", -2]]]]),
                    "g": of("x", ["/", 1, "x"]),
                    "a": 1,
                    "s": -1,
                },
                [above(1), every(["y"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "a sine of an exponential that decays": Forgery(
        "is no polynomial",
        proved(
            ["=", integral(["exp", ["-", "x"]], high=OO), 1],
            theorem(
                "decaying",
                {"f": of("x", ["exp", ["-", "x"]]), "g": of("x", ["*", 0, ["sin", ["exp", "x"]]]), "a": 1, "s": 0},
                [above(1), every(["y"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "a Gaussian that grows": Forgery(
        NO_SIGN,
        proved(
            ["=", integral(["exp", sq("x")], low=NOO, high=OO), 0],
            theorem(
                "gaussian",
                {"f": of("x", ["exp", sq("x")]), "g": of("x", 0), "a": -1, "b": 0, "c": 1},
                [above(-1), every(["y"], ID)],
                by(here()),
            ),
        ),
    ),
    "a Gaussian with another middle": Forgery(
        NOT_EQUAL,
        proved(
            ["=", integral(["exp", ["-", sq("x")]], low=NOO, high=OO), ["sqrt", PI]],
            theorem(
                "gaussian",
                {"f": of("x", ["exp", ["-", sq("x")]]), "g": of("x", 0), "a": 1, "b": 1, "c": 1},
                [above(1), every(["y"], ID)],
                by(here()),
            ),
        ),
    ),
    "a Gaussian wave of another frequency": Forgery(
        NOT_EQUAL,
        proved(
            ["=", integral(["*", ["exp", ["-", sq("x")]], COS], low=NOO, high=OO), ["*", ["exp", -1], ["sqrt", PI]]],
            theorem(
                "gaussian_wave",
                {
                    "f": of("x", ["*", ["exp", ["-", sq("x")]], COS]),
                    "g": of("x", 0),
                    **{"a": 1, "b": 0, "c": 1, "u": 2, "v": 0},
                },
                [above(1), every(["y"], ID)],
                by(here()),
            ),
        ),
    ),
    "a Gaussian wave that grows": Forgery(
        NO_SIGN,
        proved(
            ["=", integral(["*", ["exp", sq("x")], COS], low=NOO, high=OO), 0],
            theorem(
                "gaussian_wave",
                {
                    "f": of("x", ["*", ["exp", sq("x")], COS]),
                    "g": of("x", 0),
                    **{"a": -1, "b": 0, "c": 1, "u": 1, "v": 0},
                },
                [above(-1), every(["y"], ID)],
                by(here()),
            ),
        ),
    ),
    "an integral that is shifted by something else": Forgery(
        NOT_EQUAL,
        proved(
            ["=", integral("x", low=NOO, high=OO), integral(["+", "x", 1], low=NOO, high=OO)],
            theorem(
                "shifted",
                {"f": of("x", "x"), "g": of("x", ["+", "x", 1]), "a": 1},
                [every(["y"], ID)],
                by(here()),
            ),
        ),
    ),
    "a Gaussian beside what outweighs it": Forgery(
        "is no polynomial",
        proved(
            ["=", integral(["exp", ["-", sq("x")]], low=NOO, high=OO), ["sqrt", PI]],
            theorem(
                "gaussian",
                {"f": of("x", ["exp", ["-", sq("x")]]), "g": of("x", ["exp", sq("x")]), "a": 1, "b": 0, "c": 1},
                [above(1), every(["y"], ID)],
                by(here()),
            ),
        ),
    ),
    **{
        f"a full turn {what}": Forgery(
            why,
            proved(
                ["=", integral(["/", 4, ["+", a, ["*", b, COS]]], "x", 0, ["*", 2, PI]), value],
                theorem(
                    "full_turn",
                    {"f": of("x", ["/", 4, ["+", a, ["*", b, COS]]]), "a": a, "b": b, "c": 0, "u": 4, "r": r, "s": 0},
                    [above(a), above(["+", ["^", a, 2], ["-", ["^", b, 2]]]), above(r), ID, every(["y"], implies(ID))],
                    by(here()),
                ),
            ),
        )
        for what, why, a, b, r, value in (
            ("through a zero below", NO_SIGN, 3, 5, 4, ["*", 2, PI]),
            ("with another root", NOT_EQUAL, 5, 3, 3, ["*", 2, PI]),
            ("with a negative root", NO_SIGN, 5, 3, -4, ["*", -2, PI]),
            ("of a negative sum", NO_SIGN, -5, 3, 4, ["*", 2, PI]),
            ("with another value", NOT_EQUAL, 5, 3, 4, PI),
        )
    },
    "a constant without a value": Forgery(
        UNDER_A_BINDER,
        proved(
            ["=", integral(POLE, "t"), POLE],
            theorem("constant", {"c": POLE, "s": 0, "t": 1}, [], by(here())),
        ),
    ),
    "an integral in an integral without a value": Forgery(
        "a denominator may be zero",
        proved(
            ["=", integral(integral(HOLE, "r"), "t"), 1],
            theorem(
                "antiderivative_everywhere",
                {"f": of("t", integral(HOLE, "r")), "g": of("t", sq("t")), "s": 0, "t": 1},
                [
                    every(
                        ["t"],
                        theorem(
                            "antiderivative_everywhere",
                            {"f": of("r", HOLE), "g": of("r", ["*", 2, "t", "r"]), "s": 0, "t": 1},
                            [every(["r"], ID)],
                            by(here()),
                        ),
                    )
                ],
                by(here()),
            ),
        ),
    ),
    "an end of an integral that divides by zero": Forgery(
        "a denominator may be zero: y",
        proved(
            ["=", integral(integral("t", "r", 0, ["/", 1, "t"]), "t", -1, 1), 2],
            theorem(
                "antiderivative",
                {"f": of("t", integral("t", "r", 0, ["/", 1, "t"])), "g": of("t", "t"), "s": -1, "t": 1},
                [
                    above(2),
                    every(
                        ["y"],
                        implies(theorem("constant", {"c": "y", "s": 0, "t": ["/", 1, "y"]}, [], by(here(2)))),
                    ),
                ],
                by(here()),
            ),
        ),
    ),
    "half a Gaussian without its end": Forgery(
        NOT_EQUAL,
        proved(
            ["=", integral(["*", 2, "x", ["exp", ["-", sq("x")]]], high=OO), 0],
            theorem(
                "half_gaussian",
                {"f": of("x", ["*", 2, "x", ["exp", ["-", sq("x")]]]), "g": of("x", -1), "a": 1, "c": 0},
                [above(1), every(["y"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "half a Gaussian that does not decay": Forgery(
        NO_SIGN,
        proved(
            ["=", integral(1, high=OO), 1],
            theorem(
                "half_gaussian",
                {"f": of("x", 1), "g": of("x", 0), "a": 0, "c": 1},
                [above(0), every(["y"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "a gamma function reflected from beyond 1": Forgery(
        NO_SIGN,
        proved(
            ["=", ["*", ["gamma", 2], ["gamma", -1], ["sin", ["*", PI, 2]]], PI],
            theorem("gamma_reflected", {"t": 2}, [above(2), above(-1)], by(here())),
        ),
    ),
    "a gamma function doubled below zero": Forgery(
        NO_SIGN,
        proved(
            ["=", ["*", ["gamma", -1], HALF_GAMMA, ["pow", 2, -2]], ["*", 2, ["sqrt", PI], ["gamma", -2]]],
            theorem("gamma_doubled", {"t": -1}, [above(-1)], by(here())),
        ),
    ),
    "Euler's first integral of a pole": Forgery(
        NO_SIGN,
        proved(
            ["=", ["*", integral(["pow", "x", -1]), ["gamma", 1]], 0],
            theorem(
                "unit_beta",
                {"f": of("x", ["pow", "x", -1]), "c": 1, "u": -1, "v": 0},
                [above(0), above(1), every(["y"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "a power times a logarithm that diverges": Forgery(
        NO_SIGN,
        proved(
            ["=", ["diverges", ["*", ["pow", "x", -1], ["log", "x"]], "x", 0, 1], 0],
            theorem(
                "log_head",
                {"f": of("x", ["*", ["pow", "x", -1], ["log", "x"]]), "c": 1, "u": -1, "s": 1},
                [above(1), above(0), every(["y"], implies(ID))],
                by(here(1)),
            ),
        ),
    ),
    "an inverted letter without its rate": Forgery(
        NOT_EQUAL,
        proved(
            ["=", integral(["^", "x", -2], low=1, high=OO), integral(sq("x"))],
            theorem(
                "inverted",
                {"f": of("x", ["^", "x", -2]), "g": of("x", sq("x")), "s": 1},
                [every(["y"], implies(have([">", ["+", 1, -1, ["/", 1, "y"]], 0], above(["/", 1, "y"]), ID)))],
                by(here()),
            ),
        ),
    ),
    "a pole of an inverted integrand": Forgery(
        MAY_BE_ZERO,
        proved(
            ["=", integral(["^", ["+", "x", -2], -2], low=1, high=OO), integral(["^", ["+", 1, ["*", -2, "x"]], -2])],
            theorem(
                "inverted",
                {"f": of("x", ["^", ["+", "x", -2], -2]), "g": of("x", ["^", ["+", 1, ["*", -2, "x"]], -2]), "s": 1},
                [every(["y"], implies(have([">", ["+", 1, -1, ["/", 1, "y"]], 0], above(["/", 1, "y"]), ID)))],
                by(here()),
            ),
        ),
    ),
    "a letter moved without its rate": Forgery(
        NOT_EQUAL,
        proved(
            ["=", integral(sq(["*", 2, "x"])), integral(sq("x"), high=2)],
            theorem(
                "moved",
                {"f": of("x", sq(["*", 2, "x"])), "g": of("x", sq("x")), "a": 2, "b": 0, "s": 0, "t": 1},
                [implies(absurd([], [here(), "1/2"])), every(["y"], ID)],
                by(here()),
            ),
        ),
    ),
    "a letter moved to one place": Forgery(
        NO_CONTRADICTION,
        proved(
            ["=", integral(["/", 1, "x"], low=0, high=0), 0],
            theorem(
                "moved",
                {"f": of("x", 1), "g": of("x", ["/", 1, "x"]), "a": 0, "b": 0, "s": 0, "t": 1},
                [implies(absurd([], [here(), "1"])), every(["y"], ID)],
                by(here()),
            ),
        ),
    ),
    "an integral across a pole that is said to have a value": Forgery(
        NO_CONTRADICTION,
        proved(
            ["=", ["diverges", ["^", "x", -2], "x", -1, 1], 0],
            theorem(
                "antiderivative_converges",
                {"f": of("x", ["^", "x", -2]), "g": of("x", ["-", ["^", "x", -1]]), "s": -1, "t": 1},
                [above(2), every(["x"], implies(implies(absurd([], [here(2), "1"])))), every(["x"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "a gamma function at zero": Forgery(
        NO_SIGN,
        proved(
            ["=", integral(["*", ["pow", "x", -1], ["exp", ["-", "x"]]], high=OO), ["gamma", 0]],
            theorem(
                "gamma_integral",
                {"f": of("x", ["*", ["pow", "x", -1], ["exp", ["-", "x"]]]), "c": 1, "u": -1, "a": 1},
                [above(1), above(0), every(["y"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "a gamma function without decay": Forgery(
        NO_SIGN,
        proved(
            ["=", integral(["pow", "x", 2], high=OO), ["gamma", 3]],
            theorem(
                "gamma_integral",
                {"f": of("x", ["pow", "x", 2]), "c": 1, "u": 2, "a": 0},
                [above(0), above(3), every(["y"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "a head of a power that diverges": Forgery(
        NO_SIGN,
        proved(
            ["=", ["diverges", ["*", ["pow", "x", -1], ["exp", "x"]], "x", 0, 1], 0],
            theorem(
                "head_converges",
                {"f": of("x", ["*", ["pow", "x", -1], ["exp", "x"]]), "g": of("x", ["exp", "x"]), "u": -1, "s": 1},
                [above(1), above(0), every(["y"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "a head beside what diverges": Forgery(
        "may have no integral",
        proved(
            ["=", ["diverges", ["pow", "x", -1], "x", 0, 1], 0],
            theorem(
                "head_converges",
                {"f": of("x", ["pow", "x", -1]), "g": of("x", ["pow", "x", -1]), "u": 0, "s": 1},
                [above(1), above(1), every(["y"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "a tail that grows": Forgery(
        NO_SIGN,
        proved(
            ["=", ["diverges", ["exp", "x"], "x", 1, OO], 0],
            theorem(
                "tail_converges",
                {"f": of("x", ["exp", "x"]), "c": 1, "u": 0, "a": -1, "s": 1},
                [above(-1), above(1), every(["y"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "a tail from zero": Forgery(
        NO_SIGN,
        proved(
            ["=", ["diverges", ["*", ["pow", "x", -1], ["exp", ["-", "x"]]], "x", 0, OO], 0],
            theorem(
                "tail_converges",
                {"f": of("x", ["*", ["pow", "x", -1], ["exp", ["-", "x"]]]), "c": 1, "u": -1, "a": 1, "s": 0},
                [above(1), above(0), every(["y"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "the tail of one over x": Forgery(
        NO_SIGN,
        proved(
            ["=", integral(["pow", "x", -1], low=1, high=OO), 0],
            theorem(
                "power_tail",
                {"f": of("x", ["pow", "x", -1]), "c": 1, "u": -1, "s": 1},
                [above(1), above(0), every(["y"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "a tail of a power from zero": Forgery(
        NO_SIGN,
        proved(
            ["=", integral(["pow", "x", -2], high=OO), 0],
            theorem(
                "power_tail",
                {"f": of("x", ["pow", "x", -2]), "c": 1, "u": -2, "s": 0},
                [above(0), above(1), every(["y"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "one over x from zero": Forgery(
        NO_SIGN,
        proved(
            ["=", integral(["pow", "x", -1]), 0],
            theorem(
                "power_head",
                {"f": of("x", ["pow", "x", -1]), "c": 1, "u": -1, "s": 1},
                [above(1), above(0), every(["y"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "a power from zero to before it": Forgery(
        NO_SIGN,
        proved(
            ["=", integral("x", high=-1), 1],
            theorem(
                "power_head",
                {"f": of("x", "x"), "c": 1, "u": 1, "s": -1},
                [above(-1), above(2), every(["y"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "a sum of integrals that have no values": Forgery(
        NOT_EQUAL,
        proved(
            ["=", integral(0, high=OO), ["+", integral("x", high=OO), integral(["-", "x"], high=OO)]],
            theorem(
                "sum_of_integrals",
                {"f": of("x", 0), "g": of("x", "x"), "h": of("x", ["-", "x"]), "s": 0},
                [ID, ID, every(["y"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "a sum of other integrals": Forgery(
        NOT_EQUAL,
        proved(
            ["=", integral(1, high=OO), 0],
            theorem(
                "sum_of_integrals",
                {"f": of("x", 1), "g": of("x", 0), "h": of("x", 0), "s": 0},
                [ID, ID, every(["y"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "what is not reflected": Forgery(
        NOT_EQUAL,
        proved(
            ["=", integral(["exp", "x"], low=NOO, high=0), integral(["exp", "x"], high=OO)],
            theorem(
                "reflected",
                {"f": of("x", ["exp", "x"]), "g": of("x", ["exp", "x"]), "s": 0},
                [every(["y"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "what is not scaled": Forgery(
        NOT_EQUAL,
        proved(
            ["=", integral(["exp", ["-", ["*", 2, "x"]]], high=OO), integral(["exp", ["-", "x"]], high=OO)],
            theorem(
                "scaled",
                {
                    "f": of("x", ["exp", ["-", ["*", 2, "x"]]]),
                    "g": of("x", ["exp", ["-", "x"]]),
                    "a": 1,
                    "c": 1,
                    "s": 0,
                },
                [above(1), every(["y"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "pieces of what has no integral": Forgery(
        "may have no integral",
        proved(
            [
                "=",
                integral(["/", 1, "x"], low=-1, high=1),
                ["+", integral(["/", 1, "x"], low=-1), integral(["/", 1, "x"])],
            ],
            theorem("pieces", {"f": of("x", ["/", 1, "x"]), "r": 0, "s": -1, "t": 1}, [], by(here())),
        ),
    ),
    "halves without values": Forgery(
        NOT_EQUAL,
        proved(
            ["=", integral("x", low=NOO, high=OO), ["+", integral("x", low=NOO, high=0), integral("x", high=OO)]],
            theorem("halves", {"f": of("x", "x"), "s": 0}, [ID, ID], by(here())),
        ),
    ),
    "a sum of other sums": Forgery(
        NOT_EQUAL,
        proved(
            ["=", ["sum", "k", "k", 1, 3], ["sum", sq("k"), "k", 1, 3]],
            theorem(
                "sum_of_sums",
                {"f": of("k", "k"), "g": of("k", sq("k")), "h": of("k", 0), "a": 1, "b": 0, "s": 1, "t": 3},
                [every(["y"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "a pole between other ends than those of the theorem": Forgery(
        "a denominator may be zero",
        proved(
            ["=", minus(integral(["^", "x", -2], low=-1, high=OO), integral(["^", "x", -2], low=-1, high=OO)), 0],
            theorem(
                "power_tail",
                {"f": of("x", ["^", "x", -2]), "c": 1, "u": -2, "s": 1},
                [above(1), above(1), every(["y"], implies(ID))],
                ID,
            ),
        ),
    ),
    "a sum that grows by another number": Forgery(
        NOT_EQUAL,
        proved(
            ["=", ["sum", "k", "k", 1, 3], 9],
            theorem(
                "telescope",
                {"f": of("k", "k"), "g": of("k", sq("k")), "s": 1, "t": 3},
                [above(3), ID, every(["x"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "a sum of other sums with a divisor that is zero at the first addend": Forgery(
        MAY_BE_ZERO,
        proved(
            ["=", ["sum", ["/", "a", "k"], "k", 0, 3], ["*", "a", ["sum", ["/", 1, "k"], "k", 0, 3]]],
            theorem(
                "sum_of_sums",
                {
                    "f": of("k", ["/", "a", "k"]),
                    "g": of("k", ["/", 1, "k"]),
                    "h": of("k", 0),
                    "a": "a",
                    "b": 0,
                    "s": 0,
                    "t": 3,
                },
                [every(["y"], implies(ID))],
                by(here()),
            ),
            at={"a": 1},
        ),
    ),
    "a product that grows by another factor": Forgery(
        NOT_EQUAL,
        proved(
            ["=", ["product", "k", "k", 1, 3], 9],
            theorem(
                "telescoping_product",
                {"f": of("k", "k"), "g": of("k", sq("k")), "s": 2, "t": 3},
                [above(2), ID, every(["x"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "a product that begins with another number": Forgery(
        NOT_EQUAL,
        proved(
            ["=", ["product", 2, "k", 1, 3], 0],
            theorem(
                "telescoping_product",
                {"f": of("k", 2), "g": of("k", 0), "s": 1, "t": 3},
                [above(3), ID, every(["x"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "an empty sum of addends that change their rule": Forgery(
        NOT_EQUAL,
        proved(
            ["=", ["sum", DISTANCE, "k", 1, 0], 1],
            theorem(
                "telescope",
                {
                    "f": of("k", DISTANCE),
                    "g": of("k", ["+", ["/", sq("k"), 2], ["-", "k"], 1]),  # from 2 on it grows by k - 3/2
                    "s": 1,
                    "t": 0,
                },
                [above(0), ID, every(["x"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "a sum whose addends change their rule at its beginning": Forgery(
        NO_SIGN,
        proved(
            ["=", ["sum", DISTANCE, "k", 1, 0], 1],
            theorem(
                "telescope",
                {"f": of("k", DISTANCE), "g": of("k", ["+", ["/", sq("k"), 2], ["-", "k"]]), "s": 1, "t": 0},
                [
                    above(0),
                    ID,
                    every(
                        ["x"],
                        implies(
                            theorem(
                                "root",
                                {"t": AHEAD},
                                [above(AHEAD)],
                                theorem(
                                    "equal_squares",
                                    {"s": ["sqrt", AHEAD], "t": minus("x", ["/", 1, 2])},
                                    [above(["sqrt", AHEAD]), above(["+", minus("x", 1), ["/", 1, 2]]), by(here(2))],
                                    {**ID, "cofactors": [[here(3), "-1"]]},
                                ),
                            )
                        ),
                    ),
                ],
                by(here()),
            ),
        ),
    ),
    "half a one": Forgery(
        "a sum between ends that may not be whole",
        proved(
            ["=", ["sum", 1, "k", 1, ["/", 1, 2]], ["/", 1, 2]], counted(["/", 1, 2], above(["/", 1, 2]), by(here()))
        ),
    ),
    "as many ones as a hypothesis does not let there be": Forgery(
        "a sum between ends that may not be whole",
        proved(
            ["=", ONES, ["/", 1, 2]],
            counted("n", above(["/", 1, 2], [hyp(), "1/2"]), {**ID, "cofactors": [[here(), "1"], [hyp(), "1/2"]]}),
            [["=", ["*", 2, "n"], 1]],
            at={"n": ["/", 1, 2]},
        ),
    ),
    "a hypothesis that holds of no whole number of ones": Forgery(
        "a sum between ends that may not be whole",
        proved(
            ["=", "n", ["/", 1, 2]],
            counted("n", above("n"), {**ID, "cofactors": [[here(), "-1"], [hyp(), "1"]]}),
            [["=", ONES, ["/", 1, 2]], [">=", "n", 0]],
            witnesses=[
                {
                    "values": {"n": ["/", 1, 2]},
                    "proof": counted(
                        ["/", 1, 2], above(["/", 1, 2]), each({**ID, "cofactors": [[here(), "1"]]}, compute())
                    ),
                }
            ],
        ),
    ),
    "a sum to all numbers": Forgery(
        "a sum between ends that may not be whole",
        proved(
            ["forall", ["n"], ["=>", [">=", "n", 0], ["=", ONES, "n"]]],
            every(["m"], implies(counted("m", above("m"), by(here(1))))),
        ),
    ),
    "the rate of a sum by its end": Forgery(
        "a sum between ends that may not be whole",
        proved(["=", ["integral", ONES, "n", 0, 1], ["integral", ONES, "n", 0, 1]], ID),
    ),
    "a lemma about a sum to a half": Forgery(
        "a sum between ends that may not be whole",
        proved(["=", "n", "n"], implies(ID), lemmas=[["l", ["=", ["sum", 1, "k", 1, ["/", 1, 2]], ["/", 1, 2]]]]),
    ),
    "a power of zero times zero in a sum": Forgery(
        MAY_BE_ZERO, proved(["=", ["sum", ["*", ["pow", "k", -1], "k"], "k", 0, 3], ["sum", 1, "k", 0, 3]], ID)
    ),
    "a power of zero times zero in a product": Forgery(
        MAY_BE_ZERO, proved(["=", ["product", ["*", ["pow", "k", -1], "k"], "k", 0, 3], ["product", 1, "k", 0, 3]], ID)
    ),
    "a power of zero times zero all along an integral": Forgery(
        MAY_BE_ZERO, proved(["=", integral(["*", ["pow", NO_BASE, -1], NO_BASE]), 1], constant(1, by(here())))
    ),
    "a power of zero times zero in an integral that has a value": Forgery(
        MAY_BE_ZERO,
        proved(
            ["=", integral(["*", ["pow", NO_BASE, -1], NO_BASE]), 1],
            have(["=", integral(1), 1], constant(1, by(here())), compute(here())),
        ),
    ),
    "a sum with a term that has a period": Forgery(
        "may have a period",
        proved(
            ["=", ["sin", ["*", 2, PI, "t"]], 0],
            theorem(
                "telescope",
                {"f": of("k", 0), "g": of("k", ["sin", ["*", 2, PI, "k"]]), "s": 0, "t": "t"},
                [above("t"), ID, every(["x"], implies(ID))],
                by(here()),
            ),
            [[">=", "t", 0]],
            at={"t": 0},
        ),
    ),
    "a product with a factor that has a period": Forgery(
        "may have a period",
        proved(
            ["=", ["cos", ["*", 2, PI, "t"]], 1],
            theorem(
                "telescoping_product",
                {"f": of("k", 1), "g": of("k", ["cos", ["*", 2, PI, "k"]]), "s": 1, "t": "t"},
                [above("t"), ID, every(["x"], implies(ID))],
                by(here()),
            ),
            [[">=", "t", 0]],
            at={"t": 0},
        ),
    ),
    "an antiderivative across a pole": Forgery(
        NO_CONTRADICTION,
        proved(
            ["=", integral(["^", "x", -2], low=-1), -2],
            theorem(
                "antiderivative",
                {"f": of("x", ["^", "x", -2]), "g": of("x", ["-", ["^", "x", -1]]), "s": -1, "t": 1},
                [above(2), every(["x"], implies(implies(absurd([], [here(2), "1"])))), every(["x"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "the divisor of an integral cleared between the ends of another": Forgery(
        MAY_BE_ZERO,
        proved(
            ["=", integral(["/", 1, "x"], low=-1, high=1), integral(["/", 1, "x"], low=-1, high=1)],
            theorem(
                "antiderivative",
                {"f": of("x", ["/", 1, "x"]), "g": of("x", ["log", "x"]), "s": 1, "t": 2},
                [
                    above(1),
                    every(["y"], implies(above(["+", minus("y", 1), 1]))),
                    every(["y"], implies({"rule": "identity", "times": ["y"]})),
                ],
                ID,
            ),
        ),
    ),
    "a divisor cleared by the contrary of the goal": Forgery(
        MAY_BE_ZERO,
        proved(["=", ["*", "x", ["/", 0, "x"]], 0], implies(absurd([here()])), at={"x": 0}),
    ),
    "an antiderivative of another function": Forgery(
        NOT_EQUAL,
        proved(
            ["=", integral("x"), 1],
            theorem(
                "antiderivative",
                {"f": of("x", "x"), "g": of("x", sq("x")), "s": 0, "t": 1},
                [above(1), every(["x"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "an antiderivative from the larger end to the smaller one": Forgery(
        NOT_THE_FORM,
        proved(
            ["=", integral(1, low=1, high=0), -1],
            theorem(
                "antiderivative",
                {"f": of("x", 1), "g": of("x", "x"), "s": 1, "t": 0},
                [above(1), every(["x"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "an antiderivative that is a root below zero": Forgery(
        NO_SIGN,
        proved(
            ["=", integral(["/", 1, ["*", 2, ["sqrt", "x"]]], low=-1, high=0), ["-", ["sqrt", -1]]],
            theorem(
                "antiderivative_everywhere",
                {"f": of("x", ["/", 1, ["*", 2, ["sqrt", "x"]]]), "g": of("x", ["sqrt", "x"]), "s": -1, "t": 0},
                [every(["x"], above("x")), every(["x"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "an antiderivative everywhere across a pole": Forgery(
        NO_CONTRADICTION,
        proved(
            ["=", integral(["^", "x", -2], low=-1), -2],
            theorem(
                "antiderivative_everywhere",
                {"f": of("x", ["^", "x", -2]), "g": of("x", ["-", ["^", "x", -1]]), "s": -1, "t": 1},
                [every(["x"], implies(absurd([], [here(), "1"]))), every(["x"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "an antiderivative with a binder in it": Forgery(
        "may not be smooth",
        proved(
            ["=", integral(0), 1],
            theorem(
                "antiderivative",
                {"f": of("x", 0), "g": of("x", integral("y", "y", 0, "x")), "s": 0, "t": 1},
                [above(1), every(["x"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "dichotomy with a side left out": Forgery(
        "1 proofs for 2", proved([">", "x", 0], theorem("dichotomy", {"t": "x"}, [], cases(here(), above("x"))))
    ),
    "dichotomy with the wrong side": Forgery(
        NO_SIGN, proved([">", "x", 0], theorem("dichotomy", {"t": "x"}, [], cases(here(), above("x"), above("x"))))
    ),
    "the root of minus one": Forgery(
        NO_SIGN, proved(["=", sq(["sqrt", "x"]), "x"], theorem("root", {"t": "x"}, [above("x")], by(here(1))))
    ),
    "the root of a number below zero": Forgery(
        NOT_THE_FORM, proved(["=", sq(["sqrt", -4]), -4], theorem("root", {"t": -4}, [above(0)], by(here(1))))
    ),
    "the root of a product of negative factors": Forgery(
        NO_SIGN,
        proved(
            ["=", ["sqrt", ["*", "x", "y"]], ["*", ["sqrt", "x"], ["sqrt", "y"]]],
            theorem("root_of_product", {"s": "x", "t": "y"}, [above("x"), above("y")], by(here())),
            [[">", ["*", "x", "y"], 0]],
            at=SIDE,
        ),
    ),
    "the root of a product with one negative factor": Forgery(
        NO_SIGN,
        proved(
            ["=", ["sqrt", ["*", "x", "y"]], ["*", ["sqrt", "x"], ["sqrt", "y"]]],
            theorem("root_of_product", {"s": "x", "t": "y"}, [above("x"), above("y")], by(here())),
            [[">=", "x", 0]],
            at=SIDE,
        ),
    ),
    "equal squares of two signs": Forgery(
        NOT_THE_FORM,
        proved(["=", 1, -1], theorem("equal_squares", {"s": 1, "t": -1}, [above(1), above(1), ID], by(here()))),
    ),
    "squares that are not equal": Forgery(
        NOT_EQUAL, proved(["=", 1, 2], theorem("equal_squares", {"s": 1, "t": 2}, [above(1), above(2), ID], by(here())))
    ),
    "equal squares with premises left out": Forgery(
        "1 proofs for 3", proved(["=", 1, -1], theorem("equal_squares", {"s": 1, "t": -1}, [ID], by(here())))
    ),
    "a power of zero is positive": Forgery(
        NO_SIGN, proved([">", ["pow", 0, 1], 0], theorem("power", {"b": 0, "u": 1}, [above(0)], above(["pow", 0, 1])))
    ),
    "a power of a negative base is positive": Forgery(
        NOT_THE_FORM,
        proved([">", ["pow", -1, 1], 0], theorem("power", {"b": -1, "u": 1}, [above(1)], above(["pow", -1, 1]))),
    ),
    "a power of a letter is positive": Forgery(
        NO_SIGN,
        proved(
            [">", ["pow", "x", "y"], 0], theorem("power", {"b": "x", "u": "y"}, [above("x")], above(["pow", "x", "y"]))
        ),
    ),
    "a power of a sum of a negative base": Forgery(
        NO_SIGN,
        proved(
            ["=", 1, ["*", ["pow", "x", ["/", 1, 2]], ["pow", "x", ["/", -1, 2]]]],
            theorem("power_of_sum", {"b": "x", "s": ["/", 1, 2], "t": ["/", -1, 2]}, [above("x")], by(here())),
        ),
    ),
    "a power of a product of negative bases": Forgery(
        NO_SIGN,
        proved(
            ["=", ["pow", ["*", "x", "y"], "u"], ["*", ["pow", "x", "u"], ["pow", "y", "u"]]],
            theorem("power_of_product", {"s": "x", "t": "y", "u": "u"}, [above("x"), above("y")], by(here())),
        ),
    ),
    "a power of a power of a negative base": Forgery(
        NO_SIGN,
        proved(
            ["=", ["pow", sq("x"), ["/", 1, 2]], "x"],
            theorem("power_of_power", {"b": "x", "n": 2, "u": ["/", 1, 2]}, [above("x")], by(here())),
        ),
    ),
    "a power of a power that is no whole number": Forgery(
        "('/', 1, 2) for the parameter n of power_of_power",
        proved(
            ["=", ["pow", "x", 1], 1],
            theorem("power_of_power", {"b": "x", "n": ["/", 1, 2], "u": 2}, [above("x")], by(here())),
            [[">", "x", 0]],
            at={"x": 1},
        ),
    ),
    "a power of a power that is a letter": Forgery(
        "'y' for the parameter n of power_of_power",
        proved(
            ["=", ["pow", "x", 1], 1],
            theorem("power_of_power", {"b": "x", "n": "y", "u": 2}, [above("x")], by(here())),
            [[">", "x", 0]],
            at={"x": 1},
        ),
    ),
    "a power of a power that is a truth value": Forgery(
        "True is no letter",
        proved(
            ["=", ["pow", "x", 1], 1],
            theorem("power_of_power", {"b": "x", "n": True, "u": 2}, [above("x")], by(here())),
            [[">", "x", 0]],
            at={"x": 1},
        ),
    ),
    "the inverse of power zero": Forgery(
        NO_CONTRADICTION,
        proved(
            ["=", 2, 3],
            theorem(
                "power_inverse",
                {"b": 2, "u": 0, "t": 1},
                [above(2), implies(absurd([], [here(), "1"])), ID],
                by(here()),
            ),
        ),
    ),
    "the inverse of a power of a negative base": Forgery(
        NOT_THE_FORM,
        proved(
            ["=", -2, 2],
            theorem(
                "power_inverse",
                {"b": -2, "u": 2, "t": 4},
                [above(2), implies(absurd([], [here(), "1/2"])), ID],
                by(here()),
            ),
        ),
    ),
    "the inverse of another power": Forgery(
        NOT_EQUAL,
        proved(
            ["=", 2, ["pow", 5, ["/", 1, 2]]],
            theorem(
                "power_inverse",
                {"b": 2, "u": 2, "t": 5},
                [above(2), implies(absurd([], [here(), "1/2"])), ID],
                by(here()),
            ),
        ),
    ),
    "the gamma function at a pole": Forgery(
        NO_SIGN, proved(["=", ["gamma", 1], 0], theorem("gamma", {"t": 0}, [above(0)], by(here(1))))
    ),
    "the gamma function of a negative number": Forgery(
        NOT_THE_FORM,
        proved(
            [">", ["gamma", ["/", -1, 2]], 0],
            theorem("gamma", {"t": ["/", -1, 2]}, [above(["/", 1, 2])], above(["gamma", ["/", -1, 2]])),
        ),
    ),
    "another value of the gamma function": Forgery(
        NOT_EQUAL, proved(["=", ["gamma", 1], PI], theorem("gamma_values", {}, [], by(here(1))))
    ),
    "a negative value of the gamma function": Forgery(
        NOT_THE_FORM,
        proved(["<", ["gamma", ["/", 1, 2]], 0], theorem("gamma_values", {}, [], above(["gamma", ["/", 1, 2]]))),
    ),
    "pi below zero": Forgery(NOT_THE_FORM, proved(["<", PI, 0], theorem("circle_number", {}, [], above(PI)))),
    "pi above four": Forgery(NOT_THE_FORM, proved([">", PI, 4], theorem("circle_number", {}, [], above(PI)))),
    "the right half of a whole turn": Forgery(
        NOT_THE_FORM,
        proved(
            [">=", ["cos", PI], 0],
            theorem(
                "circle_number",
                {},
                [],
                theorem("right_half", {"a": PI}, [above(["*", ["/", 3, 2], PI]), above(HALF_PI)], above(["cos", PI])),
            ),
        ),
    ),
    "the right half of any angle": Forgery(
        NO_SIGN,
        proved(
            [">=", COS, 0],
            theorem("right_half", {"a": "x"}, [above(["+", "x", HALF_PI]), above(minus(HALF_PI, "x"))], above(COS)),
        ),
    ),
    "a positive cosine of a whole turn's half": Forgery(
        NOT_THE_FORM,
        proved(
            [">", ["cos", PI], 0],
            theorem("positive_cosine", {"a": PI}, [above(["*", ["/", 3, 2], PI]), above(HALF_PI)], above(["cos", PI])),
        ),
    ),
    "a positive cosine at a right angle": Forgery(
        NO_SIGN,
        proved(
            [">", ["cos", HALF_PI], 0],
            theorem("positive_cosine", {"a": HALF_PI}, [above(PI), above(0)], above(["cos", HALF_PI])),
        ),
    ),
    "a positive sine of nothing": Forgery(
        NO_SIGN,
        proved([">", ["sin", 0], 0], theorem("positive_sine", {"a": 0}, [above(0), above(PI)], above(["sin", 0]))),
    ),
    "a positive sine of any angle": Forgery(
        NO_SIGN,
        proved(
            [">", ["sin", "x"], 0],
            theorem("positive_sine", {"a": "x"}, [above("x"), above(minus(PI, "x"))], above(["sin", "x"])),
        ),
    ),
    "an arctangent of a quarter of a turn": Forgery(
        "('here', 1) is no such fact",
        proved(["=", ["arctan", "x"], HALF_PI], theorem("principal_value_arctan", {"t": "x"}, [], by(here(1)))),
    ),
    "an arcsine beyond one": Forgery(
        NOT_THE_FORM,
        proved(
            ["<=", ["arcsin", 2], HALF_PI],
            theorem("principal_value_arcsin", {"t": 2}, [above(3)], above(minus(HALF_PI, ["arcsin", 2]))),
        ),
    ),
    "an arccosine beyond one": Forgery(
        NOT_THE_FORM,
        proved(
            ["<=", ["arccos", 2], PI],
            theorem("principal_value_arccos", {"t": 2}, [above(3)], above(minus(PI, ["arccos", 2]))),
        ),
    ),
    "a first quadrant of a negative arctangent": Forgery(
        NOT_THE_FORM,
        proved(
            ["<=", 0, ["arctan", -1]], theorem("first_quadrant_arctan", {"t": -1}, [above(1)], above(["arctan", -1]))
        ),
    ),
    "a first quadrant of a negative arcsine": Forgery(
        NOT_THE_FORM,
        proved(
            ["<=", 0, ["arcsin", -1]],
            theorem("first_quadrant_arcsin", {"t": -1}, [above(0), above(1)], above(["arcsin", -1])),
        ),
    ),
    "a first quadrant of an arcsine beyond one": Forgery(
        NOT_THE_FORM,
        proved(
            ["<=", 0, ["arcsin", 2]],
            theorem("first_quadrant_arcsin", {"t": 2}, [above(3), above(2)], above(["arcsin", 2])),
        ),
    ),
    "a first quadrant of a negative arccosine": Forgery(
        NOT_THE_FORM,
        proved(
            ["<=", ["arccos", -1], HALF_PI],
            theorem("first_quadrant_arccos", {"t": -1}, [above(0), above(1)], above(minus(HALF_PI, ["arccos", -1]))),
        ),
    ),
    "a first quadrant of an arccosine beyond one": Forgery(
        NOT_THE_FORM,
        proved(
            ["<=", ["arccos", 2], HALF_PI],
            theorem("first_quadrant_arccos", {"t": 2}, [above(3), above(2)], above(minus(HALF_PI, ["arccos", 2]))),
        ),
    ),
    **{
        f"another value of {name}": Forgery(
            NOT_EQUAL, proved(["=", claim, ["/", PI, wrong]], theorem(name, {}, [], by(here())))
        )
        for name, claim, wrong in (
            ("known_angle_arctan_0", ["arctan", 0], 2),
            ("known_angle_arctan_1", ["arctan", ["/", 1, ["sqrt", 3]]], 3),
            ("known_angle_arctan_2", ["arctan", 1], 3),
            ("known_angle_arctan_3", ["arctan", ["sqrt", 3]], 6),
            ("known_angle_arcsin_0", ["arcsin", 0], 1),
            ("known_angle_arcsin_1", ["arcsin", ["/", 1, 2]], 3),
            ("known_angle_arcsin_2", ["arcsin", ["/", ["sqrt", 2], 2]], 3),
            ("known_angle_arcsin_3", ["arcsin", ["/", ["sqrt", 3], 2]], 6),
            ("known_angle_arcsin_4", ["arcsin", 1], 1),
            ("known_angle_arccos_0", ["arccos", 1], 2),
            ("known_angle_arccos_1", ["arccos", ["/", ["sqrt", 3], 2]], 3),
            ("known_angle_arccos_2", ["arccos", ["/", ["sqrt", 2], 2]], 3),
            ("known_angle_arccos_3", ["arccos", ["/", 1, 2]], 6),
            ("known_angle_arccos_4", ["arccos", 0], 1),
        )
    },
    # mean
    "a mean that depends on its own letter": Forgery(
        NOT_EQUAL,
        proved(
            ["=", ["mean", SIN, "x"], SIN],
            theorem("mean", {"f": of("x", SIN), "c": SIN, "g": of("x", 0)}, [every(["y"], ID)], by(here())),
        ),
    ),
    "a mean of the letter x by a letter of the same name": Forgery(
        NOT_EQUAL,
        proved(
            ["=", ["mean", "x", "x"], "x"],
            theorem("mean", {"f": of("x", "x"), "c": "x", "g": of("x", 0)}, [every(["y"], ID)], by(here())),
        ),
    ),
    "a primitive that is not periodic": Forgery(
        "'x' is no polynomial in sin and cos x",
        proved(
            ["=", ["mean", 1, "x"], 0],
            theorem("mean", {"f": of("x", 1), "c": 0, "g": of("x", "x")}, [every(["y"], ID)], by(here())),
        ),
    ),
    "a primitive with a bottom that turns": Forgery(
        "('/', ('sin', 'x'), ('cos', 'x')) is no polynomial in sin and cos x",
        proved(
            ["=", ["mean", ["^", COS, -2], "x"], 0],
            theorem(
                "mean",
                {"f": of("x", ["^", COS, -2]), "c": 0, "g": of("x", ["/", SIN, COS])},
                [every(["y"], ID)],
                by(here()),
            ),
        ),
    ),
    "a primitive with a negative power": Forgery(
        "('^', ('cos', 'x'), -1) is no polynomial in sin and cos x",
        proved(
            ["=", ["mean", ["^", COS, -2], "x"], 0],
            theorem(
                "mean",
                {"f": of("x", ["^", COS, -2]), "c": 0, "g": of("x", ["^", COS, -1])},
                [every(["y"], ID)],
                by(here()),
            ),
        ),
    ),
    "a primitive that is a tangent": Forgery(
        "('tan', 'x') is no polynomial in sin and cos x",
        proved(
            ["=", ["mean", ["^", COS, -2], "x"], 0],
            theorem(
                "mean",
                {"f": of("x", ["^", COS, -2]), "c": 0, "g": of("x", ["tan", "x"])},
                [every(["y"], ID)],
                by(here()),
            ),
        ),
    ),
    "a primitive of half the angle": Forgery(
        "('*', 2, ('sin', ('/', 'x', 2))) is no polynomial in sin and cos x",
        proved(
            ["=", ["mean", ["cos", ["/", "x", 2]], "x"], 0],
            theorem(
                "mean",
                {"f": of("x", ["cos", ["/", "x", 2]]), "c": 0, "g": of("x", ["*", 2, ["sin", ["/", "x", 2]]])},
                [every(["y"], ID)],
                by(here()),
            ),
        ),
    ),
    "a primitive that is an arctangent of a tangent": Forgery(
        "('arctan', ('tan', 'x')) is no polynomial in sin and cos x",
        proved(
            ["=", ["mean", 1, "x"], 0],
            theorem(
                "mean",
                {"f": of("x", 1), "c": 0, "g": of("x", ["arctan", ["tan", "x"]])},
                [every(["y"], ID)],
                by(here()),
            ),
        ),
    ),
    "a primitive that is an unknown function": Forgery(
        "('call', 'f', (0,), 'x') is no polynomial in sin and cos x",
        proved(
            ["=", ["mean", f("x", orders=[1]), "x"], 0],
            theorem(
                "mean", {"f": of("x", f("x", orders=[1])), "c": 0, "g": of("x", f("x"))}, [every(["y"], ID)], by(here())
            ),
        ),
    ),
    "a primitive of something else": Forgery(
        NOT_EQUAL,
        proved(
            ["=", ["mean", sq(SIN), "x"], 0],
            theorem(
                "mean", {"f": of("x", sq(SIN)), "c": 0, "g": of("x", ["*", SIN, COS])}, [every(["y"], ID)], by(here())
            ),
        ),
    ),
    "a mean whose letter is the claim's": Forgery(
        "the letter y is taken",
        proved(
            ["=", ["mean", "x", "x"], "y"],
            theorem("mean", {"f": of("x", "x"), "c": "y", "g": of("x", 0)}, [every(["y"], ID)], by(here())),
        ),
    ),
    "a mean by an assumption about the letter": Forgery(
        "the letter x is taken",
        proved(
            ["=", ["mean", ["*", "x", SIN], "x"], 0],
            theorem(
                "mean",
                {"f": of("x", ["*", "x", SIN]), "c": 0, "g": of("x", 0)},
                [every(["x"], by(hyp(), factor="s"))],
                by(here()),
            ),
            [["=", "x", 0]],
            at={"x": 0},
        ),
    ),
    "a mean of the letter sin_x": Forgery(
        NOT_EQUAL,
        proved(
            ["=", ["mean", SIN, "x"], "sin_x"],
            theorem("mean", {"f": of("x", SIN), "c": "sin_x", "g": of("x", 0)}, [every(["y"], ID)], by(here())),
        ),
    ),
    "a mean over a number": Forgery(
        "0 is no letter",
        proved(
            ["=", ["mean", 1, "x"], 0],
            theorem("mean", {"f": of("x", 1), "c": 0, "g": {"letter": 0, "term": 0}}, [ID], by(here())),
        ),
    ),
    "a mean with a term for a function": Forgery(
        "1 for the parameter f of mean",
        proved(["=", ["mean", 1, "x"], 0], theorem("mean", {"f": 1, "c": 0, "g": of("x", 0)}, [ID], by(here()))),
    ),
    "a mean with a function for a term": Forgery(
        "(('x',), 0) for the parameter c of mean",
        proved(
            ["=", ["mean", 1, "x"], 0],
            theorem("mean", {"f": of("x", 1), "c": of("x", 0), "g": of("x", 0)}, [ID], by(here())),
        ),
    ),
    "a function with a key too many": Forgery(
        "a step of a proof has the superfluous ['at']",
        proved(
            ["=", ["mean", 1, "x"], 0],
            theorem("mean", {"f": {**of("x", 1), "at": 0}, "c": 0, "g": of("x", 0)}, [ID], by(here())),
        ),
    ),
    "a mean of infinity": Forgery(
        "['infinity'] is no term",
        proved(
            ["=", ["mean", 1, "x"], 0], theorem("mean", {"f": of("x", 1), "c": OO, "g": of("x", 0)}, [ID], by(here()))
        ),
    ),
    "a mean for one value of the letter": Forgery(
        "no existence",
        proved(
            ["=", ["mean", "x", "x"], 0],
            theorem("mean", {"f": of("x", "x"), "c": 0, "g": of("x", 0)}, [witness({"x": 0}, ID)], by(here())),
        ),
    ),
    "a mean by a definition of the phase": Forgery(
        "the letter x is taken",
        proved(
            ["=", ["mean", SIN, "x"], "d"],
            theorem("mean", {"f": of("x", SIN), "c": "d", "g": of("x", 0)}, [every(["x"], ID)], by(here())),
            definitions=[["d", SIN]],
        ),
    ),
    # quarter_turn
    "a zero of what does not turn": Forgery(
        NOT_EQUAL,
        proved(
            ["exists", ["x"], ["=", 1, 0]],
            theorem(
                "quarter_turn", {"f": of("x", 1)}, [every(["y"], ID)], witness({"x": "z"}, by(here())), letters=["z"]
            ),
        ),
    ),
    "a zero of a sine over a cosine": Forgery(
        "('/', 1, ('cos', 'x')) is no polynomial in sin and cos x",
        proved(
            ["exists", ["x"], ["=", ["/", 1, COS], 0]],
            theorem(
                "quarter_turn",
                {"f": of("x", ["/", 1, COS])},
                [every(["y"], ID)],
                witness({"x": "z"}, by(here())),
                letters=["z"],
            ),
        ),
    ),
    "a zero of what turns half": Forgery(
        NOT_EQUAL,
        proved(
            ["exists", ["x"], ["=", SIN, 2]],
            theorem(
                "quarter_turn", {"f": of("x", SIN)}, [every(["y"], ID)], witness({"x": "z"}, by(here())), letters=["z"]
            ),
        ),
    ),
    "a zero of a function of the quarter": Forgery(
        "('call', 'f', (0,), 'x') is no polynomial in sin and cos x",
        proved(
            ["exists", ["x"], ["=", f("x"), 0]],
            theorem(
                "quarter_turn",
                {"f": of("x", f("x"))},
                [every(["y"], by(hyp()))],
                witness({"x": "z"}, by(here())),
                letters=["z"],
            ),
            [["=", f("x"), 0]],
        ),
    ),
    "a zero that is an angle of the claim": Forgery(
        "('cos', ('*', 2, 'y')) is no polynomial in sin and cos y",
        proved(
            ["=", ["cos", ["*", 2, "x"]], 0],
            theorem(
                "quarter_turn", {"f": of("y", ["cos", ["*", 2, "y"]])}, [every(["z"], ID)], by(here()), letters=["x"]
            ),
        ),
    ),
    "a zero that is an angle of a wave": Forgery(
        "the letter x is taken",
        proved(
            ["=", minus(sq(COS), sq(SIN)), 0],
            theorem(
                "quarter_turn",
                {"f": of("y", minus(sq(["cos", "y"]), sq(["sin", "y"])))},
                [every(["z"], ID)],
                by(here()),
                letters=["x"],
            ),
        ),
    ),
    "a zero that a hypothesis speaks of": Forgery(
        "the letter x is taken",
        proved(
            ["exists", ["x"], ["and", ["=", "x", 1], ["=", minus(sq(COS), sq(SIN)), 0]]],
            theorem(
                "quarter_turn",
                {"f": of("y", minus(sq(["cos", "y"]), sq(["sin", "y"])))},
                [every(["z"], ID)],
                witness({"x": "x"}, each(by(hyp()), by(here()))),
                letters=["x"],
            ),
            [["=", "x", 1]],
            at={"x": 1},
        ),
    ),
    "a zero that is a coefficient of what vanishes": Forgery(
        "the letter z is taken",
        proved(
            ["=", 0, 1],
            theorem(
                "quarter_turn",
                {"f": of("y", ["*", "z", minus(sq(["cos", "y"]), sq(["sin", "y"]))])},
                [every(["w"], ID)],
                by(here()),
                letters=["z"],
            ),
        ),
    ),
    "a zero that is called by a number": Forgery(
        "0 is no text",
        proved(
            ["=", 0, 1],
            theorem(
                "quarter_turn",
                {"f": of("y", minus(sq(["cos", "y"]), sq(["sin", "y"])))},
                [every(["w"], ID)],
                by(here()),
                letters=[0],
            ),
        ),
    ),
    "a zero without a name": Forgery(
        "other letters than are said to exist",
        proved(
            ["=", 0, 1],
            theorem(
                "quarter_turn",
                {"f": of("y", minus(sq(["cos", "y"]), sq(["sin", "y"])))},
                [every(["w"], ID)],
                by(here()),
            ),
        ),
    ),
    "a zero with two names": Forgery(
        "other letters than are said to exist",
        proved(
            ["=", 0, 1],
            theorem(
                "quarter_turn",
                {"f": of("y", minus(sq(["cos", "y"]), sq(["sin", "y"])))},
                [every(["w"], ID)],
                by(here()),
                letters=["u", "v"],
            ),
        ),
    ),
    "a zero that is defined": Forgery(
        "the letter d is taken",
        proved(
            ["=", minus(sq(["cos", "d"]), sq(["sin", "d"])), 0],
            theorem(
                "quarter_turn",
                {"f": of("y", minus(sq(["cos", "y"]), sq(["sin", "y"])))},
                [every(["w"], ID)],
                by(here()),
                letters=["d"],
            ),
            definitions=[["d", 0]],
        ),
    ),
    # intermediate_value
    "a zero of a step": Forgery(
        "('/', 1, 'x') is no polynomial in  x",
        proved(
            ["exists", ["x"], ["=", ["/", 1, "x"], 0]],
            theorem(
                "intermediate_value",
                {"f": of("x", ["/", 1, "x"]), "s": -1, "t": 1},
                [above(2), above(1)],
                witness({"x": "z"}, by(here(2))),
                letters=["z"],
            ),
        ),
    ),
    "a zero of a wave beyond polynomials": Forgery(
        "('tan', 'x') is no polynomial in  x",
        proved(
            ["exists", ["x"], ["=", ["tan", "x"], 0]],
            theorem(
                "intermediate_value",
                {"f": of("x", ["tan", "x"]), "s": 1, "t": 2},
                [above(1), above(1)],
                witness({"x": "z"}, by(here(2))),
                letters=["z"],
            ),
        ),
    ),
    "a zero without a change of sign": Forgery(
        NOT_THE_FORM,
        proved(
            ["exists", ["x"], ["=", ["+", sq("x"), 1], 0]],
            theorem(
                "intermediate_value",
                {"f": of("x", ["+", sq("x"), 1]), "s": -1, "t": 1},
                [above(2), above(4)],
                witness({"x": "z"}, by(here(2))),
                letters=["z"],
            ),
        ),
    ),
    "a zero between ends in the other order": Forgery(
        NOT_THE_FORM,
        proved(
            ["exists", ["x"], ["and", ["<", 1, "x"], ["<", "x", -1]]],
            theorem(
                "intermediate_value",
                {"f": of("x", "x"), "s": 1, "t": -1},
                [above(2), above(1)],
                witness({"x": "z"}, each(above(minus("z", 1)), above(minus(-1, "z")))),
                letters=["z"],
            ),
        ),
    ),
    "a zero at an end": Forgery(
        NO_SIGN,
        proved(
            ["=", 0, 1],
            theorem(
                "intermediate_value",
                {"f": of("x", "x"), "s": 0, "t": 1},
                [above(1), above(0)],
                by(here()),
                letters=["z"],
            ),
        ),
    ),
    "a zero that is an end": Forgery(
        "the letter z is taken",
        proved(
            ["=", 0, 1],
            theorem(
                "intermediate_value",
                {"f": of("x", "x"), "s": ["-", "z"], "t": "z"},
                [above(["*", 2, "z"]), above(sq("z"))],
                BACK,
                letters=["z"],
            ),
            [[">", "z", 0]],
            at={"z": 1},
        ),
    ),
    "a zero between infinite ends": Forgery(
        "['-infinity'] is no term",
        proved(
            ["=", 0, 1],
            theorem(
                "intermediate_value", {"f": of("x", "x"), "s": NOO, "t": OO}, [above(1), above(1)], BACK, letters=["z"]
            ),
        ),
    ),
    # integrals
    "the integral of a letter as of a constant": Forgery(
        NOT_EQUAL, proved(["=", integral("x"), "x"], theorem("constant", {"c": "x", "s": 0, "t": 1}, [], by(here())))
    ),
    "the integral of a letter, another bound": Forgery(
        NOT_EQUAL,
        proved(["=", integral("y", "y"), "y"], theorem("constant", {"c": "y", "s": 0, "t": 1}, [], by(here()))),
    ),
    "the integral of a constant to infinity": Forgery(
        "['infinity'] is no term",
        proved(["=", integral(1, high=OO), 0], theorem("constant", {"c": 1, "s": 0, "t": OO}, [], by(here()))),
    ),
    "the integral of a function as of a constant": Forgery(
        "(('x',), 1) for the parameter c of constant",
        proved(["=", integral(f("x")), 1], theorem("constant", {"c": of("x", 1), "s": 0, "t": 1}, [], by(here()))),
    ),
    "a power rule from right to left": Forgery(
        NOT_THE_FORM,
        proved(
            ["=", 0, 1],
            theorem(
                "power_rule",
                {"f": of("x", 1), "s": 1, "t": 0, "c": 1, "g": of("x", "x"), "u": 1},
                [above(0), every(["y"], implies(each(above("y"), ID)))],
                by(here()),
            ),
        ),
    ),
    "a power rule through zero": Forgery(
        NO_SIGN,
        proved(
            ["=", integral(["pow", "x", -2], "x", -1, 1), -2],
            theorem(
                "power_rule",
                {"f": of("x", ["pow", "x", -2]), "s": -1, "t": 1, "c": -1, "g": of("x", "x"), "u": -1},
                [above(2), every(["y"], implies(each(above("y"), ID)))],
                by(here()),
            ),
        ),
    ),
    "a power rule of something else": Forgery(
        NOT_EQUAL,
        proved(
            ["=", integral(1, "x", 1, 2), 0],
            theorem(
                "power_rule",
                {"f": of("x", 1), "s": 1, "t": 2, "c": 1, "g": of("x", ["+", sq("x"), 1]), "u": 1},
                [above(1), every(["y"], implies(each(above(["+", sq("y"), 1]), ID)))],
                by(here()),
            ),
        ),
    ),
    "a power rule of what is no polynomial": Forgery(
        "('tan', 'x') is no polynomial in  x",
        proved(
            ["=", 0, 1],
            theorem(
                "power_rule",
                {"f": of("x", 1), "s": 1, "t": 2, "c": 1, "g": of("x", ["tan", "x"]), "u": 1},
                [above(1), every(["y"], implies(each(ID, ID)))],
                by(here()),
            ),
        ),
    ),
    "a power rule with an exponent that is bound": Forgery(
        "(('x',), 'x') for the parameter u of power_rule",
        proved(
            ["=", 0, 1],
            theorem(
                "power_rule",
                {"f": of("x", 1), "s": 1, "t": 2, "c": 1, "g": of("x", 2), "u": of("x", "x")},
                [above(1), every(["y"], implies(each(above(2), ID)))],
                by(here()),
            ),
        ),
    ),
    "a power rule with a letter that a hypothesis fixes": Forgery(
        "the letter x is taken",
        proved(
            ["=", integral("x", "x", 1, 2), 2],
            theorem(
                "power_rule",
                {"f": of("x", "x"), "s": 1, "t": 2, "c": 2, "g": of("x", "x"), "u": 1},
                [above(1), every(["x"], implies(each(above("x"), by(hyp()))))],
                by(here()),
            ),
            [["=", "x", 2]],
            at={"x": 2},
        ),
    ),
    "an antiderivative from right to left": Forgery(
        NOT_THE_FORM,
        proved(["=", 0, 1], antiderivative(2, 1, by(here()))),
    ),
    "what rises from the larger end to the smaller one": Forgery(
        NO_SIGN, proved([">=", 1, ["exp", 1]], rising("rising", 1, 0, ordered=["-", 1]))
    ),
    "what falls": Forgery(NO_SIGN, proved([">=", -1, 0], rising("rising", 0, 1, ["-", "x"], -1))),
    "what does not fall said to rise strictly": Forgery(
        NO_SIGN, proved(["=", 0, 1], rising("rising_strictly", 0, 1, 2, 0, then=absurd([["positive", minus(2, 2)]])))
    ),
    "what rises strictly between equal ends": Forgery(
        NO_SIGN, proved([">", ["exp", "y"], ["exp", "y"]], rising("rising_strictly", "y", "y", ordered=0))
    ),
    "what rises through a pole": Forgery(
        NO_CONTRADICTION,
        proved(
            [">=", -1, 1],
            rising("rising", -1, 1, ["-", INVERSE], ["/", 1, sq("z")], [implies(absurd([], [here(2), "1"]))], 2),
        ),
    ),
    "what rises with a pole and nobody says that there is none": Forgery(
        "2 proofs for 3", proved([">=", -1, 1], rising("rising", -1, 1, ["-", INVERSE], ["/", 1, sq("z")], [], 2))
    ),
    "what rises by a letter that a hypothesis fixes": Forgery(
        NO_SIGN,
        proved([">=", 1, 0], rising("rising", 0, 1, ["*", "y", "x"], "y"), [["=", "y", -1]], at={"y": -1}),
    ),
    "what rises as far as its own letter": Forgery(
        NO_SIGN, proved([">=", "x", 0], rising("rising", 0, "x", "x", 1, ordered="x"))
    ),
    "an antiderivative through a pole": Forgery(
        NO_CONTRADICTION,
        proved(
            ["=", integral(["^", "x", -2], "x", -1, 1), -2],
            antiderivative(-1, 1, by(here()), ["^", "x", -2], ["-", INVERSE], [NOT_EVEN], 2),
        ),
    ),
    "an antiderivative of which nobody says that it is smooth": Forgery(
        "2 proofs for 3",
        proved(
            ["=", integral(["^", "x", -2], "x", -1, 1), -2],
            antiderivative(-1, 1, by(here()), ["^", "x", -2], ["-", INVERSE], [], 2),
        ),
    ),
    "an antiderivative with a pole at an end": Forgery(
        NO_SIGN,
        proved(
            ["=", integral(INVERSE), ["-", ["log", 0]]],
            antiderivative(
                0,
                1,
                theorem("log_of_one", {}, [], {**ID, "cofactors": [[here(), "1"], [here(1), "1"]]}),
                smooth=[above("y")],
            ),
        ),
    ),
    "an antiderivative that is smooth at no place": Forgery(
        NO_SIGN,
        proved(
            ["=", integral(["/", 1, ["*", 2, ["sqrt", "x"]]], low=-1), 1],
            antiderivative(
                -1, 1, by(here()), ["/", 1, ["*", 2, ["sqrt", "x"]]], ["sqrt", "x"], [above("y"), above("y")], 2
            ),
        ),
    ),
    "an antiderivative that jumps": Forgery(
        NO_CONTRADICTION,
        proved(
            ["=", PI, 0],
            antiderivative(
                0,
                PI,
                constant(1, by(here(), here(1)), 0, PI),
                1,
                ["arctan", ["tan", "x"]],
                [NOT_EVEN],
                PI,
            ),
        ),
    ),
    "an antiderivative of something else": Forgery(
        NOT_EQUAL,
        proved(["=", INVERSES, 0], antiderivative(1, 2, by(here()), INVERSE, ["^", "x", 0], [])),
    ),
    "an antiderivative that is one elsewhere": Forgery(
        NO_SIGN,
        proved(["=", THROUGH_ZERO, 0], antiderivative(-1, 1, by(here()), ordered=2)),
    ),
    "an antiderivative with a letter that is bound": Forgery(
        NOT_EQUAL,
        proved(
            ["=", 0, 1],
            theorem(
                "antiderivative",
                {"f": of("z", 1), "g": of("z", "x"), "s": 0, "t": 1},
                [above(1), every(["y"], implies(ID))],
                constant(1, by(here(), here(1))),
            ),
        ),
    ),
    "an antiderivative with a letter that a hypothesis fixes": Forgery(
        "the letter y is taken",
        proved(
            ["=", integral("x", "x", 0, 1), 2],
            antiderivative(0, 1, by(here()), "x", ["*", 2, "x"], [], last=by(hyp())),
            [["=", "y", 2]],
            at={"y": 2},
        ),
    ),
    "an antiderivative that is an integral": Forgery(
        "('integral', 'z', 'z', 0, 'x') may not be smooth",
        proved(["=", 0, 1], antiderivative(0, 1, by(here()), "x", integral("z", "z", 0, "x"), [])),
    ),
    "an antiderivative that is no term in a letter": Forgery(
        "'x' for the parameter g of antiderivative",
        proved(
            ["=", 0, 1],
            theorem(
                "antiderivative",
                {"f": of("x", 1), "g": "x", "s": 0, "t": 1},
                [above(1), every(["y"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "an integrand that has no value elsewhere": Forgery(
        MAY_BE_ZERO, proved(["=", minus(THROUGH_ZERO, THROUGH_ZERO), 0], antiderivative(1, 2, ID))
    ),
    "an integrand that has no value, cleared where nothing is true": Forgery(
        MAY_BE_ZERO,
        proved(
            ["and", ["=>", ["=", 0, 1], ["=", 0, 0]], ["=", minus(INVERSES, INVERSES), 0]],
            each(implies(antiderivative(1, 2, ID)), ID),
        ),
    ),
    "the logarithm of a negative number undone": Forgery(
        NO_SIGN,
        proved(["=", ["exp", ["log", -1]], -1], theorem("exp_of_log", {"t": -1}, [above(-1)], by(here()))),
    ),
    "the logarithm of what may be zero undone": Forgery(
        NO_SIGN,
        proved(
            ["=", ["exp", ["log", sq("x")]], sq("x")],
            theorem("exp_of_log", {"t": sq("x")}, [SQUARED], by(here())),
            at={"x": 1},
        ),
    ),
    "the logarithm of one that is one": Forgery(
        NOT_EQUAL, proved(["=", ["log", 1], 1], theorem("log_of_one", {}, [], by(here())))
    ),
    "the logarithm of one and of another number": Forgery(
        "log_of_one is a theorem about no parameters",
        proved(["=", ["log", 2], 0], theorem("log_of_one", {"t": 2}, [], by(here()))),
    ),
    "the logarithm of another exponential": Forgery(
        NOT_EQUAL,
        proved(
            ["=", ["log", ["exp", "x"]], "y"], theorem("log_of_exp", {"t": "x"}, [], by(here())), at={"x": 1, "y": 1}
        ),
    ),
    "the logarithm of a product of negative numbers": Forgery(
        NO_SIGN,
        proved(["=", 0, 1], theorem("log_of_product", {"s": -1, "t": -1}, [above(-1), above(-1)], by(here()))),
    ),
    "the logarithm of a product with a premise too few": Forgery(
        "1 proofs for 2", proved(["=", 0, 1], theorem("log_of_product", {"s": 1, "t": -1}, [above(1)], by(here())))
    ),
    "the logarithm of a sum for that of a product": Forgery(
        NOT_EQUAL,
        proved(
            ["=", ["log", ["+", 2, 3]], ["+", ["log", 2], ["log", 3]]],
            theorem("log_of_product", {"s": 2, "t": 3}, [above(2), above(3)], by(here())),
        ),
    ),
    "the logarithm of the square of a negative number": Forgery(
        NO_SIGN,
        proved(
            ["=", ["log", 4], ["*", 2, ["log", -2]]],
            theorem("log_of_power", {"t": -2, "u": 2}, [above(-2)], by(here())),
        ),
    ),
    "the logarithm of a power with another exponent": Forgery(
        NOT_EQUAL,
        proved(
            ["=", ["log", 8], ["*", 2, ["log", 2]]], theorem("log_of_power", {"t": 2, "u": 3}, [above(2)], by(here()))
        ),
    ),
    "the power of a negative number as an exponential": Forgery(
        NO_SIGN,
        proved(
            ["=", 1, ["exp", ["*", 2, ["log", -1]]]],
            theorem("power_as_exp", {"b": -1, "u": 2}, [above(-1)], by(here())),
        ),
    ),
    "a power as the exponential of another base": Forgery(
        NOT_EQUAL,
        proved(
            ["=", ["pow", 2, "x"], ["exp", ["*", "x", ["log", 3]]]],
            theorem("power_as_exp", {"b": 2, "u": "x"}, [above(2)], by(here())),
        ),
    ),
    "zero diverges": Forgery(
        NO_CONTRADICTION,
        proved(
            ["=", ["diverges", 0, "x", 0, OO], 1],
            theorem(
                "power_diverges",
                {"f": of("x", 0), "c": 0, "u": 1},
                [implies(BACK), every(["y"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "a power that decays diverges": Forgery(
        NOT_EQUAL,
        proved(
            ["=", ["diverges", FRACTION["term"], "x", 0, OO], 1],
            theorem(
                "power_diverges",
                {"f": FRACTION, "c": 1, "u": -2},
                [implies(BACK), every(["y"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "a power diverges between numbers": Forgery(
        NOT_EQUAL,
        proved(
            ["=", ["diverges", "x", "x", 0, 1], 1],
            theorem(
                "power_diverges",
                {"f": of("x", ["pow", "x", 1]), "c": 1, "u": 1},
                [implies(BACK), every(["y"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "the integral of Euler with a negative scale": Forgery(
        NOT_THE_FORM,
        proved(
            ["=", 0, 1],
            theorem(
                "beta",
                {**FROM, "p": -1, "f": of("x", ["pow", ["+", ["-", sq("x")], 1], -1])},
                [above(1), above(1), above(1), above(1), every(["y"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "the integral of Euler without a constant": Forgery(
        NO_SIGN,
        proved(
            ["=", 0, 1],
            theorem(
                "beta",
                {**FROM, "q": 0, "f": of("x", ["pow", sq("x"), -1])},
                [above(1), above(0), above(1), above(1), every(["y"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "the integral of Euler that diverges at zero": Forgery(
        NO_SIGN,
        proved(
            ["=", 0, 1],
            theorem(
                "beta",
                {**FROM, "k": -1, "f": of("x", ["*", ["^", "x", -1], FRACTION["term"]])},
                [above(1), above(1), above(0), above(2), every(["y"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "the integral of Euler that diverges at infinity": Forgery(
        NO_SIGN,
        proved(
            ["=", ["diverges", ["*", "x", FRACTION["term"]], "x", 0, OO], 0],
            theorem(
                "beta",
                {**FROM, "k": 1, "f": of("x", ["*", "x", FRACTION["term"]])},
                [above(1), above(1), above(2), above(0), every(["y"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "the integral of Euler of another integrand": Forgery(
        NOT_EQUAL,
        proved(
            ["=", 0, 1],
            theorem(
                "beta",
                {**FROM, "f": of("x", ["pow", ["+", sq("x"), 2], -1])},
                [above(1), above(1), above(1), above(1), every(["y"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "the integral of Euler with half a power": Forgery(
        "('/', 1, 2) for the parameter k of beta",
        proved(
            ["=", 0, 1],
            theorem(
                "beta",
                {**FROM, "k": ["/", 1, 2], "f": FRACTION},
                [above(1), above(1), above(1), above(1), every(["y"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "the integral of Euler that is said to diverge": Forgery(
        NO_SIGN,
        proved(
            ["=", ["diverges", FRACTION["term"], "x", 0, OO], 1],
            theorem(
                "beta_diverges",
                {**FROM, "f": FRACTION},
                [above(1), above(1), implies(BACK), choose(1, above(-1)), every(["y"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "the integral of Euler times zero diverges": Forgery(
        NO_CONTRADICTION,
        proved(
            ["=", ["diverges", 0, "x", 0, OO], 1],
            theorem(
                "beta_diverges",
                {**FROM, "c": 0, "r": 0, "f": of("x", 0)},
                [above(1), above(1), implies(BACK), choose(1, above(1)), every(["y"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "the integral of Euler with a negative constant diverges": Forgery(
        NOT_THE_FORM,
        proved(
            ["=", 0, 1],
            theorem(
                "beta_diverges",
                {**FROM, "q": -1, "f": FRACTION},
                [above(1), above(1), implies(BACK), choose(1, above(1)), every(["y"], implies(ID))],
                by(here()),
            ),
        ),
    ),
    "an even function that is odd": Forgery(
        NOT_EQUAL,
        proved(
            ["=", integral("x", "x", NOO, OO), ["*", 2, integral("x", "x", 0, OO)]],
            theorem("even", {"f": of("x", "x")}, [every(["y"], ID)], by(here())),
        ),
    ),
    "an even function for one letter": Forgery(
        "the letter x is taken",
        proved(
            ["=", integral("x", "x", NOO, OO), ["*", 2, integral("x", "x", 0, OO)]],
            theorem("even", {"f": of("x", "x")}, [every(["x"], by(hyp(), factor="-2"))], by(here())),
            [["=", "x", 0]],
            at={"x": 0},
        ),
    ),
    "an odd function that is even": Forgery(
        NOT_EQUAL,
        proved(
            ["=", integral(FRACTION["term"], "x", NOO, OO), 0],
            theorem("odd", {"f": FRACTION}, [every(["y"], ID), ID], by(here())),
        ),
    ),
    "an odd function without a finite half": Forgery(
        NOT_EQUAL,
        proved(
            ["=", ["diverges", "x", "x", NOO, OO], 0],
            theorem("odd", {"f": of("x", "x")}, [every(["y"], ID), ID], by(here(1))),
        ),
    ),
    # congruence, enclosure, all
    "equal values of arguments that are not equal": Forgery(
        NOT_EQUAL,
        proved(["=", SIN, ["sin", "y"]], theorem("congruence", {"s": SIN, "t": ["sin", "y"]}, [ID], by(here()))),
    ),
    "equal values of two functions": Forgery(
        "('sin', 'x') and ('cos', 'x') are not the same function",
        proved(["=", SIN, COS], theorem("congruence", {"s": SIN, "t": COS}, [ID], by(here()))),
    ),
    "equal values of a function and its derivative": Forgery(
        "('call', 'f', (0,), 'x') and ('call', 'f', (1,), 'x') are not the same function",
        proved(
            ["=", f("x"), f("x", orders=[1])],
            theorem("congruence", {"s": f("x"), "t": f("x", orders=[1])}, [ID], by(here())),
        ),
    ),
    "equal values of two unknown functions": Forgery(
        "('call', 'f', (0,), 'x') and ('call', 'g', (0,), 'x') are not the same function",
        proved(
            ["=", f("x"), ["call", "g", [0], "x"]],
            theorem("congruence", {"s": f("x"), "t": ["call", "g", [0], "x"]}, [ID], by(here())),
        ),
    ),
    "equal values with one more argument": Forgery(
        "('call', 'f', (0,), 'x') and ('call', 'f', (0, 0), 'x', 'y') are not the same function",
        proved(["=", f("x"), f("x", "y")], theorem("congruence", {"s": f("x"), "t": f("x", "y")}, [ID], by(here()))),
    ),
    "equal integrals of what is equal": Forgery(
        "are not both functions of values",
        proved(
            ["=", integral("x"), integral("y")],
            theorem("congruence", {"s": integral("x"), "t": integral("y")}, [by(hyp()), ID, ID], by(here())),
            [["=", "x", "y"]],
            at=SIDE,
        ),
    ),
    "equal derivatives of what is equal": Forgery(
        "are not both functions of values",
        proved(
            ["=", ["diff", "x", "x", 1, 2], ["diff", 2, "x", 1, 2]],
            theorem(
                "congruence", {"s": ["diff", "x", "x", 1, 2], "t": ["diff", 2, "x", 1, 2]}, [by(hyp())], by(here())
            ),
            [["=", "x", 2]],
            at={"x": 2},
        ),
    ),
    "equal sums of what is equal": Forgery(
        "are not both functions of values",
        proved(
            ["=", ["+", "x", 1], ["+", "y", 1]],
            theorem("congruence", {"s": ["+", "x", 1], "t": ["+", "y", 1]}, [ID, ID], by(here())),
        ),
    ),
    "congruence of a letter": Forgery(
        "are not both functions of values",
        proved(["=", "x", "y"], theorem("congruence", {"s": "x", "t": "y"}, [ID], by(here()))),
    ),
    "congruence of nothing": Forgery(
        "are not both functions of values", proved(["=", "x", "y"], theorem("congruence", {}, [], by(here())))
    ),
    "congruence of functions": Forgery(
        "are not both functions of values",
        proved(["=", "x", "y"], theorem("congruence", {"s": of("x", SIN), "t": of("x", COS)}, [], by(here()))),
    ),
    "congruence of three": Forgery(
        "congruence is about s and t alone",
        proved(["=", SIN, SIN], theorem("congruence", {"s": SIN, "t": SIN, "u": SIN}, [ID], by(here()))),
    ),
    "congruence without premises": Forgery(
        "0 proofs for 1",
        proved(["=", SIN, ["sin", "y"]], theorem("congruence", {"s": SIN, "t": ["sin", "y"]}, [], by(here()))),
    ),
    "digits of a letter": Forgery(
        "the digits of 'x'",
        proved(["<=", "x", 1], theorem("enclosure", {"t": "x", "digits": 1}, [], above(minus(1, "x")))),
    ),
    "digits of a letter that is not the number": Forgery(
        NOT_EQUAL,
        proved(
            ["<=", "x", 1], theorem("enclosure", {"t": "x", "digits": 1}, [ID], above(minus(1, "x")), numbers={"x": 1})
        ),
    ),
    "digits of letters in a circle": Forgery(
        "the digits of 'x'",
        proved(
            ["<=", "x", 1],
            theorem("enclosure", {"t": "x", "digits": 1}, [ID, ID], above(minus(1, "x")), numbers={"x": "y", "y": "x"}),
        ),
    ),
    "digits of a fraction of zero": Forgery(
        "a division by what may be zero",
        proved(["<=", 0, 1], theorem("enclosure", {"t": ["/", 1, minus(PI, PI)], "digits": 1}, [], above(1))),
    ),
    "digits of an arcsine beyond one": Forgery(
        "the root of what may be negative",
        proved(["<=", 0, 1], theorem("enclosure", {"t": ["arcsin", 2], "digits": 1}, [], above(1))),
    ),
    "digits of an integral": Forgery(
        NOT_THE_FORM,
        proved(
            ["<=", integral("x"), ["/", 49, 100]],
            theorem("enclosure", {"t": integral("x"), "digits": 1}, [], above(minus(["/", 5, 10], integral("x")))),
        ),
    ),
    "digits of an integral of an unknown function": Forgery(
        "the digits of ('call', 'f', (0,), 'x')",
        proved(["<=", 0, 1], theorem("enclosure", {"t": integral(f("x")), "digits": 1}, [], above(1))),
    ),
    "digits of a mean": Forgery(
        "the digits of ('mean', ('sin', 'x'), 'x')",
        proved(["<=", 0, 1], theorem("enclosure", {"t": ["mean", SIN, "x"], "digits": 1}, [], above(1))),
    ),
    "digits of a function": Forgery(
        "the digits of ('call', 'f', (0,), 1)",
        proved(["<=", 0, 1], theorem("enclosure", {"t": f(1), "digits": 1}, [], above(1))),
    ),
    "digits of a term in a letter": Forgery(
        "no term with digits", proved(["<=", 0, 1], theorem("enclosure", {"t": of("x", 1), "digits": 1}, [], above(1)))
    ),
    "more digits than there are": Forgery(
        "41 digits", proved(["<=", 0, 1], theorem("enclosure", {"t": PI, "digits": 41}, [], above(1)))
    ),
    "fewer digits than none": Forgery(
        "-1 digits", proved(["<=", 0, 1], theorem("enclosure", {"t": PI, "digits": -1}, [], above(1)))
    ),
    "digits counted by a truth value": Forgery(
        "True is no letter", proved(["<=", 0, 1], theorem("enclosure", {"t": PI, "digits": True}, [], above(1)))
    ),
    "digits of two": Forgery(
        "['s'] is nothing that has digits",
        proved(
            ["<=", PI, 4], theorem("enclosure", {"t": PI, "digits": 1, "s": 4}, [], above(minus(["/", 32, 10], PI)))
        ),
    ),
    "a decimal below the digits": Forgery(
        NO_SIGN,
        proved(
            ["<=", PI, ["/", 314, 100]],
            theorem("enclosure", {"t": PI, "digits": 2}, [], above(minus(["/", 314, 100], PI))),
        ),
    ),
    "digits of a defined letter that is another": Forgery(
        NOT_EQUAL,
        proved(
            ["<=", "d", 1],
            theorem("enclosure", {"t": 1, "digits": 1}, [ID], above(minus(1, "d")), numbers={"d": 1}),
            definitions=[["d", 2]],
        ),
    ),
    "an unknown theorem": Forgery(
        "there is no theorem fermat", proved(ZERO_IS_ONE, theorem("fermat", {}, [], by(here())))
    ),
    "a theorem that is a rule": Forgery(
        "there is no theorem have", proved(ZERO_IS_ONE, theorem("have", {}, [], by(here())))
    ),
    "a theorem without a parameter": Forgery(
        "root is a theorem about t", proved(ZERO_IS_ONE, theorem("root", {}, [ID], by(here())))
    ),
    "a theorem with a parameter too many": Forgery(
        "circle_number is a theorem about no parameters",
        proved(ZERO_IS_ONE, theorem("circle_number", {"t": 1}, [], by(here()))),
    ),
    "a theorem with another parameter": Forgery(
        "root is a theorem about t", proved(ZERO_IS_ONE, theorem("root", {"x": 1}, [above(1)], by(here())))
    ),
    "a theorem about infinity": Forgery(
        "['infinity'] is no term", proved(ZERO_IS_ONE, theorem("root", {"t": OO}, [above(1)], by(here())))
    ),
    "a theorem about nothing": Forgery(
        "None is no letter", proved(ZERO_IS_ONE, theorem("root", {"t": None}, [above(1)], by(here())))
    ),
    "a theorem about a formula": Forgery(
        "['=', 0, 0] is no term", proved(ZERO_IS_ONE, theorem("root", {"t": ["=", 0, 0]}, [above(1)], by(here())))
    ),
    "a theorem with letters that do not exist": Forgery(
        NOT_EQUAL, proved(ZERO_IS_ONE, theorem("root", {"t": 1}, [above(1)], ID, letters=["x"]))
    ),
    "a theorem with numbers": Forgery(
        "a step of a proof has the superfluous ['numbers']",
        proved(["=", 0, 0], theorem("root", {"t": 1}, [above(1)], ID, numbers={"x": 1})),
    ),
    "what a theorem says beyond its last part": Forgery(
        "('here', 2) is no such fact", proved(["=", 0, 1], theorem("root", {"t": 1}, [above(1)], by(here(2))))
    ),
    "a premise as a fact": Forgery(
        "('here', 0) is no such fact",
        proved(["=", 1, 2], theorem("equal_squares", {"s": 1, "t": 2}, [above(1), above(2), by(here(0))], by(here()))),
    ),
    "what a theorem says in the proof of its premise": Forgery(
        "('here', 0) is no such fact",
        proved(["=", 1, 2], theorem("equal_squares", {"s": 1, "t": 2}, [above(1), above(2), by(here())], by(here()))),
    ),
    "a fact of a theorem in another branch": Forgery(
        "('here', 1) is no such fact",
        proved(
            ["and", ["=", 0, 0], ["=", sq(["sqrt", 2]), ["+", 1, 2]]],
            each(theorem("root", {"t": 3}, [above(3)], ID), by(here(1))),
        ),
    ),
}

QUADRANT = [above(["*", ["/", 3, 2], PI]), above(HALF_PI)]  # of pi: it is above -pi/2, and is not below pi/2
SIGNS = ("=", "!=", "<", "<=", ">", ">=")


def angle(name: str, a: JSON, t: JSON, *premises: JSON) -> JSON:
    """What a theorem of angles says, with proofs of its premises, one of which is not true."""
    step = theorem(name, {"a": a, "t": t}, [*premises], by(here(1)))
    return proved(ZERO_IS_ONE, theorem("circle_number", {}, [], step))


TOO_FAR: dict[str, Forgery] = {
    f"{name} {sign} of an angle beyond its range": Forgery(NOT_THE_FORM, angle(f"{name} {sign}", a, 0, *premises, ID))
    for name, a, premises in (
        ("arctangent", PI, QUADRANT),
        ("arcsine", PI, [above(1), *QUADRANT]),
        ("arccosine", ["-", PI], [above(1), above(PI), above(["*", 2, PI])]),
    )
    for sign in (*SIGNS, *(f"{sign} back" for sign in SIGNS))
}
BEYOND_ONE: dict[str, Forgery] = {
    f"{name} {sign} of a number beyond one": Forgery(
        NOT_THE_FORM, angle(f"{name} {sign}", 0, 2, above(3), *premises, ID)
    )
    for name, premises in (("arcsine", [above(HALF_PI)] * 2), ("arccosine", [above(0), above(PI)]))
    for sign in (*SIGNS, *(f"{sign} back" for sign in SIGNS))
}
OTHERWISE: dict[str, Forgery] = {
    f"{name} {sign} of angles that are not so": Forgery(
        {"=": NOT_EQUAL, "!=": NO_CONTRADICTION}.get(sign, NOT_THE_FORM),
        angle(f"{name} {sign}", 0, t, *premises, last),
    )
    for name, premises in (
        ("arctangent", [above(HALF_PI)] * 2),
        ("arcsine", [above(["/", 3, 4]), *[above(HALF_PI)] * 2]),
        ("arccosine", [above(["/", 3, 4]), above(0), above(PI)]),
    )
    for sign, t, last in (
        ("=", ["/", 1, 2], ID),
        ("!=", ["/", 1, 2], implies(absurd([], [here(1), "1"]))),
        *((sign, ["/", -1, 2], above(1)) for sign in ("<", "<=", ">", ">=")),
    )
}


def without_value(t: JSON, value: JSON = 1) -> JSON:
    """A term that counts as a number wherever it has a value."""
    return ["+", t, ["-", t], value]


NO_VALUE = "is not about numbers"  # that all terms have values under a binder, of which there is no proof
POSITIVE_ROOTS = [
    "forall",
    ["x_0"],
    ["=>", ["and", ["<", 0, "x_0"], ["<", "x_0", 1], ["!=", "x_0", 0]], [">=", "x_0", 0]],
]
ABOVE_ZERO = ["forall", ["x_0"], ["=>", ["and", ["<", 0, "x_0"], ["<", "x_0", 1], ["!=", "x_0", 0]], [">", "x_0", 0]]]
SUMMED = ["forall", ["x_0"], ["=>", ["and", ["<=", 0, "x_0"], ["<=", "x_0", "n"]], [">", "x_0", 0]]]
BETWEEN = ["forall", ["x_0"], ["=>", ["and", ["<", -1, "x_0"], ["<", "x_0", "a"], ["!=", "x_0", 0]], [">=", "x_0", 0]]]


def nowhere(x: str, stated: JSON, form: JSON, facts: int) -> JSON:
    """A point at which nothing lies between two ends, so that anything is so of it."""
    no = have([">", ["+", x, 1], 0], above(form), absurd([here(facts)], [["point", 0], "1"]))
    return {"values": {x: -1}, "proof": have(stated, every(["y"], implies(no)), compute(here()))}


NOWHERE_SUMMED = nowhere("n", SUMMED, ["+", "y", minus("n", "y"), 1], 2)
NOWHERE = nowhere("a", BETWEEN, ["+", ["+", "y", 1], minus("a", "y")], 3)
DIVERGING = integral(["pow", "x", ["/", -5, 3]])
EASY = {"values": {}, "proof": compute()}
JUNK = without_value(["sqrt", "x"])
FLAT = antiderivative(-1, 1, by(here()), JUNK, "x", (), 2)
NOT_THREE = implies(antiderivative(-1, 1, absurd([], [here(), "-1"], [here(1), "1"]), JUNK, "x", (), 2))
UNDEFINED: dict[str, Forgery] = {
    f"{what} under a binder": Forgery(NO_VALUE, proved(claim, proof, witnesses=[EASY]))
    for what, claim, proof in (
        ("a root of negative numbers", ["=", integral(JUNK, low=-1), 2], FLAT),
        (
            "a logarithm of negative numbers",
            ["=", integral(without_value(["log", "x"]), low=-1), 2],
            antiderivative(-1, 1, by(here()), without_value(["log", "x"]), "x", (), 2),
        ),
        (
            "an arcsine beyond one",
            ["=", integral(without_value(["arcsin", "x"]), low=-2, high=2), 4],
            antiderivative(-2, 2, by(here()), without_value(["arcsin", "x"]), "x", (), 4),
        ),
        ("a power of zero", ["=", ["sum", without_value(["pow", "k", PI]), "k", 0, 1], ["sum", 1, "k", 0, 1]], ID),
        ("a root of cosines", ["=", ["mean", without_value(["sqrt", COS], 0), "x"], ["mean", 0, "x"]], ID),
        (
            "a gamma function",
            ["=", ["diverges", without_value(["gamma", "x"]), "x", NOO, OO], ["diverges", 1, "x", NOO, OO]],
            ID,
        ),
        (
            "a root under two binders",
            ["=", integral(integral(without_value(["sqrt", minus("x", "y")]), "y")), integral(integral(1, "y"))],
            ID,
        ),
        ("a root under a quantifier", ["forall", ["x"], ["=", JUNK, 1]], every(["y"], ID)),
        (
            "a root behind an implication",
            ["forall", ["x"], ["=>", [">", 1, "x"], ["=", JUNK, 1]]],
            every(["y"], implies(ID)),
        ),
        ("a root in a product", ["=", ["product", JUNK, "x", -1, 0], ["product", 1, "x", -1, 0]], ID),
    )
}
UNDEFINED |= {
    "ends of an integral that are not in order": Forgery(
        "('<', 1, 0) is not so",
        proved(
            ["=", integral(JUNK, low=1, high=0), integral(1, low=1, high=0)],
            ID,
            witnesses=[
                {
                    "values": {},
                    "proof": have(
                        [
                            "forall",
                            ["x_0"],
                            ["=>", ["and", ["<", 1, "x_0"], ["<", "x_0", 0], ["!=", "x_0", 0]], [">=", "x_0", 0]],
                        ],
                        every(["y"], implies(Y_IS_POSITIVE)),
                        compute(here()),
                    ),
                }
            ],
        ),
    ),
    "a sum without addends where they have values": Forgery(
        "('<=', 0, 'n')",
        proved(
            ["=", ["sum", without_value(["log", "k"]), "k", 0, "n"], ["sum", 1, "k", 0, "n"]],
            ID,
            witnesses=[NOWHERE_SUMMED],
        ),
    ),
    "an integral over nothing where the integrand has values": Forgery(
        "('<', -1, 'a')",
        proved(
            ["=", integral(JUNK, low=-1, high="a"), integral(1, low=-1, high="a")],
            ID,
            witnesses=[NOWHERE],
        ),
    ),
    "a power that diverges at an end": Forgery(
        "is not about numbers",
        proved(
            ["=", minus(DIVERGING, DIVERGING), 0],
            ID,
            witnesses=[{"values": {}, "proof": have(ABOVE_ZERO, every(["y"], implies(above("y"))), compute(here()))}],
        ),
    ),
    "an integral that diverges": Forgery(
        "the digits of ('diverges'",
        proved(["=", minus(integral("x", high=OO), integral("x", high=OO)), 0], ID, witnesses=[EASY]),
    ),
    "a sum that diverges": Forgery(
        "('or',))",
        proved(["=", minus(["sum", "k", "k", 1, OO], ["sum", "k", "k", 1, OO]), 0], ID, witnesses=[EASY]),
    ),
    "a proof about other letters": Forgery(
        "is no value",
        proved(
            ["=", integral(JUNK, low=-1), integral(1, low=-1)],
            ID,
            witnesses=[
                {
                    "values": {},
                    "proof": have(POSITIVE_ROOTS, every(["y"], implies(above("y"))), compute(here())),
                }
            ],
        ),
    ),
    "something that exists where it has no value": Forgery(
        "('>', 0, 0) is not so",
        proved(["exists", ["x"], ["=", ["*", "x", ["log", "x"]], 0]], witness({"x": 0}, each(ID, compute()))),
    ),
    "something that exists, without its value": Forgery(
        NO_EQUATION, proved(["exists", ["x"], ["=", ["*", "x", ["log", "x"]], 0]], witness({"x": 0}, ID))
    ),
    "a refutation of what has no value": Forgery(
        NO_VALUE, refuted(["=", integral(JUNK, low=-1), 3], {}, proof=each(each(NOT_THREE), compute(), compute()))
    ),
}

GROUPS = (RULES, ADDITION, BINDERS, ANALYSIS, CERTIFICATES, THEOREMS, TOO_FAR, BEYOND_ONE, OTHERWISE, UNDEFINED)
FORGERIES: dict[str, Forgery] = {name: forgery for group in GROUPS for name, forgery in group.items()}
