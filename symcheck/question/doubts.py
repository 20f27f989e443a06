"""What keeps a counterexample from being one: a relation that says what a letter is, or an unsaid convention."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Collection, Iterable, Iterator
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction

from symcheck.core.calculus import functions, letters, nodes
from symcheck.core.problems import Problem
from symcheck.core.terms import Call as Applied
from symcheck.core.terms import Connective, Formula, Relation, Term
from symcheck.core.verdicts import SymcheckError
from symcheck.question.conventions import free, mentioned, unsaid
from symcheck.question.order_of_factors import commuted, relying_on_order
from symcheck.question.prepare import DEFINED, PAIR, VARIABLES, Definitions, Reading
from symcheck.reading import Tree, read, tex, to_latex
from symcheck.reading.commands import OVER
from symcheck.reading.inference import told_size
from symcheck.reading.landau import terms_of_order
from symcheck.reading.lexer import SIZES, SPACES
from symcheck.reading.lowering import ABOVE
from symcheck.reading.notation import SAID, Letter
from symcheck.reading.tree import (
    Add,
    Antiderivative,
    Bars,
    BigSum,
    Call,
    Chain,
    Cross,
    Derivative,
    Diag,
    Div,
    Limiting,
    MatrixOf,
    Mul,
    Name,
    Norm,
    Number,
    Pow,
    Root,
    Sqrt,
    Tuple,
    children,
    walk,
    with_children,
)

GREEK = frozenset({r"\mu", r"\nu", r"\rho", r"\sigma", r"\lambda", r"\kappa"})  # indices, above too: hardly exponents
INDICES = frozenset("ijklmn") | GREEK
EXACT = (1, 2, 4, 5, 8)  # denominators of decimals that nobody means to be rounded: 0.5, 0.25, 0.2
ANGULAR = ("sin", "cos", "tan", "tg", "cot", "ctg")
CONNECTIVES = ("for", "and", "or", "otherwise")  # words that stand between relations, and are no units
NUMBERS_ALONE = "it holds where its matrices have one row and column, as numbers do, and is not read for larger ones"
NORM = (r"\|", "Vert", r"\norm")  # what a norm is printed with
HAS_COMPONENTS = (MatrixOf, Tuple, Cross, Diag)
PLAIN = ("scalar", "function", "index")  # kinds of letters that are numbers
TURN = 6  # radians are about one turn; whole numbers above it are rather degrees
# a number with a unit: "5\,\text{kg}"
_UNIT = re.compile(r"\d(?:\s|~|\\[,;:!> ]|\\quad)*\\(?:text|mathrm|textrm|mbox|rm)\s*\{([^{}]*)\}")
# a number in brackets above a letter: "x^{(2)}", a derivative or a mere label
_LABEL = re.compile(r"\^\s*\{?\s*\(\s*\d+\s*\)")
# "\Delta(x)": the Laplacian or a difference, or a factor
_OPERATOR = re.compile(r"(\\(?:Delta|delta))\s*(?:\\left|\\big[lg]?|\\Big[lg]?)?\s*[(\[]")
# a letter with an accent that may stand for an operation
_ACCENTED = re.compile(r"\\(?:tilde|hat|widetilde|widehat|breve|check)\{(.+)\}")
# what may be the vectors of a basis: bold i, j, k, or a bold e with an index
_BASIS = re.compile(
    r"(?:\\(?:hat|widehat)\{)?\\(?:mathbf|boldsymbol|bm|pmb|vec)\{(?:\\?[ijk](?:math)?|e(?=\}+_))\}+(?:_\{?\w\}?)?"
)
_TYPED = re.compile(r"\\text\{([A-Za-z])\d+\}")  # a letter with digits behind it on the line: "v1"
# letters that mostly are complex numbers
_COMPLEX = frozenset({"z", "w", r"\zeta"})
_BARRED = re.compile(r"\\(?:bar|overline)\{")  # a letter with a line above it
_SKEW = re.compile(r"\[\\(?:tilde|widetilde)|\\lfloor")  # a matrix that is often made of a vector
# an expectation or transform before a bracket: "\mathbb{E}[x]", "E(x)"
_APPLIED = re.compile(
    r"(\\mathbb\s*\{?[A-Z]\}?|\\mathcal\s*\{?[A-Z]\}?|\\operatorname\{\w+\}|(?<![A-Za-z\\{])[EP])\s*(?:\\left|\\[bB]igl?)?\s*(?:\[|\\\{)"
)
# names of functions without a backslash: "sin x"
_FUNCTION = re.compile(r"(?<![A-Za-z\\])(?:a?rc)?(?:sin|cos|tan|cot|exp|log|ln|max|min|det|sqrt)h?(?![A-Za-z])")
# what opens a name of several letters, or words: "x_{max", "\mathrm{max"
_NAMED = re.compile(r"(?:_\s*|\\(?:math|text|operator|mbox|rm|begin|end|label|tag)[a-z]*\*?\s*)\{[^{}]*$")
# a brace below a term with what that is, but for words
_BRACED = re.compile(r"(\\(?:under|over)brace).*\}\s*[_^]\s*\{(?!\s*\\(?:text|mathrm|mbox))[^{}]*[A-Za-z]")
_UNIT_VECTOR = re.compile(r"\\(?:hat|widehat)\{\\(?:mathbf|boldsymbol|bm|pmb|vec)\{")  # a bold letter with a hat
_HAT = re.compile(r"(?:\\(?:mathbf|boldsymbol|bm|pmb)\{)?\\(?:hat|widehat)\{")  # a hat over a letter, bold or not
_WORD = re.compile(r"(?<![A-Za-z\\])[a-z]{4,}(?![A-Za-z])")  # small letters without a space
_LETTER = re.compile(r"(?:\\[A-Za-z]+|[A-Za-z])(?:_(?:\{[^{}]*\}|\w))?")  # a letter with its subscript
# a function before several letters without brackets: "\sin xy"
_BARE = re.compile(
    r"(\\(?:sin|cos|tan|cot|ln|log|lg|exp|sinh|cosh|tanh|arctan|arcsin|arccos))(?![A-Za-z])\s*"
    r"((?:(?:\\(?!sin|cos|tan|cot|ln|log|exp|left|right|math|bold|frac|sqrt|cdot|times|text|quad)[A-Za-z]+|[A-Za-z])"
    r"(?:_(?:\{[^{}]*\}|\w))?\s*){2,})"
)
_SUBSCRIPT = re.compile(r"_\{?([^{}]*)\}?$")  # the last subscript of a letter


def spelled_function(texts: Iterable[str]) -> str:
    """The doubt whether letters such as those of sin, outside of names and words, are meant as the function."""
    name = next((name for text in texts for name in functions_in_letters(text)), "")
    return f"is {name} the function, or a product of letters? write \\{name}, or spaces" if name else ""


def functions_in_letters(text: str) -> Iterator[str]:
    """The names of functions that are spelled in letters, outside of names and words."""
    return (found[0] for found in _FUNCTION.finditer(text) if not _NAMED.search(text[: found.start()]))


def braced(relation: str) -> str:
    """The doubt whether terms with braces that say what they are, are equal for all values of letters.

    Or whether a script behind braces, which nobody sees, belongs to all that stands in them.
    """
    if found := _BRACED.search(relation):
        return f"is what stands at {found[1]} equal by an equation to be solved? write it without the brace"
    texts = tex.texts(relation)
    for k, text in enumerate(texts):
        before = texts[k - 1] if k else ""
        if text != "{" or before in ("_", "^", "}", "]") or (before[:1] == "\\" and before not in SPACES):
            continue
        end = next((m for m in range(k, len(texts)) if texts[k : m + 1].count("{") == texts[k : m + 1].count("}")), k)
        inside = texts[k + 1 : end]
        several = len(inside) > 1 and all(part.isalnum() or part[:1] == "\\" for part in inside[:2])
        if texts[end + 1 : end + 2] == ("^",) and several and inside[0] not in OVER | SIZES:
            shown = "".join(inside)
            return (
                f"does the power behind {shown} in braces belong to all of it? write brackets around it, or no braces"
            )
    return ""


def defines(problem: Problem, *, bare: bool = False) -> bool:
    """Whether the claim says what a letter or a function is that occurs nowhere else; `bare`: the letter itself."""
    equations = [f for name, fs in problem.hypotheses if name != DEFINED for f in fs if f.tag == "="]
    said: list[Term] = [*equations, *(term for _, term in problem.definitions)]
    known = {name for name, _ in problem.definitions}.union(*map(letters, said), *map(functions, said))
    return _says_what_is_new(problem.claim, known, bare)


def _says_what_is_new(claim: Formula, known: set[str], bare: bool) -> bool:
    if isinstance(claim, Connective) and claim.tag == "or":  # one of two signs
        return all(_says_what_is_new(part, known, bare) for part in claim.formulas)
    if not isinstance(claim, Relation) or claim.tag != "=":
        return False
    left, right = claim.terms
    sides = [
        (side, other) for side, other in ((left, right), (right, left)) if not bare or isinstance(side, str | Applied)
    ]
    return any(_is_new(side, other, known) for side, other in sides)


def _is_new(side: Term, other: Term, known: set[str]) -> bool:
    """Whether a side is a new letter, a multiple or power of one, or a value or derivative of a new function."""
    if isinstance(side, Applied):
        own = {t for t in side.terms if isinstance(t, str)}
        highest = any(call.orders >= side.orders for call in _calls(other, side.function))
        return len(own) == len(side.terms) and side.function not in known and not highest
    alone = letters(side)
    if len(alone) != 1 or alone & (known | letters(other)):
        return False
    return isinstance(side, str) or all(part.tag in ("*", "^", "-", "/") for part in nodes(side))


def _calls(tree: Term, function: str) -> Iterator[Applied]:
    return (part for part in nodes(tree) if isinstance(part, Applied) and part.function == function)


def doubt(reading: Reading, orders: Collection[str] = ()) -> str:
    """The convention on which a relation may rely; "" if none is seen. Orders of functions are no indices."""
    asked = reading.source[0]
    said = {letter for letter, _ in asked.letters}
    unit = next((each for each in _UNIT.finditer(asked.relation) if each[1].strip() not in CONNECTIVES), None)
    if unit and unit[1] not in said and unit[0][unit[0].find("\\text") :] not in said:
        return f"{unit[1]} behind a number: a unit, or a letter? leave units out, or say what it is"
    for _, part in walk(reading.tree):
        if isinstance(part, Number) and "." in part.text and Fraction(part.text).denominator not in EXACT:
            return f"is {part.text} exact, or rounded? write a fraction, or \\approx"
        if isinstance(part, Call) and part.function in ANGULAR and _in_degrees(part.arguments[0]):
            return f"is the argument of {part.function} in degrees, or in radians? write ^\\circ for degrees"
        if isinstance(part, Name) and _LABEL.search(part.letter) and part.letter not in said:
            return f"{part.letter}: a label, a power or a derivative? say what it is"
    if (sign := _OPERATOR.search(asked.relation)) and sign[1] not in said:
        return f"{sign[1]} before brackets: a letter, or a change of what is in them? say what it is"
    if is_overlined(reading.tree):
        return r"is the line above a sum or product its conjugate, or a mean? write \bar above a letter too"
    if reason := doubt_of_proofs(reading) or _matrix_of_vector(reading, said) or _angle_between(reading):
        return reason
    units = [g.letter for g in reading.inference.guesses if _UNIT_VECTOR.match(g.letter.latex) and g.letter.depends]
    if units and not {*said, *reading.source[2]} & {each.latex for each in units}:
        return f"is {units[0].latex} always of length 1? say so, as |{units[0].latex}| = 1, or what it is"
    spelled = {g.letter.latex for g in reading.inference.guesses}
    if slopes := sorted(x for x in spelled - said if x.startswith(r"\nabla")):
        return f"what does {slopes[0]} belong to? write brackets around all that is differentiated"
    pairs = ((x, PAIR.fullmatch(x)) for x in spelled - said)
    if both := [
        x for x, p in pairs if p and p["first"] and not x[-3:-1].isalnum() and f"{p['stem']}_{p['first']}" in spelled
    ]:
        return f"is {both[0]} one letter for two of the others? write an equation for each"
    typed = ((x, found[1]) for x in spelled - said if (found := _TYPED.fullmatch(x)))
    if alone := next((x[6:-1] for x, stem in typed if stem in spelled), ""):
        return f"is {alone} a letter, or {alone[0]} times {alone[1:]}? write {alone[0]}_{{{alone[1:]}}}, or a \\cdot"
    if named := [x for x in spelled if _UNIT_VECTOR.match(x) and x[x.find("{") + 1 : -1] in spelled and x not in said]:
        return f"is {named[0]} the unit vector along {named[0][named[0].find('{') + 1 : -1]}? say what it is"
    hats = [
        g.letter.latex for g in reading.inference.guesses if g.letter.kind == "vector" and _HAT.match(g.letter.latex)
    ]
    if free := [x for x in hats if x not in said and not mentioned(x, (*asked.where, *asked.given))]:
        return f"is {free[0]} of length 1, or one of several axes? say so, as |{free[0]}| = 1, or what it is"
    if member := next(_members(reading.tree, spelled - said), ""):
        return f"is {member} a member of the family that is summed over? write brackets around the subscripts, as x[n]"
    if any(part.tag == "!=" for problem in reading.problems for part in _relations(problem.claim)):
        return "is it meant that the sides are never equal, or that they are not always equal?"
    if reason := _of_a_word(asked.relation) or _behind_function(asked.relation) or _alone(reading):
        return reason
    if name := _along(reading):
        return f"is {name} held constant in a derivative by a letter that varies with it? write \\partial if it is"
    if name := _integrated(reading):
        return f"does the integral say what {name} is? give another equation for it, or the integral with its bounds"
    if name := _limited(reading):
        return f"does the limit say what {name} is? give another equation for it"
    if polynomial := _order_of_polynomials(reading):
        return f"{polynomial} where its letter goes to 0, or to infinity? compare coefficients"
    if index := next((x for x in _repeated(reading.tree) if x not in orders), ""):
        return f"is {index} summed over, as it is repeated in a product? write the sum"
    return ""


def _of_a_word(relation: str) -> str:
    """The doubt whether letters that stand together are a word."""
    for found in _WORD.finditer(relation):
        if not _NAMED.search(relation[: found.start()]) and set(found[0]) & set("aeiou"):
            return f"is {found[0]} a word, or a product of letters? write \\text{{{found[0]}}}, or spaces"
    return ""


def _behind_function(relation: str) -> str:
    """The doubt whether the last of several letters behind a function, which stands elsewhere too, is its factor."""
    letters_ = [(found[1], _LETTER.findall(found[2])) for found in _BARE.finditer(relation)]
    every = Counter(_LETTER.findall(re.sub(r"d\s*[A-Za-z]", "", relation)))  # but for differentials
    for name, inside in letters_:
        if (
            len(inside) > 1
            and inside[-1] not in VARIABLES
            and every[inside[-1]] > sum(own.count(inside[-1]) for _, own in letters_)
        ):
            return f"does {inside[-1]} belong to the argument of {name}? write brackets"
    return ""


def _alone(reading: Reading) -> str:
    """The doubt whether an i that a relation says what it is, is the imaginary unit."""
    units = {g.letter.latex for g in reading.inference.guesses if g.letter.number == "i" and g.why != SAID}
    members = reading.tree.members if isinstance(reading.tree, Chain) else ()
    alone = [each.letter for each in members if isinstance(each, Name) and each.letter in units]
    return f"is {alone[0]} the imaginary unit, or a letter? say what it is" if alone else ""


def _relations(claim: Formula) -> Iterator[Formula]:
    if isinstance(claim, Relation):
        yield claim
    elif isinstance(claim, Connective) and claim.tag in ("and", "or"):
        for part in claim.formulas:
            yield from _relations(part)


def held(reading: Reading, used: Iterable[str]) -> str:
    """The doubt whether letters are constant where differentials are taken; what is false then is so in any case."""
    names = sorted({x for name in ("", *used) for x in reading.held.get(name, ())})
    owners = map(reading.inference.notation.owner, names)
    said = dict(reading.source[0].letters)
    letters_ = dict.fromkeys(letter.latex for letter in owners if letter and letter.latex not in said)
    return f"say whether {', '.join(letters_)} is constant where differentials are taken" if letters_ else ""


def doubt_of_proofs(reading: Reading) -> str:
    """The convention on which even a proof may rely; the empty text if none is seen."""
    asked, inference = reading.source[0], reading.inference
    said = {letter for letter, _ in asked.letters}
    names = {part.letter for _, part in walk(reading.tree) if isinstance(part, Name)}
    if names & {"d", r"\text{d}"} - said - reading.source[2].keys() and not names >= {"a", "b", "c", "d"}:
        return "d: a letter, or the sign of a differential? say what it is"
    factors = {part.letter for _, part in walk(reading.tree) if isinstance(part, Name)}
    for _, part in walk(reading.tree):
        if isinstance(part, Name) and part.primes and part.letter in reading.source[2].keys() - said:
            if reading.source[2][part.letter][1]:
                continue  # a function of one letter
            return f"the prime of {part.letter}: a derivative, by which letter? or another letter? say what it is"
    if inference.remote and any(_may_be_mean(part) for _, part in walk(reading.tree)):
        return "is the line above a power or product its conjugate, or a mean? say whether its letters are complex"
    begun = any(re.search(r"\b[EP]\[\d", text) for text in asked.where)  # a sequence with its first values
    if not begun and (applied := _APPLIED.search(asked.relation)) and applied[1] in factors - said:
        return f"{applied[1]} before square brackets: a factor, or an expectation or a transform of what is in them?"
    known = {g.letter.latex for g in inference.guesses if g.why == SAID}
    known |= said | {*reading.source[2]}
    keeping = {g.letter.latex for g in inference.guesses if g.letter.kind in ("matrix", "vector")}  # their order
    if ordered := relying_on_order(reading.tree, known) or commuted(reading.tree, known | keeping):
        return f"it relies on the order of factors: are {', '.join(ordered)} numbers, or matrices? say what they are"
    if told_size(1) in inference.choices:
        return NUMBERS_ALONE
    return _norm_of_numbers(reading) or _unchanging(reading) or unsaid(reading)


def _norm_of_numbers(reading: Reading) -> str:
    """The doubt what stands between the signs of a norm, where it is a number only because nothing tells more of it.

    What holds of numbers, such as that the norm of a product is the product of the norms, need not hold of matrices.
    """
    guesses = {g.letter.latex: g for g in reading.inference.guesses}
    trees = [reading.tree]
    for text in (*reading.source[0].where, *reading.source[0].given):
        with suppress(SymcheckError):
            trees += [read(text, reading.inference.notation)] if any(sign in text for sign in NORM) else []
    for norm in (part for tree in trees for _, part in walk(tree) if isinstance(part, Norm)):
        inside = [part for _, part in walk(norm.value)]
        found = [guesses[part.letter] for part in inside if isinstance(part, Name) and part.letter in guesses]
        if any(isinstance(part, HAS_COMPONENTS) for part in inside) or any(g.letter.kind not in PLAIN for g in found):
            continue
        if unsaid_ := [g.letter.latex for g in found if g.why != SAID and not _is_number(g.letter, reading)]:
            return f"{', '.join(dict.fromkeys(unsaid_))} in a norm: a number, a vector or a matrix? say what it is"
    return ""


def _is_number(letter: Letter, reading: Reading) -> bool:
    """Is it a constant such as pi, or said to be a number by its set or its sign?"""
    own = (text.strip() for text in reading.source[0].given)
    behind = (text.removeprefix(letter.latex).lstrip() for text in own if text.startswith(letter.latex))
    return bool(letter.number) or any(text.startswith((r"\in", "<", ">", r"\le", r"\ge")) for text in behind)


def _unchanging(reading: Reading) -> str:
    """The doubt whether letters are constant that stand in what an equation says of a letter with a derivative.

    Directions turn, unless they are said not to; and something there changes, or nobody would differentiate it.
    """
    asked, inference, known, *_ = reading.source
    own = {guess.letter.latex: guess.letter for guess in inference.guesses}
    constant = {letter for letter, phrase in asked.letters if phrase.startswith("constant")}
    for name, (_, arguments, _) in known.items():
        variables = own[name].depends if name in own and not arguments else ""
        if not variables:
            continue
        inside = [own[x] for x in _said_by(name, known) if x in own and x not in known]
        places = {*variables.split(", ")}
        places |= {x for place in places & known.keys() for x in _said_by(place, known)}  # components
        varying = [x for x in inside if x.depends or x.latex in places or (x.skew in own and own[x.skew].depends)]
        if inside and not varying and not all(x.latex in constant for x in inside):
            shown = ", ".join(x.latex for x in inside)
            return f"{name} is differentiated; which of {shown} changes? say what depends on what"
        vectors = [x.latex for x in inside if x.kind == "vector" and x not in varying]
        if turning := next((x for x in vectors if x not in constant), ""):
            return (
                f"does {turning} change with {variables}? say that it is a constant vector, or depends on {variables}"
            )
    return ""


def _said_by(name: str, known: Definitions) -> set[str]:
    """The letters in what equations say of a letter, and of those letters in turn."""
    found = set[str]()
    open_ = [name]
    while open_:
        right = known[open_.pop()][2]
        new = {letter for letter, *_ in free(right)} - found
        found |= new
        open_ += new & known.keys()
    return found


def _members(tree: Tree, spelled: Iterable[str]) -> Iterator[str]:
    """Letters such as H_n beside a sum over H_k: of that family nothing is said at n, at which it has a value."""
    families = {
        p.letter for _, p in walk(tree) if isinstance(p, Name) and any(isinstance(x, str) for x in p.subscripts)
    }
    for latex in sorted(spelled):
        stem, below, subscript = latex.partition("_")
        if below and stem in families and re.search(r"(?<![A-Za-z\\])[A-Za-z](?![A-Za-z])", subscript):
            yield latex


def with_swapped_angles(tree: Tree) -> Tree:
    """The same with the arguments of angles of two arguments the other way round, as some programs have them."""
    if isinstance(tree, Call) and tree.function in ("atan2", "arctan2"):
        return replace(tree, arguments=tuple(map(with_swapped_angles, reversed(tree.arguments))))
    return with_children(tree, tuple(map(with_swapped_angles, children(tree))))


def with_arguments_above(tree: Tree) -> Tree:
    """The same with arguments of complex numbers in [0, 2 pi), as some have them."""
    new = with_children(tree, tuple(map(with_arguments_above, children(tree))))
    return replace(new, function=ABOVE) if isinstance(new, Call) and new.function in ("arg", "Arg") else new


def _may_be_mean(tree: Tree) -> bool:
    """Is there a line above something of other letters than those that are usual for complex numbers?"""
    overlined = isinstance(tree, Call) and tree.function == "overlined"
    return overlined and any(isinstance(x, Name) and x.letter.partition("_")[0] not in _COMPLEX for _, x in walk(tree))


def is_overlined(tree: Tree) -> bool:
    """Is there a line over more than a letter, and over no letter alone: a mean, or a conjugate?"""
    over = any(isinstance(part, Call) and part.function == "overlined" for _, part in walk(tree))
    return over and not any(isinstance(part, Name) and _BARRED.match(part.letter) for _, part in walk(tree))


def with_longer_arguments(tree: Tree) -> Tree:
    r"""The same with letters behind a function of a sum in its argument: of (2k + 1) x in `\cos(2k + 1) x`."""
    new = with_children(tree, tuple(map(with_longer_arguments, children(tree))))
    if not isinstance(new, Mul):
        return new
    factors = list[Tree]()
    for factor in new.factors:
        match factors[-1:]:
            case [Call(function, (Add() as angle,))] if function in ANGULAR and isinstance(factor, Name):
                factors[-1] = Call(function, (Mul((angle, factor)),))
            case [Call(function, (Mul((Add(), *_) as inside),))] if function in ANGULAR and isinstance(factor, Name):
                factors[-1] = Call(function, (Mul((*inside, factor)),))
            case _:
                factors.append(factor)
    if len(factors) == len(new.factors):
        return new
    return Mul(tuple(factors)) if len(factors) > 1 else factors[0]


def _order_of_polynomials(reading: Reading) -> str:
    """The term of an order beside polynomials alone, which may be meant for large values too."""
    notation, defined = reading.inference.notation, reading.source[2]
    orders = terms_of_order(reading.tree, notation=notation)
    trees = [reading.tree, *(read(right, notation) for _, _, right in defined.values())] if orders else []
    parts = [part for tree in trees for _, part in walk(tree) if part not in {call for _, _, call in orders}]
    bends = any(
        isinstance(p, Call | Sqrt | Root)
        or (isinstance(p, Div) and _has_letters(p.bottom))
        or (isinstance(p, Pow) and _has_letters(p.exponent))
        for p in parts
    )
    return "" if bends or not orders else to_latex(orders[0][2])


def _has_letters(tree: Tree) -> bool:
    return any(isinstance(part, Name) for _, part in walk(tree))


def _angle_between(reading: Reading) -> str:
    """The doubt whether an angle that nothing else says is that between the vectors of a product."""
    vectors = any(g.letter.kind == "vector" for g in reading.inference.guesses)
    lengths = any(isinstance(part, Bars | Norm) for _, part in walk(reading.tree))
    vectors |= lengths and any(sign in reading.source[0].relation for sign in (r"\cdot", r"\times"))
    calls = [part for _, part in walk(reading.tree) if isinstance(part, Call) and part.function in ANGULAR]
    angles = {call.arguments[0] for call in calls if isinstance(call.arguments[0], Name)}
    elsewhere = " ".join((*reading.source[0].where, *reading.source[0].given))
    for angle in angles if vectors else ():
        places = [part for _, part in walk(reading.tree) if part == angle]
        if isinstance(angle, Name) and len(places) == 1 and angle.letter not in elsewhere:
            return f"is {angle.letter} the angle between the vectors? say what it is"
    return ""


def _matrix_of_vector(reading: Reading, said: set[str]) -> str:
    r"""The doubt what `\tilde{\omega}` or `S(\omega)` is where omega is a vector: often it is its skew matrix."""
    letters_ = [guess.letter for guess in reading.inference.guesses if guess.letter.latex not in said]
    vectors = {letter.latex for letter in letters_ if letter.kind == "vector"}
    known = reading.source[2]
    repeated = any(len(letter.partial) > 2 for letter in letters_)
    basis = [letter.latex for letter in letters_ if letter.kind == "vector" and _BASIS.fullmatch(letter.latex)]
    if len(basis) > 1 and not {*basis} & known.keys():
        return f"are {', '.join(basis)} perpendicular and of length 1? say what they are"
    for letter in letters_:
        if len(letter.partial) == 2 and not repeated and "(" not in known[letter.partial[0]][0]:
            return f"is {letter.latex} a derivative of {letter.partial[0]}, or a component? say what it is"
        if letter.kind == "matrix" and letter.latex not in known and _SKEW.match(letter.latex.replace(" ", "")):
            return f"is {''.join(letter.latex.split())} a skew matrix, of which vector? say what it is"
        accented = _ACCENTED.fullmatch(letter.latex)
        if accented and accented[1] in vectors and letter.kind == "scalar":
            return f"is {letter.latex} a number, or the skew matrix of {accented[1]}? say what it is"
    calls = [part for _, part in walk(reading.tree) if isinstance(part, Call)]
    for name, arguments in ((call.function, call.arguments) for call in calls):
        of_vector = any(isinstance(each, Name) and each.letter in vectors for each in arguments)
        if isinstance(name, Name) and name.letter not in {*said, *known} and of_vector:
            return f"is {name.letter} of a vector a number, a vector or a matrix? say what it is"
    return ""


def _along(reading: Reading) -> str:
    """The letter that total derivatives by what depends on another letter may hold constant, in a loose notation.

    It stands beside the variable in what is differentiated, or the same is differentiated by another letter too.
    """
    own = {guess.letter.latex: guess.letter for guess in reading.inference.guesses}
    moving = {x for x, letter in own.items() if letter.depends}
    times = {x for letter in own.values() for x in (letter.depends or "").split(", ")}
    slopes = [part for _, part in walk(reading.tree) if isinstance(part, Derivative)]
    of = {
        slope: {name.letter for tree, _ in slope.variables for _, name in walk(tree) if isinstance(name, Name)}
        for slope in slopes
    }
    for slope in slopes:
        by = of[slope] & moving
        if slope.partial or not by:
            continue
        inside = {name.letter for _, name in walk(slope.body) if isinstance(name, Name) and not name.dots}
        if by & inside and (others := sorted(inside & moving - by)):
            return others[0]
        same = [other for other in slopes if other.body == slope.body]
        if others := sorted({x for other in same for x in of[other] if other.partial or x not in times} - by):
            return others[0]
    return ""


def _limited(reading: Reading) -> str:
    """A letter that is equal to a limit and occurs nowhere else."""
    members = reading.tree.members if isinstance(reading.tree, Chain) else ()
    elsewhere = " ".join((*reading.source[0].where, *reading.source[0].given))
    names = [part for _, part in walk(reading.tree) if isinstance(part, Name)]
    for name in (m for m in members if isinstance(m, Name) and any(isinstance(other, Limiting) for other in members)):
        if names.count(name) == 1 and name.letter not in elsewhere:
            return to_latex(name)
    return ""


def _integrated(reading: Reading) -> str:
    """The letter that an integral without bounds may define, as I = int r^2 dm does."""
    members = reading.tree.members if isinstance(reading.tree, Chain) else ()
    if any(isinstance(part, Antiderivative) for _, part in walk(reading.tree)):
        alone = [each.letter for each in members if isinstance(each, Name)]
        return next((letter for letter in alone if letter not in reading.source[2]), "")
    return ""


def _in_degrees(argument: Tree) -> bool:
    """Is it a whole number that hardly anybody would mean in radians?"""
    return isinstance(argument, Number) and argument.text.isdigit() and int(argument.text) > TURN


def _repeated(tree: Tree) -> Iterator[str]:
    """Indices that stand twice in one addend and not in another, as by Einstein's convention."""
    members = tree.members if isinstance(tree, Chain) else ()
    addends = [term for member in members for term in (member.terms if isinstance(member, Add) else (member,))]
    counts = [_indices(addend) for addend in addends]
    for count in counts:
        yield from (x for x, n in count.items() if n > 1 and any(not other[x] for other in counts))


def _indices(addend: Tree) -> Counter[str]:
    found: Counter[str] = Counter()
    bound: set[str] = set()
    for _, part in walk(addend):
        if isinstance(part, BigSum):
            bound |= {*map(str, part.indices)}
        if isinstance(part, Name):
            spelled = _SUBSCRIPT.search(part.letter)
            tokens = tex.texts(spelled[1]) if spelled else ()
            found.update(x for x in (*tokens, *part.subscripts) if x in INDICES)
        if isinstance(part, Pow) and isinstance(part.exponent, Name) and part.exponent.letter in GREEK:
            found[part.exponent.letter] += 1
    return Counter({x: n for x, n in found.items() if x not in bound})
