"""Which wheels are on stretches of road that have surfaces of their own."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...geometry import CrossSection
from ...geometry.arrays import Booleans, Floats, Integers
from ...ir.scene import Scene, SceneRoad
from ...ir.scene_surface import SurfaceName
from ...ir.surface_stretches import surface_stretches
from ..lanes.surfaces import TireSurface, road_surface, surface_names
from ..lines.route_table import RouteTable
from .bodies import Bodies
from .motion import Motion
from .vehicle_dynamics import GRAVITY

TIRE = 0.25
"""Meters by which the wheels are closer together than the body is wide."""
WHEELS = ((1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0))
"""Ahead and to the left, in halves of the wheelbase and of the track."""


@dataclass(frozen=True)
class Patches:
    """Columns (N,) over agents. Grip and resistance of an agent are those of the surfaces below its
    four wheels, on average: it does not turn toward the side that has more grip."""

    patched: Booleans
    """whether they drive on roads with such stretches"""
    rolling: Floats
    """of the road that they begin on, for each newton of weight"""
    scenes: NDArray[np.object_]
    known: dict[Any, Any] = field(default_factory=dict, repr=False)
    """what was looked up of roads and scenes, which is the same for every lookup"""

    @classmethod
    def of(
        cls, scenes: Sequence[Scene], road: Integers, has_route: Booleans,
        surfaces: Sequence[TireSurface],
    ) -> Patches:  # fmt: skip
        """`road`: of each agent, -1 for none; `surfaces`: of their roads."""
        slots = len(road) // len(scenes)
        of_agents = np.empty(len(road), dtype=object)
        patched = np.zeros(len(road), dtype=bool)
        for number, scene in enumerate(scenes):
            rows = slice(number * slots, (number + 1) * slots)
            of_agents[rows] = scene
            if any(one.surface_patches for one in scene.roads):
                on = np.array([bool(one.surface_patches) for one in scene.roads] + [False])
                patched[rows] = on[road[rows]] | has_route[rows]
        return cls(patched, np.array([surface.rolling for surface in surfaces]), of_agents)

    def take(self, agents: Integers) -> Patches:
        """Those of some agents."""
        rows = self.patched[agents], self.rolling[agents], self.scenes[agents]
        return Patches(*rows, self.known)

    def below(
        self, own: Bodies, mixed: Bodies, motion: Motion, table: RouteTable, present: Booleans,
        has_route: Booleans,
    ) -> Bodies:  # fmt: skip
        """`mixed` bodies with what these stretches change; `own` are those on the road that each
        agent begins on."""
        if self.is_empty:
            return mixed
        rows = np.flatnonzero(self.patched & present & ~own.walks)
        if not len(rows):
            return mixed
        place = table.place(rows, motion.along[rows])
        more = np.zeros((2, len(rows)))
        for i in np.flatnonzero(place.turn < 0).tolist():
            agent = int(rows[i])
            scene = self.scenes[agent]
            lanes = self._lanes(scene.roads[int(place.road[i])])
            station, direction = float(place.station[i]), int(place.direction[i])
            line = lanes.line(int(place.lane[i]) if has_route[agent] else None, station)
            for ahead, left in _wheels(own, motion, agent):
                at = station + direction * ahead, line + direction * left
                said = lanes.surface(*at)
                if said is not None:
                    surface = self._table(scene)[said]
                    more[0, i] += 0.25 * (surface.friction - own.friction[agent])
                    more[1, i] += 0.25 * (surface.rolling - self.rolling[agent])
        changed = more.any(axis=0)
        rows, more = rows[changed], more[:, changed]
        friction = mixed.friction[rows] + more[0]
        return mixed.on_ground(rows, friction, mixed.rolling[rows] + GRAVITY * more[1])

    @cached_property
    def is_empty(self) -> bool:
        """Whether no agent can come to any."""
        return not self.patched.any()

    def _lanes(self, road: SceneRoad) -> _LaneSurfaces:
        if id(road) not in self.known:
            self.known[id(road)] = _LaneSurfaces.of(road)
        found: _LaneSurfaces = self.known[id(road)]
        return found

    def _table(self, scene: Scene) -> Mapping[SurfaceName, TireSurface]:
        if id(scene) not in self.known:
            table = {name: road_surface(scene.world, name) for name in surface_names()}
            self.known[id(scene)] = table
        found: Mapping[SurfaceName, TireSurface] = self.known[id(scene)]
        return found


@dataclass(frozen=True)
class _LaneSurfaces:
    """The surfaces of the lanes of a road by station."""

    section: CrossSection
    ends: Floats
    stretches: tuple[tuple[SurfaceName | None, ...], ...]
    period: float | None

    @classmethod
    def of(cls, road: SceneRoad) -> _LaneSurfaces:
        section = road.cross_section()
        stretches = surface_stretches(road, section.ids)
        ends = np.array([stretch.end for stretch in stretches[:-1]])
        surfaces = tuple(stretch.surfaces for stretch in stretches)
        return cls(section, ends, surfaces, road.length if road.closed else None)

    def line(self, lane: int | None, station: float) -> float:
        """How far left of the curve the middle of a lane is; 0 for None."""
        return 0.0 if lane is None else float(self.section.offset(lane, station))

    def surface(self, station: float, offset: float) -> SurfaceName | None:
        """What is at an offset to the left of the curve; None beside the road too."""
        station = station % self.period if self.period else station
        lanes = self.stretches[int(np.searchsorted(self.ends, station))]
        borders = self.section.border_offsets(station)
        if not borders[-1] <= offset <= borders[0]:
            return None
        return lanes[int((borders[1:-1] > offset).sum())]


def _wheels(bodies: Bodies, motion: Motion, agent: int) -> list[tuple[float, float]]:
    """How far ahead of the foot point and left of the line the wheels of an agent are."""
    cosine, sine = float(motion.cosine[agent]), float(motion.sine[agent])
    half_base, offset = float(bodies.half_base[agent]), float(motion.offset[agent])
    half_track = 0.5 * max(float(bodies.width[agent]) - TIRE, 0.0)
    return [
        (
            i * half_base * cosine - j * half_track * sine,
            offset + i * half_base * sine + j * half_track * cosine,
        )
        for i, j in WHEELS
    ]
