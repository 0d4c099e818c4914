"""Junctions of SUMO: links between lanes, and which yields to which."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from roadlang.geometry import Floats, poses_along

from ..surfaces.built import is_loop
from .acyclic import without_circles
from .edges import GAP, SumoEdge, in_order, pairs_of_edges
from .lane_lines import TOLERANCE, simplified

if TYPE_CHECKING:
    from roadlang.api import SceneConnection, SceneJunction, SceneLaneEnd, SceneRoad

_LATERAL = 5.5
"""m/s^2 on turns, as netconvert has it."""
_STEP = 0.5
"""Meters between the points of a turn, before they are thinned."""
_TYPES = {
    "right_first": "right_before_left",
    "yield": "priority",
    "stop": "priority_stop",
    "all_way_stop": "allway_stop",
    "signals": "traffic_light",
}
_TURNS = {"left": "l", "straight": "s", "right": "r", "u": "t"}
_BY_TURN = {"straight": 0, "right": 1, "left": 2, "u": 3}
"""Who goes first where the scene does not say it."""
_FACE = 0.2
"""Meters that the area of a node without junction is deep."""


@dataclass(frozen=True)
class LaneLink:
    """From a lane of one edge to one of another, by their numbers; a line (n, 2), m and m/s."""

    source: SumoEdge
    source_lane: int
    target: SumoEdge
    target_lane: int
    turn: str
    line: Floats
    length: float
    speed: float
    connection: SceneConnection | None = None


@dataclass(frozen=True)
class SumoNode:
    """A node with its links in the order of their numbers. `yields` and `conflicts` are pairs of
    numbers: the first yields to the second."""

    id: str
    kind: str
    area: Floats
    incoming: tuple[SumoEdge, ...]
    links: tuple[LaneLink, ...]
    yields: frozenset[tuple[int, int]] = frozenset()
    conflicts: frozenset[tuple[int, int]] = frozenset()
    junction: SceneJunction | None = field(default=None, repr=False)

    def state(self, number: int) -> str:
        """Of a link, where no signal switches it."""
        waits = any(first == number for first, _ in self.yields)
        if self.kind == "traffic_light":
            return "o" if waits else "O"
        if self.kind == "allway_stop":
            return "w"
        if self.kind in ("right_before_left", "left_before_right"):
            return "=" if waits else "M"
        minor = () if self.junction is None else self.junction.control.minor
        if self.kind == "priority_stop" and self.links[number].source.road.name in minor:
            return "s"
        return "m" if waits else "M"


def junction_node(
    id: str, junction: SceneJunction, edges: Mapping[str, Sequence[SumoEdge]], left_hand: bool
) -> SumoNode:
    """Of a junction of the scene. `edges`: by road."""
    incoming = tuple(
        edge for arm in junction.arms for edge in edges.get(arm.road, ()) if edge.target == id
    )
    incoming = tuple({edge.id: edge for edge in incoming}.values())
    by_lane: dict[tuple[str, int], list[LaneLink]] = {}
    for connection in junction.connections:
        link = _link(connection, edges, id)
        if link is not None:
            by_lane.setdefault((link.source.id, link.source_lane), []).append(link)
    links = tuple(
        link
        for edge in incoming
        for lane in range(len(edge.lanes))
        for link in by_lane.get((edge.id, lane), ())
    )
    kind = _TYPES[junction.control.kind] if junction.kind == "junction" else "priority"
    if kind == "traffic_light" and junction.control.cycle <= 0.0:
        kind = "priority"
    if kind == "right_before_left" and left_hand:
        kind = "left_before_right"
    yields, conflicts = _right_of_way(junction, links)
    area = simplified(np.array(junction.area), TOLERANCE)
    return SumoNode(id, kind, area, incoming, links, yields, conflicts, junction)


def _link(
    connection: SceneConnection, edges: Mapping[str, Sequence[SumoEdge]], node: str
) -> LaneLink | None:
    source = _edge_at(edges.get(connection.source.road, ()), connection.source, node, leaves=False)
    target = _edge_at(edges.get(connection.target.road, ()), connection.target, node, leaves=True)
    if source is None or target is None:
        return None
    (from_edge, from_lane), (to_edge, to_lane) = source, target
    curvature = max((abs(piece[1]) for piece in connection.pieces), default=0.0)
    speed = (from_edge.lanes[from_lane].speed + to_edge.lanes[to_lane].speed) / 2.0
    if curvature > 0.0:
        speed = min(speed, float(np.sqrt(_LATERAL / curvature)))
    return LaneLink(
        from_edge,
        from_lane,
        to_edge,
        to_lane,
        _TURNS[connection.turn],
        _points(connection),
        max(connection.length, GAP),
        speed,
        connection,
    )


def _edge_at(
    edges: Sequence[SumoEdge], at: SceneLaneEnd, node: str, leaves: bool
) -> tuple[SumoEdge, int] | None:
    """The edge that ends (or begins) with a lane at an end of its road, and the lane's number."""
    for edge in edges:
        is_end = edge.forward != leaves
        if (edge.source if leaves else edge.target) != node:
            continue
        if is_end != (at.end == "end"):
            continue
        lane = edge.index(at.lane)
        if lane is not None:
            return edge, lane
    return None


