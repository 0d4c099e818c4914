"""A scene that another engine moves, as the embedded engine sees and records it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from ..geometry.arrays import Booleans, Floats, Integers
from ..ir.control import Control, ControlBatch
from ..ir.observation import Observation
from ..ir.scene import Scene
from ..ir.trace import Trace
from ..plugins.kinds import Controller
from .building.carried_state import Continued, carry_world, same_network
from .building.world_building import world_of
from .calling.controllers import Driver
from .calling.decision import Decision
from .controlling.driving import DriverGroup
from .observing.sensing import DueReading
from .observing.single_agents import OthersSeen, observations
from .recording.recording import Recorder
from .state.held_controls import limited
from .surroundings.contacts import Contact
from .vehicles.bodies import Body
from .vehicles.poses import Poses


class Mirror:
    """A scene that another engine drives, step by step. The mirror makes the decisions of the
    agents (conditions, paths, lanes, neighbors, right of way) and records a trace with all columns,
    by the same code as the embedded engine.

    `controllers`: of the agents that are to be decided for; those of scenes are `Driver`s, any
    other decides by its method `control`. `step`: seconds between decisions; `bodies`: properties
    of the kinds of agents, by name. Columns are in the order of the agents of the scene.
    """

    def __init__(
        self,
        scene: Scene,
        controllers: Mapping[str, Controller],
        step: float,
        bodies: Mapping[str, Body] | None = None,
    ) -> None:
        drivers = {
            name: driver for name, driver in controllers.items() if isinstance(driver, Driver)
        }
        agents = tuple(
            actor if actor.name in drivers else replace(actor, drive=()) for actor in scene.agents
        )
        self._names = [actor.name for actor in agents]
        self._alone = {
            row: controllers[name]
            for row, name in enumerate(self._names)
            if name in controllers and name not in drivers
        }
        self.driven: Integers = np.array(
            [row for row, name in enumerate(self._names) if name in controllers], dtype=np.int64
        )
        """the agents that are decided for"""
        self._world = world_of([replace(scene, agents=agents)], bodies or {}, step, step)
        self._world.heights = None  # the ground of other engines is level
        self._drivers = DriverGroup(self._world, [drivers], step)
        self._recorder = Recorder(self._world)
        self._known: Poses | None = None

    @property
    def _poses(self) -> Poses:
        """Of all agents, looked up once between two calls of `follow`."""
        if self._known is None:
            self._known = self._world.poses
        return self._known

    @property
    def time(self) -> float:
        """Seconds since the start."""
        return self._world.time

    @property
    def present(self) -> Booleans:
        """(N,) whether the agent has not yet left the scene at the end of its path."""
        return self._world.present

    @property
    def finished(self) -> bool:
        """Whether all agents with a road have arrived."""
        return bool(self._world.finished[0])

    def follow(self, pose: Floats, steering: Floats, *, passed: bool) -> None:
        """Set the state of all agents: `pose` (N, 4) x, y, heading, speed; `steering` (N,).
        `passed`: whether a step has passed since the last call."""
        self._world.follow(pose, steering, self._poses, passed=passed)
        self._known = None

    def carry_on(self, before: Mirror, restarted: frozenset[str] = frozenset()) -> None:
        """Continue the drive of another mirror, whose scene was edited. Agents of both scenes keep
        pose, speed and counts, projected onto their paths, and the state of their conditions and
        controllers. Agents or groups in `restarted` start again.
        """
        rows = Continued.of(before._world, self._world, restarted)
        carry_world(before._world, self._world, rows)
        self._known = None
        self._drivers.carry_on(before._drivers, rows, same_network(before._world, self._world))
        self.forget()

    def forget(self) -> None:
        """Discard the trace recorded so far."""
        self._recorder = Recorder(self._world)

    def touch(self, contact: Contact) -> None:
        """Record the first contact of an agent with something."""
        self._world.contacts[contact.agent] += 1.0
        hardest = max(self._world.collision[contact.agent], contact.speed)
        self._world.collision[contact.agent] = hardest
        self._recorder.note(self._world, [contact])

    def record(self) -> None:
        """One sample of the trace: all agents as they are now."""
        self._recorder.record(self._world, self._poses)

    def trace(self, engine: str) -> Trace:
        """The recorded trace, with this name of the engine."""
        return replace(self._recorder.traces()[0], engine=engine)

    def due_readings(self) -> list[DueReading]:
        """What the engine has to measure now, and `deliver` before the next `decide`: the readings
        of sensors whose kinds do not compute them."""
        if self._drivers.sensing is None:
            return []
        return self._drivers.sensing.due(self._drivers.truth(self._world, self._poses))

    def deliver(self, agent: str, sensor: str, arrays: Mapping[str, ArrayLike]) -> None:
        """Pass in what the engine measured. Raises RL474 for arrays of another shape."""
        assert self._drivers.sensing is not None, "it was due"
        self._drivers.sensing.deliver(self._names.index(agent), sensor, arrays)

    def decide(self) -> Decision:
        """What all agents are to do until the next step; that of those that are not `driven`
        means nothing. At the end of their roads, agents brake.

        Raises RL470, RL474 of controllers, RL513 of conditions.
        """
        world = self._world
        decision = self._drivers.decide(world, self._poses)
        if self._alone:
            rows, found = self._decided_alone()
            decision.put(rows, found)
        self._recorder.note_failures(world, decision.failures)
        return replace(decision, acceleration=limited(world, decision.acceleration))

    def limited(self, acceleration: Floats) -> Floats:
        """(N,) accelerations; at the end of their roads, agents brake."""
        return limited(self._world, acceleration)

    def seen(self, name: str) -> Observation:
        """The current observation of an agent."""
        view = self._drivers.view(self._world, self._poses)
        return observations(view, np.array([self._names.index(name)]))[0]

    def _decided_alone(self) -> tuple[Integers, ControlBatch]:
        view = self._drivers.view(self._world, self._poses)
        rows = np.array(list(self._alone), dtype=np.int64)
        others = OthersSeen(view, self._world.scenes[0], 0)
        found: Sequence[Control] = [
            controller.control(seen)
            for controller, seen in zip(
                self._alone.values(), observations(view, rows, others), strict=True
            )
        ]
        return rows, ControlBatch.of(found)
