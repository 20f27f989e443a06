"""One relation, or one kernel, in full."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from difflib import get_close_matches
from typing import TYPE_CHECKING

from symcheck import audit, papers
from symcheck.audit import check, kernels
from symcheck.core.ids import Id
from symcheck.core.verdicts import SymcheckError, Verdict
from symcheck.kernels.codegen.kernel import Kernel
from symcheck.ledger import Record
from symcheck.views import terminal

if TYPE_CHECKING:
    from symcheck.question.answer import General


def show(name: str, certificate: bool = False, records: Callable[[Iterable[str]], list[Record]] = check) -> None:
    """Print a relation as read, hypotheses, proof or counterexample, correction; or a kernel and what it rests on.

    Parameters
    ----------
    name
        "mirer2009:2.12" for a relation, "axial_moments" or "mirer2009:axial_moments" for a kernel.
    certificate
        Whether to print the whole certificate.
    records
        Where the records of a selection come from.

    Raises
    ------
    SymcheckError
        If there is neither such a relation nor such a kernel; the message has the nearest name.

    See Also
    --------
    symcheck.check : The same as records.
    """
    out = terminal.console()
    before, colon, _ = name.partition(":")
    keys = [before] if colon else list(papers.load())
    named = {known: (key, kernel) for key in keys for known, kernel in _named(key)}
    if ":" in name and name not in named:
        for n, record in enumerate(records([name])):
            out.print(end="\n" * (n > 0))
            terminal.show(out, record, certificate, _in_general(record))
        return
    if name not in named:
        every = (each for key in keys for each in audit.decide.expand(papers.load()[key]))
        near = [each.id for each in every if each.item.number == name]
        near = [f"{name}:NUMBER"] if name in keys else near or get_close_matches(name, named, n=1)
        meant = f"did you mean {' or '.join(near)}?" if near else "`symcheck check PAPER` lists the numbers of a paper"
        raise SymcheckError(f"{name!r} is neither of the form PAPER:NUMBER nor a kernel; {meant}")
    key, kernel = named[name]
    claims = records([str(Id.of(key, place)) for place in kernel.claims])
    terminal.kernel(out, key, name.rpartition(":")[2], kernel, claims)


def _in_general(record: Record) -> General | None:
    """The form for any value of a quantity that is printed as 1, if both are proved."""
    if record.verdict is not Verdict.PROVED or not record.dimension or not record.dimension.general:
        return None
    from symcheck.question.ask import decided_one
    from symcheck.question.general import of_relation

    return of_relation(record.id, decided_one)


def _named(key: str) -> Iterator[tuple[str, Kernel]]:
    """The kernels of a paper by name, without and with its key."""
    for name, kernel in kernels.declared(key).items():
        yield from ((name, kernel), (f"{key}:{name}", kernel))
