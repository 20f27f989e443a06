"""Sweeps: what they compute, what stops them, and that nothing is lost or taken for finished by halves."""

from __future__ import annotations

import json
import re
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from concurrent.futures import Future, wait
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner
from limits import interruptible

from symcheck import kernels
from symcheck.cli import cli
from symcheck.core.extras import installing
from symcheck.numeric import liquid, random_rotation, wheels
from symcheck.numeric.sweep import workers as sweep_workers
from symcheck.numeric.sweep.functions import SweepError, code, known

xarray = pytest.importorskip("xarray")
pytest.importorskip("zarr")

ROOT = Path(__file__).resolve().parent.parent
DISTANCES = """
function = "ignatov2005.face_distances_of_four_wheels"
[parameters]
a = { start = 0.1, stop = 1.5, count = 60 }
b = { start = 0.2, stop = 1.2, count = 40 }
"""
LONG = DISTANCES.replace("60", "500").replace("40", "300")
GROWTH = """
function = "liquid.stability"
[parameters]
A = 1.0
C = { start = 0.1, stop = 2.0, count = 12 }
omega_0 = { start = 0.5, stop = 8.0, count = 3, scale = "log" }
E_n = [0.2, 0.1]
lambda_n = [{ start = -1.0, stop = 1.0, count = 5 }, [0.2, 0.4]]
"""
FAILURES = """
function = "wheels.guaranteed_rate"
[parameters]
moments = [[1.0, 2.0, 2.5], [1.0, 1.0, 1.0]]
[parameters.half_spaces]
function = "wheels.half_spaces"
complete = true
limits = [1.0, 1.0, [0.5, 1.0], 1.0]
failures = [[], [0], [0, 2]]
axes = { function = "wheels.four_wheels", a = { start = 0.2, stop = 1.4, count = 9 }, b = 0.9 }
"""
TORQUES = {"varepsilon": 0.01, "k": 0.6, "g_1": [0.6, 0.8, 0.7], "g_2": [1.0, 0.0, 1.0]}
D = [[1, 0.3, 0.2], [0.2, 0.5, 0.1], [0.2, 0.1, 0.9]]
ENSEMBLE = f"""
function = "random_rotation.simulate"
seed = 1
realizations = 300
[parameters]
step = 2.0
steps = 4
every = 2
[parameters.torques]
function = "random_rotation.RandomTorques"
varepsilon = [0.01, 0.02]
k = 0.6
d = {D}
g_1 = [0.6, 0.8, [0.7, 0.9]]
g_2 = [1, 0, 1]
[parameters.start]
function = "random_rotation.stationary_sample"
[parameters.start.torques]
function = "random_rotation.RandomTorques"
varepsilon = 0.01
k = 0.6
d = {D}
g_1 = [0.6, 0.8, 0.7]
g_2 = [1, 0, 1]
"""
TORQUES_ALONE = f"""
function = "random_rotation.RandomTorques"
[parameters]
varepsilon = [0.01, 0.02]
k = 0.6
d = {D}
g_1 = [0.6, 0.8, 0.7]
g_2 = [1, 0, 1]
"""
TOLERANCES = """
function = "ignatov2005.volume_of_four_wheels"
seed = 3
realizations = 9000
[parameters]
a = { normal = [0.9, 0.01] }
b = { uniform = [0.3, 0.5] }
"""
SWEEPS = {"kernel": DISTANCES, "growth": GROWTH, "failures": FAILURES, "ensemble": ENSEMBLE, "tolerances": TOLERANCES}


def run(folder: Path, text: str, out: str, *options: str) -> tuple[int, str]:
    """Exit code and what was said by `symcheck sweep`, in this process."""
    (folder / "sweep.toml").write_text(text, encoding="utf-8")
    found = CliRunner().invoke(cli, ["sweep", str(folder / "sweep.toml"), "--out", str(folder / out), *options])
    if found.exception and not isinstance(found.exception, SystemExit):
        raise found.exception
    return found.exit_code, found.output


def swept(folder: Path, text: str, out: str, *options: str) -> Any:
    """The result of a sweep that succeeds."""
    exit_code, said = run(folder, text, out, *options)
    assert exit_code == 0, said
    return opened(folder / out)


def opened(path: Path) -> Any:
    how = {"engine": "h5netcdf"} if path.suffix == ".nc" else {"engine": "zarr"}  # a warning would be an error
    with xarray.open_dataset(path, **how) as found:
        return found.load().drop_attrs(deep=False)


def journal(path: Path) -> list[str]:
    """The chunks that count as finished."""
    file = path.with_name(f"{path.name}.partial.finished")
    return [line.split()[0] for line in file.read_text().split("\n") if line] if file.exists() else []


