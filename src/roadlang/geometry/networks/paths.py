"""Ways through a road network: the longest simple one, the shortest between two points."""

from __future__ import annotations

import heapq
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from ..arrays import finite, norm
from ..curves.curve import Curve
from ..curves.filleting import chained
from ..curves.width import WidthProfile
from ..errors import GeometryError
from ..lanes.road import Road
from .network import Edge, RoadNetwork

SHARPEST_TURN = 2.0 * np.pi / 3.0
"""Radians: a road does not go on through a junction more sharply than this."""

ROUNDING = 5.0
"""Meters before and after a junction within which a path is rounded."""

_MOST_VISITS = 20_000


@dataclass(frozen=True, slots=True)
class Step:
    """Part of one edge: from arc length `start` of its curve to `stop`, meters; against the
    direction of the edge if `stop` is less."""

    edge: int
    start: float
    stop: float

    @property
    def length(self) -> float:
        """Arc length in meters."""
        return abs(self.stop - self.start)


@dataclass(frozen=True, eq=False)
class Path:
    """A way through a network: parts of its edges, `steps`, each beginning where the last one ends.

    Corners between them are rounded within `rounding` meters. The steps are not checked before
    `curve` is used, which raises GeometryError where they do not meet.
    """

    network: RoadNetwork
    steps: tuple[Step, ...]
    rounding: float = ROUNDING

    @property
    def edges(self) -> tuple[int, ...]:
        """Edge ids in order."""
        return tuple(step.edge for step in self.steps)

    @property
    def length(self) -> float:
        """Meters along the edges, before corners are rounded."""
        return sum(step.length for step in self.steps)

    @cached_property
    def curve(self) -> Curve:
        """One curve along the path: the edges themselves, with rounded corners between."""
        if self.is_loop:
            return self.network.edge(self.steps[0].edge).curve
        return chained([self._part(step) for step in self.steps], self.rounding)

    @cached_property
    def width(self) -> WidthProfile:
        """The edges' widths along `curve`, which rounded corners make a little shorter."""
        if self.is_loop:
            return self.network.edge(self.steps[0].edge).width
        stations, widths, traveled = [], [], 0.0
        for step in self.steps:
            along = np.linspace(0.0, step.length, max(2, int(step.length) + 1))
            source = step.start + np.sign(step.stop - step.start) * along
            # A hair inside, where the next step may begin with another width.
            inner = traveled + np.clip(along, 1e-6 * step.length, (1.0 - 1e-6) * step.length)
            stations.append(inner)
            widths.append(self.network.edge(step.edge).width.at(source))
            traveled += step.length
        shortened = self.curve.length / traveled
        return WidthProfile(np.concatenate(stations) * shortened, np.concatenate(widths))

    @property
    def is_loop(self) -> bool:
        """Whether the path is the whole of one closed curve."""
        if len(self.steps) != 1:
            return False
        edge = self.network.edge(self.steps[0].edge)
        return edge.curve.closed and self.steps[0].length >= edge.length

    def road(self, lanes: int = 2) -> Road:
        """The path as one road."""
        return Road(self.curve, self.width, lanes)

    def _part(self, step: Step) -> Curve:
        curve = self.network.edge(step.edge).curve
        if step.start <= step.stop:
            return curve.between(step.start, step.stop) if curve.closed else _cut(curve, step)
        low, high = step.stop, step.start
        return _cut(curve, Step(step.edge, low, high)).reversed()


def _cut(curve: Curve, step: Step) -> Curve:
    is_full = step.start <= 0.0 and step.stop >= curve.length and not curve.closed
    return curve if is_full else curve.between(step.start, step.stop)


def longest_path(network: RoadNetwork) -> Path:
    """The longest way that passes no node twice and turns nowhere sharper than `SHARPEST_TURN`.

    A closed road counts with its whole length. Finding it is NP-hard: the search is exact in
    networks of up to some twenty junctions and gives its best after 20,000 steps in larger ones,
    starting from dead ends. Ties go to the road that the network lists first.
    """
    if not network.edges:
        raise GeometryError("a network without roads has no longest road")
    best: tuple[float, tuple[Step, ...]] = (0.0, ())
    visits = iter(range(_MOST_VISITS))
    for node in sorted(network.nodes, key=lambda node: network.degree(node.id) != 1):
        for length, steps in _simple_paths(network, node.id, visits):
            if length > best[0] * (1.0 + 1e-9):
                best = length, steps
    for edge in network.edges:
        if edge.length > best[0] * (1.0 + 1e-9):
            best = edge.length, (Step(edge.id, 0.0, edge.length),)
    return Path(network, best[1])


