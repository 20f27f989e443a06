"""What an argument may be: the one place where the numeric layer checks what it is given.

An error names the argument, the value and the condition, with the equation it comes from; a value that is not finite
does not get in, so that none gets out unseen.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection
from importlib import import_module
from types import ModuleType
from typing import Any, Protocol, TypeAlias, TypeVar, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from symcheck.core.extras import installing
from symcheck.kernels.calling import is_foreign
from symcheck.kernels.quantities import is_quantity

Array = NDArray[np.float64]
Result = TypeVar("Result", Array, NDArray[np.complex128])


class Turn(Protocol):
    """A rotation, such as SciPy's `Rotation`."""

    def as_matrix(self) -> Array:
        """The matrices that turn vectors."""


Orientation: TypeAlias = ArrayLike | Turn  # axes as rows, or the rotation that turns the reference axes into them
Truth = bool | np.bool_ | NDArray[np.bool_]
Shape = tuple[int | None, ...]  # lengths of last axes, None for any length

TOLERANCE = 1e-9  # relative: a matrix that was written with ten digits still passes
LARGEST = 1e100  # a moment: the product of three is a double; a coefficient: the quotient of two squares is one
FARTHEST = 1e150  # a quotient: its square is a double
STEPS = 10_000  # powers of two that make of every double 0 or infinity
GREATEST = 1e302  # a momentum: sums of a million are doubles
HUGE = np.finfo(np.float64).max / 4  # an entry of a 3 x 3 matrix: its eigenvalues are doubles
ROUNDING = 8 * np.finfo(np.float64).eps  # of the sum of three moments
IN_DEGREES = re.compile(r"(arc)?deg|arcmin|arcsec|°|rpm", re.IGNORECASE)  # as pint and CF conventions spell them
MAX_CHARACTERS = 100  # characters of a value in an error, which stays on one line


# --- numbers


def real(name: str, value: ArrayLike, shape: Shape = ()) -> Array:
    """The value as an array of finite doubles with these last axes."""
    array = doubles(name, value, shape)
    require(np.isfinite(array) if is_numpy(array) else array - array == 0, name, array, "be finite")
    return array


def doubles(name: str, value: ArrayLike, shape: Shape = ()) -> Array:
    """As `real`, for a caller whose own condition excludes NaN and infinity."""
    if isinstance(value, np.ma.MaskedArray):
        raise ValueError(
            f"{name} is a masked array, whose mask would be lost; pass its filled() or compressed() values"
        )
    in_radians(name, value)
    if is_foreign(type(value)):
        return _of_shape(name, cast("Array", value), shape)
    try:
        array = np.asarray(value)
        if array.dtype.kind not in "iuf":
            raise TypeError
        array = array.astype(np.float64, copy=False)
    except (TypeError, ValueError):
        raise ValueError(f"{name} = {shortened(value)} is not an array of real numbers") from None
    return _of_shape(name, array, shape)


def _of_shape(name: str, array: Array, shape: Shape) -> Array:
    last = array.shape[array.ndim - len(shape) :]
    if last != shape and (len(last) < len(shape) or any(map(_differs, shape, last))):
        raise ValueError(f"{name} has shape {tuple(array.shape)}; its last axes must be ({_words(shape)})")
    return array


def in_radians(name: object, value: object) -> None:
    """ValueError if the value, an xarray.DataArray, says that its unit is a degree, or one made of degrees.

    Also for a quantity of pint, whose unit an array would lose.
    """
    if type(value) is np.ndarray:
        return
    if is_quantity(type(value)):
        raise ValueError(
            f"{name} is a quantity in {getattr(value, 'units', '')}; this function takes plain numbers, in the unit "
            "that it says: pass the quantity's m_as(unit). Generated kernels take quantities as they are"
        )
    units = str(getattr(value, "attrs", {}).get("units", ""))
    if IN_DEGREES.match(units):
        raise ValueError(f"{name} has units {units!r}; angles are in radians, rates in rad/s")


def moderate(name: str, array: Array, least: float = 0.0, most: float = GREATEST, source: str = "") -> Array:
    """The array, if all absolute values are between these two."""
    size = abs(array)
    bounds = f"lie between {least:g} and {most:g}" if least else f"be at most {most:g} either way"
    require((size >= least) & (size <= most), name, array, f"{bounds}; take another unit", source)
    return array


def momentum(name: str, value: ArrayLike, shape: Shape = ()) -> Array:
    """As `real`, of at most 1e302 N m s either way."""
    array = doubles(name, value, shape)
    if is_numpy(array) and np.count_nonzero(np.abs(array) <= GREATEST) == array.size:
        return array
    return moderate(name, real(name, value, shape))


