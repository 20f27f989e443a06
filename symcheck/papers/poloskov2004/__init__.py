"""Poloskov 2004: rotation of a rigid body under dissipative and random torques."""

from symcheck.core.claims import Paper, Section
from symcheck.papers.poloskov2004 import beyond, front, sec1, sec2, sec3, sec4, standing
from symcheck.papers.poloskov2004.notation import notation

paper = Paper(
    key="poloskov2004",
    title="I. E. Poloskov, On the rotation of a rigid body under dissipative and random torques (2004)",
    source="001_dec306ec7e285669.txt",
    published="2004; the text at hand names no journal and no pages",
    digest="5e468bfc8295254b",
    notation=notation,
    sections=(
        Section("S", "Standing conditions, not printed", standing),
        Section("0", "Abstract", front),
        Section("1", "Introduction", sec1),
        Section("2", "Change of variables", sec2),
        Section("3", "The Fokker-Planck-Kolmogorov equation and its solution", sec3),
        Section("4", "Analysis of the results", sec4),
        Section("B", "Beyond the paper", beyond),
    ),
)
