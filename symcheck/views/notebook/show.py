"""What the cells of the notebooks call: each function returns something that Jupyter displays, made from the records.

Verdicts, hypotheses and certificates come from records; derived expressions from a paper's `derivation.py`, which is
called here; numbers and figures from the numeric layer.
"""

from symcheck.views.notebook.derivations import derived, kernel, step
from symcheck.views.notebook.errata import errata, erratum, slips
from symcheck.views.notebook.ledgers import contents, ledger, not_proved
from symcheck.views.notebook.live import sliders
from symcheck.views.notebook.pictures import drawing, figure
from symcheck.views.notebook.readers import changed, exercise
from symcheck.views.notebook.relations import certificate, claim, proof, rows
from symcheck.views.notebook.results import fields, numbers

__all__ = [
    "certificate",
    "changed",
    "claim",
    "contents",
    "derived",
    "drawing",
    "errata",
    "erratum",
    "exercise",
    "fields",
    "figure",
    "kernel",
    "ledger",
    "not_proved",
    "numbers",
    "proof",
    "rows",
    "sliders",
    "slips",
    "step",
]
