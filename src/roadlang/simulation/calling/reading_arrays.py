"""The arrays of readings: what kinds state of them, and whether they give what they state."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...ir.observation import ObservationBatch
from ...plugins.guard import plugin_guard, wrong_result
from ...plugins.kinds import ReadingArray, Sensor
from ...plugins.registry import KindEntry
from ...plugins.results import REAL

Arrays = Mapping[str, NDArray[Any]]
_RESERVED = ("time", "arrival", "file", "allow_pickle")
"""Every reading has the first two; `numpy.savez` has the others."""


def stated_arrays(entry: KindEntry, sensor: Sensor) -> dict[str, ReadingArray]:
    """What a sensor states of its readings. Raises RL470, RL474."""
    with plugin_guard(entry, None):
        found = dict(sensor.arrays())
    for name, array in found.items():
        fault = _fault_of(name, array)
        if fault is not None:
            raise wrong_result(entry, None, fault)
    for name in sensor.replaces:
        if name not in found:
            raise wrong_result(entry, None, f"replaces `{name}`, which is not one of its arrays")
        if name not in ObservationBatch.number_columns():
            fault = f"replaces `{name}`, which is not a column of numbers in observations"
            raise wrong_result(entry, None, fault)
        if found[name].shape != ():
            fault = f"replaces `{name}` with an array of shape {found[name].shape}, not a number"
            raise wrong_result(entry, None, fault)
    return found


def checked_arrays(
    entry: KindEntry, stated: Mapping[str, ReadingArray], found: object, leading: tuple[int, ...]
) -> Arrays:
    """Arrays with these leading axes, as they are stated. Raises RL474."""
    if not isinstance(found, Mapping) or found.keys() != stated.keys():
        names = sorted(map(str, found)) if isinstance(found, Mapping) else type(found).__name__
        raise wrong_result(entry, None, f"gave {names} as arrays, not {sorted(stated)}")
    return {name: _checked(entry, array, found[name], name, leading)
            for name, array in stated.items()}  # fmt: skip


def _fault_of(name: object, array: object) -> str | None:
    if not isinstance(name, str) or not name.isidentifier():
        return f"has an array {name!r}; names have letters, digits and `_`"
    if name in _RESERVED:
        return f"has an array `{name}`; no array of a reading can be called so"
    if not isinstance(array, ReadingArray):
        return f"states {array!r} of its array `{name}`, which is not a ReadingArray"
    shape: object = array.shape
    if not isinstance(shape, tuple) or not all(type(n) is int and n >= 0 for n in shape):
        return f"states the shape {shape!r} of its array `{name}`, which is not a tuple of integers"
    try:
        is_real = np.dtype(array.dtype).kind in REAL
    except TypeError:
        is_real = False
    if not is_real:
        return f"states the type {array.dtype!r} of its array `{name}`, not one of real numbers"
    return None


def _checked(
    entry: KindEntry, stated: ReadingArray, value: Any, name: str, leading: tuple[int, ...]
) -> NDArray[Any]:
    with plugin_guard(entry, None):
        array = np.asarray(value)
        fits = array.dtype.kind in REAL and not np.isnan(array).any()
    if not fits:
        raise wrong_result(entry, None, f"gave `{name}` with values that are not real numbers")
    shape = (*leading, *stated.shape)
    if array.shape != shape:
        raise wrong_result(entry, None, f"gave `{name}` of shape {array.shape}, not {shape}")
    dtype = np.dtype(stated.dtype)
    if dtype.kind in "iu" and array.dtype != dtype and array.size:
        limits, low, high = np.iinfo(dtype), array.min(), array.max()
        if low < limits.min or high > limits.max:
            fault = f"gave `{name}` with values from {low} to {high}, which are no {dtype.name}"
            raise wrong_result(entry, None, fault)
    return array.astype(dtype, copy=False)