@pytest.fixture
def computed(monkeypatch: pytest.MonkeyPatch) -> list[dict[str, slice]]:
    """The chunks computed in this process."""
    log: list[dict[str, slice]] = []
    plain = sweep_workers.compute

    def counting(text: str, version: str, slices: dict[str, slice]) -> dict[str, Any]:
        log.append(slices)
        return plain(text, version, slices)

    monkeypatch.setattr(sweep_workers, "compute", counting)
    return log


# --- what is computed


def test_a_kernel_is_swept_over_the_outer_product_with_the_units_it_declares(tmp_path: Path) -> None:
    found = swept(tmp_path, DISTANCES, "out.zarr")
    a, b = np.linspace(0.1, 1.5, 60), np.linspace(0.2, 1.2, 40)
    expected = kernels.load("ignatov2005").face_distances_of_four_wheels(*np.meshgrid(a, b, indexing="ij"))
    for name, array in zip(("r_1", "r_2", "r_3"), expected, strict=True):
        assert found[name].dims == ("a", "b")
        assert found[name].attrs["units"] == "h_max"
        np.testing.assert_array_equal(found[name], array)
    np.testing.assert_array_equal(found.a, a)
    assert found.a.attrs["units"] == "rad"


def test_components_of_vectors_are_axes(tmp_path: Path) -> None:
    found = swept(tmp_path, GROWTH, "out.zarr", "--chunk", "C=5")
    assert found.sizes == {"C": 12, "omega_0": 3, "lambda_n_1": 5, "lambda_n_2": 2, "frequency": 3}
    C, spin, first, second = np.meshgrid(
        np.linspace(0.1, 2, 12), np.geomspace(0.5, 8, 3), np.linspace(-1, 1, 5), [0.2, 0.4], indexing="ij"
    )
    expected = liquid.stability(1.0, C, [0.2, 0.1], np.stack([first, second], -1), spin)
    for name, array in expected._asdict().items():
        np.testing.assert_array_equal(found[name], array)


def test_failed_wheels_are_an_axis(tmp_path: Path) -> None:
    found = swept(tmp_path, FAILURES, "out.zarr", "--chunk", "a=4")
    assert found.guaranteed_rate.dims == ("moments", "limits_3", "a", "failure")
    np.testing.assert_array_equal(found.failure_wheels, [[0, 0, 0], [1, 0, 0], [1, 0, 1]])
    np.testing.assert_array_equal(found.moments_values, [[1, 2, 2.5], [1, 1, 1]])
    axes = wheels.four_wheels(np.linspace(0.2, 1.4, 9), 0.9)
    left = wheels.half_spaces(axes, [0.0, 1.0, 0.5, 1.0], complete=True)
    expected = wheels.guaranteed_rate(left, [1.0, 2.0, 2.5])
    np.testing.assert_array_equal(found.guaranteed_rate[0, 0, :, 1], expected)


def test_an_ensemble_has_the_paths_of_the_function_called_once(tmp_path: Path) -> None:
    found = swept(tmp_path, ENSEMBLE, "out.zarr", "--chunk", "realization=70")
    assert found.angular_velocity.dims == ("varepsilon", "g_1_3", "realization", "record", "axis")

    def seed(number: int, *index: int) -> int:  # the outer function is read first
        words = np.random.SeedSequence(1, spawn_key=(number, *index)).generate_state(4)
        return int.from_bytes(words.tobytes(), "little")

    torques = random_rotation.RandomTorques(**TORQUES, d=D)
    start = random_rotation.stationary_sample(torques, 300, seed=seed(2, 1, 0))
    other = random_rotation.RandomTorques(**{**TORQUES, "varepsilon": 0.02}, d=D)
    expected = random_rotation.simulate(other, start, 2.0, 4, every=2, seed=seed(1, 1, 0)).angular_velocity
    np.testing.assert_array_equal(found.angular_velocity[1, 0], expected.swapaxes(0, 1))
    assert len(np.unique(found.angular_velocity)) == found.angular_velocity.size


def test_random_parameters_have_their_distribution(tmp_path: Path) -> None:
    found = swept(tmp_path, TOLERANCES.replace("volume_of_four_wheels", "axes_of_four_wheels"), "out.zarr")
    a = np.arccos(-found.e_1z.values)
    b = np.arctan2(found.e_2x.values, found.e_2y.values)
    assert abs(a.mean() - 0.9) < 5 * 0.01 / 9000**0.5
    assert abs(a.std() / 0.01 - 1) < 5 / 18000**0.5
    assert 0.3 <= b.min() < 0.301
    assert 0.499 < b.max() <= 0.5
    assert abs(np.corrcoef(a, b)[0, 1]) < 5 / 9000**0.5


@pytest.mark.parametrize("name", SWEEPS)
def test_results_do_not_depend_on_chunks_or_threads(tmp_path: Path, name: str) -> None:
    whole = swept(tmp_path, SWEEPS[name], "whole.zarr")
    axes = [axis for axis in whole.dims if axis in whole.coords and f"{axis}_values" not in whole.dims]
    swept_axes = [axis for axis in axes if axis in next(iter(whole.data_vars.values())).dims]
    options = [option for axis in swept_axes for option in ("--chunk", f"{axis}={-(-whole.sizes[axis] // 3)}")]
    assert swept(tmp_path, SWEEPS[name], "parts.zarr", *options, "--threads", "2").identical(whole)
    size = whole.nbytes / 1e6 / 40
    assert swept(tmp_path, SWEEPS[name], "small.zarr", "--chunk-memory", str(size)).identical(whole)


