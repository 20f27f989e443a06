"""LaTeX to MathML, by the vendored Temml, which runs in an embedded JavaScript engine: no browser, no network."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from importlib.resources import files

import quickjs

from symcheck.core.verdicts import SymcheckError
from symcheck.views.latex import is_formula, standing_alone

STACK = 8 << 20  # in bytes, of the interpreter: deeply nested formulas need more than its default
ASKED = """texts => JSON.stringify(JSON.parse(texts).map(text => {
    try { return temml.renderToString(text, {throwOnError: true, annotate: false, wrap: "tex"}); }
    catch (error) { return null; }
}))"""


def typeset(texts: Iterable[str]) -> dict[str, str | None]:
    """The MathML of each LaTeX text; None for other text: words, or the characters of a damaged source.

    The engine lets other threads run, so that the texts are shared among the cores.
    """
    given = list(dict.fromkeys(texts))
    distinct = [text for text in given if is_formula(text)]
    workers = min(4, os.cpu_count() or 1)
    with ThreadPoolExecutor(workers) as pool:
        shares = [distinct[first::workers] for first in range(workers)]
        found = pool.map(_share, shares)
    maths = (pair for pairs in map(zip, shares, found) for pair in pairs)
    return dict.fromkeys(given) | dict(maths)


def _share(texts: list[str]) -> list[str | None]:
    context = quickjs.Context()
    context.set_max_stack_size(STACK)
    try:
        context.eval((files(__package__) / "vendor" / "temml.min.js").read_text(encoding="utf-8"))
        ask = context.eval(ASKED)
        found = ask(json.dumps([standing_alone(text) for text in texts]))
    except quickjs.JSException as error:
        raise SymcheckError(f"formulas cannot be typeset ({error}); install symcheck again") from error
    maths: list[str | None] = json.loads(found)
    return maths
