"""One relation, or one kernel, in full."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from difflib import get_close_matches

from symcheck.audit import check, kernels
from symcheck.core.ids import Id
from symcheck.core.verdicts import SymcheckError
from symcheck.ledger import Record
from symcheck.papers import load
from symcheck.views import terminal


def show(name: str, certificate: bool = False, records: Callable[[Iterable[str]], list[Record]] = check) -> None:
    """Print a relation as read, hypotheses, proof or counterexample, correction; or a kernel and what it rests on.

    Parameters
    ----------
    name
        "mirer2009:2.12" for a relation, "axial_moments" for a kernel.
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
    if ":" in name:
        for record in records([name]):
            terminal.show(out, record, certificate)
        return
    keys = list(load())
    named = {known: (key, kernel) for key in keys for known, kernel in kernels.declared(key).items()}
    if name not in named:
        near = get_close_matches(name, named, n=1)
        example = f"{name}:NUMBER" if name in keys else near[0] if near else f"{keys[0]}:{name}"
        raise SymcheckError(f"{name!r} is neither of the form PAPER:NUMBER nor a kernel; did you mean {example}?")
    key, kernel = named[name]
    terminal.kernel(out, key, name, kernel, records([str(Id.of(key, place)) for place in kernel.claims]))
