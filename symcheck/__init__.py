"""symcheck: audits the printed equations of mechanics papers and says of each: proved, refuted or undecided.

`check`, `errata` and `show` are the audit, `papers.load()` the papers, `kernel` a generated function for arrays; the
other names declare papers and read records. Each is imported when it is first used.
"""

TYPE_CHECKING = False  # as in `typing`, whose import would delay every start

if TYPE_CHECKING:
    from symcheck import papers
    from symcheck.audit.library import check, errata
    from symcheck.core.claims import Declaration, Erratum, Hypothesis, Paper, Section
    from symcheck.core.verdicts import Group, Origin, Reading, Role, SymcheckError, Verdict
    from symcheck.document.look import Look, look
    from symcheck.ledger.record import Record
    from symcheck.numeric.chunked.kernels import kernel
    from symcheck.papers.declare import claim, definition, exclusion, ours, premise
    from symcheck.question.answer import Answer
    from symcheck.question.ask import decide
    from symcheck.reading import Letter, Notation
    from symcheck.views.show import show

__version__ = "0.1.0"

__all__ = [
    "Answer",
    "Declaration",
    "Erratum",
    "Group",
    "Hypothesis",
    "Letter",
    "Look",
    "Notation",
    "Origin",
    "Paper",
    "Reading",
    "Record",
    "Role",
    "Section",
    "SymcheckError",
    "Verdict",
    "check",
    "claim",
    "decide",
    "definition",
    "errata",
    "exclusion",
    "kernel",
    "look",
    "ours",
    "papers",
    "premise",
    "show",
]

_HOMES = {
    "audit.library": ("check", "errata"),
    "core.claims": ("Declaration", "Erratum", "Hypothesis", "Paper", "Section"),
    "core.verdicts": ("Group", "Origin", "Reading", "Role", "SymcheckError", "Verdict"),
    "document.look": ("Look", "look"),
    "ledger.record": ("Record",),
    "numeric.chunked.kernels": ("kernel",),
    "papers.declare": ("claim", "definition", "exclusion", "ours", "premise"),
    "question.answer": ("Answer",),
    "question.ask": ("decide",),
    "reading": ("Letter", "Notation"),
    "views.show": ("show",),
}


def __getattr__(name: str) -> object:
    """A public name, imported at its first use."""
    from symcheck.core.lazy import public

    return public(__name__, _HOMES, name)


def __dir__() -> list[str]:
    return [*globals(), *__all__]
