"""Esenkov 2006: stability of a spinning symmetric body with an ideal liquid, two damaged texts of one derivation."""

from symcheck.core.claims import Paper, Section
from symcheck.papers.esenkov2006 import beyond, comparison, first_text, modes, second_text, standing
from symcheck.papers.esenkov2006.notation import notation

paper = Paper(
    key="esenkov2006",
    title="A. S. Esenkov, Models of optimal control of rotating rigid bodies with liquid filling (2006)",
    source="002_df6bd28b8c88dd7c.txt",
    published="thesis, 2006, pages 29, 34 and 35 as a comparison of two texts shows them",
    digest="4426f0e76a10466b",
    notation=notation,
    excerpt=True,
    sections=(
        Section("S", "Standing conditions, not printed", standing),
        Section("2", "Page 29: the freely spinning body with ideal liquid", first_text),
        Section("1.4.1", "Pages 34-35: necessary condition of stability for ideal liquid", second_text),
        Section("C", "The two texts compared", comparison),
        Section("B", "Beyond the paper: one mode", beyond),
        Section("N", "Beyond the paper: several modes", modes),
    ),
)
