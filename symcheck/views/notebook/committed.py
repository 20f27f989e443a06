"""The notebooks of a checkout: notebooks/<name>.ipynb made of notebooks/sources/<name>.md; a name may have a folder."""

from __future__ import annotations

from collections.abc import Sequence
from difflib import get_close_matches
from pathlib import Path
from typing import TYPE_CHECKING

from symcheck.core.files import put
from symcheck.core.verdicts import SymcheckError
from symcheck.views.notebook import compare
from symcheck.views.notebook.execute import Progress, in_kernel, in_process
from symcheck.views.notebook.output import PNG
from symcheck.views.notebook.source import notebook

if TYPE_CHECKING:
    from nbformat import NotebookNode


def folder() -> Path:
    """The folder notebooks/ beside the package, or in the current folder; SymcheckError if there is none."""
    for place in (Path(__file__).resolve().parents[3], Path.cwd()):
        if (place / "notebooks" / "sources").is_dir():
            return place / "notebooks"
    raise SymcheckError("no folder notebooks/ here; run this in a checkout of symcheck")


def names(only: Sequence[str] = ()) -> list[str]:
    """The names of all notebooks in their order, or of those asked for: "6_errata", or its beginning."""
    sources = folder() / "sources"
    known = sorted(file.relative_to(sources).with_suffix("").as_posix() for file in sources.rglob("*.md"))
    for each in only:
        if not any(name.startswith(each) for name in known):
            near = get_close_matches(each, known, n=1, cutoff=0)
            raise SymcheckError(f"there is no notebook {each!r}; did you mean {near[0] if near else 'another'}?")
    return [name for name in known if not only or any(name.startswith(each) for each in only)]


def built(name: str) -> NotebookNode:
    """A notebook made anew of its source, without outputs."""
    return notebook(folder() / "sources" / f"{name}.md")


def executed(name: str, kernel: bool = False, progress: Progress = lambda done, total: None) -> NotebookNode:
    """A notebook made anew and executed, in this process or through a Jupyter kernel."""
    return in_kernel(built(name), folder(), progress) if kernel else in_process(built(name), progress)


def committed(name: str) -> NotebookNode:
    """The notebook as it is committed; SymcheckError if there is none or it cannot be read."""
    import nbformat

    file = folder() / f"{name}.ipynb"
    try:
        return nbformat.read(file, as_version=4)
    except FileNotFoundError as error:
        raise SymcheckError(f"notebooks/{name}.ipynb is missing; run `symcheck notebooks --write`") from error
    except (ValueError, AttributeError, nbformat.ValidationError) as error:
        raise SymcheckError(f"notebooks/{name}.ipynb is damaged ({error}); run `symcheck notebooks --write`") from error


def differences(name: str, executed: NotebookNode) -> list[str]:
    """How the notebook that was executed differs from the committed one, one line each."""
    return [f"notebooks/{name}.ipynb: {difference}" for difference in compare.differences(executed, committed(name))]


def write(name: str, executed: NotebookNode) -> None:
    """Commit what was executed; a picture is kept, byte for byte, if everything else in its cell is the same."""
    import nbformat

    file = folder() / f"{name}.ipynb"
    if file.exists() and not list(compare.differences(executed, old := committed(name))):
        _keep_pictures(executed, old)
    nbformat.validate(executed)
    put(file, f"{nbformat.writes(executed)}\n".encode())


def _keep_pictures(executed: NotebookNode, old: NotebookNode) -> None:
    for new, kept in zip(executed.cells, old.cells, strict=True):
        for output, before in zip(new.get("outputs", ()), kept.get("outputs", ()), strict=True):
            if PNG in output.data:
                output.data[PNG] = before.data[PNG]
