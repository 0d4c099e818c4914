"""Where the lanes of a road are beside the places of copies."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..diagnostics import DiagnosticError
from ..evaluate.copies import CopyBatch
from ..ir.scenario import ScenarioActor
from .cross_sections import LaneBatch
from .placement_faults import unknown_lane
from .road_lanes import lane_parts
from .road_places import RoadPlaces

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]


@dataclass(frozen=True, eq=False)
class LanePlaces:
    """Arrays (R,): offsets from the center line, left positive, in meters."""

    left: Floats
    """the left edge of the road, with all its lanes"""
    right: Floats
    """its right edge"""
    middle: Floats
    """the middle of the lane of each copy; 0 for lane 0"""
    backward: NDArray[np.bool_]
    """whether traffic in that lane runs against the road"""


def lane_places(
    actor: ScenarioActor, copies: CopyBatch, place: RoadPlaces, lane: Integers
) -> LanePlaces:
    """The lanes at the places (R,) of copies that are in `lane` (R,), 0 of none. Raises RL613."""
    assert actor.on is not None
    count = copies.count
    left, right, middle = np.zeros((3, count))
    backward = np.zeros(count, dtype=bool)
    for rows, lanes in lane_parts(actor.on, copies.candidates):
        chosen = np.flatnonzero(np.isin(copies.rows, rows))
        part = lanes.take(np.searchsorted(rows, copies.rows[chosen]))
        width, station = place.width[chosen, None], place.station[chosen, None]
        borders = part.border_offsets(width, station)[..., 0]
        left[chosen], right[chosen] = borders[0], borders[-1]
        for id in np.unique(lane[chosen]).tolist():
            if id != 0:
                within = lane[chosen] == id
                index = _place_of(actor, lanes, id)
                middle[chosen[within]] = (borders[index] + borders[index + 1])[within] / 2.0
                backward[chosen[within]] = lanes.pattern.lanes[index].direction == "backward"
    return LanePlaces(left, right, middle, backward)


def _place_of(actor: ScenarioActor, lanes: LaneBatch, id: int) -> int:
    ids = lanes.pattern.ids
    fault = unknown_lane(actor, id, ids)
    if fault is not None:
        raise DiagnosticError(fault)
    return ids.index(id)
