"""What the cells of the notebooks call: each function returns something that Jupyter displays, made from the records.

Verdicts, hypotheses and certificates come from records; derived expressions from a paper's `derivation.py`, which is
called here; numbers and figures from the numeric layer.
"""

from symcheck.notebook.derivations import derived, kernel, step
from symcheck.notebook.errata import errata, erratum, slips
from symcheck.notebook.ledgers import contents, ledger, not_proved
from symcheck.notebook.pictures import drawing, figure
from symcheck.notebook.relations import certificate, claim, proof, rows
from symcheck.notebook.results import fields, numbers

__all__ = [
    "certificate",
    "claim",
    "contents",
    "derived",
    "drawing",
    "errata",
    "erratum",
    "fields",
    "figure",
    "kernel",
    "ledger",
    "not_proved",
    "numbers",
    "proof",
    "rows",
    "slips",
    "step",
]
