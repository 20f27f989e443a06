"""Records as something to look at: terminal, page, notebooks, exports and pictures. Nothing is decided here.

Each view is a module: of a paper (`terminal`, `page`, `letter`, `exports`, `notebook`, `figures`, `pictures`,
`diagnostics`), of a name (`show`), of a formula of the reader's own (`answer`), of a document (`look`).
"""

__all__ = [
    "answer",
    "diagnostics",
    "exports",
    "figures",
    "letter",
    "look",
    "notebook",
    "page",
    "pictures",
    "show",
    "terminal",
]