def coefficient(name: str, value: ArrayLike, source: str) -> Array:
    """As `positive`, so near to 1 that a quotient of two squares is a double."""
    array = doubles(name, value)
    if is_numpy(array) and np.count_nonzero((array >= 1 / LARGEST) & (array <= LARGEST)) == array.size:
        return array
    return moderate(name, positive(name, value, source), 1 / LARGEST, LARGEST)


def exact(name: str, value: ArrayLike, shape: Shape) -> Array:
    """As `real`, without leading axes: one set of parameters."""
    array = real(name, value, shape)
    require(array.ndim == len(shape), f"{name}.shape", array.shape, f"be ({_words(shape)}); call once for each set")
    return array


def number(name: str, value: object, otherwise: str = "") -> float:
    """One finite number."""
    plain = _plain(value)
    if isinstance(plain, int | float) and not isinstance(plain, bool) and abs(plain) <= np.finfo(np.float64).max:
        return float(plain)
    raise ValueError(f"{name} = {shortened(value)} must be a finite number{otherwise}")


def whole(name: str, value: object, least: int, most: float = np.inf) -> int:
    """One integer within these bounds."""
    if isinstance(value, (int, np.integer)) and not isinstance(value, bool) and least <= value <= most:
        return int(value)
    bounds = f"from {least} on" if most == np.inf else f"from {least} to {most:g}"
    raise ValueError(f"{name} = {shortened(value)} must be a whole number {bounds}")


def positive(name: str, value: ArrayLike, source: str = "", shape: Shape = ()) -> Array:
    """As `real`, all greater than 0."""
    array = real(name, value, shape)
    require(array > 0, name, array, "be positive", source)
    return array


def not_negative(name: str, value: ArrayLike, source: str = "", shape: Shape = ()) -> Array:
    """As `real`, all at least 0."""
    array = real(name, value, shape)
    require(array >= 0, name, array, "not be negative", source)
    return array


def increasing(name: str, value: ArrayLike) -> Array:
    """Two or more numbers along one axis, each greater than the one before."""
    array = exact(name, value, (None,))
    require(array.size > 1 and bool((np.diff(array) > 0).all()), name, array, "be two or more, increasing")
    return array


def probability(name: str, value: ArrayLike) -> Array:
    """As `real`, strictly between 0 and 1."""
    array = real(name, value)
    require((array > 0) & (array < 1), name, array, "lie between 0 and 1, both excluded")
    return array


def acute(name: str, angle: ArrayLike) -> Array:
    """As `real`, strictly between 0 and pi/2."""
    array = real(name, angle)
    require((array > 0) & (array < np.pi / 2), name, array, "lie between 0 and pi/2", "tables 2 and 7")
    return array


# --- arrays of other libraries


def is_numpy(value: object) -> bool:
    """Whether it is an array of NumPy; others are of a library of the array API standard, such as JAX or PyTorch."""
    return isinstance(value, np.ndarray | np.generic)


def in_one_library(*arrays: Array) -> list[Array]:
    """The arrays; those of NumPy are put into the library of the others, if there are others."""
    if all(map(is_numpy, arrays)):
        return [*arrays]
    from array_api_compat import array_namespace

    library: Any = array_namespace(*(x for x in arrays if not is_numpy(x)))
    return [library.asarray(x) if is_numpy(x) else x for x in arrays]


def values_of(array: object) -> Array | None:
    """The numbers of an array as NumPy's; None while another library traces a function, as it has none then."""
    if is_numpy(array):
        return cast("Array", array)
    try:
        return np.asarray(getattr(array, "detach", lambda: array)())
    except Exception:  # of any kind: each library has its own
        return None


# --- bodies and axes


def principal_moments(moments: ArrayLike) -> Array:
    """Principal moments of inertia, shape (..., 3), so near to 1 that a product of three is a double."""
    array = positive("moments", moments, "mirer2009:2.0.6", (3,))
    return moderate("moments", array, 1 / LARGEST, LARGEST, "mirer2009:2.1")


def slack_of(moments: Array) -> Array:
    """By how much the triangle inequalities hold: I_1 + I_2 + I_3 - 2 I_i, without cancellation."""
    unit = power_of_two(np.abs(moments).max(axis=-1, keepdims=True))
    first = moments / unit
    slack = total(np.roll(first, -1, axis=-1), np.roll(first, -2, axis=-1), -first)
    return evaluated("the slack", lambda x: np.asarray(x * unit), slack)


