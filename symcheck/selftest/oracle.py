"""A judge independent of the provers: evaluates formulas with 40 digits at random points under the hypotheses."""

from __future__ import annotations

import random
from typing import Any

import mpmath

from symcheck.statement import Formula, Problem, Term

mpmath.mp.dps = 40
SEED, POINTS = 20090055, 3
TOLERANCE = mpmath.mpf(10) ** -25
CONSTANTS = {"pi": mpmath.pi, "infinity": mpmath.inf}
SIGNS = {
    "=": lambda d: abs(d) < TOLERANCE,
    "!=": lambda d: abs(d) > TOLERANCE,
    "<=": lambda d: d < TOLERANCE,
    ">=": lambda d: d > -TOLERANCE,
    "<": lambda d: d < -TOLERANCE,
    ">": lambda d: d > TOLERANCE,
}


def value(term: Term, at: dict[str, Any], unfold: dict[str, Term]) -> Any:
    """The number a term stands for; names are looked up in the definitions first."""
    if isinstance(term, int):
        return mpmath.mpf(term)
    if term in CONSTANTS:
        return CONSTANTS[term]
    if isinstance(term, str):
        if term not in at and term in unfold:
            at[term] = value(unfold[term], at, unfold)
        return at.setdefault(term, mpmath.mpf(random.randint(1, 10**6)) / random.randint(1, 10**5))
    head, *rest = term
    if head == "diff":
        return _derivative(term, at, unfold)
    if head in ("mean", "integral", "diverges"):
        return _over(term, at, unfold)
    args = [value(part, at, unfold) for part in rest]
    if head == "+":
        return mpmath.fsum(args)
    if head == "*":
        return mpmath.fprod(args)
    if head == "-":
        return -args[0]
    if head == "/":
        return args[0] / args[1]
    if head == "^":
        return args[0] ** int(args[1])
    if head in ("pow", "sqrt", "log") and args[0] < 0:
        raise ZeroDivisionError(f"{head} of a negative number")
    if head in ("arcsin", "arccos") and abs(args[0]) > 1:
        raise ZeroDivisionError(f"{head} of a number above 1")
    if head == "pow":
        return args[0] ** args[1]
    return getattr(mpmath, {"arctan": "atan", "arcsin": "asin", "arccos": "acos"}.get(str(head), str(head)))(args[0])


def _over(term: Any, at: dict[str, Any], unfold: dict[str, Term]) -> Any:
    """A mean over one turn of a trigonometric polynomial, for which 64 points are exact; no integral."""
    head, body, name, *_ = term
    value(name, at, unfold)
    value(body, at, unfold)

    def along(x: Any) -> Any:
        return value(body, {k: v for k, v in at.items() if k not in unfold} | {name: x}, unfold)

    if head == "mean":
        return mpmath.fsum(along(2 * mpmath.pi * k / 64) for k in range(64)) / 64
    raise KeyError("an integral is not known to 40 digits")


def _derivative(term: Any, at: dict[str, Any], unfold: dict[str, Term]) -> Any:
    _, body, name, order = term
    value(name, at, unfold)
    value(body, at, unfold)  # every free variable gets its value before the steps of the difference

    def along(x: Any) -> Any:
        return value(body, {k: v for k, v in at.items() if k not in unfold} | {name: x}, unfold)

    return mpmath.diff(along, at[name], order, h=mpmath.mpf(10) ** -28) if order else along(at[name])


def rotation(rng: random.Random, handed: int) -> dict[str, Any]:
    """A random rotation (handed = 1) or reflection (-1), entries a_11 to a_33."""
    w, x, y, z = (mpmath.mpf(rng.randint(-999, 999)) for _ in range(4))
    n = (w * w + x * x + y * y + z * z) * handed
    rows = (
        (w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)),
        (2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)),
        (2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z),
    )
    return {f"a_{i + 1}{j + 1}": rows[i][j] / n for i in range(3) for j in range(3)}


def point(problem: Problem, rng: random.Random) -> dict[str, Any] | None:
    """A random point that satisfies the hypotheses, or None for hypotheses this oracle cannot sample."""
    names = {name for name, _ in problem.hypotheses}
    at: dict[str, Any] = {}
    if names & {"orthogonal", "right-handed"}:
        at |= rotation(rng, 1 if "right-handed" in names else rng.choice((1, -1)))
    if "chosen angles" in names:
        at |= {"beta": mpmath.asin(1 / mpmath.sqrt(3)), "gamma": mpmath.pi / 4}
    if "damping matrix symmetric" in names:
        m = {(i, j): mpmath.mpf(rng.randint(1, 999)) / 7 for i in (1, 2, 3) for j in range(i, 4)}
        at |= {f"m_{i}{j}": m[min(i, j), max(i, j)] for i in (1, 2, 3) for j in (1, 2, 3)}
    if "triple root" in names:
        letters = [f"{x}_{i}" for x in "IJL" for i in (1, 2, 3)] + ["k"]
        at |= {letter: mpmath.mpf(rng.randint(1, 99)) / 7 for letter in letters}
        product = at["I_1"] * at["I_2"] * at["I_3"]
        at["xi"] = at["k"]
        at["J_3"] = product / at["J_1"] / at["J_2"]
        at["L_3"] = (3 * product - at["J_1"] * at["L_1"] - at["J_2"] * at["L_2"]) / at["J_3"]
    unfold = dict(problem.definitions)
    holds_all = all(holds(formula, at, unfold) for _, formulas in problem.hypotheses for formula in formulas)
    return at if holds_all else None


def holds(formula: Formula, at: dict[str, Any], unfold: dict[str, Term]) -> bool:
    """Whether a formula without quantifiers holds at a point."""
    head, *parts = formula
    if head in SIGNS:
        return bool(SIGNS[head](value(parts[0], at, unfold) - value(parts[1], at, unfold)))
    truths = [holds(part, at, unfold) for part in parts]
    return {
        "and": all(truths),
        "or": any(truths),
        "=>": not truths[0] or truths[-1],
        "<=>": truths[0] == truths[-1],
    }[head]


def contradicts(problem: Problem, original: Problem) -> bool:
    """Whether at some random point that satisfies the hypotheses the formula fails and the original does not.

    False if no such point is found, also where the hypotheses or the functions are none that can be sampled.
    """
    rng = random.Random(SEED)
    for at in (point(problem, rng) for _ in range(POINTS)):
        if at is None:
            continue
        try:
            if holds(original.claim, at, dict((*problem.definitions, *original.definitions))) and not holds(
                problem.claim, at, dict(problem.definitions)
            ):
                return True
        except (ZeroDivisionError, KeyError):
            continue
    return False
