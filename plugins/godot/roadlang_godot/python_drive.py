"""Lets controllers written in Python see the engine's agents, and passes on what they decide."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from roadlang.api import Code, Mirror

from .drives import is_walker
from .faults import fault
from .layout import Layout
from .telemetry import Records

if TYPE_CHECKING:
    from roadlang.api import Control, Controller, Observation, Scene, SceneActor

TURN_TIME = 0.2
"""Seconds in which who is on foot turns to a heading."""
SLOWEST = 0.3
"""m/s: slower, it turns as at this speed."""
WALKER_BASE = 0.5
"""Wheelbase of who is on foot, in the engine."""


class PythonDriver:
    """Turns records into what controllers see. `step` is the time for which a decision holds."""

    def __init__(
        self, scene: Scene, layout: Layout, step: float, controllers: Mapping[str, Controller]
    ) -> None:
        self._layout = layout
        self._actors = {actor.name: actor for actor in scene.agents}
        self._mirror = Mirror(scene, controllers, step)
        self._tick: int | None = None

    def controls(self, state: Records) -> dict[tuple[int, int], tuple[float, float]]:
        """The decisions of all controllers, as the engine takes them.

        Raises `EngineError` RL510 for one that puts an agent somewhere.
        """
        self.look(state)
        out = {}
        for name, control in self._mirror.decide().items():
            actor = self._actors[name]
            if control.pose is not None:
                kind = actor.drive[-1].kind
                raise fault(Code.UNSUPPORTED_CONTROLLER, kind=kind, engine="Godot's project")
            out[(0, self._layout.agents[name])] = self._taken(actor, control)
        return out

    def look(self, state: Records) -> None:
        """The agents are where records say."""
        by_number = {int(row["agent"]): row for row in state}
        rows = [by_number[self._layout.agents[name]] for name in self._actors]
        frame = self._layout.frame
        pose = np.array(
            [(row["x"] + frame.x, row["y"] + frame.y, row["heading"], row["speed"])
             for row in rows], dtype=np.float64,
        )  # fmt: skip
        steering, contacts = (
            np.array([row[name] for row in rows], dtype=np.float64)
            for name in ("steering", "contacts")
        )
        tick = int(rows[0]["tick"])
        passed = self._tick is not None and tick > self._tick
        self._tick = tick
        self._mirror.follow(pose, steering, contacts, passed=passed)

    def seen(self, name: str) -> Observation:
        """What an agent sees now."""
        return self._mirror.seen(name)

    def _taken(self, actor: SceneActor, control: Control) -> tuple[float, float]:
        """Steering angle and acceleration. Who is on foot turns to a heading by steering."""
        if not is_walker(actor) or math.isnan(control.heading):
            return control.steering, control.acceleration
        seen = self._mirror.seen(actor.name)
        turn = math.remainder(control.heading - seen.heading, 2.0 * math.pi)
        pace = max(seen.speed, SLOWEST)
        return math.atan(turn * WALKER_BASE / (pace * TURN_TIME)), control.acceleration
