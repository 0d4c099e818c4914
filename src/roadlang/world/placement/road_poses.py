"""Where copies stand on one road: arc length, lane and offset to x, y and heading."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...evaluate.candidates import CandidateBatch
from ...evaluate.copies import CopyBatch
from ...evaluate.evaluation import evaluate
from ...evaluate.kind_instance import scalar
from ...geometry.arrays import Booleans, Floats, Integers
from ...ir.scenario import ScenarioActor
from ..roads.road_places import places_along
from .actor_numbers import number_of_copies
from .copies import element_of
from .lane_places import LaneOffsets, lane_places
from .spots import NoPlace

NO_ROAD = -1
"""The number of the road of what is on none, or on a declared one"""


@dataclass(frozen=True, eq=False)
class RoadPoses:
    """Arrays (R,) as in `PlacedBatch`, of the copies of a `CopyBatch`."""

    x: Floats
    y: Floats
    heading: Floats
    start: Floats
    offset: Floats
    lane: Integers
    backward: Booleans
    road: Integers
    """number of the road in its network, or `NO_ROAD`"""
    lacking: Floats
    """in a network: meters to the nearest lane that are too many; else 0"""
    width: Floats
    """meters across its heading"""
    missing_lane: Integers
    """the number of the lane that its road lacks, as another decides it; 0 where there is one"""
    no_place: Integers
    """see `NoPlace`"""


@dataclass(frozen=True, eq=False)
class LaneStart:
    """Where along a road, and in which lane, copies (R,) begin."""

    start: Floats
    lane: Integers
    """0 for none"""
    offset: Floats
    """left of the center line, meters, of those in no lane"""
    backward: Booleans
    """whether it faces against the road, where `is_directed`; others face as their lane runs"""
    is_directed: Booleans

    def take(self, index: NDArray[np.intp]) -> LaneStart:
        """That of some copies."""
        return LaneStart(*(getattr(self, field.name)[index] for field in fields(self)))

    def in_no_lane(self, which: Booleans) -> LaneStart:
        """With some of them (R,) in no lane, on the center line."""
        if not which.any():
            return self
        lane, offset = np.where(which, 0, self.lane), np.where(which, 0.0, self.offset)
        return replace(self, lane=lane, offset=offset)

    @classmethod
    def of(cls, start: Floats, lane: Integers) -> LaneStart:
        """In lanes, facing as they run."""
        no = np.zeros(len(start), dtype=bool)
        return cls(start, lane, np.zeros(len(start)), no, no)


@dataclass(frozen=True, eq=False)
class WrittenPlace:
    """The options of the placement as columns (R,): `heading` and `offset`; `side` and `facing`
    are words, "" where nothing is said."""

    heading: Floats
    offset: Floats
    side: NDArray[np.str_]
    facing: NDArray[np.str_]

    @classmethod
    def of(cls, actor: ScenarioActor, copies: CopyBatch) -> WrittenPlace:
        """What the statement says for its copies."""
        heading, offset = (
            number_of_copies(actor, name, copies, 0.0) for name in ("heading", "offset")
        )
        side, facing = (word_option(actor, name, copies) for name in ("side", "facing"))
        return cls(heading, offset, side, facing)

    def take(self, index: NDArray[np.intp]) -> WrittenPlace:
        """What is said of some copies."""
        return WrittenPlace(*(getattr(self, field.name)[index] for field in fields(self)))


def option_value(actor: ScenarioActor, name: str, copies: CopyBatch) -> Any:
    """An option for these copies, None where it is not written."""
    value = actor.options.get(name)
    return None if value is None else evaluate(value, copies, element_of(actor))


def word_option(actor: ScenarioActor, name: str, copies: CopyBatch) -> NDArray[np.str_]:
    """(R,) a word, "" where none is written."""
    value = option_value(actor, name, copies)
    if isinstance(value, np.ndarray):
        words = np.array([*map(str, value.reshape(-1).tolist())])
        return np.broadcast_to(words, (copies.count,))
    return np.full(copies.count, "" if value is None else str(scalar(value)))


def poses_on_road(
    name: str,
    actor: ScenarioActor,
    candidates: CandidateBatch,
    rows: NDArray[np.intp],
    begin: LaneStart,
    written: WrittenPlace,
    sizes: tuple[Floats, Floats],
) -> RoadPoses:
    """Where copies (R,) stand on a road, those at `rows` (R,) of the candidates; `sizes` are their
    lengths and widths, in meters; a width of NaN is that of the lane, or of the roadway.
    Raises RL613."""
    lengths, widths = sizes
    spans = np.isnan(widths)
    in_middle = spans & (written.side == "") & ("lane" not in actor.options)
    begin = begin.in_no_lane(in_middle)
    place = places_along(name, candidates, rows, begin.start)
    lanes = lane_places(name, actor, candidates, rows, place, begin.lane)
    missing_lane = np.where(lanes.missing, begin.lane, 0)
    begin = begin.in_no_lane(lanes.missing)
    if spans.any():
        widths = np.where(spans, lanes.width, widths)
        lanes = replace(lanes, middle=np.where(in_middle, lanes.roadway_middle, lanes.middle))
    across = _across(written.heading, lengths, widths)
    offset = _offsets(lanes, begin, written, across)
    backward = np.where(begin.is_directed, begin.backward, lanes.backward)
    backward = np.where(written.facing == "", backward, written.facing == "back")
    heading = place.heading + np.where(backward, math.pi, 0.0) + written.heading
    directions = place.heading.tolist()
    sine = np.array([math.sin(direction) for direction in directions])
    cosine = np.array([math.cos(direction) for direction in directions])
    return RoadPoses(
        place.x - offset * sine,
        place.y + offset * cosine,
        np.array([math.remainder(angle, 2 * math.pi) for angle in heading.tolist()]),
        begin.start,
        offset,
        begin.lane,
        backward,
        np.full(len(rows), NO_ROAD),
        np.zeros(len(rows)),
        widths,
        missing_lane,
        np.where(lanes.missing, NoPlace.NO_LANE, NoPlace.HAS_ONE),
    )


def _across(turned: Floats, lengths: Floats, widths: Floats) -> Floats:
    """(R,) meters that things take across the road, turned against it."""
    if not turned.any():
        return widths
    sine = np.array([abs(math.sin(angle)) for angle in turned.tolist()])
    cosine = np.array([abs(math.cos(angle)) for angle in turned.tolist()])
    return np.asarray(lengths * sine + widths * cosine)


def _offsets(lanes: LaneOffsets, begin: LaneStart, written: WrittenPlace, across: Floats) -> Floats:
    """(R,) meters left of the center line: from the line, a lane's middle, or outward from an edge.

    Beside the road it is the near side of the thing that stands `offset` from the edge.
    """
    beside, outward = begin.lane == 0, written.offset + across / 2
    found = lanes.middle + written.offset
    found = np.where(beside & (written.side == "left"), lanes.left + outward, found)
    found = np.where(beside & (written.side == "right"), lanes.right - outward, found)
    return found + np.where(beside, begin.offset, 0.0)