def total(*terms: Array) -> Array:
    """Their sum, with what each addition rounds off added at the end: right to rounding where the terms cancel."""
    found, lost = terms[0], 0 * terms[0]
    for term in terms[1:]:
        found, before = found + term, found
        part = found - before
        lost = lost + ((before - (found - part)) + (term - part))
    return found + lost


def moments_of_a_mass(moments: ArrayLike) -> tuple[Array, Array]:
    """Moments of inertia that some distribution of mass has, a rod or a plate included, and their `slack_of`."""
    array = real("moments", moments, (3,))
    slack = slack_of(array)
    allowed = -(ROUNDING * np.abs(array)).sum(axis=-1, keepdims=True)
    holds = (slack >= allowed).all(axis=-1)
    require(holds, "moments", array, "satisfy the triangle inequalities I_1 + I_2 + I_3 >= 2 I_i", "mirer2009:2.3")
    return array, slack


def orthonormal_axes(axes: Orientation) -> Array:
    """Three orthonormal axes as rows, shape (..., 3, 3); of a rotation, those into which it turns others."""
    array = real("axes", rows_of(axes), (3, 3))
    known = values_of(array)
    if known is None:
        return array
    with np.errstate(over="ignore", invalid="ignore"):
        products = known @ known.swapaxes(-1, -2)
    holds = (np.abs(products - np.eye(3)) <= TOLERANCE).all(axis=(-1, -2))
    require(holds, "axes", known, f"have orthonormal rows, to {TOLERANCE:g}", "mirer2009:2.7")
    return array


def rows_of(axes: object) -> ArrayLike:
    """The axes of a rotation as rows; what is none, as it is."""
    as_matrix = getattr(axes, "as_matrix", None)
    return cast("ArrayLike", axes) if as_matrix is None else np.asarray(as_matrix()).swapaxes(-1, -2)


def unit_axes(axes: Orientation, source: str, count: int | None = None) -> Array:
    """Unit vectors as rows, shape (..., count, 3)."""
    array = doubles("axes", rows_of(axes), (count, 3))
    known = values_of(array)
    if known is None:
        return array
    square = np.einsum("...k,...k->...", known, known)
    square -= 1
    np.abs(square, out=square)
    require(
        square <= TOLERANCE,
        "axes",
        known,
        f"be finite and have the length 1, to {TOLERANCE:g}; divide it by its length in double precision",
        source,
    )
    return array


def symmetric_matrix(name: str, matrix: ArrayLike, source: str = "") -> Array:
    """A symmetric matrix, shape (..., 3, 3), with the roundings of its two halves averaged."""
    array = real(name, matrix, (3, 3))
    mirrored = array.swapaxes(-1, -2)
    largest = np.abs(array).max(axis=(-1, -2), keepdims=True)
    require((largest <= HUGE)[..., 0, 0], name, array, f"have entries of at most {HUGE:.2g}; take another unit", source)
    holds = (np.abs(array - mirrored) <= TOLERANCE * largest).all(axis=(-1, -2))
    require(holds, name, array, "be symmetric", source)
    return np.asarray((array + mirrored) / 2)


# --- stationary laws of the randomly driven rotation


def equatorial(alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> tuple[Array, Array, Array]:
    """alpha, beta, gamma, for which the amplitude has a stationary density."""
    noise = coefficient("alpha", alpha, "(3.5); without multiplicative noise the density is Rayleigh's, B.10")
    additive = coefficient("beta", beta, "4.0.3; without additive noise nothing is stationary, B.11")
    dissipation = coefficient("gamma", gamma, "1.1.7")
    noise, additive, dissipation = in_one_library(noise, additive, dissipation)
    require(2 * dissipation > noise, "gamma", dissipation, "satisfy 4 gamma^2 > alpha^2", "4.0.3")
    return noise, additive, dissipation


def axial(k: ArrayLike, g_13: ArrayLike, g_23: ArrayLike, d_33: ArrayLike) -> tuple[Array, Array, Array, Array]:
    """k, g_13, g_23, d_33, for which the frequency has a stationary density."""
    ratio, noise, additive, dissipation = in_one_library(
        coefficient("k", k, "(1.1)"),
        coefficient("g_13", g_13, "(3.5); without multiplicative noise the density is normal"),
        coefficient("g_23", g_23, "4.0.5; without additive noise nothing is stationary"),
        coefficient("d_33", d_33, "4.0.5"),
    )
    return ratio, noise, additive, dissipation


def within(name: str, value: Array, unit: Array, words: str) -> Array:
    """The value in a unit, of which it has no more than squares allow; `words` say what the unit is."""
    with np.errstate(over="ignore"):
        quotient = value / unit
    require(abs(quotient) <= FARTHEST, name, value, f"be at most about {FARTHEST:g} {words}")
    return quotient


# --- shapes, choices and results


def common_shape(**arrays: Array) -> tuple[int, ...]:
    """The shape to which the arrays broadcast."""
    try:
        return np.broadcast_shapes(*(tuple(array.shape) for array in arrays.values()))
    except ValueError:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in arrays.items())
        raise ValueError(f"the leading axes of {shapes} must broadcast to one shape") from None