def test_netcdf_holds_the_same(tmp_path: Path) -> None:
    pytest.importorskip("dask")
    pytest.importorskip("h5netcdf")
    for name, text in (("kernel", DISTANCES), ("failures", FAILURES)):
        whole = swept(tmp_path, text, f"{name}.zarr")
        assert swept(tmp_path, text, f"{name}.nc", "--chunk-memory", "0.01").identical(whole)
    assert sorted(path.name for path in tmp_path.iterdir()) == [
        "failures.nc",
        "failures.zarr",
        "kernel.nc",
        "kernel.zarr",
        "sweep.toml",
    ]


def test_values_that_are_not_finite_are_counted(tmp_path: Path) -> None:
    text = 'function = "mirer2009.equal_moment_pitch"\n[parameters]\nI_1 = [1.0, 2.0]\nI_2 = [1.0, 2.0]\nI_3 = 2.0\n'
    exit_code, said = run(tmp_path, text, "out.zarr")
    found = opened(tmp_path / "out.zarr")
    count = sum(int((~np.isfinite(array)).sum()) for array in found.data_vars.values())
    assert exit_code == 0
    assert count > 0
    assert said.endswith(f"{count} values are infinite or not a number\n")


def test_constant_vectors_stay_vectors_for_functions_of_one_set(tmp_path: Path) -> None:
    text = f"""
function = "wheels.allocate"
[parameters]
axes = {np.eye(3).tolist()}
limits = [1.0, 2.0, 4.0]
demand = [0.5, {{ start = -1.0, stop = 1.0, count = 5 }}, 0.0]
"""
    found = swept(tmp_path, text, "out.zarr")
    np.testing.assert_array_equal(found.momenta[:, 1], np.linspace(-1, 1, 5))


# --- what is no sweep

ERRORS = {
    "no TOML": ("function =", "is not a sweep in TOML"),
    "no function": ("[parameters]\na = 1", 'a sweep has function = "..." and a table'),
    "no parameters": ('function = "liquid.growth_rate"', 'a sweep has function = "..." and a table'),
    "date": (DISTANCES + "c = 1979-05-27", "is not a sweep in TOML"),
    "key": ("realisations = 1\n" + DISTANCES, "the sweep has no 'realisations'; did you mean 'realizations'"),
    "function": (DISTANCES.replace("four", "fuor"), "did you mean 'ignatov2005.face_distances_of_four_wheels'"),
    "function of no array": (DISTANCES.replace("ignatov2005.face", "liquid.growth"), "did you mean"),
    "module": (DISTANCES.replace("ignatov2005.face_distances_of_four_wheels", "os.system"), "cannot be swept"),
    "parameter": (GROWTH.replace("omega_0", "omega0"), "has no parameter omega0; did you mean 'omega_0'"),
    "missing": (DISTANCES.replace("b =", "#"), "needs b"),
    "text": (DISTANCES.replace("{ start = 0.1, stop = 1.5, count = 60 }", '"x"'), "a = 'x' must be a finite number"),
    "truth": (DISTANCES.replace("{ start = 0.1, stop = 1.5, count = 60 }", "true"), "a = True must be"),
    "infinite": (DISTANCES.replace("0.1", "inf"), "a.start = inf must be a finite number"),
    "no count": (DISTANCES.replace(", count = 60", ""), "a = {'start': 0.1, 'stop': 1.5} must be"),
    "count": (DISTANCES.replace("60", "0"), "a.count = 0 must be a whole number from 1 to 1e+08"),
    "a huge count": (DISTANCES.replace("60", "1_000_000_000_000_000"), "a.count = 1000000000000000 must be"),
    "a huge ensemble": (TOLERANCES.replace("9000", "1_000_000_000"), "realizations = 1000000000 must be"),
    "range": (DISTANCES.replace("stop = 1.5", "end = 1.5"), "a has no 'end'"),
    "scale": (GROWTH.replace("log", "cubic"), "omega_0.scale = 'cubic' must be"),
    "logarithm": (GROWTH.replace("start = 0.5", "start = 0.0"), "must have the same sign and not be 0"),
    "empty": (DISTANCES.replace("{ start = 0.1, stop = 1.5, count = 60 }", "[]"), "a is an empty list"),
    "ragged": (FAILURES.replace("[1.0, 1.0, 1.0]]", "[1.0, 1.0]]"), "moments must be a list of arrays of one shape"),
    "components": (GROWTH.replace("[0.2, 0.1]", "{ start = 0, stop = 1, count = 2 }"), "E_n has components"),
    "nothing": (re.sub(r"\{.*\}", "0.5", DISTANCES), "nothing varies"),
    "domain": (GROWTH.replace("A = 1.0", "A = -1.0"), "liquid.stability: A = -1.0 must be positive"),
    "object": (
        ENSEMBLE.replace('[parameters.torques]\nfunction = "random_rotation.RandomTorques"', "[parameters.x]"),
        "random_rotation.simulate has no parameter x",
    ),
    "torques": (GROWTH.replace("liquid.stability", "random_rotation.RandomTorques"), "has no parameter"),
    "no numbers": (TORQUES_ALONE, "gives no numbers; use it for a parameter of another function"),
    "a number for an object": (
        ENSEMBLE.split("[parameters.start.torques]")[0] + "torques = 1",
        "start.torques must be the result of a function",
    ),
    "seed": (TOLERANCES.replace("seed = 3", ""), "both a seed and a number of realizations"),
    "realizations": (TOLERANCES.replace("9000", "0"), "realizations = 0 must be a whole number from 1 to 1e+08"),
    "own seed": (ENSEMBLE.replace("step = 2.0", "step = 2.0\nseed = 1"), "seed is given by the sweep"),
    "no ensemble": (re.sub("(seed|realizations) = .*", "", ENSEMBLE), "what is random needs a seed"),
    "not random": ("seed = 1\nrealizations = 2\n" + DISTANCES, "nothing is random"),
    "distribution": (TOLERANCES.replace("0.01", "-0.01"), "a.normal = [0.9, -0.01] is not a distribution"),
    "distribution of one": (TOLERANCES.replace("[0.9, 0.01]", "0.9"), "a.normal must be [mean, deviation]"),
    "failures": (FAILURES.replace("[[], [0], [0, 2]]", "[0]"), "must be a list of lists of wheels"),
    "wheel": (FAILURES.replace("[0, 2]", "[4]"), "wheel 4; the wheels are counted from 0 to 3"),
    "no wheels": ("failures = [[]]\n" + DISTANCES, "needs a function with axes and limits"),
    "half-spaces": (FAILURES.split("[parameters.half")[0] + "half_spaces = 1", "must be the result of a function"),
}


