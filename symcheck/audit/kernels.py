"""Kernels and what they rest on: one is written only if its claims, and the equality of its forms, are proved."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from importlib import import_module
from importlib.util import find_spec

from symcheck import papers
from symcheck.audit.checked import NOT_ACCEPTED, reasons
from symcheck.core.certificates import Certificate
from symcheck.core.claims import Paper
from symcheck.core.formulas import conjuncts
from symcheck.core.ids import Id
from symcheck.core.problems import Applied, Problem
from symcheck.core.terms import node
from symcheck.core.verdicts import SymcheckError, Verdict
from symcheck.kernels.codegen.kernel import Kernel
from symcheck.kernels.codegen.program import Program, compiled
from symcheck.kernels.codegen.target import CompiledKernel
from symcheck.ledger import Record, digest_of
from symcheck.proof import certificate, identity
from symcheck.reading import from_sympy, lower, read


def declared(key: str) -> dict[str, Kernel]:
    """The kernels of a paper by name, in the order of declaration: those beside its relations, and its `kernels.py`."""
    if key not in papers.load():
        return {}
    papers.load()[key]  # a user's file is a module from now on
    name = f"symcheck.papers.{key}"
    modules = [each for each in (name, f"{name}.kernels") if find_spec(name) and find_spec(each)]
    found = (pair for each in modules for pair in vars(import_module(each)).items())
    return {name: value for name, value in found if isinstance(value, Kernel)}


def programs(kernel: Kernel) -> tuple[Program, Program]:
    """What is computed for many points, and for few: the accurate forms where there are any."""
    derived = kernel.derived()
    outputs = {output.name: derived[output.name] for output in kernel.outputs}
    outputs |= kernel.accurate() if kernel.accurate else {}
    angles = [argument.name for argument in kernel.arguments if argument.acute]
    inputs = [argument.name for argument in kernel.arguments]
    return compiled(inputs, outputs, angles), compiled(inputs, outputs)


def compiled_kernels(paper: Paper, records: Iterable[Record]) -> tuple[dict[str, CompiledKernel], list[Certificate]]:
    """The kernels of a paper by name, as targets write them, and the certificates of their accurate forms."""
    known, kernels, proofs = {record.id: record for record in records}, {}, []
    for name, kernel in declared(paper.key).items():
        equal = list(equalities(paper, name, kernel))
        claims = dict(_claims(paper, name, kernel, known))
        kernels[name] = CompiledKernel(kernel, *programs(kernel), claims, digest(equal) if equal else "")
        proofs += equal
    return kernels, proofs


def equalities(paper: Paper, name: str, kernel: Kernel) -> Iterator[Certificate]:
    """The certificates that the accurate forms equal the derived ones."""
    derived, forms = kernel.derived(), kernel.accurate() if kernel.accurate else {}
    given = tuple(
        (each.name, tuple(p for f in lower(read(each.states, paper.notation), paper.notation) for p in conjuncts(f)))
        for each in kernel.given
    )
    for output, form in forms.items():
        sides = from_sympy(derived[output]), from_sympy(form)
        problem = Problem(f"{paper.key}:{name}.{output}", node("=", *sides), (), given)
        outcome = identity.decide(problem)
        if outcome.verdict is Verdict.UNDECIDED:
            outcome = identity.decide(replace(problem, hints=(Applied("equal_squares", sides),)))
        if outcome.verdict is not Verdict.PROVED:
            why = outcome.reason or outcome.verdict
            raise SymcheckError(f"{problem.id}: the accurate form is not proved equal to the derived one ({why})")
        proof = certificate(problem, outcome)
        if refused := reasons([proof])[0]:
            raise SymcheckError(f"{problem.id}: {NOT_ACCEPTED} ({refused})")
        yield proof


def _claims(paper: Paper, name: str, kernel: Kernel, known: Mapping[str, Record]) -> Iterator[tuple[str, str]]:
    """The relations that a kernel rests on, each with the digest of its certificates."""
    for place in kernel.claims:
        id = Id.of(paper.key, place)
        links = [record for record in known.values() if id.has(record.id)]
        wrong = [record for record in links if record.verdict is not Verdict.PROVED]
        if wrong or not links:
            state = f"{wrong[0].id}, which is {wrong[0].verdict}" if wrong else f"{id}, which is not declared"
            raise SymcheckError(f"kernel {name} rests on {state}; only what is proved is generated")
        yield str(id), digest(c for record in links for c in record.certificates)


def digest(certificates: Iterable[Certificate]) -> str:
    """A short name of some certificates: the beginning of the SHA-256 of their digests."""
    text = " ".join(map(digest_of, certificates))
    return hashlib.sha256(text.encode()).hexdigest()[:12]
