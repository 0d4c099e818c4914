"""Perturbing the roads of a network while they stay joined."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from .arrays import Floats, finite
from .batch import CurveBatch, displace
from .errors import GeometryError
from .frame import Frame
from .network import Edge, Node, RoadNetwork
from .window import Window, ease, fade

REACH = 15.0
"""Meters from a junction within which a displacement fades out."""


@dataclass(frozen=True, eq=False)
class NetworkBatch:
    """V variants of a network.

    `nodes`: (V, 2) positions by node id; `edges`: V curves by edge id, whose first and last points
    are bit for bit the positions of the nodes at their ends.
    """

    root: RoadNetwork
    nodes: Mapping[int, Floats]
    edges: Mapping[int, CurveBatch]

    def variant(self, index: int) -> RoadNetwork:
        """One variant as a network of its own."""
        nodes = tuple(
            Node(
                node.id,
                (float(self.nodes[node.id][index, 0]), float(self.nodes[node.id][index, 1])),
            )
            for node in self.root.nodes
        )
        edges = tuple(
            replace(edge, curve=self.edges[edge.id].curve(index)) for edge in self.root.edges
        )
        return RoadNetwork(nodes, edges)


def anchored_nodes(network: RoadNetwork) -> frozenset[int]:
    """The nodes that roads must keep meeting at: all but dead ends and the seams of lone rings."""
    free = set()
    for node in network.nodes:
        ends = network.edges_at(node.id)
        lone_ring = len(ends) == 2 and ends[0] is ends[1] and ends[0].curve.closed
        if len(ends) <= 1 or lone_ring:
            free.add(node.id)
    return frozenset(node.id for node in network.nodes) - free


def junction_window(
    network: RoadNetwork, edge: Edge, stations: Floats, reach: float = REACH
) -> Window:
    """Zero where the edge ends at an anchored node, one beyond `reach` meters from there.

    Value, slope and bend of a displacement in this window vanish at such ends, so that positions,
    headings and curvatures there stay what they were.
    """
    anchored = anchored_nodes(network)
    return fade(stations, edge.length, reach, edge.start in anchored, edge.end in anchored)


def perturb_network(
    network: RoadNetwork,
    stations: Mapping[int, ArrayLike],
    displacements: Mapping[int, ArrayLike],
    shifts: Mapping[int, ArrayLike] | None = None,
    reach: float = REACH,
) -> NetworkBatch:
    """Each edge displaced along its normal, junctions kept joined.

    `stations` (S,) and `displacements` (V, S) or (S,) by edge id; an edge without a displacement
    stays. Displacements fade out at anchored nodes. `shifts`, (V, 2) or (2,) by node id, move
    nodes, and over `reach` meters the roads that end there. Dead ends go where their road goes.
    """
    shifts = shifts or {}
    rows = _variants([*displacements.values()], [*shifts.values()])
    anchored = anchored_nodes(network)
    nodes = {
        node.id: np.array(node.position) + _row_shift(shifts.get(node.id), rows)
        for node in network.nodes
    }
    edges: dict[int, CurveBatch] = {}
    for edge in network.edges:
        frame = Frame.of(edge.curve, stations[edge.id])
        moved = _displaced(network, edge, frame, displacements.get(edge.id), rows, reach)
        points = moved + _carried(edge, frame, shifts, rows, reach)
        _pin(edge, points, nodes, anchored)
        edges[edge.id] = CurveBatch(frame.stations, points, frame.closed, frame.period)
    return NetworkBatch(network, nodes, edges)


def _displaced(
    network: RoadNetwork,
    edge: Edge,
    frame: Frame,
    displacement: ArrayLike | None,
    rows: int,
    reach: float,
) -> Floats:
    if displacement is None:
        return np.repeat(frame.points[None], rows, axis=0)
    moves = np.atleast_2d(finite(displacement, "a displacement"))
    window = junction_window(network, edge, frame.stations, reach)
    points = displace(frame, frame.stations, window.value * moves).points
    return np.array(np.broadcast_to(points, (rows, *points.shape[1:])))


def _carried(
    edge: Edge, frame: Frame, shifts: Mapping[int, ArrayLike], rows: int, reach: float
) -> Floats:
    """(V, S, 2) how far moved nodes carry the points of an edge along."""
    carried = np.zeros((rows, len(frame.stations), 2))
    span = min(reach, edge.length / 2.0)
    for node, away in ((edge.start, frame.stations), (edge.end, edge.length - frame.stations)):
        if node in shifts:
            share = 1.0 - ease(away / span)[0]
            carried += share[:, None] * _row_shift(shifts[node], rows)[:, None, :]
    return carried


def _pin(edge: Edge, points: Floats, nodes: dict[int, Floats], anchored: frozenset[int]) -> None:
    """Makes the ends of an edge and its nodes the same numbers."""
    ends = ((edge.start, 0),) if edge.curve.closed else ((edge.start, 0), (edge.end, -1))
    for node, end in ends:
        if node in anchored:
            points[:, end] = nodes[node]
        else:
            nodes[node] = points[:, end].copy()


def _row_shift(shift: ArrayLike | None, rows: int) -> Floats:
    if shift is None:
        return np.zeros((rows, 2))
    given = np.atleast_2d(finite(shift, "the shift of a node"))
    if given.shape not in ((rows, 2), (1, 2)):
        raise GeometryError("the shift of a node must be (x, y), or one for each variant")
    return np.broadcast_to(given, (rows, 2))


def _variants(displacements: list[ArrayLike], shifts: list[ArrayLike]) -> int:
    counts = {len(np.atleast_2d(np.asarray(values))) for values in (*displacements, *shifts)} - {1}
    if len(counts) > 1:
        raise GeometryError("all roads of a network must have the same number of variants")
    return counts.pop() if counts else 1
