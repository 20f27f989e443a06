"""What `make bench` prints: our proofs with cofactors against SymPy's own means, and the checker against an import.

The proof set is (2.11), (2.12), (2.13), the expansion of f, (2.18) and (1.3) of Mirer 2009. SymPy gets the same
statements: `simplify` with the direction cosines as functions of three angles, and `groebner` + `reduced` over the
relations of an orthogonal matrix.
"""

from __future__ import annotations

import gc
import os
import statistics
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from symcheck import kernels
from symcheck.audit import Done, context_of, obligation_of, units
from symcheck.audit.executor import Pool
from symcheck.core.problems import Form, Method, Problem
from symcheck.core.terms import Term, node
from symcheck.core.verdicts import Verdict
from symcheck.proof.algebra.knowledge import ring_of, starting
from symcheck.proof.algebra.polynomial import unfold
from symcheck.reading import to_sympy

PROOF_SET = ("2.11", "2.12", "2.13", "2.13.1", "2.18", "1.3")
LINKS = {"2.13.1": "ab"}  # the third link is a misprint, not an identity
SHORT = 0.1  # seconds that short runs are repeated for
UNTYPED = "297103a"  # the last commit before terms were typed
LIMIT = 60.0  # seconds for one statement; a statement that takes longer is counted with this time


def problems() -> Iterator[tuple[Method, Problem]]:
    """The lowered statements of the proof set, each with its method."""
    for number in PROOF_SET:
        obligation = obligation_of(f"mirer2009:{number}")
        context = context_of(obligation)
        for unit in units(context):
            if unit.letter in LINKS.get(number, unit.letter):
                method = context.method(unit.letter)
                for n, formula in enumerate(unit.formulas):
                    yield method, context.problem(formula, context.item.statement.given, method, n)


def vanishing(problem: Problem) -> Term:
    """What has to be zero: left minus right, minus the form that an inequality rests on."""
    _, left, right = problem.claim
    forms = (node("-", hint.sum) for hint in problem.hints if isinstance(hint, Form))
    return unfold(node("+", left, node("-", right), *forms), dict(problem.definitions))


def cofactors() -> Callable[[], int]:
    """Finds the cofactors of all statements over all their hypotheses, from polynomials; tells how many have them."""
    ready = []
    for _, problem in problems():
        ring = ring_of(problem)
        ready.append((starting(problem, ring).ideal(), ring.poly(vanishing(problem))))
    return lambda: sum(ideal.cofactors(poly) is not None for ideal, poly in ready)


def groebner() -> Callable[[], int]:
    """SymPy's `groebner` once and `reduced` for each statement, from expressions; tells how many it proves."""
    import sympy

    statements = [problem for _, problem in problems()]
    named = {name: formulas for problem in statements for name, formulas in problem.hypotheses}
    equalities = [f for name in ("orthogonal", "right-handed") for f in named[name] if f[0] == "="]
    relations = [sympy.expand(to_sympy(left) - to_sympy(right)) for _, left, right in equalities]
    numerators = [sympy.expand(sympy.numer(sympy.together(to_sympy(vanishing(problem))))) for problem in statements]
    letters = [sympy.Symbol(f"a_{i}{j}", real=True) for i in (1, 2, 3) for j in (1, 2, 3)]

    def run() -> int:
        basis = list(sympy.groebner(relations, *letters, order="grevlex"))
        return sum(sympy.reduced(numerator, basis, *letters, order="grevlex")[1] == 0 for numerator in numerators)

    return run


def simplify(index: str) -> tuple[float, bool]:
    """(seconds, whether SymPy simplifies the difference to zero on Euler angles)."""
    from symcheck.papers.mirer2009 import derivation

    _, problem = list(problems())[int(index)]
    expression = to_sympy(vanishing(problem))
    cosines = derivation.direction_cosines()
    values = {symbol: cosines[symbol.name] for symbol in expression.free_symbols if symbol.name in cosines}
    turned = expression.subs(values)
    seconds, rest = timed(turned.simplify)
    return seconds, bool(rest == 0)


def timed(function: Callable[[], Any], short: float = SHORT) -> tuple[float, Any]:
    """(seconds, result) of one run, as `timeit` does it: short runs repeated, the garbage collector standing still."""
    gc.collect()
    gc.disable()
    runs, start = 0, time.perf_counter()
    while not runs or time.perf_counter() - start < short:
        result, runs = function(), runs + 1
    seconds = (time.perf_counter() - start) / runs
    gc.enable()
    return seconds, result


