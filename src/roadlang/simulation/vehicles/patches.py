"""Which wheels are on stretches of road that have surfaces of their own."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ...ir.scene import Scene
from ..lanes.surfaces import TireSurface
from ..lines.route_table import RouteTable
from .bodies import Bodies
from .lane_surfaces import NOTHING_SAID, LaneSurfaces
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
    scene: Integers
    """number of the scene that they are in"""
    surfaces: LaneSurfaces

    @classmethod
    def of(
        cls, scenes: Sequence[Scene], road: Integers, has_route: Booleans,
        surfaces: Sequence[TireSurface],
    ) -> Patches:  # fmt: skip
        """`road`: of each agent, -1 for none; `surfaces`: of their roads."""
        slots = len(road) // len(scenes)
        patched = np.zeros(len(road), dtype=bool)
        for number, scene in enumerate(scenes):
            rows = slice(number * slots, (number + 1) * slots)
            if any(one.surface_patches for one in scene.roads):
                on = np.array([bool(one.surface_patches) for one in scene.roads] + [False])
                patched[rows] = on[road[rows]] | has_route[rows]
        rolling = np.array([surface.rolling for surface in surfaces])
        of_lanes = LaneSurfaces.of(scenes if patched.any() else ())
        return cls(patched, rolling, np.arange(len(road)) // max(slots, 1), of_lanes)

    def take(self, agents: Integers) -> Patches:
        """Those of some agents."""
        rows = self.patched[agents], self.rolling[agents], self.scene[agents]
        return Patches(*rows, self.surfaces)

    def below(
        self, own: Bodies, mixed: Bodies, motion: Motion, table: RouteTable, present: Booleans,
        has_route: Booleans,
    ) -> Bodies:  # fmt: skip
        """`mixed` bodies with what these stretches change; `own` are those on the road that each
        agent begins on."""
        if self.is_empty:
            return mixed
        rows = np.flatnonzero(self.patched & present & ~own.walks)
        place = table.place(rows, motion.along[rows])
        on_road = place.turn < 0
        rows, station = rows[on_road], place.station[on_road]
        lanes = self.surfaces.at(self.surfaces.first[self.scene[rows]] + place.road[on_road])
        reach = own.half_base[rows] + own.width[rows]
        near = np.flatnonzero(~lanes.is_plain(station, reach, has_route[rows]))
        if not len(near):
            return mixed
        rows, station, lanes = rows[near], station[near], lanes.take(near)
        direction = place.direction[on_road][near]
        line = np.zeros(len(rows))
        routed = np.flatnonzero(has_route[rows])
        if len(routed):
            lane = place.lane[on_road][near][routed]
            line[routed] = lanes.take(routed).middle(lane, station[routed])
        ahead, left = _wheels(own, motion, rows)
        said = lanes.surface(station + direction * ahead, line + direction * left)
        return self._on(said, rows, own, mixed)

    def _on(self, said: Integers, rows: Integers, own: Bodies, mixed: Bodies) -> Bodies:
        """Bodies whose wheels (W, R) of agents `rows` are on surfaces with these numbers."""
        tires = self.surfaces.tires[self.scene[rows], said]
        begun = np.stack((own.friction[rows], self.rolling[rows]), axis=-1)
        more = np.zeros((len(rows), 2))
        for wheel, surface in enumerate(said):
            share = (tires[wheel] - begun) / len(WHEELS)
            more = more + np.where((surface == NOTHING_SAID)[:, None], 0.0, share)
        changed = more.any(axis=1)
        rows, more = rows[changed], more[changed]
        friction = mixed.friction[rows] + more[:, 0]
        return mixed.on_ground(rows, friction, mixed.rolling[rows] + GRAVITY * more[:, 1])

    @cached_property
    def is_empty(self) -> bool:
        """Whether no agent can come to any."""
        return not self.patched.any()


def _wheels(bodies: Bodies, motion: Motion, agents: Integers) -> tuple[Floats, Floats]:
    """(4, R) how far ahead of the foot point and left of the line the wheels of agents are."""
    cosine, sine = motion.cosine[agents], motion.sine[agents]
    half_base, offset = bodies.half_base[agents], motion.offset[agents]
    half_track = 0.5 * np.maximum(bodies.width[agents] - TIRE, 0.0)
    i, j = np.array(WHEELS).T[:, :, None]
    ahead = i * half_base * cosine - j * half_track * sine
    return ahead, offset + i * half_base * sine + j * half_track * cosine
