"""Steps of a derivation as cells show them: what a function returns, next to the printed form."""

from __future__ import annotations

import ast
import inspect
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from typing import Any

from symcheck.audit import kernels
from symcheck.core.claims import Assertion
from symcheck.core.counts import number_of
from symcheck.core.ids import Id
from symcheck.core.verdicts import SymcheckError
from symcheck.kernels.codegen.kernel import Kernel
from symcheck.reading import Notation
from symcheck.views.notebook import letters
from symcheck.views.notebook.output import Code, Heading, Math, Output, Part, Prose
from symcheck.views.notebook.records import item, notation, paper, recorded, records
from symcheck.views.notebook.relations import evidence, statement, title, verdicts

LONGEST = 24  # lines of a function that are shown


def step(derivation: Callable[..., object], *arguments: object, only: Sequence[str] = (), relation: str = "") -> Output:
    """What a function of a paper's derivation computes, next to the printed relation that is compared with it.

    only      names among the expressions, where there are many
    relation  its id
    """
    used = notation(relation) if relation else paper(derivation.__module__.split(".")[-2]).notation
    found = records(relation) if relation else ()
    compared = list(statement(found, reread=False)) if found else []
    formulas = [part for part in compared if isinstance(part, Math)]
    parts: list[Part] = [
        Heading(f"`derivation.{derivation.__name__}({', '.join(map(repr, arguments))})`"),
        Prose("", " ".join((derivation.__doc__ or "").split("\n\n")[0].split())),
        Code("", source(derivation)),
        Math("derived", letters.aligned(_rows(derivation(*arguments), only, used))),
        *formulas,
        *(part for part in compared if part not in formulas),
    ]
    if found:
        parts += [Heading(f"{title(found[0], whole=len(found) > 1)} — {verdicts(found)}"), *evidence(found)]
    return Output(tuple(parts))


def source(derivation: Callable[..., object]) -> str:
    """How a function derives: its lines without decorators and docstring, the first ones of many."""
    lines = inspect.getsource(inspect.unwrap(derivation)).splitlines()
    [function] = ast.parse("\n".join(lines)).body
    assert isinstance(function, ast.FunctionDef)
    says = function.body[0]
    head, end = lines[function.lineno - 1 : says.lineno - 1], says.end_lineno or says.lineno
    shown = [*head, *lines[end:]] if ast.get_docstring(function) else lines[function.lineno - 1 :]
    more = len(shown) - LONGEST
    return "\n".join(shown if more <= 0 else [*shown[:LONGEST], f"    # and {number_of(more, 'more line')}"])


def derived(id: str, only: Sequence[str] = ()) -> Output:
    """The same for the derivation that a relation itself declares; SymcheckError if it declares none."""
    found = item(id)
    declared = (found.plan.where or found.statement.equation) if isinstance(found, Assertion) else None
    if declared is None:
        raise SymcheckError(f"{id} declares no derivation; show it with claim")
    function, arguments = (declared.func, declared.args) if isinstance(declared, partial) else (declared, ())
    return step(function, *arguments, only=only, relation=id)


def _rows(derived: Any, only: Sequence[str], used: Notation) -> list[str]:
    if isinstance(derived, Mapping):
        return letters.equations({name: derived[name] for name in only or derived}, used)
    return letters.expressions(derived if isinstance(derived, tuple) else (derived,), used)


def kernel(key: str, name: str) -> Output:
    """What a generated kernel computes, and the relations on which it rests, with their recorded verdicts."""
    found = kernels.declared(key)[name]
    derived = found.derived()
    outputs = {output.name: derived[output.name] for output in found.outputs}
    parts = (
        Heading(f"`kernels.load({key!r}).{name}`"),
        Prose("", found.says),
        Math("generated from", letters.aligned(letters.equations(outputs, paper(key).notation))),
        Prose("rests on", ", ".join(_rests(key, found))),
    )
    return Output(parts)


def _rests(key: str, declared: Kernel) -> Iterator[str]:
    verdicts = recorded(key)
    for number in declared.claims:
        rests = Id.of(key, number)
        links = [id for id in verdicts if rests.has(id)]
        yield f"{rests} ({', '.join(sorted({str(verdicts[id]) for id in links}))})"
