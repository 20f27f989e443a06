"""What is typed as letters in LaTeX that are none: names of functions, Greek letters, words, norms and numbers."""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterator, Sequence

from symcheck.core.verdicts import SymcheckError
from symcheck.reading import tex
from symcheck.reading.commands import ARGUMENTS, LETTER_COMMANDS


def _with_norms(toks: Sequence[tex.Tok]) -> list[tex.Tok]:
    """The same with one token for the double bars of a norm that are typed as two, `|| x ||`."""
    found, k, single, opened = list[tex.Tok](), 0, 0, False
    double = [a.text == b.text == "|" and b.at == a.at + 1 for a, b in itertools.pairwise(toks)] + [False]
    if not any(double):
        return [*toks]
    while k < len(toks):
        begins = double[k] and not single % 2 and any(double[k + 2 :])
        if double[k] and (opened or begins):
            found.append(tex.Tok(r"\|", toks[k].at))
            opened, k = not opened, k + 2
            continue
        single += toks[k].text == "|"
        found.append(toks[k])
        k += 1
    return found


def _with_words(source: str) -> list[tex.Tok]:
    """The tokens of TeX; functions printed as italic letters become commands, and words in text keep a space."""
    toks, found = tex.tokenize(source), list[tex.Tok]()
    if "||" in source:
        toks = _with_norms(toks)
    k, text_ends, inside = 0, -1, 0
    scripts: list[bool] = []  # is each open brace that of a script, or of an argument?
    while k < len(toks):
        tok = toks[k]
        if tok.text == "{":
            before = toks[k - 1].text if k else ""
            scripts.append(before in ("_", "^") or (before[:1] == "\\" and before not in _OF_FORMULAS))
            inside += scripts[-1]
        elif tok.text == "}" and scripts:
            inside -= scripts.pop()
        if tok.text == "_" and k >= text_ends and (below := _typed_below(toks, k)):
            raise SymcheckError(f"_{below}: one subscript, or a product? write _{{{below}}}, or a space behind it")
        if tok.text == "e" and not inside and (power := _scientific(toks, k)):
            spelled = (r"\cdot", "1", "0", "^", "{", *str(int(power)), "}")
            found += [tex.Tok(text, tok.at + n) for n, text in enumerate(spelled)]  # their places make one number
            k += 1 + len(power)
            continue
        if tok.text in _TEXTS and k + 1 < len(toks) and toks[k + 1].text == "{":
            text_ends = _closing(toks, k + 1)
        if k < text_ends:
            spaced = k > 1 and toks[k - 1].text.isalpha() and tok.text.isalpha() and tok.at > toks[k - 1].at + 1
            found += [tex.Tok("~", tok.at - 1)] if spaced else []
            tok = tex.Tok(r"\_", tok.at) if tok.text == "_" else tok
        elif tok.text.isalpha() and not inside and (count := _digits_behind(toks, k)):
            found += [
                tex.Tok(text, tok.at) for text in (r"\text", "{", *(t.text for t in toks[k : k + 1 + count]), "}")
            ]
            k += 1 + count
            continue
        elif tok.text.isalpha() and len(word := _letters(toks, k)) > 1:
            if _is_greek(word, toks, k) or _is_command(word, toks, k):
                made = [f"\\{word}"]
            elif word == "exp" and [t.text for t in toks[k - 1 : k] + toks[k + 3 : k + 4]] == ["{", "}"] and inside:
                made = [r"\text", "{", *word, "}"]  # a label
            elif _is_function(word, toks, k):
                made = [f"\\{_OTHERWISE.get(word, word)}"]
            elif not inside and _is_word(word, toks, k):
                made = [r"\bmod"] if word == "mod" else [r"\text", "{", *word, "}"]
            else:
                made, word = [tok.text], tok.text
            found += [tex.Tok(text, tok.at) for text in made]
            k += len(word)
            continue
        found.append(tok)
        k += 1
    return found


