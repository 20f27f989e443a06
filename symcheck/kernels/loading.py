"""Where generated kernels lie, and those whose name is known only when the program runs.

Others are imported: `from symcheck.generated import mirer2009`.
"""

from __future__ import annotations

from collections.abc import Mapping
from difflib import get_close_matches
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from types import ModuleType

from symcheck.core.ids import key_of
from symcheck.core.verdicts import SymcheckError
from symcheck.kernels.specification import KernelFunction

PACKAGE = "symcheck.generated"
GENERATED = "generated"  # in the folder of an audit


def folder() -> Path:
    """Find the folder generated/, where `symcheck generate` writes.

    Returns
    -------
    pathlib.Path
        The folder: in a wheel, an editable install and a checkout alike.

    Raises
    ------
    SymcheckError
        If there is none.
    """
    spec = find_spec(PACKAGE)
    if spec is None or not spec.submodule_search_locations:
        raise SymcheckError("there is no folder generated/; install symcheck again or restore the checkout")
    return Path(spec.submodule_search_locations[0]).resolve()


def load(name: str, *, check: bool = False, engine: str = "numpy") -> ModuleType:
    """Import the kernels of a paper whose key is known only when the program runs.

    Parameters
    ----------
    name
        The key of the paper, such as "ignatov2005", or the folder of an audit.
    check
        True gives kernels that raise ValueError for an argument outside of its domain; else nothing is checked.
    engine
        What computes arrays: "numpy"; "c", which the machine's compiler compiles when a mix of arrays and numbers is
        first met; or "numba". What is compiled stays in the user's cache. Where there is no compiler, or no Numba, a
        RuntimeWarning says so, and the kernels run in NumPy.

    Returns
    -------
    module
        `symcheck.generated.<key>`, or one like it whose kernels are checked, or run by another engine.

    Raises
    ------
    SymcheckError
        If nothing was generated under that name, if kernels of another folder with the same key are in use, or if
        there is no engine of that name.

    Examples
    --------
    >>> load("ignatov2005", check=True).volume_of_four_wheels(0.5, -1.0)
    Traceback (most recent call last):
        ...
    ValueError: volume_of_four_wheels: b = -1.0 must satisfy 0 < b < pi/2
    """
    own = Path(name) / GENERATED
    key, home = (key_of(Path(name)), own.resolve()) if own.is_dir() else (name, folder())
    path = import_module(PACKAGE).__path__
    if str(home) not in map(str, map(Path.resolve, map(Path, path))):
        path.append(str(home))
    module = f"{PACKAGE}.{key}"
    try:
        found = import_module(module)
    except ModuleNotFoundError as error:
        if error.name != module:
            raise
        raise SymcheckError(f"no kernels named {key!r} in {home}; run `symcheck generate`") from error
    if (other := Path(found.__file__ or "").resolve().parent) != home:
        raise SymcheckError(f"the kernels of {other} are in use under the key {key!r}; rename one of the folders")
    if engine != "numpy":
        from symcheck.kernels.engines import compiled_module

        found = compiled_module(found, engine)
    if not check:
        return found
    from symcheck.kernels.checked import checked_module

    return checked_module(found)


def of_paper(key: str) -> Mapping[str, KernelFunction]:
    """List the kernels of a paper.

    Parameters
    ----------
    key
        The key of the paper, or the folder of an audit.

    Returns
    -------
    mapping of str to KernelFunction
        The kernels by name.

    Raises
    ------
    SymcheckError
        If nothing was generated for the paper.

    See Also
    --------
    find : A single kernel.
    """
    kernels: Mapping[str, KernelFunction] = vars(load(key))["KERNELS"]
    return kernels


def find(key: str, name: str) -> KernelFunction:
    """Find a kernel by name.

    Parameters
    ----------
    key
        The key of the paper, or the folder of an audit.
    name
        The name of the kernel, as `symcheck show` takes it.

    Returns
    -------
    KernelFunction
        The kernel, for numbers and NumPy arrays.

    Raises
    ------
    SymcheckError
        If there is no such kernel; the message has the nearest name.

    See Also
    --------
    symcheck.kernel : The same for chunked and labelled arrays too.

    Examples
    --------
    >>> round(find("ignatov2005", "volume_of_three_wheels")(0.5, 1.0), 6)
    2.93465
    """
    known = of_paper(key)
    if name not in known:
        near = get_close_matches(name, known, n=1, cutoff=0)
        raise SymcheckError(f"{key} has no kernel {name!r}; did you mean {near[0]!r}?")
    return known[name]
