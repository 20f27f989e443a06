"""Is it right, and what the words mean that stand beside a verdict: the verdict itself, roles, readings, methods."""

from __future__ import annotations

from symcheck.core.verdicts import Origin, Reading, Role, Verdict
from symcheck.views.model import Relation

COQ = "Coq"
METHODS = {
    "identity": "the difference of the two sides is a sum of multiples of what is given, so it vanishes",
    "nonnegative": "the larger side less the smaller is written as a sum of terms none of which can be negative",
    "cases": "the alternatives are gone through one by one, each with a proof of its own",
    "existence": "what is said to exist is written down, and shown to do what is said of it",
    "theorems": "theorems of a fixed table are applied, each with its premises proved; Coq has proofs of the theorems",
}
MEANINGS = {
    Verdict.PROVED: "it follows from the hypotheses listed, wherever its terms have values; a certificate shows it",
    Verdict.REFUTED: "it fails at an exact point that satisfies the hypotheses; a certificate shows it",
    Verdict.UNDECIDED: "neither a proof nor a point where it fails was found; it may be either",
    **METHODS,
    Role.CLAIM: "the paper asserts it, so it is decided",
    Role.DEFINITION: "the paper says what a letter means; it can be neither true nor false",
    Role.PREMISE: "the paper assumes, chooses or cites it; nothing is decided of it",
    Role.EXCLUSION: "it is printed, but asserts nothing that could be decided",
    Role.OURS: "the paper does not print it; we state it beside the paper's relations, and it is decided",
    COQ: "whether Coq, an independent proof assistant, accepts the proof, or that of the correction",
    Reading.AS_PRINTED: "what is decided was read from the printed formula, sign by sign",
    Reading.WORDS: "the paper says it in words; the formula that is decided was put together from them by us",
    Reading.ADDED: "nothing of it is printed",
    Reading.STANDING: "read as printed; the proof uses a condition that the paper never prints because the subject "
    "implies it, such as a positive mass",
    Reading.MISPRINT: "read as printed, and wrong so; what is right is given",
    Reading.NEEDS_HYPOTHESIS: "wrong as printed, and right under a condition that the paper does not print",
    Reading.DAMAGED: "the characters of the text at hand say nothing, or something else than was meant; it is said "
    "what is read instead",
    Reading.STATED: "stated by the auditor of this document, not read from it",
    Reading.REWRITTEN: "read with what the auditor wrote in place of what is printed",
}

RIGHT = {
    Reading.AS_PRINTED: "Right as printed",
    Reading.STANDING: "Right as printed, under a condition that the subject implies",
    Reading.WORDS: "Right: the paper states it in words, and the formula that we made of them is proved",
    Reading.ADDED: "Right, but not part of the paper: we added it",
    Reading.DAMAGED: "Right as it is read here: the text at hand is damaged",
    Reading.MISPRINT: "Right as it is meant, but misprinted",
}
FAULT = {
    Origin.PAPER: "The fault is the paper's own",
    Origin.OCR: "The fault lies in the digitised text, not in the paper",
    Origin.UNCERTAIN: "The text at hand does not tell whether the paper or its digitisation is at fault",
}


def answer(relation: Relation) -> str:
    """Is it right, under what, and if not, whose fault is it: in one or two sentences."""
    record, conditions = relation.record, len(relation.conditions)
    if record.verdict is Verdict.PROVED:
        right = RIGHT.get(record.reading, f"Right as {record.reading}")
        given = (
            f", given the {'hypothesis' if conditions == 1 else f'{conditions} hypotheses'} below" if conditions else ""
        )
        return f"{right}{given}."
    if record.verdict is Verdict.REFUTED:
        how = record.reading if record.reading in (Reading.STATED, Reading.REWRITTEN) else ""
        # What the digitisation spoilt is not what the paper prints.
        printed = "it stands in the digitised text" if record.origin is Origin.OCR else "printed"
        wrong = f"Wrong as {how or (printed if record.printed else 'the words state it')}"
        mended = (
            "; what is right instead is proved" if record.erratum and record.erratum.verdict == Verdict.PROVED else ""
        )
        fault = f" {FAULT[record.origin]}." if record.origin else ""
        return f"{wrong}: it fails at the exact point below{mended}.{fault}"
    return f"Not decided: {MEANINGS.get(record.verdict or record.role, '')}."
