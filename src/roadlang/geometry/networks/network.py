"""Road networks: nodes where roads end or meet, joined by curves.

A facade: `longest` and `route` import the paths through a network, which stand on it, when they
are called.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from ..arrays import Floats, SharedArrays, finite, norm
from ..curves.curve import Curve
from ..curves.width import WidthProfile
from ..errors import GeometryError
from ..lanes.cross_section import CrossSection
from ..lanes.road import Road
from .junction_model import End
from .map_junctions import MapControl, MapJunction

if TYPE_CHECKING:
    from .paths import Path

_JOINED = 1e-6
WIDTHS = 64
"""Places of a road at which its width is known."""


@dataclass(frozen=True, slots=True)
class Node:
    """A place where roads end or meet: its id and its `position` (x, y) in meters."""

    id: int
    position: tuple[float, float]


@dataclass(frozen=True, eq=False)
class Edge(SharedArrays):
    """A road between two nodes, by their ids, which are one for a loop.

    `curve` runs from the start to the end node, whose positions its ends must have. `widths` (n,)
    are meters at even arc lengths of the curve, the last at its end (of a closed curve, one step
    before its start); one width is for all of it. `confidence` in [0, 1] is the extractor's.
    `cross_section` are its lanes along the curve, which also say the width, whatever `widths` is;
    without it the lanes are those that the network's options say. `Edge.of` makes one of them.
    `forward` is True where all lanes run from the start to the end node, False where they run the
    other way, None where the lanes say themselves how they run.
    What maps say besides: the `name` of the street, `elevations` (n,), meters above the origin at
    even arc lengths, the `level` of bridges (1 and more) and tunnels (-1 and less), which roads of
    other levels cross without touching, `no_turns`: from an end of this road into which ends of
    other roads nobody may turn, and `lane_arrows`: the lanes that lead to an end, by their ids, and
    where their markings point, as changes of heading in radians, left positive.
    """

    id: int
    start: int
    end: int
    curve: Curve
    widths: Floats
    confidence: float = 1.0
    cross_section: CrossSection | None = None
    name: str = ""
    elevations: Floats | None = None
    forward: bool | None = None
    level: int = 0
    no_turns: tuple[tuple[End, int, End], ...] = ()
    lane_arrows: tuple[tuple[End, int, tuple[float, ...]], ...] = ()

    @classmethod
    def of(cls, id: int, start: int, end: int, curve: Curve, section: CrossSection) -> Edge:
        """An edge with these lanes, sure."""
        widths = section.drivable_profile().at(curve.stations(count=WIDTHS))
        return cls(id, start, end, curve, widths, cross_section=section)

    @property
    def length(self) -> float:
        """Arc length in meters."""
        return self.curve.length

    @cached_property
    def width(self) -> WidthProfile:
        """Width in meters by arc length, of the drivable lanes together."""
        if self.cross_section is not None:
            return self.cross_section.drivable_profile()
        return WidthProfile.even(self.widths, self.curve.length, self.curve.closed)

    @cached_property
    def end_headings(self) -> tuple[float, float]:
        """The headings of the curve at its start and at its end."""
        start, end = self.curve.heading([0.0, self.curve.length])
        return float(start), float(end)

    def other(self, node: int) -> int:
        """The node at the other end."""
        return self.end if node == self.start else self.start

    def transformed(self, curve: Curve, width_factor: float, mirrors: bool) -> Edge:
        """The edge along what became of its curve, left and right exchanged if that `mirrors`."""
        section = self.cross_section
        if section is not None:
            section = section.scaled(curve.length / self.curve.length, width_factor)
            section = section.mirrored() if mirrors else section
        widths = np.asarray(self.widths) * width_factor
        arrows = self.lane_arrows
        if mirrors:
            arrows = tuple((end, -lane, tuple(-aim for aim in aims)) for end, lane, aims in arrows)
        return replace(self, curve=curve, widths=widths, cross_section=section, lane_arrows=arrows)

    def road(self, lanes: int = 2) -> Road:
        """The edge as a separate road: with its cross-section, or with this many equal lanes."""
        if self.cross_section is not None:
            return Road.of(self.curve, self.cross_section)
        return Road(self.curve, self.width, lanes)


@dataclass(frozen=True, eq=False)
class RoadNetwork:
    """Roads (`edges`) that are joined at `nodes`. `network_of_polylines` makes one of points.

    Ids are unique among nodes and among edges. `origin` is the latitude and longitude of (0, 0),
    in degrees, where a map says so. `junctions` are all that a map states; without them (None) they
    are planned wherever roads meet; `controls` are the signals and signs of the map. Raises
    GeometryError for ids used twice, for an edge whose nodes do not exist or lie elsewhere than its
    ends, for junctions of roads that do not exist, and for widths that are not positive.
    """

    nodes: tuple[Node, ...]
    edges: tuple[Edge, ...]
    origin: tuple[float, float] | None = None
    junctions: tuple[MapJunction, ...] | None = None
    controls: tuple[MapControl, ...] = ()

    def __post_init__(self) -> None:
        if len(self._nodes) != len(self.nodes) or len(self._edges) != len(self.edges):
            raise GeometryError("the ids of nodes, and those of edges, must differ")
        for edge in self.edges:
            self._check(edge)
        for junction in self.junctions or ():
            for id, _ in junction.arms:
                self.edge(id)

    def _check(self, edge: Edge) -> None:
        ends = edge.curve.points[[0, 0 if edge.curve.closed else -1]]
        for node, point in zip((edge.start, edge.end), ends, strict=True):
            if node not in self._nodes:
                raise GeometryError(f"road {edge.id} ends at node {node}, which does not exist")
            gap = float(norm(point - self._nodes[node].position))
            if gap > _JOINED * max(1.0, float(np.abs(point).max())):
                raise GeometryError(f"road {edge.id} ends {gap:.3g} m away from node {node}")
        edge.width.require_positive()

    def node(self, id: int) -> Node:
        """The node with this id. Raises `GeometryError` if there is none."""
        if id not in self._nodes:
            raise GeometryError(f"the network has no node {id}")
        return self._nodes[id]

    def edge(self, id: int) -> Edge:
        """The edge with this id. Raises `GeometryError` if there is none."""
        if id not in self._edges:
            known = ", ".join(str(edge.id) for edge in self.edges[:12])
            more = ", ..." if len(self.edges) > 12 else ""
            raise GeometryError(f"the network has no road {id}; its roads are {known}{more}")
        return self._edges[id]

    def edges_at(self, node: int) -> tuple[Edge, ...]:
        """The edges that end at a node, a loop twice, in the order of the network."""
        return self._incident[self.node(node).id]

    def degree(self, node: int) -> int:
        """How many ends of roads meet at a node: 1 a dead end, 3 and more a junction."""
        return len(self.edges_at(node))

    @property
    def length(self) -> float:
        """Meters of all roads together."""
        return sum(edge.length for edge in self.edges)

    @property
    def components(self) -> tuple[frozenset[int], ...]:
        """The node ids of each connected part, in the order of the nodes."""
        seen: set[int] = set()
        parts = []
        for node in self.nodes:
            if node.id in seen:
                continue
            part, waiting = {node.id}, [node.id]
            while waiting:
                node_id = waiting.pop()
                beyond = {edge.other(node_id) for edge in self.edges_at(node_id)} - part
                part |= beyond
                waiting.extend(beyond)
            seen |= part
            parts.append(frozenset(part))
        return tuple(parts)

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """West, south, east and north of all nodes and roads, meters."""
        lines = [edge.curve.at(edge.curve.stations(count=64)) for edge in self.edges]
        lines += [edge.curve.points for edge in self.edges]
        lines += [np.array([node.position]) for node in self.nodes]
        if not lines:
            raise GeometryError("an empty network has no bounds")
        every = np.concatenate(lines)
        (west, south), (east, north) = every.min(axis=0), every.max(axis=0)
        return float(west), float(south), float(east), float(north)

    def scaled(self, factor: float) -> RoadNetwork:
        """All lengths times `factor`."""
        if not 0.0 < factor < np.inf:
            raise GeometryError("a scale must be positive")
        return self.transformed(np.eye(2) * factor, width_factor=factor)

    def transformed(
        self, matrix: ArrayLike, shift: ArrayLike = (0.0, 0.0), width_factor: float = 1.0
    ) -> RoadNetwork:
        """Each point p becomes `matrix @ p + shift`; widths are multiplied by `width_factor`.

        The `origin` is lost where (0, 0) moves.
        """
        linear, offset = finite(matrix, "the matrix"), finite(shift, "the shift")
        nodes = []
        for node in self.nodes:
            x, y = linear @ np.array(node.position) + offset
            nodes.append(Node(node.id, (float(x), float(y))))
        mirrors = float(np.linalg.det(linear)) < 0.0

        def moved(curve: Curve) -> Curve:
            return curve.transformed(linear, offset)

        edges = tuple(
            edge.transformed(moved(edge.curve), width_factor, mirrors) for edge in self.edges
        )
        junctions = self.junctions
        if junctions is not None:
            junctions = tuple(junction.transformed(moved, mirrors) for junction in junctions)
        origin = None if offset.any() else self.origin
        return RoadNetwork(tuple(nodes), edges, origin, junctions, self.controls)

    def longest(self) -> Path:
        """The longest simple road through the network (see `paths.longest_path`)."""
        from .paths import longest_path

        return longest_path(self)

    def route(self, p: ArrayLike, q: ArrayLike) -> Path:
        """The shortest way along the roads from the point nearest `p` to that nearest `q`."""
        from .paths import shortest_path

        return shortest_path(self, p, q)

    @cached_property
    def _nodes(self) -> dict[int, Node]:
        return {node.id: node for node in self.nodes}

    @cached_property
    def _edges(self) -> dict[int, Edge]:
        return {edge.id: edge for edge in self.edges}

    @cached_property
    def _incident(self) -> dict[int, tuple[Edge, ...]]:
        ends: dict[int, list[Edge]] = {node.id: [] for node in self.nodes}
        for edge in self.edges:
            ends[edge.start].append(edge)
            ends[edge.end].append(edge)
        return {node: tuple(edges) for node, edges in ends.items()}