@pytest.mark.parametrize("name", ERRORS)
def test_a_wrong_specification_is_reported_in_one_line(tmp_path: Path, name: str) -> None:
    text, expected = ERRORS[name]
    exit_code, said = run(tmp_path, text, "out.zarr")
    assert exit_code == 2
    assert expected in said
    assert said.count("\n") == 1
    assert [path.name for path in tmp_path.iterdir()] == ["sweep.toml"]


OPTIONS = {
    "ending": ("out.csv", (), "must end with .zarr or .nc"),
    "folder": ("no/out.zarr", (), "there is no folder"),
    "chunk": ("out.zarr", ("--chunk", "a"), "'a' must be AXIS=POINTS"),
    "axis": ("out.zarr", ("--chunk", "c=2"), "the axes of the sweep are a, b"),
    "scheduler": (
        "out.zarr",
        ("--scheduler", "tcp://127.0.0.1:9", "--wait", "0.5"),
        "no scheduler answers at tcp://127",
    ),
    "no address": ("out.zarr", ("--scheduler", " "), "it is empty; give tcp://HOST:8786, or leave --scheduler out"),
    "memory": ("out.zarr", ("--chunk-memory", "nan"), "nan is not a finite number"),
    "no end": ("out.zarr", ("--wait", "inf"), "inf is not a finite number"),
    "address": ("out.zarr", ("--scheduler", "ftp://x", "--wait", "0.5"), "no scheduler answers at ftp://x"),
}


@pytest.mark.parametrize("name", OPTIONS)
def test_options_that_do_not_fit_are_reported_in_one_line(tmp_path: Path, name: str) -> None:
    pytest.importorskip("distributed")
    out, options, expected = OPTIONS[name]
    exit_code, said = run(tmp_path, DISTANCES, out, *options)
    assert exit_code == 2
    assert expected in said
    assert said.count("\n") == 1


def test_more_chunks_than_can_be_kept_are_refused(tmp_path: Path) -> None:
    text = re.sub("count = [0-9]+", "count = 10_000_000", DISTANCES)
    exit_code, said = run(tmp_path, text, "out.zarr", "--chunk", "a=1")
    assert exit_code == 2
    assert re.search("the sweep has [0-9,]+ chunks, more than 1,000,000", said)
    assert [path.name for path in tmp_path.iterdir()] == ["sweep.toml"]


def test_an_address_that_is_none_is_one_line_to_the_end_of_the_process(tmp_path: Path) -> None:
    pytest.importorskip("distributed")
    process = command(tmp_path, "out.zarr", "--scheduler", "garbage", "--wait", "0.5", text=DISTANCES)
    _, said = process.communicate(timeout=60)
    assert process.returncode == 2
    assert said.splitlines() == [
        "symcheck: no scheduler answers at garbage within 0.5 s (missing port number in address 'garbage')"
    ]


