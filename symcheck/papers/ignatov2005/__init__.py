"""Ignatov, Davydov, Sazonov 2005: the momentum envelopes of two arrays of reaction wheels."""

from symcheck.core.claims import Paper, Section
from symcheck.papers.ignatov2005 import beyond, drawings, lists, sec1, sec2, sec3, standing
from symcheck.papers.ignatov2005.notation import notation

paper = Paper(
    key="ignatov2005",
    title="A. I. Ignatov, A. A. Davydov, V. V. Sazonov, The analysis of dynamic capabilities of the control systems of "
    "a small spacecraft built on the basis of reaction wheels (2005)",
    source="004_745ca85746c95545.txt",
    published="Keldysh Institute of Applied Mathematics, Moscow 2005",
    digest="3f49f24d7fb68ae6",
    notation=notation,
    sections=(
        Section("S", "Standing conditions, not printed", standing),
        Section("1", "Actuators", sec1),
        Section("2", "Four-sided pyramid", sec2),
        Section("3", "Six-sided pyramid", sec3),
        Section("L", "Lists and tables of coordinates", lists),
        Section("D", "Figures, and letters that change their meaning", drawings),
        Section("B", "Beyond the paper", beyond),
    ),
)
