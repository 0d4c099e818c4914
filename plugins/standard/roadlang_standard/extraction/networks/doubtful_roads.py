"""Remarks on roads, and stretches of roads, that the extractor is not sure of."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from roadlang.geometry import Booleans, Floats

from ..curves.smoothing import stations
from .found_network import FoundNetwork, FoundRoad

if TYPE_CHECKING:
    from roadlang.api import Picture

_DOUBTFUL, _STRETCH = 0.5, 30.0
"""Roads with a confidence below `_DOUBTFUL` are remarked on, and stretches of roads longer than
`_STRETCH` pixels."""
_MOST = 5


def doubts(found: FoundNetwork, picture: Picture) -> list[str]:
    """One line for each doubtful road or stretch of one, longest first, with its place in pixels of
    the file; at most five lines of them."""
    doubtful = [stretch for road in found.roads for stretch in _doubtful_stretches(road)]
    doubtful.sort(key=lambda stretch: -stretch[0])
    lines = []
    for length, place, sure, whole in doubtful[:_MOST]:
        what = "a road" if whole else "a stretch"
        long = length * picture.scale / picture.file_scale
        x, y = picture.to_file(place)
        lines.append(f"{what} of {long:.0f} px at ({x:.0f}px, {y:.0f}px) is only {sure:.0%} sure")
    if len(doubtful) > _MOST:
        lines.append(f"{len(doubtful) - _MOST} more roads are less than {_DOUBTFUL:.0%} sure")
    return lines


def _doubtful_stretches(road: FoundRoad) -> list[tuple[float, Floats, float, bool]]:
    """The length, the middle, and the confidence of what is doubtful, and whether that is the whole
    road; short stretches of one that is not are passed over."""
    whole = (road.length, road.points[len(road.points) // 2], road.confidence, True)
    if road.confidence < _DOUBTFUL:
        return [whole]
    if road.confidences is None:
        return []
    at = stations(road.points)
    stretches = []
    for first, last in _runs(road.confidences < _DOUBTFUL):
        length = float(at[last] - at[first])
        if length > max(_STRETCH, 2 * road.usual_width):
            sure = float(road.confidences[first : last + 1].mean())
            stretches.append((length, road.points[(first + last) // 2], sure, False))
    return stretches


def _runs(chosen: Booleans) -> list[tuple[int, int]]:
    """The first and the last index of each run of True."""
    edges = np.flatnonzero(np.diff(np.r_[False, chosen, False]))
    return [(int(first), int(last) - 1) for first, last in edges.reshape(-1, 2)]
