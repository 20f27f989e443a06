"""What `make bench` prints: our proofs with cofactors against SymPy's own means, and the checker against an import.

The proof set is (2.11), (2.12), (2.13), the expansion of f, (2.18) and (1.3) of Mirer 2009. SymPy gets the same
statements: `simplify` with the direction cosines as functions of three angles, and `groebner` + `reduced` over the
relations of an orthogonal matrix.
"""

from __future__ import annotations

import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from typing import Any

from symcheck import checker, kernels
from symcheck.evidence import decide
from symcheck.evidence.executor import Done, Pool
from symcheck.proof.polynomial import unfold
from symcheck.reading import to_sympy
from symcheck.statement import Method, Problem, Verdict

PROOF_SET = ("2.11", "2.12", "2.13", "2.13.1", "2.18", "1.3")
LINKS = {"2.13.1": "ab"}  # the third link is a misprint, not an identity
LIMIT = 60.0  # seconds for one statement; a statement that takes longer is counted with this time


def problems() -> Iterator[tuple[Method, Problem]]:
    """The lowered statements of the proof set, each with its method."""
    for number in PROOF_SET:
        obligation = decide.obligation_of(f"mirer2009:{number}")
        context, by = decide.Context(obligation.paper, obligation.item), obligation.item.by
        for unit in decide._units(context):
            if unit.letter in LINKS.get(number, unit.letter):
                method = by[unit.letter] if isinstance(by, dict) else by
                for n, formula in enumerate(unit.formulas):
                    yield method, context.problem(formula, obligation.item.given, method, n)


def difference(problem: Problem) -> Any:
    """What has to be zero, as a SymPy expression: left minus right, minus the form that an inequality rests on."""
    _, left, right = problem.claim
    parts = [left, ("-", right), *(("-", term) for name, term in problem.hints if name == "form")]
    return to_sympy(unfold(("+", *parts), dict(problem.definitions)))


def simplify(index: str) -> bool:
    """Whether SymPy simplifies the difference to zero on Euler angles."""
    from symcheck.papers.mirer2009 import derivation

    _, problem = list(problems())[int(index)]
    expression = difference(problem)
    cosines = derivation.direction_cosines()
    values = {symbol: cosines[symbol.name] for symbol in expression.free_symbols if symbol.name in cosines}
    return bool(expression.subs(values).simplify() == 0)


def groebner() -> int:
    """How many of the statements SymPy's `groebner` and `reduced` prove."""
    import sympy

    statements = [problem for _, problem in problems()]
    named = {name: formulas for problem in statements for name, formulas in problem.hypotheses}
    equalities = [f for name in ("orthogonal", "right-handed") for f in named[name] if f[0] == "="]
    relations = [sympy.expand(to_sympy(f[1]) - to_sympy(f[2])) for f in equalities]
    letters = [sympy.Symbol(f"a_{i}{j}", real=True) for i in (1, 2, 3) for j in (1, 2, 3)]
    basis = sympy.groebner(relations, *letters, order="grevlex")
    numerators = [sympy.numer(sympy.together(difference(problem))) for problem in statements]
    rests = [sympy.reduced(numerator, list(basis), *letters, order="grevlex")[1] for numerator in numerators]
    return sum(sympy.expand(rest) == 0 for rest in rests)


def timed(function: Callable[[], Any], repeat: int = 1) -> tuple[float, Any]:
    """(seconds of the fastest run, last result)."""
    best, result = float("inf"), None
    for _ in range(repeat):
        start = time.perf_counter()
        result = function()
        best = min(best, time.perf_counter() - start)
    return best, result


def ours(statements: list[tuple[Method, Problem]]) -> int:
    """How many of the statements our methods prove."""
    return sum(method.decide(problem).verdict is Verdict.PROVED for method, problem in statements)


def simplified(count: int) -> tuple[float, int]:
    """(seconds, statements proved) by `simplify`, each statement in a process that is ended at the time limit."""
    seconds, proved = 0.0, 0
    for index in range(count):
        taken, [(_, answer)] = timed(lambda index=index: list(Pool(1, ("sympy",)).map(simplify, [str(index)], LIMIT)))
        seconds += taken
        proved += isinstance(answer, Done) and answer.value
    return seconds, proved


def import_of_sympy() -> float:
    """Seconds that `import sympy` adds to the start of an interpreter."""
    runs = {
        code: timed(lambda code=code: subprocess.run([sys.executable, "-c", code], check=True), 5)[0]
        for code in ("pass", "import sympy")
    }
    return runs["import sympy"] - runs["pass"]


def line(what: str, seconds: float, note: str) -> None:
    """One row of the report."""
    print(f"{what:<44} {seconds * 1000:>12.2f} ms   {note}")


def main() -> None:
    """Measure and print."""
    statements = list(problems())
    count = len(statements)
    first, _ = timed(lambda: ours(statements))
    warm, proved = timed(lambda: ours(statements), 20)
    line("ours, first time, with the basis", first, "")
    line("ours, with cofactors", warm, f"{proved} of {count} proved")
    seconds, proved = timed(groebner, 3)
    line("SymPy groebner + reduced", seconds, f"{proved} of {count} proved; {seconds / warm:,.0f} times ours")
    seconds, proved = simplified(count)
    line("SymPy simplify on Euler angles", seconds, f"{proved} of {count} proved; {seconds / warm:,.0f} times ours")
    folder = kernels.folder() / "certificates"
    certificates = [certificate for file in sorted(folder.glob("*.json")) for certificate in checker.read(file)]
    seconds, faults = timed(lambda: [fault for c in certificates if (fault := checker.check(c))], 5)
    imported = import_of_sympy()
    line(
        "checker, all certificates",
        seconds,
        f"{len(certificates)} certificates, {len(faults)} rejected; {imported / seconds:.1f} times faster than",
    )
    line("import sympy", imported, "")


if __name__ == "__main__":
    main()
