"""What each printed letter of a paper means: one table per paper, from which reading and lowering take everything."""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cache

from symcheck.reading import tex
from symcheck.statement import SymcheckError

KINDS = frozenset({"scalar", "vector", "matrix", "function", "index", "differential"})
SIGNS = frozenset({"", ">= 0", "> 0"})
SLASHES = frozenset({"", "denominator"})
DECIMALS = frozenset({"", "rounded"})
_PREFIXES = {r"\dot": "d", r"\ddot": "dd"}
_SUFFIXES = {
    r"\bar": "bar", r"\overline": "bar", r"\hat": "hat", r"\widehat": "hat",
    r"\tilde": "tilde", r"\widetilde": "tilde", r"\vec": "vec",
}  # fmt: skip


@dataclass(frozen=True)
class Letter:
    r"""One printed letter, without its indices: `I`, `\omega`, `\bar{k}`, `\mathbf{e}`, `Ox`, `f_1`.

    name        stem of its variables in lowered terms; by default `\dot{\omega}` -> "domega", `\bar{k}` -> "kbar"
    indices     number of index positions; `k` and `k_i` are two letters
    kind        "scalar", "vector", "matrix", "function" (of other letters), "index", "differential" (as in dx)
    range       the values of an index letter, or of each index of this letter
    sign        "", ">= 0" or "> 0"
    components  of a vector or matrix, or of a function with such values: any LaTeX of that shape in the same notation,
                in which i, j (in this order) stand for the letter's own indices: `(a_{i1}, a_{i2}, a_{i3})`,
                `\|a_{ij}\|`, `\operatorname{diag}(I_1, I_2, I_3)`; without it they are variables with one more index
                (a matrix: two)
    """

    latex: str
    name: str | None = None
    indices: int = 0
    kind: str = "scalar"
    range: tuple[int, ...] = (1, 2, 3)
    meaning: str = ""
    unit: str = ""
    sign: str = ""
    components: str | None = None

    def __post_init__(self) -> None:
        if self.kind not in KINDS:
            raise SymcheckError(f"letter {self.latex}: unknown kind {self.kind!r}; choose {', '.join(sorted(KINDS))}")
        if self.sign not in SIGNS:
            raise SymcheckError(f"letter {self.latex}: unknown sign {self.sign!r}; choose '', '>= 0' or '> 0'")
        canonical(self.latex)

    @property
    def stem(self) -> str:
        """The stem of the variable names."""
        return self.name if self.name is not None else _stem(canonical(self.latex))


@cache
def canonical(latex: str) -> str:
    r"""The one spelling under which a letter is looked up: `\bar k` -> `\bar{k}`, `f_{1}` -> `f_1`."""
    reader = tex.Reader(latex)
    if latex.isascii() and latex.isalpha():
        return latex
    text = reader.spelling()
    if reader.peek() == "_":
        reader.i += 1
        text += tex.subscript(reader.group())
    if reader.i < len(reader.toks):
        reader.fail("a letter is declared by its spelling alone, without indices")
    return text


def _stem(latex: str) -> str:
    head, _, rest = latex.partition("{")
    if latex.startswith("\\") and rest.endswith("}") and "_" not in latex:
        inner = _stem(rest[:-1])
        return _PREFIXES.get(head, "") + inner + _SUFFIXES.get(head, "")
    base, underscore, index = latex.rpartition("_")
    if underscore:
        return f"{_stem(base)}_{_plain(index)}"
    return _plain(latex)


def _plain(text: str) -> str:
    return re.sub(r"[^A-Za-z0-9]", "", text.replace("*", "star"))


def variable(stem: str, indices: tuple[int, ...]) -> str:
    """The name of a variable: `a`, (1, 2) -> "a_12"; numbers above 9 are set apart."""
    if not indices:
        return stem
    between = "_" if len(indices) > 1 and max(indices) > 9 else ""
    return f"{stem}_{between.join(map(str, indices))}"


def _variables(letter: Letter) -> Iterator[str]:
    """All variables this letter is lowered to."""
    if letter.kind == "differential" or letter.components is not None:
        return
    inner = {"vector": 1, "matrix": 2}.get(letter.kind, 0)
    for indices in itertools.product(*[letter.range] * letter.indices, *[(1, 2, 3)] * inner):
        yield variable(letter.stem, indices)


