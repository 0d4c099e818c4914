"""Which wheels are beside the road, on grass: less grip, and more resistance."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...geometry.arrays import Booleans, Floats, Integers
from ...ir.scene import Scene, SceneRoad
from ..lanes.lane_columns import LaneSection
from ..lanes.road_forms import RoadForms
from ..lanes.surfaces import BESIDE, TireSurface, below
from ..lines.route_table import RouteTable
from ..tapes.tape import NotElementwiseError
from .bodies import Bodies
from .motion import Motion
from .patches import TIRE, WHEELS, Patches
from .vehicle_dynamics import GRAVITY


@dataclass(frozen=True)
class Verges:
    """Columns (N,) over agents.

    Grip and resistance of an agent are those of the surfaces below its wheels, on average.
    """

    clear: Floats
    """meters left and right of its line where an agent is surely on a road as long as it goes
    straight; infinite for those on no road and on foot"""
    friction: Floats
    """of the ground beside the road"""
    rolling: Floats
    """by how much it slows down more than the road does, m/s^2"""
    roads: NDArray[np.object_]
    """those of their scenes"""
    has_route: Booleans
    edges: Floats
    """(N, 2) how far left of their lines the left and right edges of roads are, of agents without a
    route on roads that are equally wide all along; NaN until they were looked up"""
    patches: Patches
    known: dict[Any, Any] = field(default_factory=dict, repr=False)
    """edges of roads that were looked up, which are the same for every lookup"""
    forms: RoadForms = field(default_factory=RoadForms, repr=False)
    """of those roads"""

    @classmethod
    def of(
        cls, scenes: Sequence[Scene], road: Integers, has_route: Booleans, widths: Floats,
        bodies: Bodies, surfaces: Sequence[TireSurface],
    ) -> Verges:  # fmt: skip
        """`road`: of each agent, -1 for none; `widths`: of their lines, the least; `surfaces`: of
        their roads."""
        roads = np.empty(len(road), dtype=object)
        for agent in range(len(road)):
            roads[agent] = scenes[agent * len(scenes) // len(road)].roads
        clear = 0.5 * (widths - bodies.width)
        for agent in np.flatnonzero((road >= 0) & ~has_route).tolist():
            if roads[agent][road[agent]].center_offset:
                clear[agent] = -np.inf
        kinds = {id(surface): surface for surface in surfaces}  # a few, which many roads have
        beside_kinds = {kind: below(BESIDE, surface) for kind, surface in kinds.items()}
        ground = [beside_kinds[id(surface)] for surface in surfaces]
        more = [
            beside.rolling - surface.rolling
            for beside, surface in zip(ground, surfaces, strict=True)
        ]
        return cls(
            np.where((road < 0) | bodies.walks, np.inf, clear),
            np.array([beside.friction for beside in ground]),
            GRAVITY * np.array(more),
            roads,
            has_route,
            np.full((len(road), 2), np.nan),
            Patches.of(scenes, road, has_route, surfaces),
        )

    def take(self, agents: Integers) -> Verges:
        """Those of some agents."""
        return Verges(
            self.clear[agents], self.friction[agents], self.rolling[agents], self.roads[agents],
            self.has_route[agents], self.edges[agents], self.patches.take(agents), self.known,
            self.forms,
        )  # fmt: skip

    def traced(self, bodies: Bodies, motion: Motion, table: RouteTable) -> TracedVerges:
        """What `below` does, of agents whose columns are traced. `motion`: where they are now.
        Raises NotElementwiseError where an agent may come to ground that its own columns and the
        edges of its road do not tell."""
        rows = np.flatnonzero(np.isfinite(self.clear) | (self.clear < 0.0))
        edges = np.full((len(self.clear), 2), (np.inf, -np.inf))
        edges[rows] = self._edges_at(table, motion, rows)
        if len(rows) and np.isnan(self.edges[rows, 0]).any():
            raise NotElementwiseError("a road whose edges are elsewhere at each station")
        if not self.patches.is_empty:
            raise NotElementwiseError("stretches of other surfaces")
        return TracedVerges(self, edges, len(rows) > 0)

    def traced_below(
        self, bodies: Bodies, motion: Motion, present: Booleans, edges: Floats
    ) -> Bodies:
        """The same as `below`, by computations of columns alone. `edges`: of all agents."""
        every = slice(None)
        near = self._near(bodies, motion)
        beside = _share_beside(bodies, motion, edges, every)
        share = np.where(present & near, beside, 0.0)
        friction, rolling = self._ground(bodies, every, share)
        return bodies.where(share > 0.0, friction, rolling)

    def below(self, bodies: Bodies, motion: Motion, table: RouteTable, present: Booleans) -> Bodies:
        """The bodies with the grip and the resistance that they have where they are."""
        mixed = self._with_verges(bodies, motion, table, present)
        return self.patches.below(bodies, mixed, motion, table, present, self.has_route)

    def _with_verges(
        self, bodies: Bodies, motion: Motion, table: RouteTable, present: Booleans
    ) -> Bodies:
        rows = (present & self._near(bodies, motion)).nonzero()[0]
        if not len(rows):
            return bodies
        share = self._beside(bodies, motion, table, rows)
        rows, share = rows[share > 0.0], share[share > 0.0]
        return self._mixed(bodies, rows, share) if len(rows) else bodies

    def _near(self, bodies: Bodies, motion: Motion) -> Booleans:
        """(N,) who may have a wheel beside the road."""
        return np.abs(motion.offset) + bodies.half_base * np.abs(motion.sine) > self.clear

    def _mixed(self, bodies: Bodies, rows: Integers, share: Floats) -> Bodies:
        """`share` (R,) of the wheels of agents `rows` are beside the road."""
        friction, rolling = self._ground(bodies, rows, share)
        return bodies.on_ground(rows, friction, rolling)

    def _ground(self, bodies: Bodies, rows: Any, share: Floats) -> tuple[Floats, Floats]:
        """(R,) friction and rolling resistance of agents with such a share of their wheels beside
        the road."""
        on = bodies.friction[rows]
        friction = on + (self.friction[rows] - on) * share
        return friction, bodies.rolling[rows] + self.rolling[rows] * share

    def _beside(self, bodies: Bodies, motion: Motion, table: RouteTable, rows: Integers) -> Floats:
        """(R,) share of the wheels of agents that are beside their roads; at junctions none."""
        edges = self._edges_at(table, motion, rows)
        return _share_beside(bodies, motion, edges, rows)

    def _edges_at(self, table: RouteTable, motion: Motion, rows: Integers) -> Floats:
        """(R, 2) how far left of their lines the left and right edges of roads are."""
        edges = self.edges[rows]
        unknown = np.flatnonzero(np.isnan(edges[:, 0]))
        if len(unknown):
            edges[unknown] = self._looked_up(table, motion, rows[unknown])
        return edges

    def look_up(self, table: RouteTable, motion: Motion) -> None:
        """Find the edges that are the same all along roads, of all agents at once: of drives that
        begin anew again and again, they would be found for one agent after another."""
        rows = np.flatnonzero((np.isfinite(self.clear) | (self.clear < 0.0)) & ~self.has_route)
        self._edges_at(table, motion, rows)

    def _looked_up(self, table: RouteTable, motion: Motion, rows: Integers) -> Floats:
        """The same, of all agents in a lane at once. What cannot change is kept."""
        place = table.place(rows, motion.along[rows])
        edges = np.full((len(rows), 2), (np.inf, -np.inf))
        sections: dict[tuple[int, int | None], tuple[LaneSection, list[int]]] = {}
        constant: list[tuple[float, float]] = []
        theirs: list[int] = []
        numbers, lanes, routed = place.road.tolist(), place.lane.tolist(), self.has_route[rows]
        for i in np.flatnonzero(place.turn < 0).tolist():
            road = self.roads[rows[i]][numbers[i]]
            lane = int(lanes[i]) if routed[i] else None
            found = self._edges(road, lane)
            if isinstance(found, LaneSection):
                sections.setdefault((id(road), lane), (found, []))[1].append(i)
            else:
                constant.append(found)
                theirs.append(i)
        if theirs:
            direction = place.direction[theirs, None]
            edges[theirs] = _as_driven(np.array(constant), direction)
            kept = [i for i in theirs if not routed[i]]
            self.edges[rows[kept]] = edges[kept]
        for (_, lane), (section, there) in sections.items():
            left_right = _edges_of(section, lane, place.station[there])
            edges[there] = _as_driven(left_right, place.direction[there, None])
        return edges

    def _edges(self, road: SceneRoad, lane: int | None) -> tuple[float, float] | LaneSection:
        """Those of a road, left of the middle of a lane or (None) of its center line; the lanes of
        a road whose edges differ from station to station."""
        key = id(road), lane
        if key not in self.known:
            self.known[key] = self._edges_or_section(road, lane)
        found: tuple[float, float] | LaneSection = self.known[key]
        return found

    def _edges_or_section(
        self, road: SceneRoad, lane: int | None
    ) -> tuple[float, float] | LaneSection:
        """The edges of a road that is equally wide all along, else its lanes. Most roads that are
        driven together have the same lanes, as they are one road that was bent in many ways."""
        form = self.forms.number(road)
        alike = "form", form, lane
        found: tuple[float, float] | None = self.known.get(alike)
        if found is not None:
            return found
        section = LaneSection.of(road)
        if not section.is_constant:
            return section
        left, right = _edges_of(section, lane, np.zeros(())).tolist()
        if form is not None:
            self.known[alike] = left, right
        return left, right


@dataclass(frozen=True)
class TracedVerges:
    """The verges of agents whose columns are traced."""

    verges: Verges
    edges: Floats
    """(N, 2) as of `Verges`"""
    has_any: bool
    """whether any agent can have a wheel beside a road"""

    def below(self, bodies: Bodies, motion: Motion, _: RouteTable, present: Booleans) -> Bodies:
        """The bodies with the grip and the resistance that they have where they are."""
        if not self.has_any:
            return bodies
        return self.verges.traced_below(bodies, motion, present, self.edges)


def _share_beside(bodies: Bodies, motion: Motion, edges: Floats, rows: Any) -> Floats:
    """(R,) share of the wheels of agents that are beyond the left and right edges (R, 2)."""
    along = bodies.half_base[rows] * motion.sine[rows]
    across = 0.5 * np.maximum(bodies.width[rows] - TIRE, 0.0) * motion.cosine[rows]
    share: Floats = np.zeros(())
    for ahead, left in WHEELS:
        offset = motion.offset[rows] + ahead * along + left * across
        beside = (offset > edges[:, 0]) | (offset < edges[:, 1])
        share = share + np.where(beside, 1.0 / len(WHEELS), 0.0)
    return share


def _edges_of(lanes: LaneSection, lane: int | None, station: Floats) -> Floats:
    """(..., 2) left and right edges at stations (...)."""
    section = lanes.section
    borders = section.border_offsets(station)
    edges = np.stack([borders[0], borders[-1]], axis=-1)
    if lane is None:
        return edges
    place = section.ids.index(lane)
    return np.asarray(edges - 0.5 * (borders[place] + borders[place + 1])[..., None])


def _as_driven(edges: Floats, direction: Integers) -> Floats:
    """Edges (..., 2) left of a line that runs along the road, or (-1) against it."""
    return np.where(direction > 0, edges, -edges[..., ::-1])