def _typed_below(toks: Sequence[tex.Tok], k: int) -> str:
    """The word, or the two indices, typed behind the sign of a subscript without braces: `F_net`, `g_ij`.

    Print puts only the first letter below. Nothing if scripts or brackets show that the others are factors, as in
    `x_iy_i`, or if one other letter may well be one, as in `m_Av`: a capital, or a small one that stands elsewhere.
    """
    base = toks[k - 1].text if k else ""
    if not (base.isalpha() or base == "}") or k + 1 == len(toks) or not toks[k + 1].text.isalpha():
        return ""
    end = k + 2
    while end < len(toks) and toks[end].text.isalpha() and toks[end].at == toks[end - 1].at + 1:
        end += 1
    behind = toks[end].text if end < len(toks) else ""
    word = "".join(tok.text for tok in toks[k + 1 : end])
    twins = word.isupper() and any(_is_twice(toks, m, base) for m in range(len(toks) - 2))
    twins = twins or (len(word) == 2 and word.islower() and len({*word}) == 1)  # `I_xx`, or `p_x x`
    twins = twins or (k == 1 and len(word) == 2 and word.isupper() and behind == "=")  # all that a side holds
    meant = len(word) > 2 or (len({*word}) == 2 and ({*word} <= _INDICES or _is_never_apart(toks, word))) or twins
    named = len(word) > 2 and word.islower() and behind == "^" and _is_alone(toks, word)
    return word if meant and (named or behind not in ("_", "^", "(", "'", r"\left")) else ""


def _is_alone(toks: Sequence[tex.Tok], word: str) -> bool:
    """Do the letters behind the first one of a word stand nowhere else?"""
    return all(sum(tok.text == letter for tok in toks) == word.count(letter) for letter in word[1:])


def _is_never_apart(toks: Sequence[tex.Tok], word: str) -> bool:
    """Does the second of two small letters stand nowhere but behind the first one in a subscript?

    Where a factor stands behind such a subscript anywhere, as in `x_iy_i`, this one may be a factor too.
    """
    second = [k for k, tok in enumerate(toks) if tok.text == word[1]]
    ended = any(a.text == d.text == "_" and b.text.isalpha() and c.text.isalpha() for a, b, c, d in _fours(toks))
    return (
        word.islower()
        and not ended
        and all(
            k > 1 and toks[k - 2].text == "_" and toks[k - 1].text == word[0] and toks[k].at == toks[k - 1].at + 1
            for k in second
        )
    )


def _fours(toks: Sequence[tex.Tok]) -> Iterator[tuple[tex.Tok, ...]]:
    return zip(toks, toks[1:], toks[2:], toks[3:], strict=False)


def _is_twice(toks: Sequence[tex.Tok], k: int, base: str) -> bool:
    """Does one capital stand twice behind the subscript sign here, which no factor would: `C_XX`?"""
    sign, first, second = toks[k : k + 3]
    same = sign.text == "_" and first.text == second.text and second.at == first.at + 1
    return same and k > 0 and toks[k - 1].text == base and first.text.isupper()


_INDICES = frozenset("ijklmn")


LONGEST_PRODUCT = 4  # small letters that are typed without a space
DECIMALS = 3  # digits before an e behind which nobody adds a whole number
_POWER_OF_TEN = re.compile(r"e([-+]\d\d?)(?![\w.])")  # with two digits, as computers print it, or behind decimals


def _scientific(toks: Sequence[tex.Tok], k: int) -> str:
    """The sign and digits of the power of ten at an e, as in `2.5e-07` and `2.0471e+14`; `2e+10` may be a sum."""
    run = [toks[k]]
    while k + len(run) < len(toks) and toks[k + len(run)].at == run[-1].at + len(run[-1].text):
        run.append(toks[k + len(run)])
    number = k > 0 and toks[k - 1].text.isdigit() and toks[k - 1].at + 1 == toks[k].at
    found = _POWER_OF_TEN.match("".join(tok.text for tok in run)) if number else None
    decimals = "".join(tok.text for tok in toks[max(0, k - DECIMALS) : k])
    sure = len(decimals) == DECIMALS and decimals.isdigit()
    return found[1] if found and (sure or found[1][1:].startswith("0")) else ""


_OF_NUMBERS = frozenset(".0123456789")


