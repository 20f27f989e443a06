r"""Plain letters beside bold ones: `u_1` beside `\mathbf{u}` is its component, `r` beside `\mathbf{r}` its length.

Texts rely on this without a word. So such letters are not taken for independent numbers where another reading stands.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace

from symcheck.reading.evidence import spellings

# a bold letter, and its subscript
_BOLD = re.compile(r"\\(?:mathbf|boldsymbol|bm|pmb|vec|overrightarrow)\{(\\?[A-Za-z]+)\}(?:_(.+))?")
# a bold lower-case letter with a hat: a unit vector
_UNIT = re.compile(r"\\(?:hat|widehat)\{\\(?:mathbf|boldsymbol|bm|pmb|vec)\{\\?[a-z]")
_NAMES = (("x", "y", "z"), ("1", "2", "3", "4", "5", "6"))  # of components
_OF_QUATERNIONS = (("w", "x", "y", "z"), ("0", "1", "2", "3"))  # with the scalar part
_LISTED = re.compile(r"(?:\\left)?[(\[]|\\begin\{[bBp]?matrix\}")  # how a list of components begins
_ENTRY = re.compile(r"(.+)_\{(\d)(\d)\}")  # an entry of a matrix: "a_{12}"


@dataclass(frozen=True, slots=True)
class Relatives:
    """What plain letters are to bold ones.

    Parameters
    ----------
    components
        For vectors and matrices the LaTeX of their components in other letters.
    entries
        The letters of these, present or not.
    lengths
        By plain letters, the vectors whose lengths they are.
    units
        The vectors with a hat, whose length is 1.
    others
        The LaTeX of components that are as likely, for vectors that may be quaternions.
    """

    components: dict[str, str]
    entries: dict[str, str]
    lengths: dict[str, str]
    units: list[str]
    others: dict[str, str]

    def __bool__(self) -> bool:
        return bool(self.components or self.lengths or self.units)

    @property
    def readings(self) -> Iterator[Relatives]:
        """This one, and the one with the other components."""
        yield self
        if self.others:
            yield replace(self, components={**self.components, **self.others}, others={})

    def told(self, bold: Iterable[str]) -> Iterator[str]:
        """The components of some vectors, in words."""
        return (f"{each} is {self.components.get(each, 'without printed components')}" for each in bold)

    @property
    def facts(self) -> tuple[str, ...]:
        """What is so of them, in LaTeX."""
        lengths = (rf"{plain} = \|{bold}\|" for plain, bold in self.lengths.items())
        return (*lengths, *(rf"\|{unit}\| = 1" for unit in self.units))


def relatives(
    letters: Collection[str],
    free: Collection[str],
    varying: Collection[str],
    solved: Collection[str],
    formulas: Sequence[str] = (),
) -> Relatives:
    r"""The relatives of the bold letters.

    Parameters
    ----------
    letters
        All letters by their spellings, those with running indices as "a 2".
    free
        Those of which nothing is said, which no equation defines, and which are not differentiated.
    varying
        These, and those that are differentiated, which may be lengths.
    solved
        Bold letters that an equation defines.
    formulas
        All formulas: a vector of which one prints all components has no others.
    """
    found = Relatives({}, {}, {}, [], {})
    for bold in letters:
        if _UNIT.match(bold) and bold in free:
            found.units.append(bold)
        match = _BOLD.fullmatch(bold)
        if match is None or bold not in varying:
            continue
        base, script = match[1], (match[2] or "").strip("{}")
        listed = [right for each in formulas if (right := _listed(each, bold))] if bold in solved else []
        plain = f"{base}_{match[2]}" if match[2] else base
        if plain in varying and not any(plain in spellings(right) for right in listed):
            found.lengths[plain] = bold
        if (bold not in free and bold not in solved) or listed:
            continue
        for parts in _components(base, script, letters, least=1 if bold in solved else 2):
            found.components[bold] = _matrix([part] for part in parts)
            if f"{base} 1" not in letters:
                found.entries.update(dict.fromkeys(parts, bold))
        for names in _OF_QUATERNIONS if not script else ():
            parts = [f"{base}_{name}" for name in names]
            if parts[0] in letters and sum(part in letters for part in parts) > 2:
                found.others[bold] = _matrix([part] for part in parts)
                found.entries.update(dict.fromkeys(parts, bold))
        if base.isupper() and not script and (size := _size(base, letters)):
            name, n = size
            rows = [[f"{name}_{{{k}{m}}}" for m in range(1, n + 1)] for k in range(1, n + 1)]
            found.components[bold] = _matrix(rows)
            found.entries.update(dict.fromkeys((each for row in rows for each in row), bold))
    return found


def _listed(formula: str, bold: str) -> str:
    r"""What a formula says the components of a vector are, as in `\mathbf{q} = (q_w, q_x, q_y, q_z)`; "" if nothing."""
    left, _, right = formula.partition("=")
    return right if "".join(left.split()) == bold.replace(" ", "") and _LISTED.match(right.replace(" ", "")) else ""


def _matrix(rows: Iterable[Sequence[str]]) -> str:
    body = r" \\ ".join(" & ".join(row) for row in rows)
    return rf"\begin{{pmatrix}} {body} \end{{pmatrix}}"


def _components(base: str, script: str, letters: Collection[str], least: int) -> Iterator[list[str]]:
    """The names of all components of a vector of which so many are printed at least."""
    for names in _NAMES:
        spelled = [f"{base}_{{{script}{name}}}" if script else f"{base}_{name}" for name in names]
        printed = [k for k, each in enumerate(spelled) if each in letters]
        if f"{base} 1" in letters and names[0] == "1" and not script:
            yield spelled[:3]
        elif len(printed) >= least:
            yield spelled[: max(printed[-1] + 1, 3 if least == 1 else 2)]


def _size(base: str, letters: Collection[str]) -> tuple[str, int] | None:
    """The letter of the entries of a matrix, and the number of its rows, as far as entries are printed."""
    for name in (base, base.lower()):
        indices = [
            int(n) for each in letters for m in [_ENTRY.fullmatch(each)] if m and m[1] == name for n in m.groups()[1:]
        ]
        if indices:
            return name, max(indices)
    return None
