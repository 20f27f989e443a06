"""One guess for a document: what each letter is by all the formulas in which it stands, and where these disagree."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping, Sequence, Set
from dataclasses import dataclass, replace
from functools import cache

from symcheck.document.angles import OPEN_ARGUMENT, argument_rules
from symcheck.document.macros import bare, tokens, written
from symcheck.document.printed import Printed
from symcheck.document.rewriting import Rule, rewritten
from symcheck.document.survey import SKEW, UNNAMED, Role, Said, Seen, is_sayable, surveyed
from symcheck.document.written_out import partial_rules
from symcheck.reading.evidence import spellings
from symcheck.reading.faces import face, is_styled
from symcheck.reading.guesses import PRINTED
from symcheck.reading.lowering import AND_OTHER, SHAPES_DIFFER
from symcheck.reading.names import DIMENSIONLESS, INTEGRATED, KINDS_OPEN, LABEL_DOUBT, MANY_READINGS
from symcheck.reading.side_by_side import ONE_NAME

_LABEL = re.compile(r"(_\{?[^^]*)?\^\{?([a-z]+|[A-Z]|\\[a-z]+)\}?$")  # letters above a name, perhaps with others below
_NAME = re.compile(rf"{ONE_NAME} (\w+), or a product")  # a doubt
_INTEGRATED = re.compile(rf"(\S+): {INTEGRATED} (\S+): a constant")  # or a function of it
_NO_FUNCTION = re.compile(rf"({'|'.join(DIMENSIONLESS)}) without an argument")  # a number, then
_VALUES = frozenset({"vector", "matrix"})  # what a function here may give, of which letters elsewhere are the values
_INDICES = frozenset("ijklmn") | {r"\mu", r"\nu"}
_CHANGE = re.compile(r"(\\delta|\\Delta) (?=[A-Za-z\\])")  # before a name
# a label below a name, all of it in one type
_TYPED = re.compile(r"_\{\s*\\(?:text|mathrm|mathbf|boldsymbol|bm|mathit)\s*(?:\{([^{}]*)\}|(\\?[A-Za-z]+))\s*\}")
# a vector with a frame at its left, bare
_FRAMED = re.compile(r"\\prescript(\\?\w)((?:\\hat)?\\(?:bm|boldsymbol|mathbf|vec).+)")
_HATTED = re.compile(r"\\hat\{[a-z]\}")  # a letter in plain type with a hat: a unit vector, or an estimate
_WORDS = (r"_{\text", r"_{\mathrm")  # in these a label is the same as in plain type
# a name with a tilde in brackets, and what stands below it
_TILDE = re.compile(r"\[\\(?:wide)?tilde\{((?:[^{}]|\{[^{}]*\})*)\}(_.+)?\]")
# what a letter is said to be, if derivatives of nothing stand in it
_OPERATOR = re.compile(
    r"((?:\\math(?:cal|scr)|\\hat)\s*\{\s*[A-Z]\s*\}|[A-Z])\s*(?:=|:=|\\equiv)"
    r"((?:[^=]*?)\\[dt]?frac\s*\{\s*(?:d|\\partial)\s*(?:\^\s*(?:\d|\{\s*\d\s*\}))?\s*\}[^=]*)"
)
LONGEST_PRODUCT = 4  # letters, of which exponents are made without a sign
# of letters that are said to be one of these in one place and another of them elsewhere, the places disagree
KINDS = {
    "vector": "a vector",
    "matrix": "a matrix",
    "function": "a function",
    "index": "an index",
    "number": "a number",
}


@dataclass(frozen=True)
class Letter:
    """What one letter of a document is taken for.

    Parameters
    ----------
    letter
        As it is printed.
    taken, why
        What it is taken for, and the evidence.
    phrase
        The same as `decide` takes it; "" where nothing more is known than that it is a number, or places disagree.
    count
        In how many formulas it stands.
    first
        The place of the first of them.
    others
        What it is elsewhere, each with a place, if places disagree.
    """

    letter: str
    taken: str
    why: str
    phrase: str
    count: int
    first: str
    others: tuple[str, ...] = ()


def letters(formulas: Sequence[Printed], seen: Sequence[Seen]) -> list[Letter]:
    """All letters in the order of appearance."""
    places: dict[str, list[tuple[Role, Printed]]] = {}
    for formula, each in zip(formulas, seen, strict=True):
        doubtful = SHAPES_DIFFER in each.reason
        for role in each.roles:
            if role.kind != "differential":
                own = replace(role, known=False) if doubtful else role
                places.setdefault(role.letter, []).append((own, formula))
    every = {letter: Counter(role.phrase for role, _ in roles if _tells(role)) for letter, roles in places.items()}
    found = [_letter(letter, roles, _field(roles) or _common(every[letter], every)) for letter, roles in places.items()]
    vectors = {each.letter: shown(each.letter) for each in found if each.phrase.startswith("vector")}
    named = {bare(face(v)): v for v in vectors.values()} | {bare(x): v for x, v in vectors.items()}
    return [_of_vector(each, named) for each in found]


def _of_vector(letter: Letter, named: Mapping[str, str]) -> Letter:
    r"""The same, but `[\tilde{\omega}]` is made of omega, where that is a vector in the document."""
    below = _TILDE.fullmatch(shown(letter.letter)) if letter.phrase == "matrix" else None
    if below is None or not (vector := named.get(bare("".join(filter(None, below.groups()))))):
        return letter
    return replace(letter, taken=f"the skew matrix of {vector}", why="it stands in brackets", phrase=f"{SKEW} {vector}")


def of_vectors(every: Sequence[Letter]) -> dict[str, str]:
    """The matrices that are made of vectors, each with its vector."""
    names = {shown(each.letter): each.letter for each in every}
    made = {each.letter: each.phrase.removeprefix(SKEW).strip() for each in every if each.phrase.startswith(SKEW)}
    return {letter: names[vector] for letter, vector in made.items() if vector in names}


def _tells(role: Role) -> bool:
    """Does a formula tell more of a letter than that it is a number?"""
    return bool(role.phrase) and role.sure and role.known


def _common(phrases: Counter[str], every: Mapping[str, Counter[str]]) -> str:
    """The phrase that says what all others of these say: with `f(t)` that `f` depends on t; "" if there is none.

    What depends on u here and on t there is a function of u, if u depends on t.
    """
    on = {phrase: depends_on(phrase) for phrase in phrases}
    if len(phrases) < 2 or not all(on.values()):
        return next(iter(phrases), "") if len(phrases) == 1 else ""
    through = {phrase: {y for x in on[phrase] for p in every.get(x, ()) for y in depends_on(p)} for phrase in phrases}
    whole = [p for p in phrases if all(on[q] in (on[p], through[p]) for q in phrases)]
    return max(whole, key=lambda phrase: phrases[phrase], default="")


def _field(places: Sequence[tuple[Role, Printed]]) -> str:
    """That a letter depends on all by which it is differentiated partially, here by one and there by another."""
    telling = [(r.phrase, f) for r, f in places if r.known and r.phrase and (r.sure or r.phrase.startswith("depends"))]
    if not all(phrase.startswith("depends") and r"\partial" in formula.latex for phrase, formula in telling):
        return ""
    several = sorted({x for phrase, _ in telling for x in depends_on(phrase)})
    return f"depends on {', '.join(several)}" if len(several) > 1 else ""


@cache
def shown(letter: str) -> str:
    """A letter without idle spaces, as somebody would type it."""
    return written([tok for tok in tokens(letter) if not tok.is_space])


def _letter(letter: str, places: Sequence[tuple[Role, Printed]], phrase: str) -> Letter:
    """The letter by those places that tell more of it than that it is a number."""
    count, first = len(places), places[0][1].place
    telling: dict[str, tuple[Role, Printed]] = {}
    for role, formula in places:
        if _tells(role):
            telling.setdefault(role.phrase, (role, formula))
    if not telling:
        role = places[0][0]
        role = next((role for role, _ in places if role.phrase), role) if phrase else role
        return Letter(letter, role.taken, role.why, phrase, count, first)
    if printed := [role for role, _ in telling.values() if role.why == PRINTED]:
        telling = {said: each for said, each in telling.items() if said == printed[0].phrase}
        phrase = printed[0].phrase
    (role, _), *_ = telling.values()
    kinds: dict[str, Printed] = {}
    for other, formula in telling.values():
        kinds.setdefault(other.kind, formula)
    if len(kinds) > 1:
        others = tuple(f"{KINDS.get(kind, kind)} at {formula.place}" for kind, formula in kinds.items())
        return Letter(letter, role.taken, role.why, "", count, first, others)
    return Letter(letter, role.taken, role.why, phrase, count, first)


def said(seen: Seen, known: Mapping[str, Letter]) -> dict[str, str]:
    """What the document says of letters of which a formula alone does not tell what they are."""
    found = {}
    own = {shown(role.letter) for role in seen.roles}
    for role in seen.roles:
        phrase = known[role.letter].phrase if role.letter in known else ""
        phrase = phrase if is_of(own, phrase) else ""
        of_less = role.phrase.startswith("depends") and depends_on(role.phrase) <= depends_on(phrase)
        open_ = not role.sure or not role.phrase or phrase.startswith(SKEW)
        open_ = open_ or (of_less and role.phrase != phrase)
        if open_ and role.kind not in UNNAMED and is_sayable(phrase):
            found[role.letter] = phrase
    return found


def is_of(letters: Set[str], phrase: str) -> bool:
    """Are all letters on which one depends by a phrase among these, or, of a field, some?"""
    on = depends_on(phrase)
    return on <= letters or (len(on) > 1 and not on.isdisjoint(letters))


def depends_on(phrase: str) -> set[str]:
    """The letters on which a letter depends by what is said of it."""
    kind, _, variables = phrase.partition(" on " if phrase.startswith("depends") else " of ")
    return {each.strip() for each in variables.split(",")} if kind in ("depends", "function") else set()


def without_parts_of_names(every: Sequence[Letter], seen: Sequence[Seen]) -> list[Letter]:
    """The letters that are no mere parts of what may be one name: to say what they are would make it a product."""
    read = {role.letter for each in seen if each.read for role in each.roles}
    named = {role.letter for each in seen if ONE_NAME in each.reason for role in each.roles}
    return [each for each in every if each.letter in read or each.letter not in named]


def in_one_face(formulas: Sequence[Printed], seen: Sequence[Seen], every: Sequence[Letter]) -> list[Printed]:
    """The formulas, in which what is a vector, or a matrix, in bold and in plain type is one letter, in plain type.

    So is what is printed in two ways else.
    """
    formulas = by_rules(formulas, rules(formulas, seen, every))
    kinds = {shown(each.letter): each.phrase for each in every if each.phrase in ("vector", "matrix")}
    plain = {bold: face(bold).removesuffix("}") for bold in kinds}
    sizes: dict[str, set[tuple[int, ...]]] = {}
    for role in (role for each in seen for role in each.roles if role.size):
        sizes.setdefault(shown(role.letter), set()).add(role.size)
    both = {
        bold: letter
        for bold, letter in plain.items()
        if kinds[bold] == kinds.get(letter) and len(sizes.get(bold, set()) | sizes.get(letter, set())) < 2
    }
    if not both:
        return [*formulas]
    printed = re.compile("|".join(re.escape(bold) + r"(?!_)" for bold in sorted(both)))
    return [replace(f, latex=printed.sub(lambda found: f"{{{both[found[0]]}}}", f.latex)) for f in formulas]


def by_rules(formulas: Sequence[Printed], texts: Sequence[str]) -> list[Printed]:
    """The formulas after rules of rewriting."""
    own = [Rule.of(text) for text in texts]
    return [replace(each, latex=rewritten(each.latex, own)[0]) for each in formulas]


def rules(formulas: Sequence[Printed], seen: Sequence[Seen], every: Sequence[Letter]) -> list[str]:
    """Rules of rewriting that make one of what a document prints in two ways.

    These are labels in different type below a name, where both types are used, and nowhere beside each other; the
    frame at the left of vectors, if there is one frame alone, and they stand without it, too; derivatives by what is
    written out elsewhere; operators that are said to be sums of derivatives; and arguments without brackets.
    """
    unread = [f.latex for f, each in zip(formulas, seen, strict=True) if OPEN_ARGUMENT in each.reason]
    return [
        *_rules_of_names(seen, every),
        *partial_rules(formulas, seen, _lists(seen, every)),
        *_operators(formulas),
        *argument_rules((f.latex for f in formulas), unread),
    ]


def _operators(formulas: Sequence[Printed]) -> list[str]:
    """For each letter that is said once to be a sum of operators what it stands for, if it has no index anywhere."""
    said: dict[str, set[str]] = {}
    for formula in formulas:
        if found := _OPERATOR.fullmatch(formula.latex.strip().rstrip(".,; ")):
            said.setdefault(found[1], set()).add(found[2].strip())
    return [
        rf"{letter} -> \left( {sums.pop()} \right)"
        for letter, sums in said.items()
        if len(sums) == 1 and _is_operator(*sums)
        if not any(re.search(rf"{re.escape(letter)}\s*[_']", formula.latex) for formula in formulas)
    ]


def _is_operator(text: str) -> bool:
    """Is this sum read where it stands before a letter, and not alone?"""
    return surveyed(rf"\left( {text} \right) \chi_0 = 0").read and not surveyed(f"{text} = 0").is_known


def _lists(seen: Sequence[Seen], every: Sequence[Letter]) -> set[str]:
    """The letters that are vectors or matrices somewhere, or in bold type, bare."""
    lists = {each.letter for each in every if each.phrase in _VALUES or face(each.letter) or each.others}
    lists |= {role.letter for each in seen for role in each.roles if role.size or role.kind in _VALUES}
    return {*map(bare, lists)}


def _rules_of_names(seen: Sequence[Seen], every: Sequence[Letter]) -> list[str]:
    names = {shown(each.letter): each.letter for each in every}
    typed = {name: plain for name in names if (plain := _TYPED.sub(_untyped, name)) != name}
    alike = {bare(name): name for name in names if name not in typed}
    both = {name: alike[key] for name, plain in typed.items() if (key := bare(plain)) in alike}
    beside = [{role.letter for role in each.roles} for each in seen]
    labels = {
        label[0]: label[0].startswith(_WORDS) or not any({names[name], names[other]} <= letters for letters in beside)
        for name, other in both.items()
        for label in _TYPED.finditer(name)
    }
    found = [f"{label} -> {_TYPED.sub(_untyped, label)}" for label, alone in labels.items() if alone]
    unstyled = {bare(shown(role.letter)) for each in seen if each.read for role in each.roles}
    framed = [_FRAMED.fullmatch(name) for name in unstyled if name.startswith(r"\prescript")]
    vectors = [each for each in framed if each is not None]
    if len(vectors) == len(framed) and len({x[1] for x in vectors}) == 1 and any(x[2] in unstyled for x in vectors):
        found.append(f"{{}}^{{{vectors[0][1]}}} -> ")
    return found


def _untyped(label: re.Match[str]) -> str:
    return f"_{{{label[1] or label[2]}}}"


def factors(formulas: Sequence[Printed], seen: Sequence[Seen]) -> set[str]:
    """The letters of formulas that are read; those of what elsewhere may be a name only where they stand without it."""
    found = set[str]()
    runs = _runs(seen)
    for formula, each in zip(formulas, seen, strict=True):
        if each.read:
            rest = formula.latex
            for run in runs.values():
                rest = run.sub(" ", rest)
            apart = spellings(rest) if rest != formula.latex else None
            found |= {role.letter for role in each.roles if apart is None or shown(role.letter) in apart}
    return found


def in_doubt(formulas: Sequence[Printed], seen: Sequence[Seen]) -> list[Seen]:
    """The same, but what may be a name in one formula may be one in all of them; a letter is no sign of a change."""
    doubts = {run: each.reason for each in seen for run in _NAME.findall(each.reason)}
    runs, found = _runs(seen), [*seen]
    alone = {role.letter for each in seen for role in each.roles}
    for k, (formula, each) in enumerate(zip(formulas, seen, strict=True)):
        changes = [change for role in each.roles if (change := _CHANGE.match(role.letter)) and change[1] in alone]
        if each.read and changes:
            found[k] = replace(each, reason=f"{changes[0][1]}: a factor, or the sign of a change?", partly=False)
        if each.read and (run := next((x for x, printed in runs.items() if printed.search(formula.latex)), "")):
            found[k] = replace(each, reason=doubts[run], partly=False)
    return found


def _runs(seen: Sequence[Seen]) -> dict[str, re.Pattern[str]]:
    """What may be one name, and how it is printed, the longest first; in square brackets it is a matrix."""
    every = sorted({run for each in seen for run in _NAME.findall(each.reason)}, key=len, reverse=True)
    return {run: re.compile(r"(?<![A-Za-z\\\[])" + r"\s*".join(run) + "(?![A-Za-z])") for run in every}


def elsewhere(seen: Seen, known: Mapping[str, Letter], read: Set[str], says: Mapping[str, Set[str]]) -> Said:
    """What the document says of the letters of a formula that is not read, where it is not what is guessed there.

    Letters of formulas that are read are factors, and no parts of a name. `says` are the letters by which others say
    what a letter is.
    """
    own = {shown(role.letter) for role in seen.roles}
    phrases = {role.letter: known[role.letter].phrase for role in seen.roles if role.letter in known}
    told = {x: phrase for x, phrase in phrases.items() if is_sayable(phrase) and is_of(own, phrase)}
    unlike = SHAPES_DIFFER in seen.reason  # if letters before brackets are functions
    found = {
        r.letter: told[r.letter]
        for r in seen.roles
        if told.get(r.letter, r.phrase) != r.phrase
        and (unlike or not (r.kind == "function" and told[r.letter] in _VALUES))
    }
    if unlike or AND_OTHER in seen.reason:  # what has a hat has a direction, then
        found = {
            r.letter: "vector" for r in seen.roles if r.kind == "scalar" and _HATTED.match(shown(r.letter))
        } | found
    if (
        KINDS_OPEN in seen.reason or MANY_READINGS in seen.reason
    ):  # bold capitals are matrices, then, for want of better knowledge
        bold = (r for r in seen.roles if r.phrase == "matrix" and is_styled(r.letter, capital=True))
        found = {r.letter: "matrix" for r in bold if r.letter not in told} | found
    for letter, by in _INTEGRATED.findall(seen.reason):
        if by in says.get(letter, ()):
            found[letter] = f"depends on {by}"
    if number := _NO_FUNCTION.match(seen.reason):
        found[rf"\mathrm{{{number[1]}}}"] = "scalar"
    if any(ONE_NAME in reason for reason in (seen.reason, *seen.parts)):
        found = {r.letter: "scalar" for r in seen.roles if r.letter in read and r.kind == "scalar"} | found
    if LABEL_DOUBT in seen.reason:
        found |= {r.letter: "scalar" for r in seen.roles if _is_labelled(shown(r.letter), known)}
    return tuple(found.items())


def _is_labelled(name: str, known: Mapping[str, Letter]) -> bool:
    """Is a superscript of letters a label by all of the document: a word, or of letters that are nowhere numbers?"""
    above = _LABEL.search(name)
    if above is None:
        return False
    below, letters = above.groups()
    if len(letters) == 1 or letters.startswith("\\"):
        raised = any((other := _LABEL.search(shown(x))) and other.groups() == (None, letters) for x in known)
        below_others = re.compile(rf"_.*(?<![A-Za-z\\]){re.escape(letters)}(?![A-Za-z])")
        bases = (shown(x).partition("^")[0] for x in known)
        index = letters in _INDICES or letters.isupper() or any(map(below_others.search, bases))
        return bool(below) and index and letters not in known and not raised
    return len(letters) > LONGEST_PRODUCT or len({*letters}) < len(letters) or {*letters}.isdisjoint(known)
