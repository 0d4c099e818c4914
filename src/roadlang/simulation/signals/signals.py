"""Drive signals of a world as it is now: what `when:` and `while:` speak of.

Their formulas are those of the kinds, which measure traces as well.
"""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields, replace
from typing import Any

import numpy as np

from ...diagnostics import DiagnosticError
from ...geometry.arrays import Floats, Integers, inverse_index
from ...ir.road_heights import standing_trace
from ...ir.scene import Scene
from ...ir.trace import AgentTrace, Trace
from ...plugins.drive_signals import drive_signal_kind, drive_signal_values, named_entities
from ...plugins.guard import wrong_result
from ...plugins.registry import KindEntry
from ..state.world import World
from .conditions import unsupported
from .pending_samples import PendingSamples
from .samples import Samples

AnySamples = Samples | PendingSamples


class AgentsNow:
    """R agents of as many scenes, with the members of an `AgentTrace` as columns (K, R)."""

    def __init__(self, samples: AnySamples, agents: Integers, depth: int) -> None:
        self._samples, self._agents, self._depth = samples, agents, depth
        self.time = samples.time(depth)

    def __getattr__(self, name: str) -> Floats:
        if name not in _MEMBERS:
            raise AttributeError(name)
        return self._samples.column(name, self._agents, self._depth)


class ObjectsNow:
    """R objects of as many scenes, as `AgentsNow`."""

    def __init__(self, rows: Sequence[AgentTrace], time: Floats) -> None:
        self._rows = rows
        self.time = time

    def __getattr__(self, name: str) -> Floats:
        if name not in _MEMBERS:
            raise AttributeError(name)
        first = [np.ravel(getattr(row, name))[0] for row in self._rows]
        if name in ("length", "width"):
            return np.array(first)
        return np.tile(np.array(first), (len(self.time), 1))


_MEMBERS = frozenset(
    field.name for field in fields(AgentTrace) if field.name not in ("name", "time")
)


@dataclass(frozen=True)
class _Part:
    """Rows whose scenes have what the signal names at the same places of their lists."""

    rows: Integers
    scenes: Integers
    places: Mapping[str, tuple[int, ...]]
    """of each option that names agents or objects: their places, objects after `World.slots`"""
    options: Mapping[str, Any]
    objects: Mapping[int, tuple[AgentTrace, ...]]
    """by place: that of each scene"""

    def chosen(self, index: Integers) -> _Part:
        """Some of its rows."""
        objects = {at: tuple(some[i] for i in index) for at, some in self.objects.items()}
        return replace(self, rows=self.rows[index], scenes=self.scenes[index], objects=objects)


@dataclass(frozen=True)
class _Measured:
    """What a signal was measured of the last time, which is often the same again."""

    part: _Part
    samples: AnySamples
    trace: Trace
    options: Mapping[str, Any]

    def is_of(self, part: _Part, samples: AnySamples, time: Floats) -> bool:
        """Whether these are the very same."""
        return self.part is part and self.samples is samples and self.trace.time is time


def _standing(scene: Scene, place: int) -> AgentTrace:
    return standing_trace(scene, scene.standing[place], np.zeros(1))