def test_what_is_missing_is_named_with_the_command_that_installs_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("symcheck.numeric.sweep.find_spec", lambda name: None if name == "zarr" else object())
    assert run(tmp_path, DISTANCES, "out.zarr") == (
        2,
        f"symcheck: a sweep needs zarr; run `{installing('sweep')}`\n",
    )


def test_complex_results_are_refused_for_netcdf(tmp_path: Path) -> None:
    exit_code, said = run(tmp_path, GROWTH, "out.nc")
    assert (exit_code, "frequencies is complex" in said) == (2, True)


def test_every_function_that_is_known_can_be_read() -> None:
    from symcheck.numeric.sweep.functions import find

    names = known()
    assert {"liquid.growth_rate", "ignatov2005.volume_of_four_wheels", "random_rotation.simulate"} <= names
    for name in names:
        assert len(find(name).outputs) >= 1


def test_the_command_line_loads_nothing_of_a_sweep() -> None:
    text = "import sys, symcheck.cli; print([m for m in ('dask', 'numpy', 'xarray', 'zarr') if m in sys.modules])"
    done = subprocess.run([sys.executable, "-c", text], cwd=ROOT, capture_output=True, text=True, check=True)
    assert done.stdout == "[]\n"


# --- what stops a sweep, and how it goes on


def test_a_finished_sweep_is_not_computed_again(tmp_path: Path, computed: list[Any]) -> None:
    swept(tmp_path, DISTANCES, "out.zarr")
    computed.clear()
    exit_code, said = run(tmp_path, DISTANCES, "out.zarr")
    assert (exit_code, computed) == (0, [])
    assert said.endswith("is finished already; nothing was computed\n")
    exit_code, said = run(tmp_path, DISTANCES.replace("60", "61"), "out.zarr")
    assert (exit_code, computed) == (2, [])
    assert "exists and is not this sweep" in said


@contextmanager
def stopped(folder: Path, monkeypatch: pytest.MonkeyPatch, chunks: int) -> Iterator[None]:
    """A sweep in chunks of a = 6 that fails after so many of the ten are written."""
    from symcheck.numeric.sweep.store import Store

    write, left = Store.write, iter(range(chunks))

    def failing(self: Any, *args: Any) -> int:
        if next(left, None) is None:
            raise KeyboardInterrupt
        return write(self, *args)

    with monkeypatch.context() as patch:
        patch.setattr(Store, "write", failing)
        exit_code, said = run(folder, DISTANCES, "out.zarr", "--chunk", "a=6", "--threads", "1")
    assert exit_code == 130
    assert f"interrupted; {chunks} of 10 chunks are done and kept; the same command goes on from there" in said
    yield


