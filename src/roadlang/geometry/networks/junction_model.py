"""What a plan of junctions holds. Meters, radians, 1/m; heading counter-clockwise from east."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal, TypeAlias

Point: TypeAlias = tuple[float, float]
End: TypeAlias = Literal["start", "end"]
Turn: TypeAlias = Literal["left", "straight", "right", "u"]
NO_JUNCTION = -1
"""The junction of what is beyond all of them"""


@dataclass(frozen=True, slots=True)
class Arm:
    """One end of a road that enters a junction: the road begins `trim` meters from its node.

    `left` and `right` are the indices in the ring of the area of the two corners of the face where
    the road begins, as seen from the junction along the road.
    """

    edge: int
    end: End
    trim: float
    left: int
    right: int


@dataclass(frozen=True, slots=True)
class LaneEnd:
    """A lane of a road at one of the road's ends. Lane ids are those of the cross-section."""

    edge: int
    end: End
    lane: int


@dataclass(frozen=True, slots=True)
class Connection:
    """The curve from the middle of one lane to the middle of another, made of lines and arcs."""

    id: int
    source: LaneEnd
    target: LaneEnd
    turn: Turn
    start: tuple[float, float, float]
    """x, y and heading where the source lane ends"""
    pieces: tuple[tuple[float, float], ...]
    """(length, curvature) in order; curvature is positive to the left"""
    widths: tuple[float, float]
    """of the lanes that it leaves and enters; linear between"""
    stop_line: tuple[Point, Point]
    """across the source lane, from its left to its right border"""

    @property
    def length(self) -> float:
        """Meters."""
        return sum(length for length, _ in self.pieces)

    @property
    def curvature(self) -> float:
        """The greatest curvature, 1/m, unsigned."""
        return max(abs(curvature) for _, curvature in self.pieces)


@dataclass(frozen=True, slots=True)
class Conflict:
    """Two connections on which vehicles can meet, by the arc lengths along each of them.

    `cross` and `merge` (into one lane) are conflicts; of `diverge` (out of one lane) the vehicle
    behind follows the one ahead.
    """

    a: int
    b: int
    kind: Literal["cross", "merge", "diverge"]
    interval_a: tuple[float, float]
    interval_b: tuple[float, float]


@dataclass(frozen=True, slots=True)
class Refusal:
    """A turn that no vehicle can drive, and why."""

    source: LaneEnd
    target: LaneEnd
    turn: Turn
    angle: float
    """change of heading, radians, left positive"""
    reason: str


@dataclass(frozen=True, slots=True)
class Junction:
    """A place where roads meet. `id` is that of its first node."""

    id: int
    nodes: tuple[int, ...]
    kind: Literal["junction", "roundabout", "joint"]
    area: tuple[Point, ...]
    """the ring of its surface, counter-clockwise, first point not repeated"""
    arms: tuple[Arm, ...]
    """counter-clockwise"""
    connections: tuple[Connection, ...]
    conflicts: tuple[Conflict, ...]
    yields: tuple[tuple[int, int], ...]
    """pairs (a, b) of connection ids: a yields to b, where nothing else is said (right first; at a
    roundabout what enters yields)"""
    refused: tuple[Refusal, ...] = ()
    inside: tuple[int, ...] = ()
    """the roads that lie wholly within its area"""
    left_hand: bool = False
    """traffic keeps left"""


@dataclass(frozen=True, slots=True)
class Problem:
    """What could not be built. `edges` are the roads, `amount` is in meters.

    `refused`: turns of up to 150 degrees between the two roads; `overlap`: the surfaces of two
    roads overlap outside the junction, over `amount`, or where there is none (`junction` -1);
    `vanished`: a dead end lies wholly within a junction; `sweep`: vehicles that turn would drive
    over a third road; `outside`: a connection leaves the area by `amount`; `stuck`: a lane of the
    road leads into no other road; `level`: one of the two roads passes above the other.
    """

    kind: Literal["refused", "overlap", "vanished", "sweep", "outside", "stuck", "level"]
    junction: int
    edges: tuple[int, ...]
    amount: float = 0.0


@dataclass(frozen=True, slots=True)
class JunctionPlan:
    """All junctions of a network. `trims` are those of every edge: at its start, at its end.

    `ring` are the roads of roundabouts: True where traffic runs from start to end, False against.
    """

    junctions: tuple[Junction, ...] = ()
    trims: Mapping[int, tuple[float, float]] = field(default_factory=dict)
    problems: tuple[Problem, ...] = ()
    ring: Mapping[int, bool] = field(default_factory=dict)