def _digits_behind(toks: Sequence[tex.Tok], k: int) -> int:
    """The number of digits that are printed at a letter, as in `v1`, and belong to its name."""
    if not (k + 1 < len(toks) and toks[k + 1].text.isdigit()):
        return 0
    before = toks[k - 1] if k else tex.Tok("", -2)
    if before.text in ("_", "^") or before.text in ARGUMENTS:
        return 0
    if before.at == toks[k].at - 1 and before.text.isalnum():
        return 0
    end = k + 1
    while end < len(toks) and toks[end].text.isdigit() and toks[end].at == toks[k].at + end - k:
        end += 1
    behind = toks[end] if end < len(toks) else tex.Tok("", -2)
    adjacent = behind.at == toks[k].at + end - k and (tex.is_letter(behind.text) or behind.text[:1] in _OF_NUMBERS)
    one_sided = [tok.text for tok in toks[k + 1 : k + 5] if tok.text != "{"][:3] in (["0", "^", "+"], ["0", "^", "-"])
    return 0 if adjacent or one_sided or _is_base(toks, end) else end - k - 1


def _is_base(toks: Sequence[tex.Tok], end: int) -> bool:
    """Is a number raised to a power with letters in it, as in `n2^{n-1}`? Then it is a factor."""
    if [tok.text for tok in toks[end : end + 1]] != ["^"] or end + 1 == len(toks):
        return False
    last = _closing(toks, end + 1) if toks[end + 1].text == "{" else end + 1
    return any(tok.text.isalpha() for tok in toks[end + 1 : last + 1])


