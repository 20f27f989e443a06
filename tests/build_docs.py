"""Builds the reference of all public names from their docstrings. Run by `make docs`.

    python tests/build_docs.py FOLDER

Needs no network. Warnings are errors: a docstring that is not valid reStructuredText, a "See Also" that leads nowhere.
"""

from __future__ import annotations

import sys
from importlib import import_module
from pathlib import Path
from tempfile import TemporaryDirectory

from sphinx.application import Sphinx

import symcheck

PACKAGES = (
    "symcheck",
    "symcheck.reading",
    "symcheck.proof",
    "symcheck.checker",
    "symcheck.kernels",
    "symcheck.mechanics.inertia",
    "symcheck.mechanics.rotation",
    "symcheck.mechanics.zonotope",
    "symcheck.numeric.attitude",
    "symcheck.numeric.inertia",
    "symcheck.numeric.random_rotation",
    "symcheck.numeric.liquid",
    "symcheck.numeric.wheels",
    "symcheck.numeric.figures",
    "symcheck.numeric.sweep",
)
SETTINGS = {
    "project": "symcheck",
    "author": "The symcheck authors",
    "release": symcheck.__version__,
    "extensions": ["sphinx.ext.autodoc", "numpydoc"],
    "html_theme": "alabaster",
    "html_theme_options": {"description": "Reference of the public names"},
    "html_show_sphinx": False,
    "autodoc_member_order": "groupwise",
    "autodoc_typehints": "signature",
    "numpydoc_show_class_members": False,
    "nitpicky": True,
    "nitpick_ignore_regex": [("py:(class|data|exc|meth|attr)", ".*")],  # types of signatures lead to other projects
}


def write_sources(folder: Path) -> None:
    """A page for each package, and the one that lists them. What several packages offer stands on the first page."""
    described: set[int] = set()
    for package in PACKAGES:
        module = import_module(package)
        names = [name for name in getattr(module, "__all__", ()) if hasattr(module, name)]  # not modules of it
        again = [name for name in names if id(getattr(module, name)) in described]
        described |= {id(getattr(module, name)) for name in names}
        text = f"{package}\n{'=' * len(package)}\n\n.. automodule:: {package}\n   :members:\n"
        text += f"   :exclude-members: {', '.join(again)}\n" if again else ""
        (folder / f"{package}.rst").write_text(text, encoding="utf-8")
    listed = "".join(f"   {package}\n" for package in PACKAGES)
    title = f"symcheck {symcheck.__version__}"
    index = f"{title}\n{'=' * len(title)}\n\n.. toctree::\n   :maxdepth: 1\n\n{listed}"
    (folder / "index.rst").write_text(index, encoding="utf-8")


def escape_bars(app: Sphinx, what: str, name: str, found: object, options: object, lines: list[str]) -> None:
    """Between bars stands an absolute value, and not what reStructuredText takes for a substitution."""
    lines[:] = [line if line.lstrip().startswith((">>>", "...")) else line.replace("|", r"\|") for line in lines]


def build(target: Path) -> int:
    """Write HTML to a folder; the exit code is 1 if there was a warning."""
    with TemporaryDirectory() as name:
        sources = Path(name)
        write_sources(sources)
        program = Sphinx(
            sources,
            confdir=None,
            outdir=target,
            doctreedir=sources / ".doctrees",
            buildername="html",
            confoverrides=SETTINGS,
            warningiserror=True,
            freshenv=True,
            status=None,
        )
        program.connect("autodoc-process-docstring", escape_bars)
        program.build()
    return program.statuscode


def main(arguments: list[str]) -> int:
    """Build, and say where the reference is."""
    [folder] = map(Path, arguments)
    code = build(folder.resolve())
    if code == 0:
        print(f"{folder / 'index.html'} is written")
    return code


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
