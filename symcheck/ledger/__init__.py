"""What an audit leaves: a record for each relation, and the files below generated/."""

from symcheck.ledger.digests import digest, digest_of, line
from symcheck.ledger.lemmas import lemmas_of, reached
from symcheck.ledger.record import Correction, Edit, HypothesisRow, Later, Need, Record, Repair, by_paper

__all__ = [
    "Correction",
    "Edit",
    "HypothesisRow",
    "Later",
    "Need",
    "Record",
    "Repair",
    "by_paper",
    "changes",
    "digest",
    "digest_of",
    "lemmas_of",
    "line",
    "reached",
    "selftested",
    "store",
]