def test_only_what_is_missing_or_damaged_is_computed_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, computed: list[Any]
) -> None:
    whole = swept(tmp_path, DISTANCES, "whole.zarr")
    partial, log = tmp_path / "out.zarr.partial.zarr", tmp_path / "out.zarr.partial.finished"
    with stopped(tmp_path, monkeypatch, 6):
        finished = journal(tmp_path / "out.zarr")  # chunks may overtake one another
        assert len(finished) == 6
        cut, gone, replaced, other, *_ = finished
        (partial / f"r_1/c/{cut}/0").write_bytes((partial / f"r_1/c/{cut}/0").read_bytes()[:100])
        (partial / f"r_2/c/{gone}/0").unlink()  # never came to the disk
        (partial / f"r_3/c/{replaced}/0").write_bytes((partial / f"r_3/c/{other}/0").read_bytes())
        (partial / "r_3/c/9").mkdir(exist_ok=True)
        (partial / "r_3/c/9/0.7d.partial").write_bytes(b"by halves")
        log.write_bytes(log.read_bytes()[:-3])  # the last line was not written to its end
        computed.clear()
        exit_code, said = run(tmp_path, DISTANCES, "out.zarr")
    assert exit_code == 0
    assert "10 chunks, 2 of them from before" in said
    kept = {int(chunk) for chunk in finished[3:-1]}
    assert sorted(each["a"].start // 6 for each in computed) == sorted({*range(10)} - kept)
    assert opened(tmp_path / "out.zarr").identical(whole)
    assert not [path for path in tmp_path.rglob("*") if "partial" in path.name]


def test_a_file_whose_writing_was_interrupted_is_written_from_what_is_kept(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, computed: list[Any]
) -> None:
    from symcheck.numeric.sweep import store as sweep_store

    pytest.importorskip("dask")
    pytest.importorskip("h5netcdf")

    def interrupted(partial: Path, out: Path) -> None:
        out.with_name("out.nc.new").write_bytes(b"by halves")
        raise KeyboardInterrupt

    with monkeypatch.context() as patch:
        patch.setattr(sweep_store, "_to_netcdf", interrupted)
        exit_code, said = run(tmp_path, DISTANCES, "out.nc", "--chunk", "a=6")
    assert (exit_code, (tmp_path / "out.nc").exists()) == (130, False)
    assert "10 of 10 chunks are done and kept" in said
    computed.clear()
    assert swept(tmp_path, DISTANCES, "out.nc").identical(swept(tmp_path, DISTANCES, "whole.zarr"))
    assert len(computed) == 1  # that of whole.zarr
    assert sorted(path.name for path in tmp_path.iterdir()) == ["out.nc", "sweep.toml", "whole.zarr"]


CHANGES: dict[str, tuple[str, tuple[str, ...], str]] = {
    "parameters": (DISTANCES.replace("1.5", "1.4"), (), "beginning of another sweep (parameters differ); remove"),
    "function": (DISTANCES.replace("face", "vertex"), (), "beginning of another sweep (function differ); remove"),
    "chunks": (DISTANCES, ("--chunk", "a=5"), "begun with chunks {'a': 6, 'b': 40}; leave --chunk out"),
}


@pytest.mark.parametrize("name", CHANGES)
def test_a_sweep_that_was_changed_does_not_go_on(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, computed: list[Any], name: str
) -> None:
    text, options, expected = CHANGES[name]
    with stopped(tmp_path, monkeypatch, 2):
        computed.clear()
        exit_code, said = run(tmp_path, text, "out.zarr", *options)
    assert (exit_code, computed) == (2, [])
    assert expected in said


def test_a_sweep_of_which_nothing_is_computed_stands_in_the_way_of_none(tmp_path: Path) -> None:
    wrong = GROWTH.replace("start = 0.1, stop = 2.0, count = 12", "start = 1.0, stop = -1.0, count = 12")
    exit_code, said = run(tmp_path, wrong, "out.zarr")
    assert (exit_code, "no chunk is finished" in said) == (2, True)
    assert swept(tmp_path, GROWTH, "out.zarr").identical(swept(tmp_path, GROWTH, "whole.zarr"))
    assert sorted(path.name for path in tmp_path.iterdir()) == ["out.zarr", "sweep.toml", "whole.zarr"]


def test_a_sweep_of_another_version_does_not_go_on(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with stopped(tmp_path, monkeypatch, 2):
        monkeypatch.setattr("symcheck.numeric.sweep.code", lambda: "another")
        exit_code, said = run(tmp_path, DISTANCES, "out.zarr")
    assert exit_code == 2
    assert "was begun with another version of symcheck or NumPy; remove" in said


def test_a_foreign_folder_is_not_touched(tmp_path: Path) -> None:
    other = tmp_path / "out.zarr.partial.zarr"
    other.mkdir()
    (other / "file").write_text("mine")
    exit_code, said = run(tmp_path, DISTANCES, "out.zarr")
    assert (exit_code, (other / "file").read_text()) == (2, "mine")
    assert "is not the beginning of a sweep" in said


def _rewritten(path: Path, edit: Callable[[dict[str, Any]], object]) -> None:
    data = json.loads(path.read_text("utf-8"))
    edit(data)
    path.write_text(json.dumps(data), encoding="utf-8")


def _as_format_2(partial: Path) -> None:
    with xarray.open_dataset(partial, engine="zarr", consolidated=False) as found:
        kept = found.load()
    shutil.rmtree(partial)
    for name in kept.variables:
        kept[name].encoding = {}
    kept.to_zarr(partial, zarr_format=2, consolidated=False)


def _of_metadata(edit: Callable[[dict[str, Any]], object], inner: str = "") -> Callable[[Path], None]:
    return lambda partial: _rewritten(partial / inner / "zarr.json", edit)


def _identified(**changes: Any) -> Callable[[Path], None]:
    def edit(data: dict[str, Any]) -> None:
        found = json.loads(data["attributes"]["symcheck_sweep"])
        data["attributes"]["symcheck_sweep"] = json.dumps({**found, **changes})

    return _of_metadata(edit)


def _written(text: str) -> Callable[[Path], None]:
    def edit(partial: Path) -> None:
        (partial / "zarr.json").write_text(text)

    return edit


FOREIGN: dict[str, Callable[[Path], None]] = {
    "of format 2": _as_format_2,
    "no JSON": _written("{"),
    "a list": _written("[]"),
    "an array": _of_metadata(lambda data: data.update(node_type="array")),
    "without a name": _of_metadata(lambda data: data.update(attributes={})),
    "named by a number": _of_metadata(lambda data: data["attributes"].update(symcheck_sweep=3)),
    "named by a list": _of_metadata(lambda data: data["attributes"].update(symcheck_sweep="[]")),
    "chunks of no length": _identified(chunks={"a": 0, "b": 40}),
    "chunks along other axes": _identified(chunks={"a": 6}),
    "another code": _identified(code=None),
    "another shape": _of_metadata(lambda data: data.update(shape=[60, 41]), "r_1"),
    "another type": _of_metadata(lambda data: data.update(data_type="float32"), "r_1"),
    "another codec": _of_metadata(lambda data: data.update(codecs=[{"name": "of mine"}]), "r_1"),
    "an array that is a group": _of_metadata(lambda data: data.update(node_type="group"), "r_1"),
    "an array less": lambda partial: shutil.rmtree(partial / "r_1"),
}


@pytest.mark.parametrize("name", FOREIGN)
def test_a_foreign_store_is_refused_in_one_line(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, computed: list[Any], name: str
) -> None:
    with stopped(tmp_path, monkeypatch, 2):
        partial = tmp_path / "out.zarr.partial.zarr"
        FOREIGN[name](partial)
        computed.clear()
        exit_code, said = run(tmp_path, DISTANCES, "out.zarr")
    assert (exit_code, computed, said.count("\n")) == (2, [], 1)
    assert re.search(r"is not the beginning of (a|this) sweep \(.*\); remove it", said)


def test_a_finished_sweep_of_format_2_is_not_taken_for_one(tmp_path: Path) -> None:
    swept(tmp_path, DISTANCES, "out.zarr")
    _as_format_2(tmp_path / "out.zarr")
    exit_code, said = run(tmp_path, DISTANCES, "out.zarr")
    assert (exit_code, said.count("\n")) == (2, 1)
    assert "exists and is not this sweep" in said


def test_lines_of_a_journal_that_are_not_ours_count_for_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, computed: list[Any]
) -> None:
    with stopped(tmp_path, monkeypatch, 2):
        with open(tmp_path / "out.zarr.partial.finished", "ab") as journal:
            journal.write(b"3\n-1 0 0\n99 " + b"0" * 32 + b" 0\n\xff\xfe\n")
        computed.clear()
        exit_code, _ = run(tmp_path, DISTANCES, "out.zarr")
    assert (exit_code, len(computed)) == (0, 8)


def test_values_out_of_the_domain_stop_the_sweep_and_what_is_done_is_kept(tmp_path: Path) -> None:
    text = GROWTH.replace("start = 0.1, stop = 2.0, count = 12", "start = 1.0, stop = -1.0, count = 12")
    exit_code, said = run(tmp_path, text, "out.zarr", "--chunk", "C=1", "--threads", "1")
    assert exit_code == 2
    assert re.search(r"liquid.stability: C\[.*must be positive .*; 6 of 12 chunks are done and kept", said)


def command(folder: Path, out: str, *options: str, text: str = LONG, **how: Any) -> subprocess.Popen[str]:
    """`symcheck sweep` as a process of its own."""
    (folder / "sweep.toml").write_text(text, encoding="utf-8")
    arguments = ["-m", "symcheck", "sweep", str(folder / "sweep.toml"), "--out", str(folder / out), *options]
    own = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "preexec_fn": interruptible, **how}
    return subprocess.Popen([sys.executable, *arguments], cwd=ROOT, text=True, **own)


