"""What is known of each formula alone: read or not, its letters, its relations, what it may define."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence, Set
from contextlib import suppress
from dataclasses import dataclass, replace
from itertools import pairwise

from symcheck.core.verdicts import SymcheckError
from symcheck.question.limit import OutOfTime, limited
from symcheck.question.prepare import Asked, Understood, definitions, plainly, readings
from symcheck.reading import System, Tree, relations, to_latex
from symcheck.reading.guesses import ECCENTRICITY, PRINTED, Guess
from symcheck.reading.inference import Inference, inferred
from symcheck.reading.names import KINDS_OPEN
from symcheck.reading.tex import tokenize
from symcheck.reading.tree import Call, Chain, Derivative, Implies, Integral, Name, children, walk

UNSAID = "write it out"  # ends the reason why a derivative has no value as long as nothing says what its function is
READING = 1.0  # seconds for the reading of one formula; hardly one of the corpora takes a tenth
IDENTITY_MATRIX = "identity matrix"  # a kind of letters, and what is said of them
UNNAMED = ("index", "differential", "number", IDENTITY_MATRIX)  # kinds of letters that stand for nothing of their own
Said = tuple[tuple[str, str], ...]  # letters with what they are, as `decide` takes it
OPENING, CLOSING = (
    frozenset({"{", "(", "[", r"\{", r"\left", r"\begin"}),
    frozenset({"}", ")", "]", r"\}", r"\right", r"\end"}),
)
CONSTANT = re.compile(r"\\text\{(?:~?(?:a|some)~)?(?:const|constant|cst|cte)[.~]*\}")  # a word for any
# what stands in a formula that is more than a chain of equations
SMALLEST = 3  # parts of a side that is more than a letter with a sign: of shorter ones nothing can be told
PARTING = frozenset({",", ";", "&", "<", ">", ":", "|", r"\\", r"\quad", r"\qquad", r"\text"})


@dataclass(frozen=True)
class Role:
    """What one letter is in one formula."""

    letter: str
    kind: str
    phrase: str  # as `decide` takes it; "" where nothing more is known than that it is a number
    taken: str
    why: str
    sure: bool
    known: bool = True  # is the formula read?
    size: tuple[int, ...] = ()  # of what is printed as equal to it


LONGEST_ASSIGNED = 3  # parts of x + 1 and of 2x; longer ones may be identities, as x = tan(arctan x)


@dataclass(frozen=True)
class Link:
    """One equation of a formula: two sides, each with its letters."""

    left: str
    right: str
    names: tuple[frozenset[str], frozenset[str]]
    sizes: tuple[int, int]
    chained: bool  # does it stand behind another one?
    head: str = ""  # the letter that it may define
    place: int = 0  # among all relations of the formula
    bound: frozenset[str] = frozenset()  # letters at which a function is said, or by which is integrated: of any value
    operates: bool = False  # does it hold derivatives or integrals?

    @property
    def latex(self) -> str:
        """The equation."""
        return f"{self.left} = {self.right}"

    @property
    def is_assignment(self) -> bool:
        """Does a letter become something of itself, as in x = x + 1 and x = -x, which no value of it is meant to be?"""
        alone = self.names[0] == self.names[1] and len(self.names[0]) == self.sizes[0] == 1
        return alone and not self.chained and self.sizes[1] <= LONGEST_ASSIGNED


@dataclass(frozen=True)
class Seen:
    """What a formula is, alone."""

    reason: str = ""
    partly: bool = False
    roles: tuple[Role, ...] = ()
    links: tuple[Link, ...] = ()
    plain: bool = False  # equations alone, without conditions beside them
    apart: bool = False  # are some links read, and the formula as a whole is not?
    said: Said = ()  # what had to be said of the letters
    parts: tuple[str, ...] = ()  # why links of it are not read alone, if it is not as a whole
    premises: tuple[Link, ...] = ()  # of an implication
    conclusions: tuple[Link, ...] = ()
    skew: tuple[tuple[str, str], ...] = ()  # matrices, each with the vector of which it is made

    def made_of(self, vectors: Mapping[str, str]) -> Seen:
        """The same, in which a matrix that is made of a vector stands for this."""
        if not (skew := tuple((r.letter, vectors[r.letter]) for r in self.roles if r.letter in vectors)):
            return self
        own = dict(skew)

        def named(link: Link) -> Link:
            left, right = (frozenset(own.get(x, x) for x in names) for names in link.names)
            return replace(link, names=(left, right))

        return replace(self, skew=skew, links=tuple(map(named, self.links)))

    def with_units(self, units: Set[str]) -> Seen:
        """The same, in which letters are identity matrices, and so no letters of which something is said."""
        if not (own := {role.letter for role in self.roles if role.letter in units}):
            return self

        def named(link: Link) -> Link:
            return replace(link, names=(link.names[0] - own, link.names[1] - own))

        roles = (replace(r, kind=IDENTITY_MATRIX, phrase="") if r.letter in own else r for r in self.roles)
        return replace(self, roles=tuple(roles), links=tuple(map(named, self.links)))

    @property
    def read(self) -> bool:
        return not self.reason or self.partly

    @property
    def behind_another(self) -> Seen:
        """The same as what goes on with the formula above it: its first link is one of a chain."""
        return replace(self, links=tuple(replace(link, chained=True, head="") for link in self.links))

    def again(self, other: Seen) -> Seen:
        """Another reading of it, in which letters are what they were guessed to be, and for the same reason."""
        own = {role.letter: role for role in self.roles}
        roles = (own[r.letter] if r.letter in own and own[r.letter].phrase == r.phrase else r for r in other.roles)
        return replace(other, roles=tuple(replace(role, known=True) for role in roles))

    @property
    def is_known(self) -> bool:
        """Are its links read, or some of them?"""
        return not self.reason or self.apart

    @property
    def is_sayable(self) -> bool:
        """Is it read, or does it lack no more than what its letters are, such as a function that is differentiated?"""
        return self.is_known or (self.partly and UNSAID in self.reason)

    @property
    def heads(self) -> dict[str, Link]:
        """The letters that it may define, each with the equation that does."""
        return {link.head: link for link in self.links if link.head}

    def is_of_same_letters(self, link: Link) -> bool:
        """Do the same letters stand on both sides of an equation, but for those that are bound there?"""
        return link.names[0] & self.names == link.names[1] & self.names

    @property
    def names(self) -> frozenset[str]:
        """The letters that stand for something."""
        own = dict(self.skew)
        letters = (role.letter for role in self.roles if role.kind not in UNNAMED)
        return frozenset(own.get(letter, letter) for letter in letters)


def surveyed(latex: str, said: Said = ()) -> Seen:
    """One formula, alone, or with what is said of its letters elsewhere."""
    try:
        with limited(READING):
            return replace(_surveyed(latex, said), said=said)
    except OutOfTime:
        return Seen(f"it could not be read in {READING:g} s")
    except SymcheckError as error:
        return Seen(str(error))
    except RecursionError:
        return Seen("it is nested too deeply")


def is_open(latex: str) -> bool:
    """Does it have so many letters which may be vectors or matrices that alone it is not read?"""
    return KINDS_OPEN in surveyed(latex).reason


def surveyed_with(task: tuple[str, Said]) -> Seen:
    """The same for workers."""
    return surveyed(*task)


def _surveyed(latex: str, said: Said) -> Seen:
    asked = plainly(Asked(latex, letters=said))
    reason, partly = "", False
    try:
        found = readings(asked, likely=True)
        inferences, tree = [reading.inference for reading in found], found[0].tree
    except Understood as error:
        reason, partly, inferences, tree = error.reason, True, [error.inference], error.tree
    except SymcheckError as error:
        inferences = []
        for text in (asked.relation, *apart(latex)):
            with suppress(SymcheckError):
                inferences = inferred([text], dict(asked.letters), {})
                break
        roles = tuple(replace(role, known=False) for role in _roles(inferences))
        parts = [*_links_apart(latex, roles, said)]
        links = tuple(each for each in parts if isinstance(each, Link))
        reasons = tuple(each for each in parts if isinstance(each, str))
        return Seen(str(error), roles=roles, links=links, plain=bool(links), apart=bool(links), parts=reasons)
    links = tuple(_links(tree))
    if partly and isinstance(tree, Chain) and len(tree.members) > 2:
        roles = tuple(_roles(inferences))
        own = tuple(each for each in _links_apart(latex, roles, said) if isinstance(each, Link))
        return Seen(reason, True, roles, own or links, True, apart=bool(own))
    several = tree.parts if isinstance(tree, System) and not tree.qualifiers else (tree,)
    implied = [part for part in several if isinstance(part, Implies)]
    seen = Seen(reason, partly, tuple(_roles(inferences)), links, not implied and isinstance(tree, Chain | System))
    if (
        len(implied) == 1
        and isinstance(left := implied[0].left, Chain)
        and isinstance(right := implied[0].right, Chain)
    ):
        return replace(seen, premises=tuple(_links(left)), conclusions=tuple(_links(right)))
    return seen


def _links(tree: Tree) -> Iterator[Link]:
    """The equations of a formula, in printed order."""
    before: Tree | None = None
    for place, relation in enumerate(relations(tree)):
        left, right = relation.left, relation.right
        constant = any(_is_constant(part) for side in (left, right) if side is not None for _, part in walk(side))
        if left is not None and right is not None and relation.sign in ("=", r"\equiv") and not constant:
            names = frozenset(_names(left)), frozenset(_names(right))
            sides = to_latex(left), to_latex(right)
            chained = before is left
            head = "" if chained else next(iter(definitions([" = ".join(sides)])[0]), "")
            bound = {x for side in (left, right) for _, part in walk(side) for x in _bound(part)}
            bound |= names[0] - {head} if head and isinstance(left, Call) else set()
            operates = any(isinstance(part, Derivative | Integral) for side in (left, right) for _, part in walk(side))
            sizes = _size(left), _size(right)
            yield Link(*sides, names, sizes, chained, head, place, frozenset(bound), operates)
        before = right


def _is_constant(tree: Tree) -> bool:
    """Is it a word for some constant, which is another one in each relation?"""
    return isinstance(tree, Name) and CONSTANT.fullmatch(tree.letter) is not None


def apart(latex: str) -> list[str]:
    """The equations of a chain as they are printed, whether or not it is read; nothing if it is no plain chain."""
    depth, ends = 0, list[int]()
    for tok in tokenize(latex):
        depth += (tok.text in OPENING) - (tok.text in CLOSING)
        if depth < 0 or (not depth and tok.text in PARTING):
            return []
        if not depth and tok.text == "=":
            ends.append(tok.at)
    members = [latex[a:b].strip() for a, b in pairwise([0, *ends, len(latex)])] if not depth else []
    members = [member.removeprefix("=").strip() for member in members]
    return [" = ".join(both) for both in pairwise(members)] if all(members) and len(members) > 2 else []


def _links_apart(latex: str, roles: Sequence[Role], said: Said) -> Iterator[Link | str]:
    """The links that can be read alone, with the letters as they are in all of the formula, and as is said.

    Of the others the reason why they are not read.
    """
    for place, text in enumerate(apart(latex)):
        try:
            alone = surveyed(text)
            own = {r.letter: phrase for r in alone.roles if (phrase := _phrase_among(roles, r))}
            own |= {x: phrase for x, phrase in said if any(r.letter == x for r in alone.roles)}
            seen = _surveyed(text, tuple(own.items())) if own else alone
        except SymcheckError as error:
            yield str(error)
            continue
        if not seen.reason and len(seen.links) == 1:
            link = seen.links[0]
            yield replace(link, chained=place > 0, place=place, head="" if place else link.head)
        else:
            yield seen.reason


def _phrase_among(roles: Sequence[Role], role: Role) -> str:
    """What a letter is by the roles in a longer formula, if it is something else alone."""
    phrases = [r.phrase for r in roles if r.letter == role.letter and r.phrase != role.phrase]
    return next((phrase for phrase in phrases if is_sayable(phrase)), "")


def is_sayable(phrase: str) -> bool:
    """Does `decide` take a phrase about a letter? Of a function it wants to know of what."""
    return phrase.split(" ")[0] in _SAYABLE and phrase != "function"


SKEW = "skew matrix of"  # a vector
# first words of phrases that `decide` takes
_SAYABLE = frozenset({"vector", "matrix", "function", "depends", "scalar", "constant", "skew", "identity"})


def _names(tree: Tree) -> Iterator[str]:
    """The letters of a side, but for those by which it is differentiated alone, and those that an integral binds."""
    if isinstance(tree, Name):
        yield tree.letter
    bound = {*_bound(tree)}
    for part in (tree.body,) if isinstance(tree, Derivative) else children(tree):
        yield from (name for name in _names(part) if name not in bound)


def _bound(tree: Tree) -> Iterator[str]:
    return _names(tree.variable) if isinstance(tree, Integral) else iter(())


def _size(tree: Tree) -> int:
    return sum(1 for _ in walk(tree))


def _roles(inferences: list[Inference]) -> Iterator[Role]:
    """Each letter once; one that is something else in another likely reading is not sure."""
    near = [each for each in inferences if not each.remote] or inferences
    for guess in near[0].guesses if near else ():
        own = _phrase(guess)
        others = (g for each in near[1:] for g in each.guesses if g.letter.latex == guess.letter.latex)
        sure = all(_phrase(g) == own for g in others)
        size = guess.letter.size if guess.why == PRINTED else ()
        yield Role(guess.letter.latex, _kind(guess), own, guess.taken, guess.why, sure, size=size)


def _kind(guess: Guess) -> str:
    letter = guess.letter
    if letter.number:
        return "number"
    return "function" if letter.kind == "scalar" and letter.depends else letter.kind


def _phrase(guess: Guess) -> str:
    letter = guess.letter
    if letter.kind in ("vector", "matrix"):
        return letter.kind
    if letter.depends:
        return f"{'function of' if letter.kind == 'function' else 'depends on'} {letter.depends}"
    if guess.why == ECCENTRICITY:
        return "scalar"  # and not Euler's number, which it may be elsewhere
    return letter.number or ("" if letter.kind == "scalar" else letter.kind)