class SignalCall:
    """One signal of a condition for R agents, which may be in different scenes.

    `calls` (R,) name the same kind; agents and objects are found by name in the scene of each. Of a
    group, a signal of one agent is that of its first, one of a pair has all of them.
    """

    def __init__(
        self,
        calls: Sequence[Mapping[str, Any]],
        scenes: Sequence[int],
        world: World,
        signals: Mapping[str, KindEntry],
    ) -> None:
        kind = str(calls[0]["kind"])
        if kind not in signals:
            raise unsupported(kind)
        self._entry = signals[kind]
        found_kind = drive_signal_kind(self._entry)
        self._is_member = found_kind.member
        self.looks_back = float(found_kind.looks_back)
        """how many samples before the last it depends on"""
        self._known: _Measured | None = None
        self._slots = world.slots
        self._count = len(calls)
        self.failed = np.zeros(len(calls), dtype=bool)
        found: dict[str, list[int]] = {}
        places = [
            self._places(call, world.scenes[scene])
            for call, scene in zip(calls, scenes, strict=True)
        ]
        for row, (call, place) in enumerate(zip(calls, places, strict=True)):
            key = json.dumps([place, call.get("options", {})], sort_keys=True)
            found.setdefault(key, []).append(row)
        self._parts = []
        for rows in found.values():
            options = dict(calls[rows[0]].get("options", {}))
            within = np.array([scenes[row] for row in rows], dtype=np.int64)
            actors = places[rows[0]]
            objects = {
                place: tuple(
                    _standing(world.scenes[scene], place - self._slots) for scene in within
                )
                for place in {place for named in actors.values() for place in named}
                if place >= self._slots
            }
            self._parts.append(_Part(np.array(rows), within, actors, options, objects))
        self._is_one = len(self._parts) == 1
        """whether there is one part, of all rows in their order"""

    def values(self, samples: Samples) -> Floats:
        """(R,) the signal now. Raises RL470, RL474."""
        is_recent = not math.isinf(self.looks_back)
        if is_recent and self._is_one:
            (part,) = self._parts
            last: Floats = self._together(part, samples, int(self.looks_back))[-1]
            return last
        out = np.empty(self._count)
        for part in self._parts:
            if not is_recent:
                out[part.rows] = [self._alone(part, int(scene), samples) for scene in part.scenes]
            else:
                out[part.rows] = self._together(part, samples, int(self.looks_back))[-1]
        return out

    def at_once(self, samples: PendingSamples, count: int) -> Floats:
        """(K, R) the signal, which looks at one sample alone, at the last `count` samples. Raises
        RL470, RL474."""
        out = np.full((count, self._count), math.nan)
        for part in self._parts:
            out[:, part.rows] = self._together(part, samples, count - 1)
        return out

    def known_values(self, samples: PendingSamples) -> Floats:
        """(R,) the same, but NaN for agents in whose scenes the kind has failed, now or before: see
        `failed` (R,). A failure in one scene does not affect the others."""
        out = np.full(self._count, math.nan)
        parts, self._parts, self._is_one = self._parts, [], False
        for part in parts:
            try:
                out[part.rows] = self._together(part, samples, 0)[-1]
            except DiagnosticError:
                part = self._without_failures(part, samples, out)
            if len(part.rows):
                self._parts.append(part)
        return out

    def _without_failures(self, part: _Part, samples: PendingSamples, out: Floats) -> _Part:
        """The rows of a part that can be evaluated by themselves; their values go to `out`."""
        for index, row in enumerate(part.rows.tolist()):
            alone = part.chosen(np.array([index]))
            try:
                out[row] = self._together(alone, samples, 0)[-1, 0]
            except DiagnosticError:
                self.failed[row] = True
        return part.chosen(np.flatnonzero(~self.failed[part.rows]))

    def take(self, rows: Integers, agents: Integers, count: int) -> None:
        """From now on it is about `rows` of its agents alone; of the `count` agents of the world
        there are those that are `agents`."""
        place = inverse_index(agents, count)
        number = inverse_index(rows, self._count)
        chosen = [part.chosen(np.flatnonzero(number[part.rows] >= 0)) for part in self._parts]
        self._parts = [
            replace(
                part,
                rows=number[part.rows],
                scenes=place[part.scenes * self._slots] // self._slots,
            )
            for part in chosen
            if len(part.rows)
        ]
        self._count, self.failed, self._is_one = len(rows), self.failed[rows], False

    def _places(self, call: Mapping[str, Any], scene: Scene) -> dict[str, tuple[int, ...]]:
        """Where in the lists of a scene the things are that the options name."""
        is_member = self._is_member
        out = {}
        for option, name in named_entities(self._entry, call.get("options", {})).items():
            actors = [*enumerate(scene.agents), *enumerate(scene.standing, self._slots)]
            places = tuple(at for at, actor in actors if name in (actor.name, actor.group))
            if not places:
                raise unsupported(str(call["kind"]))
            out[option] = places[:1] if is_member else places
        return out

    def _together(self, part: _Part, samples: AnySamples, depth: int) -> Floats:
        """(K, R) of rows at once."""
        time, known = samples.time(depth), self._known
        if known is None or not known.is_of(part, samples, time):
            options = self._options(part, samples, depth, time)
            known = self._known = _Measured(part, samples, Trace(time, {}), options)
        found = drive_signal_values(self._entry, known.options, known.trace)
        shape = (len(time), len(part.rows))
        if found.shape == time.shape:
            return np.broadcast_to(found[:, None], shape)
        if found.shape != shape:
            raise wrong_result(
                self._entry, None, f"gave values of shape {found.shape}, not {shape}"
            )
        return found

    def _options(
        self, part: _Part, samples: AnySamples, depth: int, time: Floats
    ) -> dict[str, Any]:
        """The options of the kind, of which some are agents and objects."""
        now = {
            place: ObjectsNow(part.objects[place], time)
            if place >= self._slots
            else AgentsNow(samples, part.scenes * self._slots + place, depth)
            for place in sorted({place for some in part.places.values() for place in some})
        }
        named: dict[str, Any] = {
            key: tuple(now[place] for place in some) for key, some in part.places.items()
        }
        if self._is_member:
            named = {key: some[0] for key, some in named.items()}
        return {**part.options, **named}

    def _alone(self, part: _Part, scene: int, samples: Samples) -> float:
        """Of one scene, by all that has happened in it."""
        trace = samples.trace(scene)
        is_member = self._is_member
        named: dict[str, Any] = {key: trace.named(str(part.options[key])) for key in part.places}
        if is_member:
            named = {key: some[0] for key, some in named.items()}
        found = drive_signal_values(self._entry, {**part.options, **named}, trace)
        if found.shape != trace.time.shape:
            fault = f"gave values of shape {found.shape}, not {trace.time.shape}"
            raise wrong_result(self._entry, None, fault)
        return float(found[-1])