def _simple_paths(
    network: RoadNetwork, origin: int, visits: Iterator[int]
) -> Iterator[tuple[float, tuple[Step, ...]]]:
    """Depth first, longest edge first, until `visits` run out."""
    waiting: list[tuple[int, float, tuple[Step, ...], frozenset[int]]] = [
        (origin, 0.0, (), frozenset([origin]))
    ]
    while waiting and next(visits, None) is not None:
        node, length, steps, passed = waiting.pop()
        yield length, steps
        onward = []
        for edge in network.edges_at(node):
            neighbor = edge.other(node)
            step = _along(edge, node)
            if neighbor in passed or (steps and _turn(network, steps[-1], step) > SHARPEST_TURN):
                continue
            onward.append((neighbor, length + edge.length, (*steps, step), passed | {neighbor}))
        waiting.extend(sorted(onward, key=lambda item: item[1]))


def _along(edge: Edge, origin: int) -> Step:
    """The whole of an edge, from the given end."""
    if origin == edge.start:
        return Step(edge.id, 0.0, edge.length)
    return Step(edge.id, edge.length, 0.0)


def _turn(network: RoadNetwork, before: Step, after: Step) -> float:
    """Radians between the end of one step and the start of the next, in [0, pi]."""
    first, second = network.edge(before.edge), network.edge(after.edge)
    forward, onward = before.stop > before.start, after.stop > after.start
    arriving, leaving = first.end_headings[forward], second.end_headings[not onward]
    turn = abs(arriving - leaving + (0.0 if forward == onward else np.pi)) % (2.0 * np.pi)
    return float(min(turn, 2.0 * np.pi - turn))


def shortest_path(network: RoadNetwork, p: ArrayLike, q: ArrayLike) -> Path:
    """Dijkstra's algorithm between the points of the network nearest to `p` and to `q`.

    Raises GeometryError when no road joins them or when they are one point.
    """
    origin, goal = nearest_place(network, p), nearest_place(network, q)
    candidates = list(_within_one_edge(network, origin, goal))
    through = _through_nodes(network, origin, goal)
    if through is not None:
        candidates.append(through)
    candidates = [[step for step in steps if step.length > 1e-9] for steps in candidates]
    if not candidates:
        raise GeometryError("no road of the network joins the two points")
    steps = min(candidates, key=lambda steps: sum(step.length for step in steps))
    if not steps:
        raise GeometryError("a route needs two places that differ")
    return Path(network, tuple(steps))


def nearest_place(network: RoadNetwork, point: ArrayLike) -> tuple[Edge, float]:
    """The edge nearest to a point (x, y), and the arc length there."""
    target = finite(point, "a point").reshape(-1)
    if target.shape != (2,):
        raise GeometryError("a point needs two coordinates (x, y)")
    if not network.edges:
        raise GeometryError("a network without roads has no routes")
    places: list[tuple[float, int, Edge, float]] = []
    for edge in network.edges:
        s = float(edge.curve.project(target)[0])
        gap = float(norm(edge.curve.at(s) - target))
        places.append((gap, len(places), edge, s))
    return min(places, key=lambda place: place[:2])[2:]


def _within_one_edge(
    network: RoadNetwork, origin: tuple[Edge, float], goal: tuple[Edge, float]
) -> Iterator[list[Step]]:
    if origin[0].id == goal[0].id:
        yield [Step(origin[0].id, origin[1], goal[1])]


def _through_nodes(
    network: RoadNetwork, origin: tuple[Edge, float], goal: tuple[Edge, float]
) -> list[Step] | None:
    """The shortest way that passes at least one node."""
    best: dict[int, tuple[float, list[Step]]] = {}
    waiting: list[tuple[float, int, int, list[Step]]] = []
    for count, first in enumerate(_to_ends(*origin)):
        heapq.heappush(waiting, (first[1].length, count, first[0], [first[1]]))
    pushed = len(waiting)
    while waiting:
        length, _, node, steps = heapq.heappop(waiting)
        if node in best:
            continue
        best[node] = length, steps
        for edge in network.edges_at(node):
            pushed += 1
            onward = [*steps, _along(edge, node)]
            heapq.heappush(waiting, (length + edge.length, pushed, edge.other(node), onward))
    ends = [
        (best[node][0] + step.length, [*best[node][1], Step(step.edge, step.stop, step.start)])
        for node, step in _to_ends(*goal)
        if node in best
    ]
    return min(ends, key=lambda end: end[0])[1] if ends else None


def _to_ends(edge: Edge, s: float) -> tuple[tuple[int, Step], tuple[int, Step]]:
    """From a place on an edge to both of its ends."""
    return (
        (edge.start, Step(edge.id, s, 0.0)),
        (edge.end, Step(edge.id, s, edge.length)),
    )