_OF_FORMULAS = frozenset({r"\frac", r"\dfrac", r"\tfrac", r"\cfrac", r"\left", r"\right"})  # arguments are formulas
_TEXTS = frozenset(
    {r"\text", r"\operatorname", r"\textrm", r"\mbox", r"\textnormal", r"\textit", r"\texttt", r"\mathrm", r"\mathit"}
)
_TYPED = frozenset({"arcsin", "arccos", "arctan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "sin", "cos", "tan"})
_TYPED |= {"exp", "log", "ln", "max", "min", "argmax", "argmin"}
_OTHERWISE = {"asin": "arcsin", "acos": "arccos", "atan": "arctan"}


def _closing(toks: Sequence[tex.Tok], k: int) -> int:
    """Where the brace that opens here is closed."""
    depth = 0
    for m in range(k, len(toks)):
        depth += (toks[m].text == "{") - (toks[m].text == "}")
        if not depth:
            return m
    return len(toks)


def _letters(toks: Sequence[tex.Tok], k: int) -> str:
    """The letters from here on that are typed without spaces."""
    end = k
    while end < len(toks) and toks[end].text.isalpha() and toks[end].at == toks[k].at + end - k:
        end += 1
    return "".join([tok.text for tok in toks[k:end]])


def _is_greek(word: str, toks: Sequence[tex.Tok], k: int) -> bool:
    """Is this a Greek letter that is typed by its name? Those of two letters may be products."""
    begins = not k or not toks[k - 1].text.isalpha() or toks[k - 1].at != toks[k].at - 1
    return begins and len(word) > 2 and f"\\{word}" in LETTER_COMMANDS


def _is_command(word: str, toks: Sequence[tex.Tok], k: int) -> bool:
    """Is this a command whose backslash is missing: `(z - hat{x})^2`?"""
    begins = not k or not toks[k - 1].text.isalpha() or toks[k - 1].at != toks[k].at - 1
    return begins and word in _COMMANDS and [tok.text for tok in toks[k + len(word) :][:1]] == ["{"]


def _is_function(word: str, toks: Sequence[tex.Tok], k: int) -> bool:
    """Is this a function whose name is typed as letters: `max(a, b)`, `v cos\\theta`?"""
    if word not in _TYPED:
        return False
    start, end = k, k + len(word)
    while start and toks[start - 1].text.isalpha() and toks[start - 1].at == toks[start].at - 1:
        start -= 1
    behind = [tok.text for tok in toks[end : end + 2]]
    brackets = behind[:1] == ["("] or behind == [r"\left", "("]
    brackets = brackets or (word in ("max", "min") and start == k and behind[:1] == ["_"])  # over an index
    angle = next((tok.text for tok in toks[end : end + 4] if tok.text not in _BEFORE_ANGLE), "") in LETTER_COMMANDS
    whole = start == k and len(word) > 2 and word not in ("max", "min")  # neither a product of letters nor a label
    of_angle = angle and word in ("sin", "cos", "tan")
    return of_angle or (k - start < 2 and (brackets or whole))


_BEFORE_ANGLE = frozenset({"{", "^", "2", "3"})  # as in cos^2{\theta}
# words that are typed as letters: operators, and what no product of letters looks like
_OPERATORS = frozenset({"mod", "res", "rem", "gcd", "lcm", "div", "rot", "curl", "grad", "span", "rank", "sgn", "erf"})


def _is_word(word: str, toks: Sequence[tex.Tok], k: int) -> bool:
    """Is this a word that is typed as letters: an operator, one with an o, or a long one, defined or capitalised?"""
    end = k + len(word)
    inside = k > 0 and (toks[k - 1].at == toks[k].at - 1 and toks[k - 1].text.isalnum())
    first = not k or toks[k - 1].text in ("&", r"\\")
    behind = toks[end].text if end < len(toks) and first else ""
    defined = (len(word) > 3 and behind in ("(", "=")) or (len(word) > 4 and word.istitle())
    named = (word in _ANGLES and behind == "=") or (len(word) > 2 and (word in _OPERATORS or "o" in word or defined))
    opening = [tok.text for tok in toks[end : end + 1]]
    applied = word in _OF_VARIABLES and opening in (["("], ["["], [r"\left"])
    applied = applied or (word == "Li" and opening in (["_"], ["("]))  # the logarithmic integral, and polylogarithms
    behind_brace = [tok.text for tok in toks[end + 1 : end + 2]] if opening == ["{"] else opening
    applied = applied or (word in ("tr", "Tr") and behind_brace in _OF_STYLE)  # of a matrix
    cost = word == "cost" and first and behind == "("
    initials = first and behind == "(" and word.isupper() and len(word) > 2  # as in MSD(t) =
    named |= len(word) > LONGEST_PRODUCT and word.islower() and len({*word}) > 2
    named = (named and not _WITH_FUNCTION.search(word)) or applied or cost or initials
    return word.isascii() and named and not inside


# commands whose backslash is missing, before a brace
_COMMANDS = frozenset({"hat", "bar", "dot", "ddot", "vec", "tilde", "sqrt", "mathbf"})
# operators of statistics, before brackets
_OF_VARIABLES = frozenset({"var", "Var", "cov", "Cov", "std", "Std", "corr", "Corr", "SE", "cdf", "pdf", "CDF", "PDF"})
# and functions that have other names in print
_OF_VARIABLES |= {
    "mean",
    "avg",
    "abs",
    "sum",
    "acf",
    "sign",
    "trace",
    "tr",
    "Tr",
    "sinc",
    "Sinc",
    "rect",
    "Rect",
    "Sin",
    "Cos",
    "Tan",
    "Exp",
    "Log",
    "Ln",
}
_OF_STYLE = ([r"\mathbf"], [r"\boldsymbol"], [r"\bm"], [r"\underline"])
_ANGLES = frozenset({"Az", "El"})  # azimuth and elevation
_WITH_FUNCTION = re.compile("sin|cos|tan|log|exp|max|min|ln")  # typed as letters, and a product with it


def typed(source: str) -> list[str]:
    """The tokens of TeX, but digits that follow one another are one; a command takes only the first of them."""
    found: list[str] = []
    end = -1
    for text, at in _with_words(source):
        if at == end and (text == "." or text.isdigit()) and _goes_on(text, found):
            found[-1] += text
        else:
            found.append(text)
        end = at + len(text)
    return found


def _goes_on(text: str, found: Sequence[str]) -> bool:
    """Does a digit or a point belong to the number that ends before it?"""
    last, before = found[-1], found[-2] if len(found) > 1 else ""
    if last[-1:] == ".":
        return last[:1].isdigit() and text.isdigit()
    digits = last.isdigit() if text == "." else last[-1:].isdigit()
    return digits and before not in ("_", "^") and before not in ARGUMENTS
