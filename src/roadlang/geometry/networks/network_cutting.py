"""Networks while they are changed: roads are cut at new nodes, added, and joined."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..arrays import Floats, norm
from ..curves.curve import Curve
from .edge_parts import EdgePart
from .network import WIDTHS, Edge, Node, RoadNetwork

_STRAIGHT = np.radians(60.0)
"""Roads that go on in one another are joined where they turn by less."""
_APART = 1e-3
"""Meters between places of one road at which it is cut."""


@dataclass(frozen=True)
class CutPart:
    """A road that was a part of another, from `start` to `stop` meters along that one; of a loop
    `stop` may lie beyond its seam."""

    id: int
    start: float
    stop: float


class NetworkUnderChange:
    """The roads of a network without stated junctions, by their ids."""

    def __init__(self, network: RoadNetwork) -> None:
        self._origin = network.origin
        self.nodes = {node.id: node for node in network.nodes}
        self.edges = {edge.id: edge for edge in network.edges}

    def network(self) -> RoadNetwork:
        """What it is now, without nodes at which no road ends."""
        nodes = tuple(node for node in self.nodes.values() if self.ends_at(node.id))
        return RoadNetwork(nodes, tuple(self.edges.values()), self._origin)

    def ends_at(self, node: int) -> list[int]:
        """The ids of the roads that end at a node, that of a loop twice."""
        ends = ((edge.id, end) for edge in self.edges.values() for end in (edge.start, edge.end))
        return [id for id, end in ends if end == node]

    def nearest(self, point: Floats, widths: float) -> tuple[int, float] | None:
        """The road nearest to a point, and where, meters along it; None where none is as near as so
        many of its widths."""
        best: tuple[float, int, float] | None = None
        for edge in self.edges.values():
            s = float(edge.curve.project(point)[0])
            away = float(norm(edge.curve.at(s) - point))
            if away <= widths * float(edge.width.at(s)) and (best is None or away < best[0]):
                best = (away, edge.id, s)
        return None if best is None else best[1:]

    def add(self, start: int, end: int, curve: Curve, width: float) -> int:
        """The id of a new road, which is sure."""
        id = max(self.edges, default=0) + 1
        self.edges[id] = Edge(id, start, end, curve, np.array([width]))
        return id

    def add_node(self, point: Floats) -> int:
        """The id of a new node."""
        id = max(self.nodes, default=0) + 1
        self.nodes[id] = Node(id, (float(point[0]), float(point[1])))
        return id

    def split(self, id: int, s: float) -> int:
        """The node at this place of a road, or that at its end if this is nearer than its width."""
        pieces = self.cut(id, (s,))
        ends = [(abs(piece.start - s), self.edges[piece.id].start) for piece in pieces]
        ends += [(abs(piece.stop - s), self.edges[piece.id].end) for piece in pieces]
        return min(ends)[1]

    def cut(self, id: int, places: Sequence[float]) -> list[CutPart]:
        """The parts of a road between these places, meters along it, but for those nearer to its
        ends than its width. The first keeps the id."""
        edge = self.edges[id]
        is_ring = edge.curve.closed and len(self.ends_at(edge.start)) == 2
        bounds = _ring_bounds(edge, places) if is_ring else _bounds(edge, places)
        if len(bounds) == 2:
            return [CutPart(id, *bounds)]
        inner = [self.add_node(edge.curve.at(s % edge.length)) for s in bounds[1:-1]]
        first = self.add_node(edge.curve.at(bounds[0])) if is_ring else edge.start
        nodes = [first, *inner, first if is_ring else edge.end]
        ids = [id, *range(max(self.edges) + 1, max(self.edges) + len(bounds) - 1)]
        pieces = [CutPart(*each) for each in zip(ids, bounds[:-1], bounds[1:], strict=True)]
        for piece, start, end in zip(pieces, nodes[:-1], nodes[1:], strict=True):
            part = EdgePart(edge, piece.start, piece.stop).cut()
            self.edges[piece.id] = replace(part, id=piece.id, start=start, end=end)
        return pieces

    def remove(self, id: int) -> None:
        """Take a road away; what is left of its nodes stays as it is."""
        del self.edges[id]

    def join(self, node: int) -> None:
        """Make one road of the two that are left at a node, if one goes on in the other."""
        ends = self.ends_at(node)
        if len(ends) != 2 or ends[0] == ends[1]:
            return
        before, after = (self.edges[id] for id in ends)
        before = before if before.end == node else _reversed(before)
        after = after if after.start == node else _reversed(after)
        turn = math.remainder(after.end_headings[0] - before.end_headings[1], math.tau)
        if abs(turn) > _STRAIGHT:
            return
        del self.edges[after.id]
        self.edges[before.id] = _joined(before, after)


def _bounds(edge: Edge, places: Sequence[float]) -> list[float]:
    """Where the parts of a road begin and end; of a loop that meets others, from its seam."""
    kept = [0.0]
    for s in sorted(places):
        least = float(edge.width.at(s))
        if least < s < edge.length - least and s - kept[-1] > _APART:
            kept.append(s)
    return [*kept, edge.length]


def _ring_bounds(edge: Edge, places: Sequence[float]) -> list[float]:
    """Of a loop that meets no other road: round its seam, and so that no part is a loop."""
    kept = sorted({s % edge.length for s in places})
    kept = [s for k, s in enumerate(kept) if k == 0 or s - kept[k - 1] > _APART]
    if not kept:
        return [0.0, edge.length]
    if len(kept) == 1:
        kept.append(kept[0] + edge.length / 2.0)
    return [*kept, kept[0] + edge.length]


def _reversed(edge: Edge) -> Edge:
    forward = None if edge.forward is None else not edge.forward
    widths = edge.width.at(np.linspace(edge.length, 0.0, WIDTHS))
    return replace(
        edge,
        start=edge.end,
        end=edge.start,
        curve=edge.curve.reversed(),
        widths=widths,
        forward=forward,
    )


def _joined(before: Edge, after: Edge) -> Edge:
    """Two roads as one with the id of the first, smooth where they meet."""
    step = max(1.0, 0.5 * float(before.width.at(before.length)))
    points = np.concatenate(
        [
            before.curve.at(before.curve.stations(spacing=step)),
            after.curve.at(after.curve.stations(spacing=step))[1:],
        ]
    )
    if before.start == after.end:
        curve = Curve.through(points[:-1], closed=True)
    else:
        curve = Curve.through(points)
    length = before.length + after.length
    s = np.linspace(0.0, length, WIDTHS)
    early = np.minimum(s, before.length)
    widths = np.where(
        s <= before.length,
        before.width.at(early),
        after.width.at(np.clip(s - before.length, 0.0, after.length)),
    )
    sure = (before.confidence * before.length + after.confidence * after.length) / length
    return replace(before, end=after.end, curve=curve, widths=widths, confidence=sure)
