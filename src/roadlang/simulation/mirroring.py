"""Controllers in charge of agents that another engine moves: a world that follows what it says."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from ..geometry.arrays import Floats
from ..ir.control import Control, Observation
from ..ir.scene import Scene
from ..plugins.kinds import Controller
from .bodies import Body
from .controllers import Driver
from .driving import Crew
from .observing import Surroundings, View
from .world_building import world_of


class Mirror:
    """A scene that another engine drives, step by step, as controllers of the embedded engine see
    it: with conditions, lines that move, lanes and neighbors.

    `controllers`: of the agents that are to be decided for; those of scenes are `Driver`s, any
    other decides by its method `control`. `step`: seconds between decisions; `bodies`: what kinds
    of agents are, by name.
    """

    def __init__(
        self,
        scene: Scene,
        controllers: Mapping[str, Controller],
        step: float,
        bodies: Mapping[str, Body] | None = None,
    ) -> None:
        drivers = {name: one for name, one in controllers.items() if isinstance(one, Driver)}
        agents = tuple(
            actor if actor.name in drivers else replace(actor, drive=()) for actor in scene.agents
        )
        self._names = [actor.name for actor in agents]
        self._driven = [number for number, one in enumerate(agents) if one.name in drivers]
        self._alone = {name: one for name, one in controllers.items() if name not in drivers}
        self._step = step
        self._world = world_of([replace(scene, agents=agents)], bodies or {}, step, step)
        self._crew = Crew(self._world, [drivers], step)
        self._surroundings = Surroundings(self._world)

    def follow(self, pose: Floats, steering: Floats, contacts: Floats, *, passed: bool) -> None:
        """Where all agents are, in the order of the scene: `pose` (N, 4) x, y, heading, speed.
        `passed`: whether a step has passed since the last call."""
        self._world.follow(pose, steering, contacts, passed=passed)

    def decide(self) -> dict[str, Control]:
        """What the agents with controllers are to do until the next step.

        Raises RL470, RL474 of controllers, RL513 of conditions.
        """
        decision = self._crew.decide(self._world, self._world.poses)
        out = {self._names[number]: decision.single(number) for number in self._driven}
        if self._alone:
            others = {name: self.seen(name) for name in self._names}
            for name, controller in self._alone.items():
                out[name] = controller.control(replace(others[name], others=others))
        return out

    def seen(self, name: str) -> Observation:
        """What an agent sees now."""
        view = View(self._world, self._world.poses, self._step, self._surroundings)
        return view.single(self._names.index(name))
