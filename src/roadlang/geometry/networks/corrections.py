"""A network that was found, corrected by hand: roads dismissed, drawn and confirmed."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from itertools import pairwise

import numpy as np

from ..arrays import Floats, norm
from ..batches.batch import CurveBatch
from ..batches.crossing import crossings
from ..curves.curve import Curve
from ..curves.waypoint_curve import through_waypoints
from ..errors import GeometryError
from .network import RoadNetwork
from .network_cutting import NetworkUnderChange
from .polylines import DEFAULT_WIDTH

REACH = 2.0
"""Widths of a road from its center line within which a point is on it."""
_SPACING = 0.5
"""Meters between the points at which crossings are looked for."""


@dataclass(frozen=True)
class Corrections:
    """What a human says of a network that was found; all points in meters.

    `drawn`: (n, 2) points of roads that are missing. `dismissed`: of a road that is none, one point
    (1, 2) for all of it from node to node, or two (2, 2) for the part between them. `confirmed`:
    (n, 2) points of roads that are right.
    """

    drawn: tuple[Floats, ...] = ()
    dismissed: tuple[Floats, ...] = ()
    confirmed: Floats = field(default_factory=lambda: np.zeros((0, 2)))

    @property
    def is_empty(self) -> bool:
        """Whether nothing is said."""
        return not (self.drawn or self.dismissed or len(self.confirmed))


@dataclass(frozen=True)
class Corrected:
    """`network`: with the corrections; `missed`: points of roads to dismiss or confirm where no
    road is near."""

    network: RoadNetwork
    missed: tuple[tuple[float, float], ...] = ()


def corrected(network: RoadNetwork, corrections: Corrections) -> Corrected:
    """The network with roads dismissed, then drawn, then confirmed.

    A road is the one nearest to a point, where this is within `REACH` widths. A drawn road is a
    curve through its points, as wide as the others are on average, and sure; it begins and ends at
    the node or road that is that near, and meets every road that it crosses. Two roads that are
    left at a junction become one where one goes on in the other. Raises GeometryError for points
    that are no curve.
    """
    lengths = np.array([edge.length for edge in network.edges])
    widths = [float(np.mean(edge.widths)) for edge in network.edges]
    width = float(np.average(widths, weights=lengths)) if widths else DEFAULT_WIDTH
    change, missed = NetworkUnderChange(network), []
    left: set[int] = set()
    for points in corrections.dismissed:
        nodes = _dismissed(change, points)
        left |= nodes
        missed += [] if nodes else [points[0]]
    for node in sorted(left):
        change.join(node)
    for points in corrections.drawn:
        _draw(change, points, width)
    for point in corrections.confirmed:
        found = change.nearest(point, REACH)
        if found is None:
            missed.append(point)
        else:
            change.edges[found[0]] = replace(change.edges[found[0]], confidence=1.0)
    return Corrected(change.network(), tuple((float(x), float(y)) for x, y in missed))


def _dismissed(change: NetworkUnderChange, points: Floats) -> set[int]:
    """The nodes at which a road ended that is gone now; none where no road is near."""
    found = change.nearest(points[0], REACH)
    if found is None:
        return set()
    id, start = found
    gone = [id]
    if len(points) > 1:
        edge = change.edges[id]
        start, stop = sorted((start, float(edge.curve.project(points[-1])[0])))
        around = edge.curve.closed and stop - start > edge.length / 2.0
        pieces = change.cut(id, (start, stop))
        middles = ((piece.id, (piece.start + piece.stop) / 2.0 % edge.length) for piece in pieces)
        gone = [id for id, middle in middles if (start < middle < stop) != around]
    edges = [change.edges.pop(id) for id in gone]
    return {node for edge in edges for node in (edge.start, edge.end)}


def _draw(change: NetworkUnderChange, points: Floats, width: float) -> None:
    line = np.array(points, dtype=np.float64)
    first = _node_near(change, line[0], REACH * width)
    is_ring = len(line) > 3 and norm(line[-1] - line[0]) <= REACH * width
    last = first if is_ring else _node_near(change, line[-1], REACH * width)
    line[0], line[-1] = change.nodes[first].position, change.nodes[last].position
    if first == last and not is_ring:
        raise GeometryError("both ends of a drawn road are at the same place")
    if is_ring:
        change.add(first, last, through_waypoints(line[:-1], closed=True), width)
        return
    met = _met(change, through_waypoints(line), width)
    places = [np.array(change.nodes[node].position) for node in met]
    curve = through_waypoints(_through(line, places, width))
    along = sorted(zip((float(curve.project(place)[0]) for place in places), met, strict=True))
    joints = [(0.0, first), *along, (curve.length, last)]
    for (start, node), (stop, other) in pairwise(joints):
        change.add(node, other, curve.between(start, stop), width)


def _node_near(change: NetworkUnderChange, point: Floats, reach: float) -> int:
    """The node, or new node on a road, that is this near; otherwise a new one there."""
    away = {
        node.id: float(norm(np.array(node.position) - point))
        for node in change.nodes.values()
        if change.ends_at(node.id)
    }
    near = min(away, key=lambda id: away[id], default=None)
    if near is not None and away[near] <= reach:
        return near
    found = change.nearest(point, REACH)
    return change.add_node(point) if found is None else change.split(*found)


def _met(change: NetworkUnderChange, curve: Curve, width: float) -> list[int]:
    """The nodes, in order, at which a drawn curve crosses other roads between its ends."""
    points = curve.at(curve.stations(spacing=_SPACING))
    found: list[int] = []
    steps = set()
    for edge in change.edges.values():
        other = edge.curve.at(edge.curve.stations(spacing=_SPACING))
        other = np.vstack([other, other[:1]]) if edge.curve.closed else other
        steps |= set(crossings(_batch(points), _batch(other))[1].tolist())
    for step in sorted(steps):
        place = (points[step] + points[step + 1]) / 2.0
        if min(norm(place - points[0]), norm(place - points[-1])) > REACH * width:
            node = _node_near(change, place, width)
            found += [node] if node not in found else []
    return found


def _batch(points: Floats) -> CurveBatch:
    return CurveBatch(np.arange(len(points), dtype=np.float64), points[None])


def _through(line: Floats, places: list[Floats], width: float) -> Floats:
    """The points of a line and, in order along it, these places instead of what is near them."""
    curve = through_waypoints(line)
    kept = [
        point
        for k, point in enumerate(line)
        if k in (0, len(line) - 1) or all(norm(point - place) > width for place in places)
    ]
    every = [*kept, *places]
    order = np.argsort([float(curve.project(point)[0]) for point in every], kind="stable")
    return np.array(every)[order]
