r"""What common packages define, in TeX itself, where the reader does not know it; added where a document uses them."""

from __future__ import annotations

_PHYSICS = r"""
\NewDocumentCommand{\dv}{s o m g}{\derivativeof{\mathrm{d}}{#2}{#3}{#4}}
\NewDocumentCommand{\pdv}{s o m g}{\derivativeof{\partial}{#2}{#3}{#4}}
\newcommand{\derivativeof}[4]{\frac{#1^{#2} #3}{#1 #4^{#2}}}
\newcommand{\dd}[1]{\mathrm{d}#1}
\NewDocumentCommand{\abs}{s m}{\left|#2\right|}
\NewDocumentCommand{\norm}{s m}{\left\|#2\right\|}
\NewDocumentCommand{\vb}{s m}{\mathbf{#2}}
\NewDocumentCommand{\va}{s m}{\vec{#2}}
\NewDocumentCommand{\vu}{s m}{\hat{\mathbf{#2}}}
\newcommand{\vectorbold}[1]{\mathbf{#1}}
\newcommand{\vdot}{\cdot}
\newcommand{\dotproduct}{\cdot}
\newcommand{\cp}{\times}
\newcommand{\cross}{\times}
\newcommand{\crossproduct}{\times}
\newcommand{\grad}{\nabla}
\newcommand{\gradient}{\nabla}
\renewcommand{\div}{\nabla\cdot}
\newcommand{\curl}{\nabla\times}
\newcommand{\laplacian}{\nabla^2}
\newcommand{\Tr}{\operatorname{tr}}
\newcommand{\tr}{\operatorname{tr}}
\newcommand{\rank}{\operatorname{rank}}
\newcommand{\erf}{\operatorname{erf}}
\newcommand{\qty}{}
\newcommand{\pqty}[1]{\left(#1\right)}
\newcommand{\bqty}[1]{\left[#1\right]}
\newcommand{\vqty}[1]{\left|#1\right|}
\newcommand{\mqty}[1]{\begin{matrix}#1\end{matrix}}
\newcommand{\order}[1]{\mathcal{O}\left(#1\right)}
\newcommand{\eval}[1]{\left.#1\right|}
\newcommand{\qq}[1]{\quad\text{#1}\quad}
\newcommand{\qand}{\quad\text{and}\quad}
\newcommand{\qif}{\quad\text{if}\quad}
\newcommand{\expval}[1]{\langle #1 \rangle}
"""
_COMMATH = r"""
\newcommand{\dif}{\mathrm{d}}
\newcommand{\od}[3][]{\frac{\mathrm{d}^{#1} #2}{\mathrm{d} #3^{#1}}}
\newcommand{\pd}[3][]{\frac{\partial^{#1} #2}{\partial #3^{#1}}}
\newcommand{\del}[1]{\left(#1\right)}
\newcommand{\sbr}[1]{\left[#1\right]}
\newcommand{\abs}[1]{\left|#1\right|}
\newcommand{\norm}[1]{\left\|#1\right\|}
"""
_ESDIFF = r"""
\newcommand{\diff}[3][]{\frac{\mathrm{d}^{#1} #2}{\mathrm{d} #3^{#1}}}
\newcommand{\diffp}[3][]{\frac{\partial^{#1} #2}{\partial #3^{#1}}}
"""
_UNITS = r"""
\newcommand{\SI}[3][]{#2\,\mathrm{#3}}
\newcommand{\qty}[3][]{#2\,\mathrm{#3}}
\newcommand{\si}[2][]{\mathrm{#2}}
\newcommand{\unit}[2][]{\mathrm{#2}}
\newcommand{\num}[2][]{#2}
\newcommand{\ang}[2][]{#2^\circ}
"""
PACKAGES = {
    "physics": _PHYSICS,
    "commath": _COMMATH,
    "esdiff": _ESDIFF,
    "siunitx": _UNITS,
    "braket": r"\newcommand{\Set}[1]{\left\{#1\right\}}",
    "accents": r"\newcommand{\ring}[1]{\mathring{#1}}",
    "tensor": r"\newcommand{\tensor}[2]{#1#2}",
    "leftidx": r"\newcommand{\leftidx}[3]{{}#1{#2}#3}",
}
# what files of authors' own define alike wherever they do, for scripts at the left
USUAL = r"\newcommand{\leftexp}[2]{{}^{#1}{#2}}\newcommand{\leftsub}[2]{{}_{#1}{#2}}"
