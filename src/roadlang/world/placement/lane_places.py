"""Where the lanes of a road are beside the places of copies."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...diagnostics import Code, Diagnostic, DiagnosticError, diagnose
from ...evaluate.candidates import CandidateBatch
from ...evaluate.copies import CopyBatch
from ...geometry import CrossSection
from ...geometry.arrays import Floats, Integers
from ...ir.scenario import ScenarioActor
from ..lanes.cross_sections import LaneBatch
from ..placement_faults import unknown_lane
from ..roads.named_roads import named_lanes
from ..roads.road_places import RoadPlaces
from .relative_lanes import may_be_missing
from .usual_lanes import ON_FOOT, lanes_on_foot


@dataclass(frozen=True, eq=False)
class LaneOffsets:
    """Arrays (R,): offsets from the center line, left positive, in meters."""

    left: Floats
    """the left edge of the road, with all its lanes"""
    right: Floats
    """its right edge"""
    middle: Floats
    """the middle of the lane of each copy; 0 for lane 0"""
    backward: NDArray[np.bool_]
    """whether traffic in that lane runs against the road"""
    roadway_middle: Floats
    """the middle of the roadway"""
    width: Floats
    """of the lane of each copy; for lane 0 of the roadway, from curb to curb"""
    missing: NDArray[np.bool_]
    """whether the road lacks the lane of a copy, which another decides; it counts as lane 0"""


def lane_places(
    name: str,
    actor: ScenarioActor,
    candidates: CandidateBatch,
    which: NDArray[np.intp],
    place: RoadPlaces,
    lane: Integers,
) -> LaneOffsets:
    """The lanes of a road at the places (R,) of copies of the candidates at `which` (R,) that are
    in `lane` (R,), 0 of none. Raises RL613 for one that the file itself names."""
    count = len(which)
    left, right, middle, roadway_middle, across = np.zeros((5, count))
    backward, missing = np.zeros((2, count), dtype=bool)
    may_lack = may_be_missing(actor, candidates.scenario)
    for rows, lanes in named_lanes(name, candidates):
        chosen = np.flatnonzero(np.isin(which, rows))
        part = lanes.take(np.searchsorted(rows, which[chosen]))
        width, station = place.width[chosen, None], place.station[chosen, None]
        borders = part.border_offsets(width, station)[..., 0]
        left[chosen], right[chosen] = borders[0], borders[-1]
        first, last = part.roadway_borders
        roadway_middle[chosen] = (borders[first] + borders[last]) / 2.0
        across[chosen] = borders[first] - borders[last]
        for id in np.unique(lane[chosen]).tolist():
            within = lane[chosen] == id
            if id != 0 and may_lack and id not in lanes.pattern.ids:
                missing[chosen[within]] = True
            elif id != 0:
                index = _place_of(actor, lanes, id)
                middle[chosen[within]] = (borders[index] + borders[index + 1])[within] / 2.0
                across[chosen[within]] = (borders[index] - borders[index + 1])[within]
                backward[chosen[within]] = lanes.pattern.runs_backward(id)
    return LaneOffsets(left, right, middle, backward, roadway_middle, across, missing)


def lanes_by_word(
    name: str,
    actor: ScenarioActor,
    copies: CopyBatch,
    word: str,
    against: NDArray[np.bool_],
    sides: NDArray[np.str_],
) -> Integers:
    """(R,) ids of the lanes that a word names, for copies that travel along the road or `against`
    it: `first`, the one next to the middle, `outer`, the outermost for vehicles, or a kind of lane,
    on the side that traffic keeps, or on the one of `sides` (R,), "" for either. Raises RL613 where
    the road has none."""
    found = np.zeros(copies.count, np.int64)
    default_kind = copies.scenario.registry.default("lane").name
    for rows, lanes in named_lanes(name, copies.candidates):
        in_lanes = np.isin(copies.rows, rows)
        for side in np.unique(sides[in_lanes]).tolist():
            for backward in (False, True):
                chosen = in_lanes & (against == backward) & (sides == side)
                if chosen.any():
                    section = lanes.pattern
                    found[chosen] = (
                        _lane_on_side(actor, section, word, side)
                        if side
                        else _named_lane(actor, section, word, backward, default_kind)
                    )
    return found


def _named_lane(
    actor: ScenarioActor, section: CrossSection, word: str, against: bool, default_kind: str
) -> int:
    directed = section.driving_ids("backward" if against else "forward")
    driving = directed or section.driving_ids()
    on_foot = lanes_on_foot(section) if word == ON_FOOT else []
    if word == "first" or (word == ON_FOOT and not on_foot):
        of_default_kind = [id for id in driving if section.lane(id).kind == default_kind]
        return next(iter((*of_default_kind, *driving, *section.ids)))
    if word == "outer":
        return (driving or section.ids)[-1]
    of_kind = on_foot or [lane.id for lane in section.lanes if lane.kind == word]
    # The side of a one-way road's other direction has no driving lane: it is the other side.
    right = (driving[0] < 0) != (against and not directed) if driving else not against
    nearest = sorted(of_kind, key=lambda id: ((id < 0) != right, abs(id)))
    if not nearest:
        raise DiagnosticError(no_lane_of_kind(actor, word, section))
    return nearest[0]


def _lane_on_side(actor: ScenarioActor, section: CrossSection, word: str, side: str) -> int:
    ids = [id for id in section.ids if is_on_side(id, side)]
    if word == "outer":
        found = max((id for id in ids if section.lane(id).drivable), key=abs, default=0)
    else:
        found = min((id for id in ids if section.lane(id).kind == word), key=abs, default=0)
    if not found:
        raise DiagnosticError(no_lane_of_kind(actor, word, section))
    return found


def is_on_side(lane: int, side: str) -> bool:
    """Whether a lane lies to the `left` or `right` of the center line; "" stands for either."""
    return side == "" or (lane > 0) == (side == "left")


def no_lane_of_kind(actor: ScenarioActor, word: str, section: CrossSection) -> Diagnostic:
    """RL613, of a road without a lane of some kind."""
    lanes = ", ".join(f"{lane.id} ({lane.kind})" for lane in section.lanes)
    help_ = f"its lanes are {lanes}"
    span, lane = actor.span_of("lane"), f"`{word}`"
    return diagnose(Code.UNKNOWN_LANE, span, road=actor.on, lane=lane, help=help_)


def _place_of(actor: ScenarioActor, lanes: LaneBatch, id: int) -> int:
    ids = lanes.pattern.ids
    fault = unknown_lane(actor, id, ids)
    if fault is not None:
        raise DiagnosticError(fault)
    return ids.index(id)
