"""Every figure of the numeric layer is found, labelled and drawn, and its file is whole or not there."""

from __future__ import annotations

import sys
from collections.abc import Callable
from io import BytesIO
from pathlib import Path
from typing import Any

import matplotlib as mpl
import pytest
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from optimized import about_docstrings

from symcheck import numeric
from symcheck.numeric import figures
from symcheck.numeric.liquid import plots as liquid_plots

SIGNATURES = {".png": b"\x89PNG\r\n", ".pdf": b"%PDF-", ".svg": b"<?xml"}


@pytest.fixture(autouse=True)
def without_pyplot(monkeypatch: pytest.MonkeyPatch) -> None:
    """Pyplot keeps figures for the whole process: whoever draws with it fails here."""
    monkeypatch.setitem(sys.modules, "matplotlib.pyplot", None)
    monkeypatch.delattr(mpl, "pyplot", raising=False)


def labels(ax: Axes, direction: str) -> set[str]:
    """The labels of an axis, and of those that share it."""
    together = getattr(ax, f"get_shared_{direction}_axes")().get_siblings(ax) if direction in "xy" else [ax]
    return {getattr(each, f"get_{direction}label")() for each in together} - {""}


def is_labelled(ax: Axes) -> bool:
    if ax.get_label() == "<colorbar>":
        return bool(labels(ax, "x") | labels(ax, "y"))
    return all(labels(ax, direction) for direction in ("xyz" if hasattr(ax, "get_zlabel") else "xy"))


@about_docstrings
@pytest.mark.parametrize("name", figures.figures())
def test_the_figure_has_labelled_axes_and_is_drawn(name: str, tmp_path: Path) -> None:
    drawn = figures.figure(name)
    assert isinstance(drawn, Figure)
    assert drawn.axes
    assert [ax for ax in drawn.axes if not is_labelled(ax)] == []
    assert any(ax.has_data() for ax in drawn.axes)
    drawn.savefig(tmp_path / "figure.png", dpi=60)
    assert len(figures.summary(name)) > 20


def stand_in() -> Axes:
    """A line from the origin to the point (1, 2)."""
    ax = Figure().subplots()
    ax.plot([0, 1], [0, 2])
    return ax


@pytest.fixture
def a_figure(monkeypatch: pytest.MonkeyPatch) -> str:
    monkeypatch.setitem(liquid_plots.FIGURES, "stand-in", stand_in)
    return "stand-in"


@about_docstrings
def test_a_module_that_declares_a_figure_is_enough(a_figure: str) -> None:
    assert list(figures.figures()) == sorted(figures.figures())
    assert figures.figures()[a_figure] is stand_in
    assert figures.summary(a_figure) == "A line from the origin to the point (1, 2)."


@pytest.mark.parametrize(
    "wrapped", [stand_in, lambda: stand_in().figure, lambda: [stand_in()], lambda: Figure().subplots(2, 2)]
)
def test_figures_axes_and_arrays_of_axes_are_taken(wrapped: Callable[[], Any], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(liquid_plots.FIGURES, "wrapped", wrapped)
    assert isinstance(figures.figure("wrapped"), Figure)


@pytest.mark.parametrize("kind", SIGNATURES)
def test_the_ending_tells_the_kind_and_the_same_figure_has_the_same_bytes(
    kind: str, a_figure: str, tmp_path: Path
) -> None:
    first, second = (figures.draw(a_figure, tmp_path / f"{n}{kind}").read_bytes() for n in (1, 2))
    assert first.startswith(SIGNATURES[kind])
    assert first == second
    assert {file.name for file in tmp_path.iterdir()} == {f"1{kind}", f"2{kind}"}


def test_a_figure_that_fails_leaves_the_old_file(
    a_figure: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = figures.draw(a_figure, tmp_path / "line.svg")
    whole = path.read_bytes()

    def half(self: Figure, file: BytesIO, **_: Any) -> None:
        file.write(whole[:100])
        raise OSError("no space left")

    monkeypatch.setattr(Figure, "savefig", half)
    with pytest.raises(OSError, match="no space left"):
        figures.draw(a_figure, path)
    assert path.read_bytes() == whole
    assert list(tmp_path.iterdir()) == [path]


def test_the_nearest_name_is_suggested() -> None:
    for call in (figures.figure, figures.summary, lambda name: figures.draw(name, "figure.png")):
        with pytest.raises(ValueError, match="'liquid-frequency'; did you mean liquid-frequencies"):
            call("liquid-frequency")


@pytest.mark.parametrize("name", ["figure", "figure.gif", "png"])
def test_an_ending_that_says_nothing_is_refused(name: str, a_figure: str, tmp_path: Path) -> None:
    with pytest.raises(ValueError, match=r"\.png, \.pdf, \.svg"):
        figures.draw(a_figure, tmp_path / name)


def test_one_name_for_two_figures_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    from symcheck.numeric import domain

    monkeypatch.setattr(domain, "FIGURES", {"liquid-frequencies": stand_in}, raising=False)
    with pytest.raises(ValueError, match=r"domain and .*plots both have a figure 'liquid-frequencies'"):
        figures.figures()


def test_a_module_without_its_optional_library_has_no_figures_but_a_broken_one_is_reported(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    expected = list(figures.figures())
    monkeypatch.setattr(numeric, "__path__", [*numeric.__path__, str(tmp_path)])
    (tmp_path / "needs_a_library.py").write_text("import no_such_library")
    assert list(figures.figures()) == expected
    (tmp_path / "is_broken.py").write_text("import symcheck.no_such_module")
    with pytest.raises(ModuleNotFoundError, match=r"symcheck\.no_such_module"):
        figures.figures()
