"""What each printed letter of a paper means: one table per paper, from which reading and lowering take everything."""

from __future__ import annotations

import itertools
import re
from collections.abc import Container, Iterable, Sequence
from dataclasses import dataclass
from functools import cache, cached_property, lru_cache
from typing import Any

from symcheck.core.verdicts import SymcheckError
from symcheck.reading import tex
from symcheck.reading.commands import known

KINDS = frozenset({"scalar", "vector", "matrix", "function", "index", "differential"})
SIGNS = frozenset({"", ">= 0", "> 0"})
SLASHES = frozenset({"", "denominator"})
DECIMALS = frozenset({"", "rounded"})
ARGUMENTS = frozenset({"", "short", "long"})
INVERSES = frozenset({"", "function", "power"})
LOGARITHMS = frozenset({"", "e", "10"})
DOTS = {r"\dot": 1, r"\ddot": 2, r"\dddot": 3}
TIMES = ("t", r"\tau")
_NUMBERS = {"e": "e", r"\text{e}": "e", "i": "i", r"\text{i}": "i", r"\text{j}": "i", r"\pi": "pi"}
_MAY_BE = {**_NUMBERS, "j": "i"}
_SAID = {"e": "Euler's number", "i": "the imaginary unit", "pi": "the number pi"}
_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]*")  # names of letters in statements, as Python and SymPy take them
_FUNCTIONS = "sin|cos|tan|sqrt|exp|log|arctan|arcsin|arccos|pow|mean|integral|diverges|diff|call|exists"
# names of constants, and of values of functions: no letter is called so
_VALUE = re.compile(rf"pi|infinity|({_FUNCTIONS})(_.*)?|[A-Z][a-z]+_[0-9a-f]{{10}}")
SAID = "it is said to be"  # why a letter that somebody declares is what it is
_PREFIXES = {r"\dot": "d", r"\ddot": "dd", r"\dddot": "ddd"}
_SUFFIXES = {
    r"\bar": "bar", r"\overline": "bar", r"\hat": "hat", r"\widehat": "hat",
    r"\tilde": "tilde", r"\widetilde": "tilde", r"\vec": "vec",
}  # fmt: skip


