"""Positions by another agent or object: `ahead_of(ego, 20m)`, `behind(ego, 15m)`,
`beside(ego, left)`; and in a network: `junction(3)`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from roadlang.api import (
    AgentOrObject,
    Integer,
    Length,
    Point,
    Position,
    Standing,
    Word,
    geometry,
    option,
)

if TYPE_CHECKING:
    from roadlang.geometry import Floats


def _along(other: Any, length: Floats, gap: Floats | float, ahead: bool) -> Standing:
    """In the lane of the other, `gap` meters between the two bumpers."""
    import numpy as np

    away = gap + (other.length + length) / 2
    forward = np.where(other.backward, -1.0, 1.0) * (1.0 if ahead else -1.0)
    return Standing(other.start + forward * away, other.lane, other.offset, other.backward)


@dataclass(frozen=True)
class AheadOf(Position):
    """In front of an agent or object, in its lane."""

    name: ClassVar[str] = "ahead_of"
    other: AgentOrObject = option(help="agent or object on a road")
    distance: Length = option(minimum=0, help="from its front to the rear of what is placed")

    def place(self, length: Floats, width: Floats) -> Standing:
        """Ahead in the direction that the other faces."""
        return _along(self.other, length, self.distance, ahead=True)


@dataclass(frozen=True)
class Behind(Position):
    """Behind an agent or object, in its lane."""

    name: ClassVar[str] = "behind"
    other: AgentOrObject = option(help="agent or object on a road")
    distance: Length = option(minimum=0, help="from its rear to the front of what is placed")

    def place(self, length: Floats, width: Floats) -> Standing:
        """Behind in the direction that the other faces."""
        return _along(self.other, length, self.distance, ahead=False)


@dataclass(frozen=True)
class Beside(Position):
    """Next to an agent or object: in the next lane, or where it is in no lane, side by side."""

    name: ClassVar[str] = "beside"
    other: AgentOrObject = option(help="agent or object on a road")
    side: Word = option(words=("left", "right"), help="as seen by the other", example="left")
    gap: Length = option(1.0, minimum=0, help="gap between the two, if the other is in no lane")

    def place(self, length: Floats, width: Floats) -> Standing:
        """At the same arc length; `lane` counts on over the middle, which has no number."""
        import numpy as np

        left = np.asarray(self.side == "left") != self.other.backward
        step = np.where(left, 1, -1)
        lane = self.other.lane + step
        lane = np.where(lane == 0, step, lane)
        away = (self.other.width + width) / 2 + self.gap
        offset = self.other.offset + np.where(left, away, -away)
        is_in_lane = self.other.lane != 0
        lane = np.where(is_in_lane, lane, 0)
        return Standing(self.other.start, lane, offset, self.other.backward)


@dataclass(frozen=True)
class AtJunction(Position):
    """Before a junction of the network: in a lane that leads into it, at its stop line."""

    name: ClassVar[str] = "junction"
    id: Integer = option(
        None, minimum=0, help="id of the junction, where there are several", example="3"
    )
    near: Point = option(
        None, help="or a point: the junction that is nearest to it", example="(120m, 75m)"
    )
    road: Integer = option(None, minimum=0, help="id of the road; by default any that leads there")
    before: Length = option(0.0, minimum=0, help="how far before the stop line")
    roads: tuple[int, ...] | None = option(
        None, minimum=0, help="or the ids of roads: the junction where they meet", example="[3, 7]"
    )

    def lane_places(self, lanes: geometry.LaneGraph) -> list[geometry.RoutePlace]:
        """One in each lane, as far before its end as the lane is long enough."""
        known = sorted({turn.junction for out in lanes.turns for turn in out} - {-1})
        id: int | None = self.id
        if self.roads is not None:
            id = _junction_of_roads(lanes, tuple(map(int, self.roads)))
        elif self.near is not None:
            id = _nearest_junction(lanes, self.near)
        elif id is None and len(known) == 1:
            id = known[0]
        turns = enumerate(lanes.turns)
        leading = [lane for lane, out in turns if any(turn.junction == id for turn in out)]
        if not leading:
            if not known:
                raise geometry.GeometryError("the network has no junction that a lane leads to")
            names = ", ".join(map(str, known))
            fault = (
                f"no lane leads to junction {id}"
                if id is not None
                else "it needs `id`, `near` or `roads`"
            )
            raise geometry.GeometryError(f"{fault}; the ids of the junctions are: {names}")
        chosen = [lane for lane in leading if self.road in (None, lanes.lanes[lane].edge)]
        if not chosen:
            roads = ", ".join(map(str, sorted({lanes.lanes[lane].edge for lane in leading})))
            raise geometry.GeometryError(
                f"road {self.road} does not lead into junction {id}; its roads are {roads}"
            )
        return [_before(lanes, lane, self.before) for lane in chosen]


def _junction_of_roads(lanes: geometry.LaneGraph, roads: tuple[int, ...]) -> int:
    """The junction at which roads meet. Raises GeometryError where there is none, or several."""
    meeting: dict[int, set[int]] = {}
    for lane, out in enumerate(lanes.turns):
        for turn in out:
            ends = lanes.lanes[lane].edge, lanes.lanes[turn.target].edge
            meeting.setdefault(turn.junction, set()).update(ends)
    found = sorted(id for id, edges in meeting.items() if id >= 0 and edges.issuperset(roads))
    names = " and ".join(map(str, roads))
    if not found:
        known = "; ".join(
            f"{id}: {', '.join(map(str, sorted(edges)))}"
            for id, edges in sorted(meeting.items())
            if id >= 0
        )
        raise geometry.GeometryError(
            f"the roads {names} do not meet; the junctions and their roads are {known or 'none'}"
        )
    if len(found) > 1:
        ids = ", ".join(map(str, found))
        raise geometry.GeometryError(f"the roads {names} meet at several junctions: {ids}")
    return found[0]


def _nearest_junction(lanes: geometry.LaneGraph, point: tuple[float, float]) -> int | None:
    """The junction before which some lane ends nearest to a point; None where there is none."""
    import numpy as np

    found: dict[int, float] = {}
    for lane, out in enumerate(lanes.turns):
        at = lanes.edges[lanes.lanes[lane].edge].curve.at
        away = float(np.hypot(*(at(lanes.end[lane]) - np.asarray(point))))
        for turn in out:
            if turn.junction >= 0:
                found[turn.junction] = min(away, found.get(turn.junction, away))
    return min(found, key=lambda id: (found[id], id), default=None)


def _before(lanes: geometry.LaneGraph, lane: int, distance: float) -> geometry.RoutePlace:
    length, end = lanes.length(lane), lanes.end[lane]
    away = min(distance, length)
    too_short = max(distance + geometry.ROOM_TO_BEGIN - length, 0.0)
    return geometry.RoutePlace(lane, end - away if lanes.forward(lane) else end + away, too_short)