def until(condition: Callable[[], Any], process: subprocess.Popen[str] | None = None) -> None:
    """Wait for the condition, or fail."""
    for _ in range(3000):
        if condition():
            return
        assert process is None or process.poll() is None, process.communicate()
        time.sleep(0.01)
    raise AssertionError("nothing happened for 30 s")


@pytest.mark.parametrize("sent", [signal.SIGINT, signal.SIGKILL])
def test_a_sweep_that_was_stopped_goes_on_where_it_was(
    tmp_path: Path, computed: list[Any], sent: signal.Signals
) -> None:
    out = tmp_path / "out.zarr"
    process = command(tmp_path, "out.zarr", "--chunk", "a=2", "--threads", "2")
    until(lambda: len(journal(out)) >= 20, process)
    process.send_signal(sent)
    _, said = process.communicate(timeout=60)
    kept = len(journal(out))
    assert not out.exists()
    assert 20 <= kept < 250
    assert process.returncode == (130 if sent is signal.SIGINT else -signal.SIGKILL)
    if sent is signal.SIGINT:
        assert (
            said
            == f"symcheck: interrupted; {kept} of 250 chunks are done and kept; the same command goes on from there\n"
        )
    before = set(journal(out))
    exit_code, told = run(tmp_path, LONG, "out.zarr")
    assert (exit_code, f"250 chunks, {kept} of them from before" in told) == (0, True)
    assert sorted([*map(int, before), *(each["a"].start // 2 for each in computed)]) == list(range(250))
    assert opened(out).identical(swept(tmp_path, LONG, "whole.zarr"))


def test_a_full_disk_is_reported_and_the_sweep_goes_on_when_there_is_room(tmp_path: Path) -> None:
    resource = pytest.importorskip("resource")

    def limited() -> None:
        resource.setrlimit(resource.RLIMIT_FSIZE, (40_000, 40_000))

    text = TOLERANCES.replace("9000", "40000")
    process = command(tmp_path, "out.zarr", "--chunk", "realization=40000", text=text, preexec_fn=limited)
    _, said = process.communicate(timeout=60)
    assert process.returncode == 2
    assert "cannot be written: File too large; no chunk is finished" in said
    assert swept(tmp_path, text, "out.zarr").identical(
        swept(tmp_path, text, "whole.zarr", "--chunk", "realization=4000")
    )


def test_two_sweeps_do_not_write_one_file(tmp_path: Path) -> None:
    process = command(tmp_path, "out.zarr", "--chunk", "a=2", "--threads", "1")
    until(lambda: journal(tmp_path / "out.zarr"), process)
    exit_code, said = run(tmp_path, LONG, "out.zarr")
    process.kill()
    process.communicate()
    assert exit_code == 2
    assert "another sweep is writing" in said


# --- workers


def test_a_worker_of_another_version_is_refused() -> None:
    with pytest.raises(SweepError, match="another version of symcheck"):
        sweep_workers.compute(json.dumps({}), "another", {})
    assert code() == code()


def test_no_more_chunks_are_under_way_than_the_window() -> None:
    class Lazy:
        """Finishes the oldest call when the next result is waited for."""

        def __init__(self) -> None:
            self.pending: list[Future[int]] = []
            self.most = 0

        def submit(self, function: Any, *arguments: Any) -> Future[int]:
            self.pending = [each for each in self.pending if not each.done()]
            self.pending.append(Future())
            self.most = max(self.most, len(self.pending))
            if len(self.pending) == 3:
                self.pending[0].set_result(arguments[0])
            return self.pending[-1]

    executor = Lazy()
    workers = sweep_workers.Workers(executor, 3, None, lambda: None)  # type: ignore[arg-type]
    found = []
    for number, _ in workers.completed(max, ((k, (k,)) for k in range(20))):
        found.append(number)
        if len(found) == 18:
            break
    assert found == list(range(18))
    assert executor.most == 3
    wait([each for each in executor.pending if each.cancelled()], timeout=0)


@contextmanager
def started(*names: str, folder: Path) -> Iterator[list[subprocess.Popen[str]]]:
    """A scheduler on this machine's loopback and its workers."""
    file = folder / "scheduler.json"
    scheduler = ["scheduler", "--host", "127.0.0.1", "--port", "0", "--no-dashboard", "--no-show"]
    worker = ["worker", "--no-nanny", "--nthreads", "1", "--no-dashboard", "--host", "127.0.0.1", "--name"]
    commands = [[*scheduler], *([*worker, name] for name in names)]
    processes = [
        subprocess.Popen(
            [sys.executable, "-m", "dask", *each, "--scheduler-file", str(file)],
            cwd=ROOT,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            text=True,
        )
        for each in commands
    ]
    try:
        until(lambda: file.exists() and file.read_text().endswith("}"), processes[0])
        yield processes
    finally:
        for process in processes:
            process.kill()
            process.wait()
        shutil.rmtree(folder / "dask-scratch-space", ignore_errors=True)


def address(folder: Path) -> str:
    found: str = json.loads((folder / "scheduler.json").read_text())["address"]
    return found


@pytest.mark.slow
def test_a_cluster_gives_the_same_bits_and_loses_nothing_with_a_worker(tmp_path: Path) -> None:
    pytest.importorskip("distributed")
    out = tmp_path / "out.zarr"
    with started("one", "two", folder=tmp_path) as (_, worker, _other):
        process = command(tmp_path, "out.zarr", "--chunk", "a=2", "--scheduler", address(tmp_path))
        until(lambda: len(journal(out)) >= 50, process)
        worker.send_signal(signal.SIGKILL)
        done = len(journal(out))
        told, said = process.communicate(timeout=120)
    assert (process.returncode, done < 200) == (0, True), said
    assert "250 chunks, 0 of them from before" in told
    assert opened(out).identical(swept(tmp_path, LONG, "whole.zarr"))


@pytest.mark.slow
def test_a_cluster_without_workers_or_scheduler_is_reported_and_what_is_done_is_kept(tmp_path: Path) -> None:
    pytest.importorskip("distributed")
    out = tmp_path / "out.zarr"
    for lost, expected in ((1, "has no workers; start one with `dask worker tcp://"), (0, "is gone")):
        with started("one", folder=tmp_path) as processes:
            options = ("--chunk", "a=2", "--scheduler", address(tmp_path), "--wait", "3")
            process = command(tmp_path, "out.zarr", *options)
            before = len(journal(out))
            until(lambda n=before: len(journal(out)) >= n + 20, process)
            processes[lost].send_signal(signal.SIGKILL)
            _, said = process.communicate(timeout=60)
        assert process.returncode == 2
        assert expected in said
        assert f"{len(journal(out))} of 250 chunks are done and kept" in said
        (tmp_path / "scheduler.json").unlink()
    assert swept(tmp_path, LONG, "out.zarr").identical(swept(tmp_path, LONG, "whole.zarr"))
