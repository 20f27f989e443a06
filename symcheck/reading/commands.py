r"""Which LaTeX commands and upright words are letters. Everything else has a meaning of its own, or none that is known.

The list is of what may be a letter rather than of what may not: a command that is missing here is refused, and never
multiplied by.
"""

from __future__ import annotations

_GREEK = (
    "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi omicron pi rho sigma tau upsilon phi chi "
    "psi omega digamma Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega"
)
_VARIANTS = (
    "varepsilon vartheta varkappa varpi varrho varsigma varphi varGamma varDelta varTheta varLambda varXi varPi "
    "varSigma varUpsilon varPhi varPsi varOmega"
)
_OTHERS = "ell hbar hslash imath jmath wp aleph beth gimel daleth eth mho"
LETTER_COMMANDS = frozenset(f"\\{name}" for name in f"{_GREEK} {_VARIANTS} {_OTHERS}".split())

STYLES = frozenset(
    [r"\mathbf", r"\boldsymbol", r"\bm", r"\pmb", r"\mathcal", r"\mathscr", r"\mathfrak", r"\mathsf", r"\mathbb"]
)
ACCENTS = frozenset(
    [
        r"\dot",
        r"\ddot",
        r"\dddot",
        r"\bar",
        r"\overline",
        r"\hat",
        r"\tilde",
        r"\vec",
        r"\breve",
        r"\check",
        r"\widetilde",
        r"\widehat",
        r"\underline",
    ]
)
OVER = STYLES | ACCENTS
ROMAN = frozenset({r"\text", r"\mathrm", r"\operatorname", r"\textrm", r"\mbox"})
# how many arguments belong to a command
ARGUMENTS = {
    r"\frac": 2,
    r"\dfrac": 2,
    r"\tfrac": 2,
    r"\binom": 2,
    r"\substack": 1,
    r"\sqrt": 1,
    r"\begin": 1,
    r"\end": 1,
    r"\tag": 1,
    r"\prescript": 3,
}
ARGUMENTS |= dict.fromkeys(STYLES | ACCENTS | ROMAN | {r"\text", r"\operatorname", r"\mathrm"}, 1)

_WORDS = (
    "sin cos tan tg cot ctg cotan sec csc cosec arcsin arccos arctan arctg arccot arcctg asin acos atan sinh cosh tanh "
    "coth sh ch th cth sech csch arsinh arcosh artanh arsh arch arth ln log lg lb exp pow sqrt erf erfc Gamma gamma "
    "det dim deg ker im tr Tr sp Sp rank rang rk diag sgn sign sinc lim limsup liminf sup inf max min argmax argmin "
    "arcoth arsech arcsch atan2 arctan2 arg Arg Re Im div grad rot curl mod gcd lcm Pr Var Cov var cov conj adj vec "
    "span and or if then where for all "
    "when otherwise iff not mean infinity"
)
RESERVED_WORDS = frozenset(rf"\text{{{word}}}" for word in _WORDS.split())


def known(latex: str) -> bool:
    r"""Has this spelling a meaning of its own, as `\tanh`, `\to` and `\operatorname{div}` have, and is no letter?"""
    if latex in RESERVED_WORDS:
        return True
    return latex[:1] == "\\" and latex[1:].isalpha() and latex not in LETTER_COMMANDS
