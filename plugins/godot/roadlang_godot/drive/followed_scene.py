"""A scene in the engine as Python sees it: what agents are to do is decided here, and recorded."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from roadlang.api import Contact, Mirror
from roadlang_standard.engine_tables import BODIES

from ..build.agent_specs import AgentPose
from ..build.drives import is_walker
from ..build.layout import Layout
from ..net.telemetry import HAND, DriveState, Records
from ..sensors.eyes import Eyes
from .driving import ControlForm, EngineControl

if TYPE_CHECKING:
    from roadlang.api import Controller, Decision, Observation, Scene, Trace


class FollowedScene:
    """Turns what the engine reports into what controllers see, and into a trace.

    `controllers`: of the agents that Python drives; `step`: seconds from one report to the next;
    `rate`: physics ticks a second; `eyes`: the cameras of the scene, where it has any.
    """

    def __init__(
        self,
        scene: Scene,
        layout: Layout,
        step: float,
        rate: float,
        controllers: Mapping[str, Controller] | None = None,
        eyes: Eyes | None = None,
    ) -> None:
        self._layout = layout
        self._rate = rate
        self._eyes = eyes
        self._mirror = Mirror(scene, controllers or {}, step, BODIES)
        self._names = [actor.name for actor in scene.agents]
        self._walks = [is_walker(actor) for actor in scene.agents]
        self._numbers = [layout.agents[name] for name in self._names]
        # The engine reports agents in the order of their numbers.
        place = np.argsort(np.argsort(self._numbers))
        self._place = None if (place == np.arange(len(place))).all() else place
        self._tick = -1
        self._seen: tuple[list[str], NDArray[np.float64]] | None = None
        """agents, and x, y, heading and speed of each when they were seen last"""
        self._hands: Records = np.empty(0, HAND)
        self._inputs: dict[str, list[tuple[float, float, float]]] = {}

    def carry_on(self, before: FollowedScene, restarted: frozenset[str]) -> None:
        """Go on with the drive of the scene before an edit, but for agents that are `restarted`."""
        self._mirror.carry_on(before._mirror, restarted)
        self._tick = before._tick
        self._seen = before._seen

    def forget(self) -> None:
        """The trace begins now."""
        self._mirror.forget()
        self._inputs.clear()

    def pose(self, name: str) -> AgentPose | None:
        """Where an agent was seen last; None before the first look."""
        if self._seen is None or name not in self._seen[0]:
            return None
        names, poses = self._seen
        return AgentPose(*poses[names.index(name)].tolist())

    @property
    def finished(self) -> bool:
        """Whether all agents with a road have arrived."""
        return self._mirror.finished

    def look(self, state: DriveState) -> None:
        """The agents are where a state says; it becomes a sample of the trace."""
        self._look(state.tick, state.poses, state.contacts)
        self._hands = state.hands

    def look_at_records(self, rows: Records, contacts: Records) -> None:
        """The same of the records of one tick, in the order of the numbers of agents."""
        self._look(int(rows["tick"][0]), rows, contacts)

    def controls(self) -> dict[int, EngineControl]:
        """The decisions of all controllers, as the engine takes them.

        Raises RL470, RL474 of controllers, RL508 where cameras have no screen, RL513 of
        conditions.
        """
        by_hand = {int(hand["agent"]): self._by_hand(hand) for hand in self._hands}
        if not len(self._mirror.driven):
            return by_hand
        self._take_pictures()
        decision = self._mirror.decide()
        return by_hand | {
            self._numbers[row]: self._engine_control(row, decision) for row in self._mirror.driven
        }

    def _take_pictures(self) -> None:
        """What cameras see now, where controllers are to get it."""
        due = self._mirror.due_readings()
        if self._eyes is None or not due:
            return
        for reading, arrays in self._eyes.readings(due, self._mirror.time):
            self._mirror.deliver(reading.agent, reading.sensor.name, arrays)

    def seen(self, name: str) -> Observation:
        """What an agent sees now."""
        return self._mirror.seen(name)

    def trace(self, engine: str) -> Trace:
        """What was recorded."""
        inputs = {name: np.array(rows) for name, rows in self._inputs.items()}
        return replace(self._mirror.trace(engine), inputs=inputs)

    def _by_hand(self, hand: Any) -> EngineControl:
        """What a human wants is done in the next step, and recorded."""
        row = self._numbers.index(int(hand["agent"]))
        wanted = np.full(len(self._numbers), float(hand["acceleration"]))
        steering, acceleration = float(hand["steering"]), float(self._mirror.limited(wanted)[row])
        rows = self._inputs.setdefault(self._names[row], [])
        rows.append((self._mirror.time, steering, acceleration))
        present = bool(self._mirror.present[row])
        form = ControlForm.STEER if present else ControlForm.LEAVE
        return EngineControl(form, (0.0, 0.0, steering, acceleration))

    def _look(self, tick: int, rows: Records, contacts: Records) -> None:
        frame = self._layout.frame
        if self._place is not None:
            rows = rows[self._place]
        pose = np.empty((len(rows), 4))
        pose[:, 0] = rows["x"]
        pose[:, 1] = rows["y"]
        pose[:, 2] = rows["heading"]
        pose[:, 3] = rows["speed"]
        pose[:, 0] += frame.x
        pose[:, 1] += frame.y
        self._seen = self._names, pose
        steering = rows["steering"].astype(np.float64)
        self._mirror.follow(pose, steering, passed=0 <= self._tick < tick)
        self._tick = tick
        for contact in contacts:
            self._touch(contact)
        self._mirror.record()

    def _touch(self, contact: Any) -> None:
        """A contact is one of both agents."""
        row = self._numbers.index(int(contact["agent"]))
        time, speed = int(contact["tick"]) / self._rate, float(contact["speed"])
        index = int(contact["index"])
        if index >= 0:
            name = self._layout.objects[int(contact["other"])][index]
            self._mirror.touch(Contact(time, row, -1, name, speed))
            return
        other = self._numbers.index(int(contact["other"]))
        self._mirror.touch(Contact(time, row, other, self._names[other], speed))
        self._mirror.touch(Contact(time, other, row, self._names[row], speed))

    def _engine_control(self, row: int, decision: Decision) -> EngineControl:
        steering = float(decision.steering[row])
        acceleration = float(decision.acceleration[row])
        if not self._mirror.present[row]:
            return EngineControl(ControlForm.LEAVE, (0.0, 0.0, steering, acceleration))
        pose = decision.pose
        if pose is not None and math.isfinite(pose[row, 0]):
            frame = self._layout.frame
            x, y, heading, speed = pose[row].tolist()
            heading = math.remainder(heading, math.tau)
            return EngineControl(ControlForm.POSE, (x - frame.x, y - frame.y, heading, speed))
        if self._walks[row] and decision.heading is not None:
            heading = float(decision.heading[row])
            if math.isfinite(heading):
                heading = math.remainder(heading, math.tau)
                return EngineControl(ControlForm.FACE, (0.0, 0.0, heading, acceleration))
        return EngineControl.steer(steering, acceleration)