def one_of(name: str, value: object, choices: Collection[object]) -> None:
    """One of some values."""
    require(value in choices, name, value, f"be one of {', '.join(map(str, choices))}")


def evaluated(what: str, function: Callable[..., Array], *values: Array) -> Array:
    """What the function gives, if that is finite; what another library gives is as it comes out."""
    if not all(map(is_numpy, values)):
        return function(*values)
    with np.errstate(all="ignore"):
        return finite(what, function(*values))


def finite(what: str, result: Result) -> Result:
    """A result that has not left the range of doubles."""
    require(
        np.isfinite(result) if is_numpy(result) else True,
        what,
        result,
        "be a finite double; take arguments of moderate size in other units",
    )
    return result


def engine_module(engine: str, module: str) -> ModuleType:
    """The module of an engine that needs a library of the same name; ImportError says if that is missing."""
    try:
        return import_module(module)
    except ModuleNotFoundError as error:
        if error.name != engine:
            raise
        raise ImportError(
            f"engine={engine!r} needs {engine}; run `{installing(engine)}`, or leave engine='numpy'", name=engine
        ) from error


def power_of_two(size: Array) -> Array:
    """The greatest power of two that is at most `size`, not negative: to divide by it rounds nothing; 1/2 for 0.

    Of arrays of other libraries it is 1: they are computed in the units that they have.
    """
    return np.ldexp(1.0, np.frexp(size)[1] - 1) if is_numpy(size) else cast("Array", 1.0)


def times_power(value: Array, unit: Array, power: Array) -> Array:
    """value unit^power of a unit that is a power of two: one step, as either factor may leave the range of doubles."""
    if not is_numpy(value):
        return value * unit**power
    exponent, whole = np.frexp(unit)[1] - 1, np.floor(power)
    high = np.rint((power - whole) * 2.0**30) / 2.0**30  # times an exponent it is exact
    turn = np.floor(exponent * high)
    rest = np.exp2((exponent * high - turn) + exponent * (power - whole - high))
    steps = np.clip(exponent * whole + turn, -STEPS, STEPS)
    return np.asarray(np.ldexp(value * rest, steps.astype(np.int64)))


# --- wording of errors


def require(holds: Truth, name: str, value: object, condition: str, source: str = "") -> None:
    """ValueError naming the first value for which `holds` is not true: "I = ... must ... (source)"."""
    if holds is True:
        return
    if type(holds) is np.ndarray and np.count_nonzero(holds) == holds.size:  # all() takes twice as long
        return
    if is_foreign(type(holds)):
        known, value = values_of(holds), values_of(value)
        if known is None:
            return
        holds = cast("Truth", known)
    if np.all(holds):
        return
    shape, array = np.shape(holds), np.asarray(value)
    place = tuple(int(k) for k in np.argwhere(~np.asarray(holds))[0])
    if array.shape[: len(shape)] != shape and array.ndim <= len(shape):  # a condition on several arguments
        array = np.broadcast_to(array, shape)
    shown = array[place] if array.shape[: len(shape)] == shape and place else value
    where = f"{name}[{', '.join(map(str, place))}]" if place and array.ndim else name
    raise ValueError(f"{where} = {shortened(shown)} must {condition}{f' ({source})' if source else ''}")


def shortened(value: object) -> str:
    """A value on one line."""
    value = _plain(value)
    text = np.array2string(value, precision=6, threshold=12) if isinstance(value, np.ndarray) else repr(value)
    text = " ".join(text.split())
    return text if len(text) <= MAX_CHARACTERS else f"{text[: MAX_CHARACTERS - 3]}..."


def _plain(value: object) -> object:
    return value.item() if isinstance(value, np.ndarray | np.generic) and value.ndim == 0 else value


def _differs(required: int | None, length: int) -> bool:
    return required is not None and required != length


def _words(shape: Shape) -> str:
    return ", ".join("n" if length is None else str(length) for length in shape)
