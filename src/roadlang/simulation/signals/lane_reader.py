"""Reads the lanes of agents of a world, at many times at once."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from ...geometry.areas.footprints import Footprints
from ...geometry.areas.rings import outside_ring
from ...geometry.arrays import Booleans, Floats, Integers
from ...ir.scene import Scene, SceneRoad
from ...ir.scene_junctions import SceneJunction
from ..lanes.lane_columns import LANE_COLUMNS, LaneSection, OnRoad, on_road
from ..lanes.road_forms import RoadForms
from ..state.world import World

NEEDED = ("along", "offset", "x", "y", "heading", "station", "cross_track_error")
"""What lanes are read of: arc lengths of the lines and offsets from them, and columns of traces."""
_NEEDED_WITHOUT_ROUTES = ("along", "offset", "heading", "station")
_ON_A_ROAD = -1
_ALONE = -2
_ROUNDING = 0.05
"""Meters: foot points are not exact."""


class LaneReader:
    """`LANE_COLUMNS` of the agents of a world as it was built.

    Agents without a route whose roads have one cross-section are read together.
    """

    def __init__(self, world: World) -> None:
        self._world = world
        self._lanes: list[LaneSection] = []
        self._forms = RoadForms()
        self._known: dict[Any, int] = {}
        self._number = np.array([self._group(agent) for agent in range(len(world.present))])

    def needed(self, agents: Integers) -> tuple[str, ...]:
        """Those of `NEEDED` of which the lanes of some agents are read."""
        has_alone = np.count_nonzero(self._number[agents] == _ALONE)
        return NEEDED if has_alone else _NEEDED_WITHOUT_ROUTES

    def read(
        self,
        agents: Integers,
        columns: Mapping[str, Floats],
        names: Sequence[str] = LANE_COLUMNS,
    ) -> dict[str, Floats]:
        """(n, T) some of `LANE_COLUMNS`, of some agents. `columns` (n, T): those `needed`.

        What has no road has no lane: NaN. On the connection of a junction an agent is in the lane
        from which it leads.
        """
        shape = columns["along"].shape
        out = {name: np.full(shape, math.nan) for name in names}
        numbers = self._number[agents]
        if len(numbers) and numbers[0] >= 0 and not np.count_nonzero(numbers != numbers[0]):
            alike = self._plain(agents, columns, self._lanes[numbers[0]], names)
            self._fill(out, slice(None), alike)
            return out
        for number in np.unique(numbers):
            rows = np.flatnonzero(numbers == number)
            if number >= 0:
                part = {name: columns[name][rows] for name in _NEEDED_WITHOUT_ROUTES}
                self._fill(out, rows, self._plain(agents[rows], part, self._lanes[number], names))
            elif number == _ALONE:
                for row in rows:
                    row_columns = {name: columns[name][row] for name in NEEDED}
                    found = _along_route(self._world, int(agents[row]), row_columns)
                    self._fill(out, row, found)
        return out

    def _fill(self, out: dict[str, Floats], rows: Any, found: Mapping[str, Floats]) -> None:
        for name, column in out.items():
            column[rows] = found[name]

    def _group(self, agent: int) -> int:
        world = self._world
        if world.road[agent] < 0 or not world.filled[agent]:
            return _ON_A_ROAD
        if world.has_route[agent]:
            return _ALONE
        road = world.scenes[agent // world.slots].roads[world.road[agent]]
        form = self._forms.number(road)
        key = form, road.speed_limit, road.speed_zones
        number = self._known.get(key)
        if number is not None:
            return number
        lanes = LaneSection.of(road)
        self._lanes.append(lanes)
        if lanes.is_constant and form is not None:
            self._known[key] = len(self._lanes) - 1
        return len(self._lanes) - 1

    def _plain(
        self,
        agents: Integers,
        columns: Mapping[str, Floats],
        lanes: LaneSection,
        names: Sequence[str],
    ) -> dict[str, Floats]:
        """Of agents without a route, whose lines are the center lines of their roads."""
        world = self._world
        on = on_own_roads(world, agents, columns)
        size = world.bodies.length[agents][:, None], world.bodies.width[agents][:, None]
        if tuple(names) == ("off_road",):
            return {"off_road": lanes.off_road(on, *size)}
        found = dict(lanes.columns(on, world.backward[agents][:, None], *size))
        found["road"] = np.broadcast_to(world.road[agents][:, None], on.error.shape)
        return found


def on_own_roads(world: World, agents: Integers, columns: Mapping[str, Floats]) -> OnRoad:
    """Where agents without a route are, whose lines are the center lines of their roads. `columns`
    (n, T): `along`, `offset`, `heading` and `station` of `NEEDED`."""
    along, shape = columns["along"], columns["along"].shape
    every = agents if shape[1] == 1 else np.repeat(agents, shape[1])
    curvature, line_heading = world.track.bend_of(every, along.ravel())
    sign = np.where(world.backward[agents], -1.0, 1.0)[:, None]
    return OnRoad(
        columns["station"], sign * columns["offset"],
        columns["heading"] - line_heading.reshape(shape), sign * curvature.reshape(shape),
    )  # fmt: skip


def _along_route(world: World, agent: int, columns: Mapping[str, Floats]) -> dict[str, Floats]:
    """(T,) of one agent with a route: by the roads that it is on, one after another."""
    scene = world.scenes[agent // world.slots]
    along = columns["along"]
    rows = np.full(len(along), agent)
    place = world.table.place(rows, along)
    poses = {name: columns[name][None] for name in ("x", "y", "heading", "station")}
    size = np.array([[world.bodies.length[agent]]]), np.array([[world.bodies.width[agent]]])
    out = {name: np.full(len(along), math.nan) for name in LANE_COLUMNS}
    lanes = {number: LaneSection.of(scene.roads[number]) for number in np.unique(place.road)}
    for number, section in lanes.items():
        at = np.flatnonzero((place.road == number) & (place.turn < 0))
        if len(at):
            on = on_road(scene.roads[number], *(poses[name][:, at] for name in _POSE))
            backward = np.cos(on.error) < 0.0
            for name, values in section.columns(on, backward, *size).items():
                out[name][at] = values[0]
            out["road"][at] = number
    crossing = np.flatnonzero(place.turn >= 0)
    turns = world.table.turns
    out["lane"][crossing] = [turns[i].connection.source.lane for i in place.turn[crossing]]
    out["lane_offset"][crossing] = columns["cross_track_error"][crossing]
    out["speed_limit"][crossing] = world.table.speed_limit(rows[crossing], along[crossing])
    out["road"][crossing] = -1.0
    # Of the whole route: what is read at some moments depends on no others.
    ahead = world.table.turn[world.table.line[agent]]
    junctions = {turns[i].junction.id: turns[i].junction for i in ahead[ahead >= 0]}
    crossed = np.full(len(along), -1)
    crossed[crossing] = [turns[i].junction.id for i in place.turn[crossing]]
    _include_junctions(out["off_road"], scene, tuple(junctions.values()), crossed, poses, size)
    return out


_POSE = ("station", "x", "y", "heading")


def _include_junctions(
    off_road: Floats,
    scene: Scene,
    junctions: tuple[SceneJunction, ...],
    crossed: Integers,
    poses: Mapping[str, Floats],
    size: tuple[Floats, Floats],
) -> None:
    """At junctions, the area and its roads together are where one may drive: each corner of the
    footprint may be on another of them. Changes (T,) `off_road`. `crossed`: (T,) the junction on
    whose connection it is, -1 for none."""
    roads = {road.name: road for road in scene.roads}
    lengths, widths = (np.full(off_road.shape, float(extent[0, 0])) for extent in size)
    x, y, heading = (poses[name][0] for name in ("x", "y", "heading"))
    corners = Footprints(x, y, heading, lengths, widths).corners
    least = np.full(corners.shape[:-1], math.inf)
    for junction in junctions:
        near = _is_near(np.array(junction.area), x, y, float(size[0][0, 0]))
        at = np.flatnonzero(near | (crossed == junction.id))
        if len(at):
            around = [_outside_road(roads[arm.road], corners[at]) for arm in junction.arms]
            around.append(outside_ring(np.array(junction.area), *np.moveaxis(corners[at], -1, 0)))
            least[at] = np.minimum(least[at], np.minimum.reduce(around))
    at = np.flatnonzero(np.isfinite(least[:, 0]))
    off_road[at] = least[at].max(axis=-1)


def _is_near(ring: Floats, x: Floats, y: Floats, distance: float) -> Booleans:
    """(T,) which points are less than `distance` from an area."""
    low, high = ring.min(axis=0) - distance, ring.max(axis=0) + distance
    near = np.asarray((x > low[0]) & (x < high[0]) & (y > low[1]) & (y < high[1]))
    near[near] = outside_ring(ring, x[near], y[near]) < distance
    return near


def _outside_road(road: SceneRoad, points: Floats) -> Floats:
    """(t, 4) meters by which points (t, 4, 2) are beside the drivable lanes of a road or beyond
    its ends; negative within."""
    nodes = np.stack([np.array(road.x), np.array(road.y)], axis=-1)
    off = points[..., None, :] - nodes
    nearest = (off * off).sum(axis=-1).argmin(axis=-1)
    stations = np.array(road.stations)
    station = stations[nearest]
    zero = np.zeros(station.shape)
    on = on_road(road, station, points[..., 0], points[..., 1], zero)
    beside = LaneSection.of(road).outside(on, on.offset[None])[0]
    heading = np.interp(on.station, stations, np.unwrap(np.array(road.heading)))
    foot_x = np.interp(on.station, stations, nodes[:, 0])
    foot_y = np.interp(on.station, stations, nodes[:, 1])
    beyond = np.abs(
        (points[..., 0] - foot_x) * np.cos(heading) + (points[..., 1] - foot_y) * np.sin(heading)
    )
    past = (beyond > _ROUNDING) & (not road.closed)
    return np.asarray(np.where(past, np.maximum(beside, beyond), beside))
