"""Which driven agents have left the road: where the signal `off_road` is above zero."""

from __future__ import annotations

import numpy as np

from ..geometry.arrays import Booleans, Floats, Integers
from ..geometry.lanes.cross_section import drivable_borders
from ..ir.scene import SceneRoad
from ..simulation.lanes.lane_columns import LaneSection
from ..simulation.signals.lane_reader import on_own_roads
from ..simulation.signals.samples import Samples
from ..simulation.state.world import World

_ROUNDING = 1e-6
"""Meters."""


class OffRoadCheck:
    """Of the agents of a world as it was built.

    The signal is read only of agents whose footprints may reach beyond the lanes around their
    lines; all others are on the road for certain.
    """

    def __init__(self, world: World) -> None:
        drivable: dict[int, float] = {}  # by the identity of roads, which many scenes share
        agents = range(len(world.present))
        self._half_width = np.array([_half_width(world, agent, drivable) for agent in agents])
        self._room = _room(world, self._half_width)
        self._half_length = 0.5 * world.bodies.length
        self._lanes = _shared_lanes(world)

    def of(self, world: World, samples: Samples, agents: Integers) -> Booleans:
        """(n,) whether some agents are outside the drivable area. `samples`: of the world now."""
        out = np.zeros(len(agents), dtype=bool)
        near = self._is_near(world)[agents].nonzero()[0]
        if not len(near):
            return out
        if self._lanes is not None:
            out[near] = _beyond(world, samples, agents[near], self._lanes) > 0.0
            return out
        # To look whether it is needed takes less time than to read agent after agent.
        unsure = near[~self._inside(world, agents[near])]
        if len(unsure):
            out[unsure] = samples.column("off_road", agents[unsure], 0)[-1] > 0.0
        return out

    def _is_near(self, world: World) -> Booleans:
        """(N,) who may reach beyond a border, wherever along its line it is: a rough look, to find
        the few agents for whom it has to be worked out."""
        motion = world.motion
        side = np.abs(motion.offset) + self._half_length * np.abs(motion.sine)
        return np.asarray(world.has_road & ~(side <= self._room))

    def _inside(self, world: World, agents: Integers) -> Booleans:
        """(n,) who is between the borders for certain: a corner that is `a` meters ahead and `m`
        to the side of the foot point is at most `m + |k| a^2 / (2 (1 - |k| m))` beside a line of
        curvature `k`."""
        motion, bodies = world.motion, world.bodies
        cosine, sine = np.abs(motion.cosine[agents]), np.abs(motion.sine[agents])
        half_length, half_width = 0.5 * bodies.length[agents], 0.5 * bodies.width[agents]
        side = np.abs(motion.offset[agents]) + half_width * cosine + half_length * sine
        ahead = half_length * cosine + half_width * sine
        track = world.track.of_rows(agents)
        cell, _ = track.cell(motion.along[agents])
        curvature = np.abs(track.lines.curvature[cell])
        bends = curvature * side
        bulge = curvature * ahead * ahead / (2.0 * np.maximum(1.0 - bends, 0.5))
        return np.asarray((bends <= 0.5) & (side + bulge <= self._half_width[agents]))


def _room(world: World, half_width: Floats) -> Floats:
    """(N,) at how far beside its line the middle of an agent's front or rear is within the borders
    for certain, in the sharpest bend of the line: `OffRoadCheck._inside` says of all that it is.
    Below zero where a bend is too sharp to tell."""
    bodies, lines = world.bodies, world.track.lines
    curvature = lines.column(np.abs(lines.curvature)).max(axis=1)[world.track.row]
    reach = 0.5 * (bodies.length + bodies.width)
    bulge = curvature * reach * reach  # as much at most, in bends that wide
    wide = curvature * half_width <= 0.5
    return np.where(wide, half_width - 0.5 * bodies.width - bulge - _ROUNDING, -1.0)


def _shared_lanes(world: World) -> LaneSection | None:
    """The lanes of the roads of all agents, where all have one cross-section, the same all along:
    their signals are read together."""
    if world.has_route.any():
        return None
    roads = {id(road): road for scene in world.scenes for road in scene.roads}
    alike = {(road.lane_list, road.center_offset): road for road in roads.values()}
    (road, *others) = alike.values() or (None,)
    if road is None or others or not road.lane_list:
        return None
    lanes = LaneSection.of(road)
    return lanes if lanes.is_constant else None


def _beyond(world: World, samples: Samples, agents: Integers, lanes: LaneSection) -> Floats:
    """(n,) the signal `off_road` of agents on roads with the same lanes all along, of which no
    station has to be known."""
    columns = {name: samples.now(name, agents)[:, None] for name in ("along", "offset", "heading")}
    on = on_own_roads(world, agents, {**columns, "station": columns["along"]})
    size = world.bodies.length[agents][:, None], world.bodies.width[agents][:, None]
    return lanes.off_road(on, *size)[:, 0]


def _half_width(world: World, agent: int, drivable: dict[int, float]) -> float:
    """Meters to each side of the line of an agent that are drivable all along it. `drivable`: those
    of roads that are known already."""
    if not world.present[agent] or not world.has_road[agent]:
        return 0.0
    if world.has_route[agent]:
        return 0.5 * _line_width(world, agent)
    road = world.scenes[agent // world.slots].roads[world.road[agent]]
    if id(road) not in drivable:
        drivable[id(road)] = _drivable(road)
    return drivable[id(road)]


def _line_width(world: World, agent: int) -> float:
    """Of the narrowest lane of a route."""
    lines, row = world.track.lines, int(world.track.row[agent])
    first = row * lines.cells
    return float(lines.width[first : first + int(lines.last[row]) + 1].min())


def _drivable(road: SceneRoad) -> float:
    lanes = LaneSection.of(road)
    first, last = drivable_borders(np.array([lane.drivable for lane in lanes.section.lanes]))
    borders: Floats = lanes.section.border_offsets(np.array(road.stations))
    return float(min(borders[first].min(), -borders[last].max()))
