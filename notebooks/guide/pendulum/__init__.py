"""The compound pendulum: a paper of one page, to show how one is added."""

from symcheck.core.claims import Paper, Section
from symcheck.papers.pendulum import sec1
from symcheck.papers.pendulum.notation import notation

paper = Paper(
    key="pendulum",
    title="The compound pendulum, an example",
    source="source.txt",
    notation=notation,
    sections=(Section("1", "The compound pendulum", sec1),),
)
