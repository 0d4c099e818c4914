"""What kinds return, as arrays of numbers, or the diagnostic that describes what they are
instead."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ..diagnostics import Span
from .guard import plugin_guard, wrong_result
from .registry import KindEntry

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

REAL = "fiub"
"""Kinds of numpy types: floating point, signed and unsigned integers, Boolean"""
_KINDS = {"c": "complex numbers", "U": "text", "S": "bytes", "M": "dates", "m": "spans of time"}
"""Other kinds of numpy types, for people."""


def real_numbers(found: Any, what: str, entry: KindEntry, span: Span | None) -> NDArray[np.float64]:
    """What a kind returned as its `what`, an array of any shape.

    Raises RL474 for complex numbers, whose imaginary parts would be lost, for texts and objects.
    """
    return _as_real(_as_array(found, entry, span), what, entry, span)


def robustness_values(found: Any, entry: KindEntry, span: Span | None) -> NDArray[np.float64]:
    """What a monitor returned, an array of any shape.

    Raises RL474 for what `real_numbers` refuses, for NaN, and for True and False: as the numbers 1
    and 0 both would say that the monitor is satisfied.
    """
    import numpy as np

    array = _as_array(found, entry, span)
    if array.dtype.kind == "b":
        fault = "gave robustness as True or False, not as a number that is negative where violated"
        raise wrong_result(entry, span, fault)
    rho = _as_real(array, "robustness", entry, span)
    if np.isnan(rho).any():
        raise wrong_result(entry, span, "gave a robustness that is not a number")
    return rho


def _as_array(found: Any, entry: KindEntry, span: Span | None) -> NDArray[Any]:
    import numpy as np

    if type(found) is np.ndarray:  # of which no code of a plugin runs
        return found
    with plugin_guard(entry, span):
        return np.asarray(found)


def _as_real(
    array: NDArray[Any], what: str, entry: KindEntry, span: Span | None
) -> NDArray[np.float64]:
    import numpy as np

    if array.dtype.kind not in REAL:
        fault = f"gave {what} as {_described(array)}, not as real numbers"
        raise wrong_result(entry, span, fault)
    return array.astype(np.float64, copy=False)


def _described(array: NDArray[Any]) -> str:
    """What an array of no real numbers holds, for people."""
    if array.dtype.kind != "O":
        return _KINDS.get(array.dtype.kind, f"values of type {array.dtype}")
    items = sorted(array.flat, key=lambda item: isinstance(item, int | float))
    if not items or items[0] is None:
        return "None" if items else "nothing"
    return f"objects of type {type(items[0]).__name__}"


def check_extraction(found: Any, entry: KindEntry, span: Span | None) -> None:
    """Raises RL474 where an extractor returned anything but an extraction with its parts."""
    from ..geometry import RoadNetwork
    from ..ir.picture import Extraction, FoundObject

    if not isinstance(found, Extraction):
        raise wrong_result(entry, span, f"gave a {type(found).__name__}, not an Extraction")
    if not isinstance(found.network, RoadNetwork):
        what = type(found.network).__name__
        raise wrong_result(entry, span, f"gave an extraction of a {what}, not of a RoadNetwork")
    if not all(isinstance(found_object, FoundObject) for found_object in found.objects):
        raise wrong_result(entry, span, "gave objects that are not FoundObjects")
    if not isinstance(found.confidence, int | float) or not 0.0 <= found.confidence <= 1.0:
        fault = f"gave the confidence {found.confidence!r}, which is not within [0, 1]"
        raise wrong_result(entry, span, fault)
