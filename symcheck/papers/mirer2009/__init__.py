"""Mirer 2009: extremal relations between the elements of the inertia tensor of a rigid body."""

from symcheck.core.claims import Paper, Section
from symcheck.papers.mirer2009 import beyond, front, sec1, sec2, standing
from symcheck.papers.mirer2009.notation import notation

paper = Paper(
    key="mirer2009",
    title="S. A. Mirer, On some extremal relations between inertia tensor elements of a rigid body (2009)",
    source="000_52559675eaf93e59.txt",
    published="Keldysh Institute of Applied Mathematics, preprint 55, Moscow 2009, 14 pages",
    digest="403062539737113c",
    notation=notation,
    sections=(
        Section("S", "Standing conditions, not printed", standing),
        Section("0", "Abstract", front),
        Section("1", "The problem of model damping", sec1),
        Section("2", "Extremal relations between inertia tensor elements", sec2),
        Section("B", "Beyond the paper", beyond),
    ),
)
