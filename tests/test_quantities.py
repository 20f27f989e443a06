"""Quantities of pint go into the kernels, in any units of the same dimensions, and come out."""

from __future__ import annotations

import subprocess
import sys
from typing import Any

import numpy as np
import pytest

from symcheck.generated import mirer2009, poloskov2004
from symcheck.kernels import quantities, runtime
from symcheck.kernels.specification import specification
from symcheck.numeric import inertia

pint = pytest.importorskip("pint")
REGISTRY: Any = pint.UnitRegistry()
Q = REGISTRY.Quantity


def test_quantities_are_converted_and_come_out_in_the_units_of_the_outputs() -> None:
    found: Any = mirer2009.bounds_of_products(
        Q(1.0, "kg m^2"),
        Q(2e7, "g cm^2"),
        Q(np.array([3.0, 4.0]), "kg m^2"),  # type: ignore[call-overload]
    )
    for each, wanted in zip(found, mirer2009.bounds_of_products(1.0, 2.0, np.array([3.0, 4.0])), strict=True):
        assert each.units == REGISTRY.parse_units("kg^3 m^6")
        np.testing.assert_allclose(each.magnitude, wanted, rtol=1e-15)
    angles = [Q(90.0, "deg"), Q(0.0, "rad"), 0.0]  # a plain number is an angle too
    cosines: Any = mirer2009.direction_cosines(*angles)
    assert all(each.dimensionless for each in cosines)
    np.testing.assert_allclose([each.magnitude for each in cosines], mirer2009.direction_cosines(np.pi / 2, 0.0, 0.0))


@pytest.mark.parametrize(
    "kernel", [*mirer2009.KERNELS.values(), *poloskov2004.KERNELS.values()], ids=lambda x: x.__name__
)
def test_every_kernel_gives_the_same_with_units_and_without(kernel: Any) -> None:
    said = specification(kernel)
    points = np.linspace(0.4, 0.7, len(said.arguments))
    with np.errstate(all="ignore"):
        plain = kernel(*points)
        odd = [each.name for each in (*said.arguments, *said.outputs) if each.unit == "(rad/s)^m"]
        if odd:
            with pytest.raises(ValueError, match=rf"{odd[0]} is in \(rad/s\)\^m, which is no unit of its own"):
                kernel(*(Q(x, each.unit) for x, each in zip(points, said.arguments, strict=True)))
            return
        units = [quantities._RELATIVE.sub("1", each.unit) for each in said.arguments]
        found = kernel(*(Q(x, unit) for x, unit in zip(points, units, strict=True)))
    several = zip(found, plain, strict=True) if isinstance(plain, tuple) else [(found, plain)]
    for (one, other), output in zip(several, said.outputs, strict=True):
        assert one.is_compatible_with(quantities._RELATIVE.sub("1", output.unit))
        np.testing.assert_array_equal(one.magnitude, other)


MOMENT = Q(1.0, "kg m^2")
REFUSED = {
    "another dimension": (
        (Q(1.0, "m"), Q(1.0, "kg m^2"), Q(1.0, "kg m^2")),
        r"I_1 is in meter, which measures \[length\]",
    ),
    "no unit beside one": ((Q(1.0, "kg m^2"), 2.0, Q(1.0, "kg m^2")), "I_2 is a plain number, and other arguments are"),
}


@pytest.mark.parametrize(("arguments", "told"), REFUSED.values(), ids=REFUSED)
def test_what_measures_something_else_is_refused_in_words(arguments: list[Any], told: str) -> None:
    with pytest.raises(ValueError, match=f"bounds_of_products: {told}"):
        mirer2009.bounds_of_products(*arguments)


def test_turns_are_not_taken_for_radians() -> None:
    kernel = next(k for k in poloskov2004.KERNELS.values() if "rad/s" in {x.unit for x in specification(k).arguments})
    said = specification(kernel)
    with pytest.raises(ValueError, match="turns or radians"):
        kernel(*(Q(0.5, "Hz" if each.unit == "rad/s" else each.unit) for each in said.arguments))


def test_nothing_is_written_without_its_unit() -> None:
    moments = [Q(1.0, "kg m^2")] * 3
    with pytest.raises(ValueError, match="out= is for plain arrays"):
        mirer2009.bounds_of_products(*moments, out=[np.empty(1)] * 3)  # type: ignore[call-overload]
    with pytest.raises(ValueError, match="takes plain numbers, in the unit that it says"):
        inertia.principal_inertia(Q(np.eye(3), "kg m^2"))


def test_plain_numbers_and_arrays_never_come_to_what_converts(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object) -> Any:
        raise AssertionError

    monkeypatch.setattr(runtime, "in_units", refuse)
    monkeypatch.setattr(runtime, "is_quantity", refuse)
    for point in (
        (1.0, 2.0, 3.0),
        (np.float64(1), 2, 3.0),
        (np.arange(1.0, 5), 2.0, np.ones((2, 4))),
        (np.ones(9),) * 3,
    ):
        mirer2009.bounds_of_products(*point)  # type: ignore[call-overload]


def test_kernels_import_no_pint() -> None:
    code = "import sys; from symcheck.generated import mirer2009 as m; m.bounds_of_products(1, 2, 3); "
    subprocess.run([sys.executable, "-c", code + "assert 'pint' not in sys.modules"], check=True)
