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

_REAL = "fiub"
"""Kinds of numpy types: floating point, signed and unsigned integers, Boolean"""


def real_numbers(found: Any, what: str, entry: KindEntry, span: Span | None) -> NDArray[np.float64]:
    """What a kind returned as its `what`, an array of any shape.

    Raises RL474 for complex numbers, whose imaginary parts would be lost, for texts and objects.
    """
    import numpy as np

    if type(found) is np.ndarray:  # of which no code of a plugin runs
        array = found
    else:
        with plugin_guard(entry, span):
            array = np.asarray(found)
    if array.dtype.kind not in _REAL:
        kind = "complex numbers" if array.dtype.kind == "c" else f"of type {array.dtype}"
        raise wrong_result(entry, span, f"gave {what} that are {kind}, not real numbers")
    return array.astype(np.float64, copy=False)


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
