"""Counts in words: "1 relation", "2 relations"."""

from __future__ import annotations


def number_of(count: int, noun: str, nouns: str = "") -> str:
    """A count and what is counted; `nouns` is the plural where it is not formed with an s.

    >>> number_of(1, "relation"), number_of(2_000, "relation"), number_of(3, "question was", "questions were")
    ('1 relation', '2,000 relations', '3 questions were')
    """
    return f"{count:,} {noun if count == 1 else nouns or f'{noun}s'}"