@dataclass(frozen=True)
class Letter:
    r"""One printed letter, without its indices: `I`, `\omega`, `\bar{k}`, `\mathbf{e}`, `Ox`, `f_1`, `a^{(2)}`.

    Parameters
    ----------
    latex
        The letter as printed.
    name
        Stem of its variables in lowered terms; by default `\dot{\omega}` gives "domega" and `\bar{k}` "kbar".
    indices
        Number of index positions; `k` and `k_i` are two letters.
    kind
        "scalar", "vector", "matrix", "function" (of other letters), "index", or "differential" (as in dx).
    range
        The values of an index letter, or of each index of this letter.
    meaning
        What it stands for, in words.
    unit
        Its unit, "1" for a number; for a letter with indices one for each value of the first, or one for each variable,
        with commas, and semicolons between rows. Without it nothing is said.
    sign
        "", ">= 0" or "> 0".
    components
        Of a vector or matrix, or of a function with such values: any LaTeX of that shape in the same notation, in
        which i, j (in this order) stand for the letter's own indices: `(a_{i1}, a_{i2}, a_{i3})`, `\|a_{ij}\|`,
        `\operatorname{diag}(I_1, I_2, I_3)`. Without it they are variables with one more index (a matrix: two).
    depends
        The letters of which it is a function: "t", "x, t", `\mathbf{y}, t`; "" if it is constant. Then `r` is r(t),
        and `\dot{r}`, `r'`, `\frac{dr}{dt}` are its derivatives. A letter for which nothing is said cannot stand in a
        derivative, an integral or a mean by another letter.
    named
        Whether its value is known by its name: `r` and `r(t)` are lowered to the variable r, for which a definition
        puts the expression that says how it depends on others. No other arguments are allowed then.
    number
        "e", "i" or "pi" for a letter that is this number.
    size
        The number of components of a vector, (n,), or of rows and columns of a matrix; 3 of each by default.
    skew
        The vector of which this matrix is the skew matrix: its product with a vector is the cross product.
    whole
        Whether the spelling is one name though it is printed with several tokens: `E[\rho]`, `\Delta h`, `f^c`.
    integer
        Whether it is a whole number.
    value
        The whole number for which it stands, where a statement is looked at for one size.
    running
        Whether its indices run up to a letter: then it is a function of them.
    identity
        Whether this matrix is the identity.
    partial
        For a letter such as f_{xy}, a derivative of a function: that function, and the letters by which it is taken.
    order
        For the O of terms of an order, as in O(x^2), 0; for the o of terms of a higher order, 1.
    varies
        Whether differentials of it are printed, as in dx; other letters are constant in differentials.
    doubt
        Why nothing is said of it though it can be read: what its scripts may mean.
    open
        Whether it stands before brackets, and nothing tells whether they hold its arguments or a factor.

    Raises
    ------
    SymcheckError
        If what is said of the letter does not fit together; the message has the way out.

    See Also
    --------
    Notation : All letters of a paper.

    Examples
    --------
    >>> Letter("I", indices=1, meaning="principal moments of inertia", unit="kg m^2").stem
    'I'
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
    depends: str | None = None
    named: bool = False
    number: str = ""
    size: tuple[int, ...] = ()
    skew: str = ""
    whole: bool = False
    integer: bool = False
    value: int | None = None
    running: bool = False
    identity: bool = False
    partial: tuple[str, ...] = ()
    order: int | None = None
    varies: bool = False
    doubt: str = ""
    open: bool = False

    def __post_init__(self) -> None:
        if self.kind not in KINDS:
            raise self.fault(f"unknown kind {self.kind!r}; choose {', '.join(sorted(KINDS))}")
        if self.sign not in SIGNS:
            raise self.fault(f"unknown sign {self.sign!r}; choose '', '>= 0' or '> 0'")
        spelling = self.latex if known(self.latex) or self.whole else canonical(self.latex)
        if known(spelling):
            raise self.fault("it has a meaning of its own, or none that is known, and cannot be a letter")
        if spelling == r"\pi" and self.kind == "scalar" and not self.indices and self.name is None:
            object.__setattr__(self, "number", "pi")
        self._check_number(spelling)
        if self.kind in ("index", "differential") and (self.depends is not None or self.named):
            raise self.fault(f"an {self.kind} depends on nothing; leave out depends and named")
        if self.name is not None and not _NAME.fullmatch(self.name):
            raise self.fault(f"the name {self.name!r} is none of a variable; use letters, digits and _")
        if not self.stem or (self.stem.endswith("prime") and self.kind != "index"):
            raise self.fault(f"it would be lowered to {self.stem!r}; give it another name, name=...")

    def _check_number(self, spelling: str) -> None:
        """Letters that may be numbers say whether they are."""
        which = _NUMBERS.get(spelling, "") if not self.indices else ""
        said = self.number or self.name is not None
        if which and not said and (self.kind == "scalar" or (which != "i" and self.kind == "index")):
            ways = (
                f"say name={self.stem!r} for a letter"
                if self.kind == "index"
                else f"say number={which!r}, or name={self.stem!r}"
            )
            raise self.fault(f"{_SAID[which]}, or a letter of its own? {ways}")
        if spelling == r"\text{d}" and self.kind != "differential" and self.name is None:
            raise self.fault("the d of a differential, or a letter of its own? say kind='differential', or name='d'")

    def check(self) -> None:
        """SymcheckError if what is said of the letter does not fit together."""
        which = _MAY_BE.get(self.spelling, "") if not self.indices else ""
        if self.number and (self.number != which or self.kind != "scalar" or self.depends or self.name):
            raise self.fault(f"number={self.number!r} does not fit it; only e, i and \\pi are numbers, without a name")

    def fault(self, message: str) -> SymcheckError:
        """The error of this declaration."""
        return SymcheckError(f"letter {self.latex}: {message}")

    @property
    def places(self) -> tuple[Sequence[int], ...]:
        """The values of the indices of its components."""
        size = self.size or {"vector": (3,), "matrix": (3, 3)}.get(self.kind, ())
        return tuple([*itertools.islice(itertools.count(1), n)] for n in size)

    @property
    def stem(self) -> str:
        """The stem of the variable names."""
        return self.name if self.name is not None else _stem(self.spelling)

    @cached_property
    def instances(self) -> tuple[tuple[str, tuple[int, ...]], ...]:
        """All variables and functions it is lowered to, each with its indices."""
        if self.kind in ("differential", "index") or self.components is not None or self.number:
            return ()
        if self.skew or self.identity or self.value is not None:
            return ()
        if self.running:
            return ((self.stem, ()),)
        every = itertools.product(*[self.range] * self.indices, *self.places)
        return tuple([(variable(self.stem, indices), indices) for indices in every])

    @property
    def spelling(self) -> str:
        """How it is looked up."""
        return self.latex if self.whole else canonical(self.latex)

    @property
    def applies(self) -> bool:
        """Can this letter stand before arguments in brackets?"""
        return self.kind == "function" or bool(self.depends)

    def spelled(self, indices: tuple[int, ...]) -> str:
        """One instance of the letter, for messages."""
        return f"{self.latex}_{{{','.join(map(str, indices))}}}" if indices else self.latex


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
    if reader.peek() == "^":
        reader.i += 1
        text += tex.superscript(reader.group()) or ""
    if reader.i < len(reader.texts):
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


@lru_cache(maxsize=4096)  # the same letters are met in every formula
def is_value(name: str) -> bool:
    """Has a variable of this name a value of its own?"""
    return _VALUE.fullmatch(name) is not None


class Notation:
    r"""All letters of a paper, and its habits. Immutable.

    Parameters
    ----------
    letters
        The letters.
    slash
        What a slash before several factors means. "" refuses it as ambiguous; with "denominator" `1/2\pi` is
        1/(2 pi), as physicists print it, and not (1/2) pi, as programmers mean it. Only the paper itself can tell, by
        its other formulas. Brackets behind the slash, `1/2(a + b)`, stay refused.
    bracket
        The vectors e_i, by their letter `\mathbf{e}`, that a list in square brackets combines: `[u, 1, -1]` is
        u e_1 + e_2 - e_3. With "" such a list is a vector of components, as one in round brackets is.
    decimals
        What an equality with a decimal number says: with "" that both sides are equal, with "rounded" that they are to
        the last printed digit, as behind `\approx`. Whole numbers are exact.
    argument
        Where the argument of a function printed without brackets ends, if a space or brackets follow. "" refuses it as
        ambiguous. "short" ends it before them: `\cos a\,x` is (cos a) x, and `\sin\omega(t - x)` is
        (sin omega)(t - x). "long" ends it behind them: cos(a x) and sin(omega (t - x)).
    inverse
        What `\sin^{-1} x` is: with "function" the arcsine of x, with "power" 1/sin x. "" refuses it as ambiguous.
    log
        The base of `\log`: "e" or "10". "" refuses it as ambiguous.
    inferred
        Whether nobody has declared the letters: then a relation that does not fit what they were taken for is lowered
        to its form, and is no error.
    scales
        What is printed as if it were 1, and what it measures: `(("c", "m/s"),)`.

    Raises
    ------
    SymcheckError
        If a letter is declared twice, or two letters would be lowered to one variable.

    See Also
    --------
    Letter : One letter.

    Examples
    --------
    >>> letters = Notation([Letter("x"), Letter("y")])
    >>> letters.extended(Letter("z")).letter("z").stem
    'z'
    """

    def __init__(
        self,
        letters: Iterable[Letter],
        *,
        slash: str = "",
        bracket: str = "",
        decimals: str = "",
        argument: str = "",
        inverse: str = "",
        log: str = "",
        inferred: bool = False,
        scales: tuple[tuple[str, str], ...] = (),
    ) -> None:
        if slash not in SLASHES:
            raise SymcheckError(f"unknown meaning {slash!r} of a slash; choose '' or 'denominator'")
        if decimals not in DECIMALS:
            raise SymcheckError(f"unknown meaning {decimals!r} of decimals; choose '' or 'rounded'")
        if inverse not in INVERSES:
            raise SymcheckError(
                f"unknown meaning {inverse!r} of a power -1 of a function; choose '', 'function' or 'power'"
            )
        if log not in LOGARITHMS:
            raise SymcheckError(f"unknown base {log!r} of a logarithm; choose '', 'e' or '10'")
        if argument not in ARGUMENTS:
            raise SymcheckError(f"unknown end {argument!r} of an argument; choose '', 'short' or 'long'")
        self.letters, self.slash, self.bracket, self.decimals = tuple(letters), slash, bracket, decimals
        self.argument, self.inverse, self.log, self.inferred = argument, inverse, log, inferred
        self.scales = scales
        self.content = (
            self.letters,
            slash,
            bracket,
            decimals,
            argument,
            inverse,
            log,
            inferred,
            scales,
        )  # all that distinguishes two notations
        self._hash = hash(self.content)
        self._letters: dict[tuple[str, int], Letter] = {}
        self._index: dict[str, Letter] = {}
        for letter in self.letters:
            letter.check()
            key = letter.spelling
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
        self.wholes = tex.beginning(tuple(x.latex for x in self.letters if x.whole))
        self.words = tuple(sorted({k for k, _ in self._letters if len(k) > 1 and k.isalpha()}, key=len, reverse=True))

    def _check_variables(self) -> None:
        """No two letters may be lowered to one variable, and none to a name that has a value of its own."""
        owners: dict[str, tuple[Letter, tuple[int, ...]]] = {}
        for letter in self._letters.values():
            for name, indices in letter.instances:
                if is_value(name):
                    raise letter.fault(
                        f"it would be lowered to {name}, which is a value; give it another name, name=..."
                    )
                other, others = owners.setdefault(name, (letter, indices))
                if (other, others) != (letter, indices):
                    both = f"{other.spelled(others)} and {letter.spelled(indices)}"
                    raise SymcheckError(
                        f"letters {both} would both be lowered to {name}; give one of them another name, name=..."
                    )
            self._check_dots(letter)
        self._owners = owners

    def _check_dots(self, letter: Letter) -> None:
        """A dotted letter is no letter of its own where the dots are a derivative."""
        bare, dots = undotted(letter.spelling)
        below = self._letters.get((bare, letter.indices)) if dots else None
        if below is not None and below.depends and not below.named:
            raise letter.fault(
                f"{below.latex} depends on {below.depends}, so this is its derivative; do not declare it"
            )

    def owner(self, name: str) -> Letter | None:
        """The letter that is lowered to this variable or function, with primes or without."""
        found = self._owners.get(name) or self._owners.get(re.sub(r"(prime)+(?=_|$)", "", name))
        return found[0] if found else None

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Notation) and self.content == other.content

    def __hash__(self) -> int:
        return self._hash

    def __repr__(self) -> str:
        return f"Notation({list(self.letters)!r}, {', '.join(f'{k}={v!r}' for k, v in self.habits.items())})"

    def extended(self, *letters: Letter) -> Notation:
        """A copy in which these letters are added, or stand for others of the same spelling and number of indices."""

        def key(letter: Letter) -> tuple[str, int, bool]:
            return canonical(letter.latex), letter.indices, letter.kind == "index"

        new = {key(letter) for letter in letters}
        return self.having(*(old for old in self.letters if key(old) not in new), *letters)

    def having(self, *letters: Letter) -> Notation:
        """The same habits with these letters and no others."""
        return Notation(letters, **self.habits)

    def supposing(self, *scales: tuple[str, str]) -> Notation:
        """A copy for relations that are printed as if these were 1, too."""
        return Notation(self.letters, **{**self.habits, "scales": (*self.scales, *scales)})

    @property
    def habits(self) -> dict[str, Any]:
        """All that a notation says beside its letters."""
        return dict(
            zip(
                ("slash", "bracket", "decimals", "argument", "inverse", "log", "inferred", "scales"),
                self.content[1:],
                strict=True,
            )
        )

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
        found = self.find(latex, indices) or self.find(canonical(latex), indices)
        if found is None:
            raise SymcheckError(f"unknown letter {latex} with {indices} indices; {self.nearest(canonical(latex))}")
        return found

    def nearest(self, latex: str) -> str:
        """A way out for an unknown letter: the nearest declared one."""
        close = self.resembling(latex, 0.0)
        meant = f"did you mean {close}?" if close else "the notation has no letters"
        if known(latex):
            return tex.no_letter(latex)
        if which := _NUMBERS.get(latex):
            return f"declare it, with number={which!r} if it is {_SAID[which]}; or {meant}"
        return f"declare it in the notation, or {meant}" if close else meant

    def resembling(self, latex: str, cutoff: float = 0.75) -> str:
        """The declared letter that is spelled most alike; the empty text if none is."""
        import difflib  # only an error needs it

        close = difflib.get_close_matches(latex, [*self._spellings, *self._index], n=1, cutoff=cutoff)
        return close[0] if close else ""

    def refuse_undefined(self, defined: Container[str], *values: object) -> None:
        """SymcheckError for a named letter under a derivative, integral or mean that no definition gives a value."""
        for value in values:
            if found := self._undefined(value, defined, inside=False):
                raise SymcheckError(
                    f"nothing defines {found} here, so that its derivative, integral or mean is not known; define it, "
                    "or declare it without named"
                )

    def _undefined(self, value: object, defined: Container[str], *, inside: bool) -> str | None:
        if isinstance(value, str):
            letter = self.owner(value) if inside and value not in defined else None
            return letter.latex if letter and letter.named else None
        if isinstance(value, tuple):
            inside = inside or value[:1] in (("diff",), ("integral",), ("mean",), ("diverges",))
            bound = value[2] if inside and len(value) > 2 and isinstance(value[2], str) else ""
            for part in value[1:]:
                if part != bound and (found := self._undefined(part, defined, inside=inside)):
                    return found
        return None


def undotted(latex: str) -> tuple[str, int]:
    r"""The letter below its dots, and their number: `\ddot{x}` -> (`x`, 2)."""
    head, _, rest = latex.partition("{")
    return (rest[:-1], DOTS[head]) if head in DOTS and rest.endswith("}") else (latex, 0)
