"""Array types of the geometry, and the gate through which numbers enter it."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property
from typing import Any, TypeAlias, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .errors import GeometryError

Floats: TypeAlias = NDArray[np.float64]
Integers: TypeAlias = NDArray[np.int64]
Booleans: TypeAlias = NDArray[np.bool_]

Array = TypeVar("Array", bound=NDArray[Any])

FARTHEST = 1e12
"""Meters. Beyond it a double no longer resolves a tenth of a millimeter."""


def finite(values: ArrayLike, what: str) -> Floats:
    """`values` as a float64 array; raises GeometryError if one of them is not finite."""
    try:
        array = np.asarray(values, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise GeometryError(f"{what} must be numbers") from error
    if not np.isfinite(array).all():
        raise GeometryError(f"{what} must be finite numbers, but some are infinite or NaN")
    return array


def finite_points(points: ArrayLike, what: str = "the points of a curve") -> Floats:
    """`points` as a finite (n, 2) array within `FARTHEST` meters of the origin."""
    array = finite(points, what)
    if array.size == 0:
        return array.reshape(0, 2)
    if array.ndim != 2 or array.shape[1] != 2:
        raise GeometryError(f"{what} must be pairs (x, y), but their shape is {array.shape}")
    if np.abs(array).max() > FARTHEST:
        raise GeometryError(f"{what} must lie within {FARTHEST:g} m of the origin")
    return array


def flat(values: ArrayLike) -> Floats:
    """All of them in one row, (n,)."""
    return np.asarray(values, dtype=np.float64).reshape(-1)


def cross(a: Floats, b: Floats) -> Floats:
    """z of the cross product of (..., 2) vectors: positive when `b` points left of `a`."""
    return np.asarray(a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0])


def norm(vectors: Floats) -> Floats:
    """Lengths of (..., 2) vectors."""
    return np.hypot(vectors[..., 0], vectors[..., 1])


def left_of(vectors: Floats) -> Floats:
    """(..., 2) vectors turned a quarter turn counter-clockwise."""
    return np.stack([-vectors[..., 1], vectors[..., 0]], axis=-1)


def wrapped(angles: Floats) -> Floats:
    """Angles in [-pi, pi)."""
    turned = angles + np.pi
    # The remainder of what is within a turn is itself, and takes several times as long to find.
    if not (np.size(turned) > _MANY and turned.min() >= 0.0 and turned.max() < _TURN):
        turned = turned % _TURN
    within: Floats = turned - np.pi
    return within


_TURN, _MANY = 2.0 * np.pi, 256


def wrapped_angle(angle: float) -> float:
    """One angle in [-pi, pi), to the bits of `wrapped`."""
    return (angle + np.pi) % _TURN - np.pi


def inverse_index(rows: Integers, count: int) -> Integers:
    """(count,) where each of `count` rows is in a selection `rows`; -1 for those that are not."""
    place = np.full(count, -1)
    place[rows] = np.arange(len(rows))
    return place


def read_only(array: Array) -> Array:
    """The same numbers in an array that cannot be written to."""
    if array.flags.writeable:
        array = array.view()
        array.flags.writeable = False
    return array


class cached_array(cached_property[Array]):
    """A property that is computed once and cannot be written to."""

    def __init__(self, compute: Callable[[Any], Array]) -> None:
        super().__init__(lambda owner: read_only(compute(owner)))
        self.__doc__ = compute.__doc__


class SharedArrays:
    """A value with several readers: none of them can write to its arrays.

    What one plugin does to an array in place would change what all others see.
    """

    def __post_init__(self) -> None:
        self._share()

    def _share(self) -> None:
        for name, value in vars(self).items():
            if isinstance(value, np.ndarray):
                object.__setattr__(self, name, read_only(value))
            elif isinstance(value, tuple) and any(isinstance(v, np.ndarray) for v in value):
                parts = (read_only(v) if isinstance(v, np.ndarray) else v for v in value)
                object.__setattr__(self, name, tuple(parts))

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)  # pickled arrays come back writable
        self._share()
