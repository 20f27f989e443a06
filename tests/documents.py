"""Documents of our own for `symcheck look`: one with planted errors, one that is sound, and many that are none."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

FAULTY = r"""\documentclass{article}
\usepackage{amsmath}
\newcommand{\vect}[1]{\mathbf{#1}}
\newcommand{\half}{\tfrac{1}{2}}
\numberwithin{equation}{section}
\begin{document}
\section{A sliding block}
The position of the block is
\begin{equation} x(t) = A \cos(\omega t) + \frac{b}{2} t^2. \label{eq:position} \end{equation}
Its velocity follows:
\begin{equation} x'(t) = -A \omega \cos(\omega t) + b t. \label{eq:velocity} \end{equation}
The kinetic energy of a ring and a disc together is
\begin{align}
  T &= \half m (u + w)^2 + \half m (u - w)^2 \\
    &= m u^2 + m w^2 \notag \\
    &= m (u^2 + 2 w^2).
\end{align}
We write $q$ for the rate and get
\[ q = \frac{1 - s^2}{1 + s^2}, \qquad p = \frac{2 s}{1 + s^2}, \]
which lie on a circle, as
\begin{equation} q^2 + p^2 = 2 \label{eq:circle} \end{equation}
shows.
\section{Its frame}
The components are $\vect{r} = (r_1, r_2, r_3)$, and their sum is
\begin{equation} \sigma = r_1 + r_2 + r_4. \end{equation}
The change of the frame is
\begin{equation}
 \begin{pmatrix} y_1 \\ y_2 \end{pmatrix}
 = \begin{pmatrix} 1 & 0 & 2 \\ 0 & 1 & 3 \end{pmatrix} \begin{pmatrix} z_1 \\ z_2 \end{pmatrix}
\end{equation}
and its stiffness
\begin{equation} k = \frac{c (1 + \eta}{2}. \end{equation}
Its loss is
\begin{equation} D = 3 \kappa_s c . \end{equation}
\section{Losses}
We define the loss coefficient by
\begin{equation} \kappa_s = \frac{c}{4}. \end{equation}
\end{document}
"""
# the line of each planted error, and what is said of it
PLANTED = {
    11: "fails with these definitions: an error, or a condition printed elsewhere?",
    14: "the links of this chain do not agree: an error, or a condition printed elsewhere?",
    21: "fails with these definitions: an error, or a condition printed elsewhere?",
    25: "r_4, though r has 3 components in this section",
    28: "sizes that do not fit in a product: 2 x 3 times 2 x 1",
    32: "( is never closed",
    34: r"\kappa_s is used here and introduced at line 37 (3.1)",
}

# what is no error: conditions, equations to solve, cases, other letters in examples, usual formulas of two orbits
SOUND = r"""\documentclass{article}
\begin{document}
\section{A sliding block}
The position of the block is
\begin{equation} x(t) = A \cos(\omega t) + \frac{b}{2} t^2. \end{equation}
Its velocity follows:
\begin{equation} x'(t) = -A \omega \sin(\omega t) + b t. \end{equation}
It is at rest when
\begin{equation} x'(t) = 0. \end{equation}
To find the frequency we solve
\begin{equation} m \omega^2 = k, \end{equation}
so that $\omega = 2$ if $k = 4$ and $m = 1$. With the initial condition
\begin{equation} x(0) = 1 \end{equation}
we have $A = 1$.
\begin{example}
Let \begin{equation} f(s) = s^2 + 1, \end{equation} then \begin{equation} f'(s) = 2 s. \end{equation}
\end{example}
\begin{example}
Let \begin{equation} f(s) = s^3 + 1, \end{equation} then \begin{equation} f'(s) = 3 s^2. \end{equation}
\end{example}
The energy is
\begin{equation} E = \frac{1}{2} m v^2 + m g h = \frac{1}{2} m v_0^2. \end{equation}
The angles satisfy $\alpha + \beta = \frac{\pi}{2}$, and therefore
\begin{equation} h = \sin \alpha = \cos \beta. \end{equation}
The body turns with
\begin{equation} a = r \cos\varphi, \quad d = r \sin\varphi, \end{equation}
and lies on the line
\begin{equation} a + d = 1. \end{equation}
On a circular orbit
\begin{align} v &= \sqrt{\frac{\mu}{r}}, & n &= \sqrt{\frac{\mu}{r^3}} \end{align}
and with the velocity of escape
\begin{equation} v = \sqrt{\frac{2 \mu}{r}}. \end{equation}
With the squares
\begin{equation} G = u^2 + w^2 = 2 u w \end{equation}
where $u = w$. The radius and the coefficients are
\begin{align}
  \rho &= \sqrt{u^2 w^2} = u w, & b_n &= \frac{1 - \cos^2 (n \pi)}{2 n} = \frac{n - n}{2}, \\
  \Gamma &= g(y) + 1 = g(-y) + 1, & \mathbf{C} &= \mathbf{A} \mathbf{B} = \mathbf{B} \mathbf{A}, \\
  \mathbf{P} &= \mathbf{Q}^T \mathbf{Q} = \mathbf{Q} \mathbf{Q}^T, & \eta &= \arctan(\tan y) = y.
\end{align}
The interval is $0 \le s < 1$, or \[ s \in [0, 1), \quad s \in ]a, b] . \]
1) The first case is \[ 2) \quad c = d . \]
\end{document}
"""

SELF = r"\input{bad}"
Maker = Callable[[Path], object]


def _text(name: str, text: str) -> tuple[str, Maker]:
    return name, lambda file: file.write_text(text, encoding="utf-8")


def _data(name: str, data: bytes) -> tuple[str, Maker]:
    return name, lambda file: file.write_bytes(data)


def _beside(file: Path, other: str, text: str) -> None:
    file.write_text(r"\input{other}", encoding="utf-8")
    (file.parent / other).write_text(text, encoding="utf-8")


def _of_size(file: Path, size: int) -> None:
    with file.open("wb") as stream:
        stream.truncate(size)


MACROS = "".join(rf"\def\x{chr(98 + n)}{{\x{chr(97 + n)}\x{chr(97 + n)}}}" for n in range(25))
# the name of a file, and how it is made: each is refused in one line
BAD: dict[str, tuple[str, Maker]] = {
    "missing": ("bad.tex", lambda file: None),
    "in a file": ("bad.tex/inner.tex", lambda file: file.parent.write_text("x")),
    "a directory": ("bad.tex", lambda file: file.mkdir()),
    "a pipe": ("bad.tex", lambda file: os.mkfifo(file)),
    "a device": ("bad.tex", lambda file: file.symlink_to("/dev/zero")),
    "the empty device": ("bad.tex", lambda file: file.symlink_to("/dev/null")),
    "a dangling link": ("bad.tex", lambda file: file.symlink_to("nowhere")),
    "a link to itself": ("bad.tex", lambda file: file.symlink_to(file)),
    "a long name": ("b" * 300 + ".tex", lambda file: None),
    "empty": _data("bad.tex", b""),
    "blank": _data("bad.md", b" \n\t\n"),
    "zeros": ("bad.tex", lambda file: _of_size(file, 1000)),
    "huge": ("bad.tex", lambda file: _of_size(file, 20_000_000)),
    "random": _data("bad.tex", bytes((k * k + 7 * k) % 256 for k in range(4000))),
    "an image": _data("bad.md", b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR"),
    "a PDF": _data("bad.tex", b"%PDF-1.7\n%\xe2\xe3\xcf\xd3\n\x01\x02"),
    "compressed": _data("bad.tex", b"\x1f\x8b\x08\0\0\0\0\0"),
    "UTF-16 without a mark": _data("bad.tex", "$a = b$".encode("utf-16-le")),
    "half of UTF-16": _data("bad.tex", b"\xff\xfe$\0a\0=\0\xd8"),
    "UTF-32": _data("bad.tex", "$a = b$".encode("utf-32")),
    "broken UTF-8 with a mark": _data("bad.tex", b"\xef\xbb\xbf$a\xff = b$"),
    "Latin-1 without formulas": _data("bad.tex", "Größe, \xa0 Länge".encode("latin-1")),
    "no formula in LaTeX": _text("bad.tex", r"\documentclass{article}\begin{document}Text.\end{document}"),
    "no formula in Markdown": _text("bad.md", "# Title\n\nIt costs 5$ and `$a = b$`.\n\n    $c = d$\n"),
    "no formula in reStructuredText": _text("bad.rst", "Title\n=====\n\n.. note:: no formula\n"),
    "no formula in anything": _text("bad.doc", "Text."),
    "comments alone": _text("bad.tex", "% $a = b$\n%\\[ c = d \\]\n"),
    "verbatim alone": _text("bad.tex", "\\begin{verbatim}\n$a = b$\n\\end{verbatim} \\verb|$c = d$|"),
    "letters alone": _text("bad.tex", "the angle $x$"),
    "including itself": _text("bad.tex", SELF),
    "including itself by another": ("bad.tex", lambda file: _beside(file, "other.tex", r"\include{bad}")),
    "including what is missing": _text("bad.tex", r"\input{none}"),
    "including a binary file": ("bad.tex", lambda file: _beside(file, "other.tex", "\x01\x02")),
    "a macro that calls itself": _text("bad.tex", r"\newcommand{\x}{\x} $\x = 1$"),
    "a macro that grows": _text("bad.tex", r"\newcommand{\x}{\x\x} $\x = 1$"),
    "macros that double": _text("bad.tex", rf"\def\xa{{aaaaaaaa}}{MACROS} $\xz = 1$"),
    "an environment within itself": _text("bad.tex", r"\newenvironment{x}{\begin{x}}{} \begin{x} $a = 1$ \end{x}"),
    "braces without end": _text("bad.tex", "{" * 100_000),
    "quotations within each other": _text("bad.md", ">" * 10_000 + " text"),
    "lists within each other": _text("bad.rst", "".join(f"{' ' * 2 * k}- x\n\n" for k in range(700))),
    "no JSON": _text("bad.ipynb", "{"),
    "JSON that is no notebook": _text("bad.ipynb", "[1]"),
    "deep JSON": _text("bad.ipynb", "[" * 100_000),
    "a notebook of an old version": _text("bad.ipynb", '{"worksheets": []}'),
    "a notebook without text": _text("bad.ipynb", '{"cells": [{"cell_type": "code", "source": "$a = b$"}, 3]}'),
}
