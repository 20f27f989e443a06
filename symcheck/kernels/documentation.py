"""What a kernel says of itself, in whatever language it is written: the sections of a numpydoc docstring."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping

from symcheck.kernels.specification import Argument, Output, Specification

WIDTH = 110  # columns of a text, which stands four columns in
KIND = "float or ndarray"
CALLS = """Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit."""
EQUAL = "Outputs that are equal by formula are one array, unless `out` is given."
OUT = "{} for the results, of the broadcast shape and type."


def numpydoc(
    said: Specification,
    formulas: str,
    kind: str,
    notes: str,
    further: Mapping[str, tuple[str, str]] | None = None,
    examples: str = "",
) -> str:
    """What the function is, takes and returns, how accurate it is, on what it rests, and an example.

    formulas  what it computes, a line for each output
    kind      the type of arguments and results
    notes     how the function is called
    further   type and meaning of arguments that are not the kernel's
    """
    takes = [_entry(argument.name, kind, f"{_meaning(argument)}; {argument.domain}.") for argument in said.arguments]
    takes += [_entry(name, *each) for name, each in (further or {}).items()]
    gives = [_entry(each.name, kind, f"{_meaning(each)}.") for each in said.outputs]
    accuracy = f"Accuracy: {said.ulp} ulp over the domain. {said.condition} {said.degenerate}"
    parts = [
        said.says,
        _section("Parameters", "\n".join(takes)),
        _section("Returns", "\n".join(gives)),
        _section("Notes", "The function computes ::"),
        textwrap.indent(formulas, "    "),
        wrapped(accuracy),
        wrapped(notes),
        wrapped(evidence(said)),
        _section("Examples", examples) if examples else "",
    ]
    return "\n\n".join(filter(None, parts))


def numpy_docstring(said: Specification, text: str) -> str:
    """The docstring of a kernel for NumPy, of which the text has the sentence, the formulas and an example."""
    _, formulas, *examples = text.split("\n\n")
    import_line = f">>> from symcheck.generated.{said.paper} import {said.name}\n"
    count = len(said.outputs)
    return numpydoc(said, formulas, KIND, calls(count), {"out": out_of(count)}, import_line + "\n\n".join(examples))


def calls(outputs: int) -> str:
    """How a kernel with so many outputs is called."""
    return f"{CALLS} {EQUAL}" if outputs > 1 else CALLS


def out_of(outputs: int) -> tuple[str, str]:
    """Type and meaning of the argument `out`."""
    kind, arrays = ("ndarray", "Array") if outputs == 1 else ("sequence of ndarray", f"{outputs} arrays")
    return f"{kind}, optional", OUT.format(arrays)


def evidence(said: Specification) -> str:
    """On which claims and proofs a kernel rests, in words."""
    rests = f"Rests on {', '.join(f'{id} (sha256 {digest})' for id, digest in said.claims.items())}."
    equal = f"The forms computed are proved equal to those shown (sha256 {said.forms})."
    return f"{rests if said.claims else ''} {equal if said.forms else ''}".strip()


def wrapped(text: str) -> str:
    """A text in lines."""
    text = " ".join(text.split())
    return textwrap.fill(text, WIDTH) if len(text) > WIDTH else text


def _section(name: str, text: str) -> str:
    return f"{name}\n{'-' * len(name)}\n{text}"


def _entry(name: str, kind: str, text: str) -> str:
    lines = textwrap.wrap(text, WIDTH - 4) if len(text) > WIDTH - 4 else [text]
    return "\n    ".join([f"{name} : {kind}", *lines])


def _meaning(value: Argument | Output) -> str:
    text = f"{value.meaning[0].upper()}{value.meaning[1:]}" if value.meaning.split()[0].isalpha() else value.meaning
    return f"{text}, {'a number' if value.unit == '1' else f'in {value.unit}'}"
