"""The objects of the scenes of a world, for the agents that pass them."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ...geometry.arrays import Floats, Integers
from ...ir.scene import SceneActor
from ..state.world import World
from .levels import on_level_of_line

_NUMBERS = ("x", "y", "heading", "length", "width")
_WORDS = ("name", "kind")


@dataclass
class StandingObjects:
    """The objects of scenes, and where they are along the lines of agents: found once for each
    line."""

    count: int = 0
    """K, the most objects of a scene"""
    _found: dict[int, tuple[Floats, Floats]] = field(default_factory=dict)
    _scenes: tuple[Any, ...] | None = None  # those that the columns are of
    _columns: dict[str, Any] = field(default_factory=dict)

    @classmethod
    def of(cls, world: World) -> StandingObjects:
        """Of the scenes of a world."""
        return cls(max((len(scene.objects) for scene in world.scenes), default=0))

    def columns(self, world: World, agents: Integers) -> dict[str, Any]:
        """(N, K) what the records of the objects beside agents say; NaN and empty for none."""
        if self._scenes is not world.scenes:
            self._scenes = world.scenes
            self._columns = {name: self._column(name, "", object) for name in _WORDS}
            self._columns |= {name: self._column(name, math.nan, np.float64) for name in _NUMBERS}
        scene = agents // world.slots
        return {name: column[scene] for name, column in self._columns.items()}

    def _column(self, name: str, default: Any, kind: Any) -> Any:
        assert self._scenes is not None
        out = np.full((len(self._scenes), self.count), default, dtype=kind)
        for row, scene in enumerate(self._scenes):
            out[row, : len(scene.objects)] = [getattr(record, name) for record in scene.objects]
        return out

    def places(self, world: World, agents: Integers) -> tuple[Floats, Floats]:
        """(N, K) arc length along the lines of agents, and how far left of them; NaN for none."""
        along = np.full((len(agents), self.count), math.nan)
        left = along.copy()
        for number, agent in enumerate(agents):
            objects = world.scenes[agent // world.slots].objects
            if not objects or not world.filled[agent]:
                continue
            row = int(world.track.row[agent])
            if row not in self._found:
                self._found[row] = _on_line(world, row, objects)
            found = self._found[row]
            along[number, : len(objects)], left[number, : len(objects)] = found
        return along, left


def _on_line(world: World, row: int, objects: tuple[SceneActor, ...]) -> tuple[Floats, Floats]:
    """(K,) the places of objects on one line: at its nearest node, and straight on from there."""
    lines = world.track.lines
    start = row * lines.cells
    stop = start + int(lines.last[row]) + 1
    x, y = (np.array([getattr(actor, name) for actor in objects], dtype=float) for name in "xy")
    off_x, off_y = x[:, None] - lines.x[start:stop], y[:, None] - lines.y[start:stop]
    cell = (off_x * off_x + off_y * off_y).argmin(axis=1)
    heading = lines.heading[start + cell]
    cosine, sine = np.cos(heading), np.sin(heading)
    chosen = np.arange(len(objects)), cell
    beyond = cosine * off_x[chosen] + sine * off_y[chosen]
    left = cosine * off_y[chosen] - sine * off_x[chosen]
    along = lines.origin[row] + cell * lines.spacing[row] + beyond
    here = on_level_of_line(world, row, objects)
    return np.where(here, along, math.nan), np.where(here, left, math.nan)
