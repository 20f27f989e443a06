r"""Plain letters beside bold ones: `u_1` beside `\mathbf{u}` is its component, `r` beside `\mathbf{r}` its length.

Texts rely on this without a word. So such letters are not taken for independent numbers where another reading stands.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from types import MappingProxyType

from symcheck.reading.evidence import spellings

# a bold letter, and its subscript
_BOLD = re.compile(r"\\(?:mathbf|boldsymbol|bm|pmb|vec|overrightarrow)\{(\\?[A-Za-z]+)\}(?:_(.+))?")
# a bold lower-case letter with a hat: a unit vector
_UNIT = re.compile(r"\\(?:hat|widehat)\{\\(?:mathbf|boldsymbol|bm|pmb|vec)\{\\?[a-z]")
_NAMES = (("x", "y", "z"), ("1", "2", "3", "4", "5", "6"))  # of components
_OF_QUATERNIONS = (("w", "x", "y", "z"), ("0", "1", "2", "3"))  # with the scalar part
_COORDINATES = ("xyz", "uvw")  # and the velocities along them
_LISTED = re.compile(r"(?:\\left)?[(\[]|\\begin\{[bBp]?matrix\}")  # how a list of components begins
_ENTRY = re.compile(r"(.+)_\{(?:(\d)(\d)|([xyz])([xyz]))\}")  # an entry of a matrix: "a_{12}", "a_{xy}"
_PLAIN = re.compile(r"\\?[A-Za-z]+")  # a letter without a subscript or an accent


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
    said: Mapping[str, tuple[int, ...]] = MappingProxyType({}),
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
    said
        Letters, bold or not, that are said to be vectors or matrices, with their sizes; 0 for what is left open.
    """
    found = Relatives({}, {}, {}, [], {})
    bases = {match[1] for each in letters if (match := _BOLD.fullmatch(each))}
    for bold in letters:
        if _UNIT.match(bold) and bold in free:
            found.units.append(bold)
        match, size = _BOLD.fullmatch(bold), said.get(bold, ())
        if not size and (match is None or bold not in varying):
            continue
        base, script = (match[1], (match[2] or "").strip("{}")) if match else (bold, "")
        listed = [right for each in formulas if (right := _listed(each, bold))] if bold in solved else []
        plain = f"{base}_{match[2]}" if match and match[2] else base
        axis = next((names for names in _COORDINATES if plain in names), "")  # x beside y is a component
        beside = any(x in varying and x not in bases for x in axis if x != plain)
        length = match and len(size) < 2 and plain in varying and not beside
        if length and not any(plain in spellings(right) for right in listed):
            found.lengths[plain] = bold
        if listed or not (size or bold in free or bold in solved) or not (match or _PLAIN.fullmatch(bold)):
            continue
        own = [x for x in letters if x in free or not size or x[-2:-1] == " "]  # what is defined is no entry
        family = any(m and m[1] == base and m[2] for x in letters for m in [_BOLD.fullmatch(x)])
        least = 1 if bold in solved or (any(size) and not family) else 2
        for parts in _components(base, script, own, least, size) if len(size) < 2 else ():
            found.components[bold] = _matrix([part] for part in parts)
            if f"{base} 1" not in letters:
                found.entries.update(dict.fromkeys(parts, bold))
        for names in _OF_QUATERNIONS if not script and not size else ():
            parts = [f"{base}_{name}" for name in names]
            if parts[0] in letters and sum(part in letters for part in parts) > 2:
                found.others[bold] = _matrix([part] for part in parts)
                found.entries.update(dict.fromkeys(parts, bold))
        if not script and (len(size) == 2 or (not size and base.isupper())):
            for rows in _rows(base, own, size):
                found.components[bold] = _matrix(rows)
                if f"{rows[0][0].partition('_')[0]} 2" not in letters:
                    found.entries.update(dict.fromkeys((each for row in rows for each in row), bold))
    return found


def _listed(formula: str, bold: str) -> str:
    r"""What a formula says the components of a vector are, as in `\mathbf{q} = (q_w, q_x, q_y, q_z)`; "" if nothing."""
    left, _, right = formula.partition("=")
    return right if "".join(left.split()) == bold.replace(" ", "") and _LISTED.match(right.replace(" ", "")) else ""


def _matrix(rows: Iterable[Sequence[str]]) -> str:
    body = r" \\ ".join(" & ".join(row) for row in rows)
    return rf"\begin{{pmatrix}} {body} \end{{pmatrix}}"


def _components(
    base: str, script: str, letters: Collection[str], least: int, size: Sequence[int]
) -> Iterator[list[str]]:
    """The names of all components of a vector of which so many are printed at least."""
    number = size[0] if size else 0
    from_zero = tuple(map(str, range(number)))
    if number and all(_below(base, name) in letters for name in from_zero):
        yield [_below(base, name) for name in from_zero]
        return
    for names in (_NAMES[0], tuple(map(str, range(1, number + 1))) or _NAMES[1]):
        spelled = [_below(base, script + name) for name in names]
        printed = [k for k, each in enumerate(spelled) if each in letters]
        if f"{base} 1" in letters and names[0] == "1" and not script:
            yield spelled[: number or 3]
        elif len(printed) >= least and len(spelled) >= number:
            yield spelled[: number or max(printed[-1] + 1, 3 if least == 1 else 2)]


def _below(base: str, script: str) -> str:
    return f"{base}_{{{script}}}" if len(script) > 1 else f"{base}_{script}"


def _rows(base: str, letters: Collection[str], size: Sequence[int]) -> Iterator[list[list[str]]]:
    """The names of all entries of a matrix, as far as entries are printed, or all of the size that is said."""
    for name in (base, base.lower()):
        printed = [m.groups()[1:] for each in letters for m in [_ENTRY.fullmatch(each)] if m and m[1] == name]
        numbers = [int(n) for places in printed for n in places[:2] if n]
        running = f"{name} 2" in letters and any(size)
        if not printed and not running:
            continue
        rows, columns = size if any(size) else (max(numbers, default=3),) * 2
        letters_of = "xyz" if printed and not numbers else "123456789"
        if max(numbers, default=0) <= max(rows, columns) <= len(letters_of):
            yield [[f"{name}_{{{k}{m}}}" for m in letters_of[:columns]] for k in letters_of[:rows]]
            return