class Notation:
    """A paper's letters and habits. Immutable; `extended` gives a changed copy.

    slash     what a slash before several factors means: "" is refused as ambiguous; "denominator": `1/2\\pi` is
              1/(2 pi). Physicists print it so, programmers mean (1/2) pi; only the paper itself can tell, by its other
              formulas. Brackets behind the slash, `1/2(a + b)`, stay refused.
    bracket   the vectors e_i, by their letter `\\mathbf{e}`, that a list in square brackets combines: `[u, 1, -1]`
              is u e_1 + e_2 - e_3; "": such a list is a vector of components, as one in round brackets is
    decimals  what an equality with a decimal number says: "" that both are equal, "rounded" that it is so to the last
              printed digit, as behind `\\approx`; whole numbers are exact
    """

    def __init__(self, letters: Iterable[Letter], *, slash: str = "", bracket: str = "", decimals: str = "") -> None:
        if slash not in SLASHES:
            raise SymcheckError(f"unknown meaning {slash!r} of a slash; choose '' or 'denominator'")
        if decimals not in DECIMALS:
            raise SymcheckError(f"unknown meaning {decimals!r} of decimals; choose '' or 'rounded'")
        self.letters, self.slash, self.bracket, self.decimals = tuple(letters), slash, bracket, decimals
        self.content = (self.letters, slash, bracket, decimals)  # all that distinguishes two notations
        self._hash = hash(self.content)
        self._letters: dict[tuple[str, int], Letter] = {}
        self._index: dict[str, Letter] = {}
        for letter in self.letters:
            key = canonical(letter.latex)
            if letter.kind == "index":
                twice = key in self._index
                self._index[key] = letter
            else:
                twice = (key, letter.indices) in self._letters
                self._letters[key, letter.indices] = letter
            if twice:
                raise SymcheckError(f"letter {letter.latex} is declared twice; declare it once")
        self._spellings = {k for k, _ in self._letters}
        self._check_variables()
        if bracket and self.letter(bracket, 1).kind != "vector":
            raise SymcheckError(f"brackets cannot combine {bracket}; declare it as a vector with one index")
        self.words = tuple(sorted({k for k, _ in self._letters if len(k) > 1 and k.isalpha()}, key=len, reverse=True))

    def _check_variables(self) -> None:
        """No two letters may be lowered to one variable: it would make different things equal without a word."""
        owners: dict[str, str] = {}
        for letter in self._letters.values():
            for name in _variables(letter):
                if owners.setdefault(name, letter.latex) != letter.latex:
                    both = f"{owners[name]} and {letter.latex}"
                    raise SymcheckError(
                        f"letters {both} would both be lowered to {name}; give one of them another name"
                    )

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Notation) and self.content == other.content

    def __hash__(self) -> int:
        return self._hash

    def __repr__(self) -> str:
        habits = f"slash={self.slash!r}, bracket={self.bracket!r}, decimals={self.decimals!r}"
        return f"Notation({list(self.letters)!r}, {habits})"

    def extended(self, *letters: Letter) -> Notation:
        """A copy in which these letters are added, or stand for others of the same spelling and number of indices."""

        def key(letter: Letter) -> tuple[str, int, bool]:
            return canonical(letter.latex), letter.indices, letter.kind == "index"

        new = {key(letter) for letter in letters}
        kept = (old for old in self.letters if key(old) not in new)
        return Notation([*kept, *letters], slash=self.slash, bracket=self.bracket, decimals=self.decimals)

    def find(self, latex: str, indices: int) -> Letter | None:
        """The letter of this canonical spelling with so many indices."""
        return self._letters.get((latex, indices))

    def knows(self, latex: str) -> bool:
        """Is the spelling declared, with any number of indices?"""
        return latex in self._spellings

    def arities(self, latex: str) -> list[int]:
        """The numbers of indices this spelling is declared with."""
        return sorted(n for k, n in self._letters if k == latex)

    def index(self, latex: str) -> Letter | None:
        """The index letter of this spelling."""
        return self._index.get(latex)

    def indices(self) -> tuple[str, ...]:
        """All index letters."""
        return tuple(self._index)

    def letter(self, latex: str, indices: int = 0) -> Letter:
        """The letter of this spelling; SymcheckError with the nearest declared one if there is none."""
        found = self.find(canonical(latex), indices)
        if found is None:
            raise SymcheckError(f"unknown letter {latex} with {indices} indices; {self.nearest(canonical(latex))}")
        return found

    def nearest(self, latex: str) -> str:
        """A way out for an unknown letter: the nearest declared one."""
        import difflib  # only an error needs it

        close = difflib.get_close_matches(latex, [*self._spellings, *self._index], n=1, cutoff=0.0)
        return f"declare it in the notation, or did you mean {close[0]}?" if close else "the notation has no letters"
