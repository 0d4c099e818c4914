"""What is recorded of drives, and the traces of scenes that are made of it."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..geometry.arrays import Floats, Integers
from ..ir.scene import Scene, SceneActor
from ..ir.trace import AgentTrace, Trace
from .columns import COLUMNS
from .contacts import Contact
from .lane_columns import LANE_COLUMNS
from .lane_reader import LaneReader
from .poses import Poses
from .world import World

ENGINE = "the embedded engine"
_RECORDED = (
    "x", "y", "heading", "speed", "steering", "station", "cross_track_error", "progress",
    "contacts", "route_progress", "red_light", "collision", "along", "offset",
)  # fmt: skip
"""Those of `COLUMNS` that change, but for the rate of another."""


class Recorder:
    """Samples of all agents of a block of scenes. Scenes may end at different times."""

    def __init__(self, world: World, poses: Poses) -> None:
        self._scenes = scenes = world.scenes
        self._lanes = LaneReader(world)
        self._slots = world.slots
        self._heading = poses.heading
        self._times: list[float] = []
        self._chunk: list[Floats] = []
        self._parts: dict[int, list[Floats]] = {row: [] for row in range(len(scenes))}
        self._rows = np.arange(len(scenes))
        self._over = np.zeros(len(scenes), dtype=bool)
        self._turns = False
        self._axes = np.zeros(0)
        self._ends: dict[int, int] = {}
        self._events: dict[int, list[dict[str, Any]]] = {}

    def record(self, world: World, poses: Poses) -> None:
        """One sample of all scenes; a scene in which all have arrived ends with it."""
        jump = np.abs(poses.heading - self._heading).max(initial=0.0) > np.pi
        self._turns = self._turns or bool(jump)
        self._heading = poses.heading
        self._times.append(world.time)
        self._chunk.append(np.stack([COLUMNS[name](world, poses) for name in _RECORDED]))
        ended = world.finished & ~self._over
        if ended.any():
            self._over |= ended
            self._ends |= dict.fromkeys(self._rows[ended].tolist(), len(self._times))

    @property
    def going_on(self) -> Integers:
        """Which scenes of the world have not ended yet."""
        return np.flatnonzero(~self._over)

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

    def go_on_with(self, kept: Integers, poses: Poses) -> None:
        """Of the scenes that went on, only these still do; `poses`: of their agents, now."""
        self._close()
        self._heading = poses.heading
        self._rows, self._over = self._rows[kept], self._over[kept]

    def traces(self) -> list[Trace]:
        """The trace of each scene."""
        self._close()
        return [self._trace(row, scene) for row, scene in enumerate(self._scenes)]

    def _axis(self, count: int) -> Floats:
        """The first times, as one array for all scenes."""
        if len(self._axes) < len(self._times):
            self._axes = np.array(self._times)
            self._axes.flags.writeable = False
        return self._axes[:count]

    def _close(self) -> None:
        """Turn samples into columns: (scenes, agents, quantities, times)."""
        if not self._chunk:
            return
        samples = np.stack(self._chunk)
        self._chunk = []
        times, quantities, _ = samples.shape
        shaped = samples.reshape(times, quantities, len(self._rows), self._slots)
        columns = np.ascontiguousarray(shaped.transpose(2, 3, 1, 0))
        columns = np.concatenate([columns, self._lane_columns(columns)], axis=2)
        columns.flags.writeable = False
        for row, part in zip(self._rows, columns, strict=True):
            self._parts[int(row)].append(part)

    def _lane_columns(self, columns: Floats) -> Floats:
        """(scenes, agents, `LANE_COLUMNS`, times) of recorded columns of that form."""
        scenes, slots, _, times = columns.shape
        agents = (self._rows[:, None] * slots + np.arange(slots)).ravel()
        known = {
            name: columns[:, :, place].reshape(-1, times) for place, name in enumerate(_RECORDED)
        }
        found = self._lanes.read(agents, known)
        shape = (scenes, slots, times)
        return np.stack([found[name].reshape(shape) for name in LANE_COLUMNS], axis=2)

    def _trace(self, row: int, scene: Scene) -> Trace:
        parts = self._parts[row]
        columns = parts[0] if len(parts) == 1 else np.concatenate(parts, axis=2)
        count = min(self._ends.get(row, len(self._times)), columns.shape[2])
        columns = columns[:, :, :count]
        time = self._axis(count)
        agents = {
            actor.name: _agent(actor, columns[slot], time, self._turns)
            for slot, actor in enumerate(scene.agents)
        }
        if scene.objects:
            agents |= {actor.name: AgentTrace.still(actor, time) for actor in scene.objects}
        events = [event for event in self._events.get(row, ()) if event["time"] <= time[-1]]
        events.sort(key=lambda event: (event["time"], event["agent"]))
        return Trace(time=time, agents=agents, engine=ENGINE, events=tuple(events))


def _agent(actor: SceneActor, columns: Floats, time: Floats, turns: bool) -> AgentTrace:
    """`turns`: whether the heading may jump by a turn."""
    values: dict[str, Floats] = dict(zip((*_RECORDED, *LANE_COLUMNS), columns, strict=True))
    del values["along"], values["offset"]
    heading = values.pop("heading")
    return AgentTrace(
        name=actor.name,
        time=time,
        heading=np.unwrap(heading) if turns else heading,
        acceleration=_rate(values["speed"], time),
        length=actor.length,
        width=actor.width,
        **values,
    )


def _rate(values: Floats, time: Floats) -> Floats:
    """Derivative by central differences, at the ends one-sided."""
    if len(time) < 2:
        return np.zeros(len(time))
    out = np.empty(len(time))
    out[1:-1] = (values[2:] - values[:-2]) / (time[2:] - time[:-2])
    out[0] = (values[1] - values[0]) / (time[1] - time[0])
    out[-1] = (values[-1] - values[-2]) / (time[-1] - time[-2])
    return out