def _points(connection: SceneConnection) -> Floats:
    pose = np.array(connection.start, dtype=np.float64)
    found = [pose[None, :2]]
    for length, curvature in connection.pieces:
        if length <= 0.0:
            continue
        at = np.linspace(0.0, length, max(2, int(np.ceil(length / _STEP)) + 1))
        poses = poses_along(pose, (curvature, curvature), at)
        found.append(poses[1:, :2])
        pose = poses[-1]
    return simplified(np.concatenate(found), TOLERANCE)


def _right_of_way(
    junction: SceneJunction, links: Sequence[LaneLink]
) -> tuple[frozenset[tuple[int, int]], frozenset[tuple[int, int]]]:
    """Yields and conflicts of links by their numbers; of a conflict at least one yields."""
    numbers = {
        link.connection.id: number
        for number, link in enumerate(links)
        if link.connection is not None
    }
    conflicts = {
        (numbers[found.a], numbers[found.b])
        for found in junction.conflicts
        if found.kind != "diverge" and found.a in numbers and found.b in numbers
    }
    for number, link in enumerate(links):
        for other, later in enumerate(links[number + 1 :], number + 1):
            is_one = link.source is later.source and link.source_lane == later.source_lane
            into_one = link.target is later.target and link.target_lane == later.target_lane
            if into_one and not is_one:
                conflicts.add((number, other))
    conflicts |= {(second, first) for first, second in conflicts}
    if junction.control.kind == "all_way_stop":
        return frozenset(conflicts), frozenset(conflicts)
    stated = {
        (numbers[first], numbers[second])
        for first, second in junction.yields
        if first in numbers and second in numbers
    }
    yields = {pair for pair in conflicts if pair in stated}
    for first, second in conflicts:
        if (first, second) not in yields and (second, first) not in yields:
            yields.add(max((first, second), (second, first), key=lambda pair: _rank(links, pair)))
    return frozenset(without_circles(yields, len(links))), frozenset(conflicts)


def _rank(links: Sequence[LaneLink], pair: tuple[int, int]) -> tuple[int, int]:
    """How much the first of a pair should yield to the second."""
    first, second = (links[number].connection for number in pair)
    turns = [0 if found is None else _BY_TURN[found.turn] for found in (first, second)]
    return turns[0] - turns[1], pair[0]


def nodes_between(road: SceneRoad, edges: Sequence[SumoEdge]) -> list[SumoNode]:
    """Where the edges of one road follow each other: lanes go on in themselves."""
    links: dict[str, list[LaneLink]] = {}
    incoming: dict[str, list[SumoEdge]] = {}
    for forward in (True, False):
        for one, other in pairs_of_edges(in_order(edges, forward), is_loop(road)):
            incoming.setdefault(one.target, []).append(one)
            for number, lane in enumerate(one.lanes):
                target = other.index(lane.id)
                if target is None:
                    continue
                line = np.array([lane.line[-1], other.lanes[target].line[0]])
                speed = min(lane.speed, other.lanes[target].speed)
                link = LaneLink(one, number, other, target, "s", line, GAP, speed)
                links.setdefault(one.target, []).append(link)
    return [
        SumoNode(id, "priority", _face(edges_here), tuple(edges_here), tuple(links.get(id, ())))
        for id, edges_here in incoming.items()
    ]


def dead_end(id: str, edges: Sequence[SumoEdge]) -> SumoNode | None:
    """Where a road ends alone; None where no edge does."""
    here = [edge for edge in edges if id in (edge.source, edge.target)]
    if not here:
        return None
    incoming = tuple(edge for edge in here if edge.target == id)
    return SumoNode(id, "dead_end", _face(here, id), incoming, ())


def _face(edges: Sequence[SumoEdge], id: str = "") -> Floats:
    """(4, 2) a narrow strip across the ends of edges."""
    ends, along = [], np.zeros(2)
    for edge in edges:
        leaves = bool(id) and edge.source == id
        for lane in edge.lanes:
            first, last = (lane.line[0], lane.line[1]) if leaves else (lane.line[-1], lane.line[-2])
            direction = (first - last) / max(float(np.hypot(*(first - last))), 1e-9)
            normal = np.array([-direction[1], direction[0]])
            ends += [first + 0.5 * lane.width * normal, first - 0.5 * lane.width * normal]
            along = direction
    points = np.array(ends)
    across = np.array([-along[1], along[0]])
    offsets = (points - points[0]) @ across
    low, high = points[int(offsets.argmin())], points[int(offsets.argmax())]
    return np.array([low, high, high + _FACE * along, low + _FACE * along])
