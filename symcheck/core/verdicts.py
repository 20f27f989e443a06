"""What can be said of a relation and of an erratum, and the error that is told to people."""

from __future__ import annotations

from enum import StrEnum


class SymcheckError(Exception):
    """Bad input or a damaged file, told in one line that names the input and the way out."""


class NoForm(SymcheckError):
    """What is understood, but cannot be expressed in terms: a limit, a set, a matrix exponential."""


class Unsaid(SymcheckError):
    """What is read, but has no value before more is said: of what kind letters are, or on what they depend."""


class Doubt(SymcheckError):
    """What may be meant in two ways, of which print tells neither: no other reading settles it."""


class Loss(StrEnum):
    """What is lost with a hypothesis."""

    TRUTH = "the relation fails"
    VALUE = "a term has no value"
    EXISTENCE = "nothing of the kind exists"


class Verdict(StrEnum):
    """What the machine says of a relation: proved, refuted, or neither."""

    PROVED = "proved"
    REFUTED = "refuted"
    UNDECIDED = "undecided"


class Role(StrEnum):
    """What a declaration is in a ledger. Claims and our own statements are decided; the others claim nothing."""

    CLAIM = "claim"
    DEFINITION = "definition"
    PREMISE = "premise"
    EXCLUSION = "exclusion"
    OURS = "ours"


class Reading(StrEnum):
    """How a relation comes from the paper: from its formulas, from its words, or not at all."""

    AS_PRINTED = "as printed"
    WORDS = "from the words"
    ADDED = "added by us"
    STANDING = "standing condition"
    MISPRINT = "misprint"
    NEEDS_HYPOTHESIS = "needs hypothesis"
    DAMAGED = "damaged source"
    STATED = "stated by the auditor"
    REWRITTEN = "rewritten"


class Group(StrEnum):
    """Errata in the order in which a reviewer wants them."""

    STATEMENT = "formulas and statements"
    ROW = "list rows and table cells"
    SLIP = "slips that mislead nobody"
    DAMAGED = "damaged text, read otherwise"


SLIPS = frozenset({"lost prime", "lost letter", "typography", "rounding"})


class Origin(StrEnum):
    """Whose fault an error is: the paper's, the digitisation's, or nobody can tell."""

    PAPER = "paper"
    OCR = "OCR"
    UNCERTAIN = "cannot tell"