def interleaved(rounds: int, *functions: Callable[[], Any], short: float = SHORT) -> list[tuple[float, Any]]:
    """(median seconds, last result) of each function; in every round each runs once, in turn."""
    runs = [[timed(function, short) for function in functions] for _ in range(rounds)]
    return [(statistics.median(t for t, _ in column), column[-1][1]) for column in zip(*runs, strict=True)]


def ours(statements: list[tuple[Method, Problem]]) -> int:
    """How many of the statements our methods prove."""
    return sum(method.decide(problem).verdict is Verdict.PROVED for method, problem in statements)


def simplified(count: int) -> tuple[float, int]:
    """(seconds, statements proved) by `simplify`, each statement in a process that is ended at the time limit."""
    answers = [answer for _, answer in Pool(1, ("sympy",)).map(simplify, map(str, range(count)), LIMIT)]
    results = [answer.value if isinstance(answer, Done) else (LIMIT, False) for answer in answers]
    return sum(seconds for seconds, _ in results), sum(proved for _, proved in results)


def python(*arguments: str) -> Callable[[], Any]:
    """A run of a new interpreter, which keeps what it compiles, as an installed package does."""
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    return lambda: subprocess.run([sys.executable, *arguments], check=True, stdout=subprocess.DEVNULL, env=environment)


def line(what: str, seconds: float, note: str) -> None:
    """One row of the report."""
    print(f"{what:<44} {seconds * 1000:>12.2f} ms   {note}")


def untyped(folder: Path) -> Callable[[], Any] | None:
    """The checker before terms were typed, with its certificates of then; None where git does not have it."""
    names = [f"symcheck/{name}.py" for name in ("__init__", "checker", "theorems", "residues", "enclosures")]
    try:
        packed = subprocess.run(
            ["git", "archive", UNTYPED, *names, "generated/certificates"], check=True, capture_output=True
        )
    except (OSError, subprocess.CalledProcessError):
        return None
    subprocess.run(["tar", "-x", "-C", str(folder)], input=packed.stdout, check=True)
    run = "import sys; sys.path.insert(0, sys.argv.pop(1)); from runpy import run_module as run; "
    run += "run('symcheck.checker', run_name='__main__')"
    return python("-c", run, str(folder), str(folder / "generated" / "certificates"))


def typed_terms() -> None:
    """What typed terms, witnesses and the comparison with the ledger cost."""
    with TemporaryDirectory() as folder:
        before = untyped(Path(folder))
        if before is None:
            print(f"what typed terms cost is not measured: git does not have {UNTYPED}")
            return
        (start, _), (then, _), (now, _) = interleaved(
            9, python("-c", "pass"), before, python("-m", "symcheck.checker", str(kernels.folder()))
        )
        ratio = (now - start) / (then - start)
        line(
            "checker before terms were typed",
            then - start,
            f"now it takes {ratio:.2f} times as long, statements included",
        )


def main() -> None:
    """Measure and print."""
    statements = list(problems())
    count = len(statements)
    (unit, proved), (whole, decided), (basis, reduced) = interleaved(
        7, cofactors(), lambda: ours(statements), groebner()
    )
    line("ours, cofactors", unit, f"{proved} of {count} proved")
    line("ours, whole decisions, from terms", whole, f"{decided} of {count} proved")
    line("SymPy, groebner + reduced", basis, f"{reduced} of {count} proved; {basis / unit:,.0f} times our cofactors")
    seconds, shown = simplified(count)
    note = f"{shown} of {count} proved, {LIMIT:g} s each at most; {seconds / unit:,.0f} times our cofactors"
    line("SymPy, simplify on Euler angles", seconds, note)
    folder = kernels.folder() / "certificates"
    of_paper, of_all = (python("-m", "symcheck.checker", str(path)) for path in (folder / "mirer2009.json", folder))
    (start, _), (checked, _), (whole, _), (imported, _) = interleaved(
        9, python("-c", "pass"), of_paper, of_all, python("-c", "import sympy")
    )
    for what, seconds in (("of mirer2009", checked), ("of all papers", whole)):
        ratio = (seconds - start) / (imported - start)
        line(f"checker, all certificates {what}", seconds - start, f"{ratio:.2f} times as long as import sympy")
    line("import sympy", imported - start, "")
    typed_terms()


if __name__ == "__main__":
    main()
