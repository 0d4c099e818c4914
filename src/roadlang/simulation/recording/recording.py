"""What is recorded of drives, and the traces of scenes that are made of it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from ...geometry.arrays import Booleans, Integers, inverse_index
from ...ir.controller_failure import ControllerFailure
from ...ir.road_heights import standing_trace
from ...ir.scene import Scene
from ...ir.trace import AgentTrace, Trace
from ..signals.lane_reader import LaneReader
from ..signals.recorded_columns import RecordedAgent, RecordedPart
from ..signals.recorded_samples import RECORDED, RecordedSample
from ..state.world import World
from ..surroundings.contacts import Contact
from ..vehicles.poses import Poses
from .later_samples import LaterSamples, columns_now
from .violations import ViolationWatch

ENGINE = "the embedded engine"
_NO_SAMPLE = RecordedSample(np.zeros((len(RECORDED), 0)))


class Recorder:
    """Samples of all agents of a block of scenes. Scenes may end at different times."""

    def __init__(self, world: World, watch: ViolationWatch | None = None) -> None:
        self._watch = watch
        self._scenes = scenes = world.scenes
        self._lanes = LaneReader(world)
        self._slots = world.slots
        self._times: list[float] = []
        self._samples: list[RecordedSample] = []
        self._later = LaterSamples()
        self._parts: dict[int, list[tuple[RecordedPart, int]]] = {
            row: [] for row in range(len(scenes))
        }
        self._rows = np.arange(len(scenes))
        self._over = np.zeros(len(scenes), dtype=bool)
        self.going_on: Integers = np.arange(len(scenes))
        """which scenes of the world have not ended yet"""
        self._axis = np.zeros(0)
        self._ends: dict[int, int] = {}
        self._events: dict[int, list[dict[str, Any]]] = {}

    def record(self, world: World, poses: Poses) -> None:
        """One sample of all scenes; a scene in which all have arrived ends with it, and one that
        has violated all that is expected of it for long enough."""
        sample = np.empty((len(RECORDED), len(world.present)))
        for place, column in enumerate(columns_now(world, poses)):
            sample[place] = column
        self.add(world.time, RecordedSample(sample), world.finished)

    def record_later(self, world: World) -> None:
        """The same as `record`, of a copy of the world whose motion and columns are not changed any
        more: for many times together, where nobody looks at samples before the end."""
        looks = self._watch is not None and not self._watch.is_idle
        if looks or world.followed.guided:
            self.record(world, world.poses)
            return
        self._later.add(len(self._samples), world)
        self.add(world.time, _NO_SAMPLE, world.finished)
        if self._later.is_full:
            self._later.fill(self._samples)

    def add_all(
        self, times: Sequence[float], samples: Sequence[RecordedSample], finished: Booleans
    ) -> None:
        """The same as `add` for several times, `finished` (T, S)."""
        looks = self._watch is not None and not self._watch.is_idle
        if looks or finished.any():
            for one in zip(times, samples, finished, strict=True):
                self.add(*one)
        else:
            self._times += times
            self._samples += samples

    def add(self, time: float, sample: RecordedSample, finished: Booleans) -> None:
        """The same: `finished` (S,): scenes in which all have arrived."""
        self._times.append(time)
        self._samples.append(sample)
        done = None if self._watch is None else self._watch.done(time, sample)
        ended = (finished if done is None else finished | done) & ~self._over
        if np.count_nonzero(ended):
            self._over |= ended
            self._ends |= dict.fromkeys(self._rows[ended].tolist(), len(self._times))
            self.going_on = np.flatnonzero(~self._over)

    def note(self, world: World, contacts: list[Contact]) -> None:
        """Contacts, as events of their scenes."""
        for contact in contacts:
            actor = world.actors[contact.agent]
            event = {
                "time": contact.time,
                "event": "contact",
                "agent": actor.name if actor is not None else "",
                "other": contact.name,
                "speed": contact.speed,
            }
            row = int(self._rows[contact.agent // self._slots])
            self._events.setdefault(row, []).append(event)

    def note_failures(self, world: World, failures: Mapping[int, str]) -> None:
        """Controllers that fail from now on, by agent, as events of their scenes."""
        for agent, reason in failures.items():
            actor = world.actors[agent]
            assert actor is not None, "somebody has decided for it"
            event = ControllerFailure(actor.name, world.time, reason).event
            self._events.setdefault(int(self._rows[agent // self._slots]), []).append(event)

    def go_on_with(self, rows: Integers, agents: Integers, count: int) -> None:
        """Of the scenes that went on, only these still do, with these of `count` agents."""
        self._close()
        if self._watch is not None:
            self._watch.take(rows, inverse_index(agents, count), agents)
        self._rows, self._over = self._rows[rows], self._over[rows]
        self.going_on = np.flatnonzero(~self._over)

    def traces(self) -> list[Trace]:
        """The trace of each scene."""
        self._close()
        self._axis = np.array(self._times)
        self._axis.flags.writeable = False
        return [self._trace(row, scene) for row, scene in enumerate(self._scenes)]

    def _close(self) -> None:
        """The scenes that went on until now do not all go on."""
        if not self._samples:
            return
        self._later.fill(self._samples)
        agents = (self._rows[:, None] * self._slots + np.arange(self._slots)).ravel()
        part = RecordedPart(self._samples, agents, self._lanes)
        self._samples = []
        for place, row in enumerate(self._rows.tolist()):
            self._parts[row].append((part, place * self._slots))

    def _trace(self, row: int, scene: Scene) -> Trace:
        parts = self._parts[row]
        recorded = sum(part.count for part, _ in parts)
        time = self._axis[: min(self._ends.get(row, recorded), recorded)]
        agents: dict[str, AgentTrace] = {}
        for slot, actor in enumerate(scene.agents):
            columns = tuple((part, first + slot) for part, first in parts)
            agents[actor.name] = AgentTrace.recorded(actor, time, RecordedAgent(time, columns))
        agents |= {one.name: standing_trace(scene, one, time) for one in scene.standing}
        events = [event for event in self._events.get(row, ()) if event["time"] <= time[-1]]
        events.sort(key=lambda event: (event["time"], event["agent"]))
        return Trace(time=time, agents=agents, engine=ENGINE, events=tuple(events))
