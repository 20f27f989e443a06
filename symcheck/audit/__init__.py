"""From declarations to verdicts: what there is to decide, deciding, and the check of every certificate."""

TYPE_CHECKING = False  # as in `typing`; the names are imported when they are first used

if TYPE_CHECKING:
    from symcheck.audit.cache import Cache
    from symcheck.audit.checked import accepted, reasons
    from symcheck.audit.context import Context, context_of
    from symcheck.audit.executor import Crash, Done, Executor, Serial, Timeout
    from symcheck.audit.index import Index
    from symcheck.audit.judge import Finding, Unit, equality_claims, units
    from symcheck.audit.library import check, errata
    from symcheck.audit.obligation import Obligation, expand, fingerprint, obligation_of
    from symcheck.audit.repair import differences
    from symcheck.audit.run import Interrupted

__all__ = [
    "Cache",
    "Context",
    "Crash",
    "Done",
    "Executor",
    "Finding",
    "Index",
    "Interrupted",
    "Obligation",
    "Serial",
    "Timeout",
    "Unit",
    "accepted",
    "cache",
    "check",
    "context_of",
    "decide",
    "differences",
    "dimensions",
    "equality_claims",
    "errata",
    "expand",
    "fingerprint",
    "judge",
    "kernels",
    "library",
    "needs",
    "obligation_of",
    "outputs",
    "reasons",
    "run",
    "units",
]

_HOMES = {
    "cache": ("Cache",),
    "checked": ("accepted", "reasons"),
    "context": ("Context", "context_of"),
    "executor": ("Crash", "Done", "Executor", "Serial", "Timeout"),
    "index": ("Index",),
    "judge": ("Finding", "Unit", "equality_claims", "units"),
    "library": ("check", "errata"),
    "obligation": ("Obligation", "expand", "fingerprint", "obligation_of"),
    "repair": ("differences",),
    "run": ("Interrupted",),
}


def __getattr__(name: str) -> object:
    """A public name, imported at its first use."""
    from symcheck.core.lazy import public

    return public(__name__, _HOMES, name)


def __dir__() -> list[str]:
    return [*globals(), *__all__]
