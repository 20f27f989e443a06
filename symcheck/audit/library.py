"""The audit as a function: the records of a selection, from the cache where it has them, else decided."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING

from symcheck.audit.executor import Executor, Pool, Serial

if TYPE_CHECKING:
    from symcheck.audit.run import Progress
    from symcheck.ledger import Record

PRELOAD = ("sympy", "flint", "symcheck.audit.decide")  # what takes a worker long to import


def check(
    selection: Iterable[str] | str = (),
    *,
    jobs: int = 0,
    timeout: float = 60.0,
    cache: bool = True,
    weigh: bool = True,
    progress: Progress = lambda done, total: None,
    warn: Callable[[str], None] = warnings.warn,
) -> list[Record]:
    """Decide the relations of a selection, and have the checker accept every certificate.

    Parameters
    ----------
    selection
        "mirer2009" for a paper, "mirer2009:2.12" for a relation with its links, or several of these; nothing means all
        papers.
    jobs
        Worker processes; 0 decides in this process, without a time limit. With workers a script needs
        ``if __name__ == "__main__"``, as they import it.
    timeout
        Seconds that one declaration may take in a worker; after that it is undecided.
    cache
        Whether to use results decided before, and to keep new ones.
    weigh
        Whether to decide, too, which hypotheses each proof needs, which takes half as long again.
    progress
        Called with the numbers of declarations that are decided and that are wanted.
    warn
        Called with a line if something is wrong with the cache.

    Returns
    -------
    list of Record
        One for each relation, in printed order, with verdict, certificates, counterexample and correction.

    Raises
    ------
    SymcheckError
        If the selection names nothing; the message has the nearest names.
    Interrupted
        A KeyboardInterrupt with the records decided so far.

    See Also
    --------
    errata : The records of what is wrong as printed.
    show : A relation in full, as text.

    Examples
    --------
    >>> [(record.id, str(record.verdict)) for record in check("mirer2009:2.1.2")]
    [('mirer2009:2.1.2', 'refuted')]
    """
    from symcheck.audit import decide, run
    from symcheck.audit.cache import Cache, location
    from symcheck.papers import load

    papers = load()
    kept = Cache(location() if cache else None, warn)
    try:
        return run.audit(
            [selection] if isinstance(selection, str) else [*selection],
            papers=papers,
            decide=decide,
            cache=kept,
            executor=executor(jobs, [f"symcheck.papers.{key}" for key in papers.built_in]),
            timeout=timeout,
            weigh=weigh,
            progress=progress,
        )
    finally:
        kept.close()


def executor(jobs: int, modules: Sequence[str]) -> Executor:
    """This process, or workers that start with the provers and these modules."""
    return Pool(jobs, (*PRELOAD, *modules)) if jobs else Serial()


def errata(selection: Iterable[str] | str = ()) -> list[Record]:
    """The records of what is wrong as printed, or damaged, each with its correction.

    Parameters
    ----------
    selection
        As of `check`.

    Returns
    -------
    list of Record
        In printed order; `Record.group` says how weighty an erratum is.

    Examples
    --------
    >>> [record.id for record in errata(["mirer2009:2.12", "mirer2009:2.1.2"])]
    ['mirer2009:2.1.2']
    """
    return [record for record in check(selection, weigh=False) if record.is_erratum]
