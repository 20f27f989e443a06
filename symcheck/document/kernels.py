"""A kernel from an audited relation: what a letter is, as it is printed, becomes a function of arrays."""

from __future__ import annotations

from collections.abc import Mapping

from symcheck.core.calculus import functions
from symcheck.core.claims import Declaration
from symcheck.core.verdicts import SymcheckError
from symcheck.document.asked import Inquiry
from symcheck.document.letters import shown
from symcheck.kernels.codegen.kernel import Argument, Kernel, Output
from symcheck.question.prepare import Asked, plainly, readings
from symcheck.reading import Notation, to_sympy

Domain = Mapping[str, tuple[str, str]]


def kernel(
    relation: Declaration, link: str, says: str, notation: Notation, domain: Domain, *, ulp: int, condition: str
) -> Kernel:
    """The right side of an equation that says what a letter is, as a kernel; SymcheckError if there is none."""
    letter, term, letters = _equation(relation, link)
    value = to_sympy(term)  # type: ignore[arg-type]
    used = {str(symbol) for symbol in value.free_symbols}
    if unknown := sorted({*domain} - {latex for name, latex in letters.items() if name in used}):
        raise SymcheckError(f"{relation.number}: {unknown[0]} is no argument of what is printed there")
    known = {shown(each.latex): each for each in notation.letters}

    def told(latex: str) -> tuple[str, str]:
        said = known.get(latex)
        return (said.meaning or latex, said.unit or "1") if said else (latex, "1")

    arguments = [
        Argument(name, *told(latex), *domain.get(latex, ("", ""))) for name, latex in letters.items() if name in used
    ]
    return Kernel(
        says=says,
        arguments=tuple(arguments),
        outputs=(Output(letter, *told(letters[letter])),),
        derived=lambda: {letter: value},
        claims=(relation.number + link,),
        ulp=ulp,
        condition=condition,
    )


def _equation(relation: Declaration, link: str) -> tuple[str, object, dict[str, str]]:
    """The letter on the left side of a link, the term on its right side, and the letters by their names."""
    asked = relation.question
    if not isinstance(asked, Inquiry):
        raise SymcheckError(f"{relation.number} is not of a source; a kernel is made of a relation of the source")
    if (text := asked.links.get(link)) is None:
        raise SymcheckError(f"{relation.number} has no link {link!r}; it has {', '.join(map(repr, asked.links))}")
    found = {}
    for reading in readings(plainly(Asked(text, letters=asked.said(text)))):
        claims = [problem.claim for problem in reading.problems]
        letters = {g.letter.name: shown(g.letter.latex) for g in reading.inference.guesses if g.letter.name}
        for claim in claims:
            if len(claims) > 1 or claim.tag != "=" or claim[1] not in letters or functions(claim):
                raise SymcheckError(
                    f"{relation.number}: a kernel is made of `letter = formula` of numbers; {text} is not"
                )
            found[claim] = claim[1], claim[2], letters
    if len(found) != 1:
        raise SymcheckError(f"{relation.number}: {text} has {len(found)} readings; say what its letters are")
    return next(iter(found.values()))
