"""Agents of a world whose sensors of one name are of one kind, measured together."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...geometry.arrays import Booleans, Floats, Integers
from ...ir.batch import BatchRandom, mix, numbered
from ...ir.scene import Scene
from ...ir.sensed_batch import CastRays, SensedBatch, SolidThings
from ...plugins.kinds import Sensor
from .option_columns import columns_of, options_of
from .reading_arrays import Arrays
from .sensors import GuardedSensor

_LOST = 2**31
"""the stream of random numbers that says which readings are lost"""


@dataclass(frozen=True)
class PlacedSensor:
    """A sensor of an agent, which is in the column `row` of a world."""

    row: int
    agent: str
    scene: Scene
    guarded: GuardedSensor

    @property
    def key(self) -> np.uint64:
        """What keys its random numbers."""
        made = self.scene.provenance
        words = (made.seed, made.scene, made.attempt, self.agent, self.guarded.sensor.name)
        digest = hashlib.blake2b(repr(words).encode(), digest_size=8).digest()
        return np.uint64(int.from_bytes(digest, "little"))


@dataclass(frozen=True)
class MeasuringMoment:
    """A moment at which agents measure. Columns are over all agents of the world."""

    time: Floats
    """seconds since the drive of each agent began"""
    steps: Integers
    """decisions since then"""
    step: float
    """seconds between decisions"""
    seen: Callable[[Integers], Any]
    """what some agents see, exactly"""
    rays: Callable[[Integers], CastRays]
    """of some agents"""
    things: Callable[[Integers], SolidThings]
    """around some agents"""


class SensorGroup:
    """The sensors of one name and kind, and what they have measured: rings of readings, of as many
    as may be on their way at once."""

    def __init__(self, members: Sequence[PlacedSensor], step: float) -> None:
        self.rows: Integers = np.array([member.row for member in members], dtype=np.int64)
        self.members = list(members)
        self.guarded = members[0].guarded
        sensors = [member.guarded for member in members]
        self._columns = columns_of([each.options for each in sensors], self.guarded.integers)
        timing = [each.sensor.options for each in sensors]
        self._period = np.array([_decisions(of.get("every"), step, 1) for of in timing])
        self._lag = np.array([_decisions(of.get("delay"), step, 0) for of in timing])
        self._dropout = np.array([float(of.get("dropout") or 0.0) for of in timing])
        self._keys = np.array([member.key for member in members], dtype=np.uint64)
        count = len(self.rows)
        depth = int((self._lag // self._period).max()) + 2 if self._lag.any() else 1
        self._taken = np.zeros(count, dtype=np.int64)
        """how many readings each has, lost ones included"""
        self._shown = np.full(count, -1)
        """the number of the reading that has arrived last"""
        self._steps = np.zeros((depth, count), dtype=np.int64)
        """decisions at which they were measured"""
        self._times = np.zeros((depth, count))
        self._values: dict[str, NDArray[Any]] = {
            name: np.zeros((depth, count, *array.shape), array.dtype)
            for name, array in self.guarded.arrays.items()
        }
        self._sensor: Sensor | None = None
        self._state: Any = None
        if self.guarded.is_computed:
            self._state = self.guarded.first_state(self._of_all, count)

    @property
    def _of_all(self) -> Sensor:
        """The sensor with the options of all its agents."""
        if self._sensor is None:
            self._sensor = self.guarded.built(self._columns)
        return self._sensor

    def due(self, moment: MeasuringMoment) -> Integers:
        """The members that measure now."""
        steps = moment.steps[self.rows]
        newest = self._steps[self._slot(self._taken - 1), np.arange(len(steps))]
        is_new = (self._taken == 0) | (newest < steps)
        return np.flatnonzero(is_new & ((steps % self._period == 0) | (self._taken == 0)))

    def sense(self, moment: MeasuringMoment, delivered: Mapping[int, Arrays]) -> None:
        """Measure where it is time to. `delivered`: by column, what an engine has measured, of a
        kind that is not computed."""
        due = self.due(moment)
        if len(due):
            self._measure(due, moment, delivered)
        self._arrive(moment)

    def current(self, places: Any) -> tuple[Floats, dict[str, NDArray[Any]]]:
        """The time and the arrays of the readings that some members show. The arrays are read-only,
        and later measurements leave them as they are. Raises `LookupError` where nothing has been
        measured."""
        if (self._shown[places] < 0).any():
            raise LookupError(f"nothing has been measured by `{self.guarded.sensor.name}` yet")
        slot = self._slot(self._shown[places])
        rows = np.arange(len(self.rows))[places]
        arrays = {
            name: values[0, places] if len(values) == 1 else values[slot, rows]
            for name, values in self._values.items()
        }
        for array in arrays.values():
            array.flags.writeable = False
        return self._times[slot, rows], arrays

    def restart(self, agents: Integers) -> None:
        """Some agents of the world are at the start of a drive."""
        again = np.flatnonzero(np.isin(self.rows, agents))
        self._taken[again], self._shown[again] = 0, -1
        if self._state is not None:
            self._state[again] = self.guarded.first_state(self._of_all, len(self.rows))[again]

    def carry_on(self, place: int, before: SensorGroup, earlier: int) -> None:
        """A member goes on with what one of another group has measured, if it is of the same kind
        and as late."""
        if self.guarded.layout != before.guarded.layout or len(self._steps) != len(before._steps):
            return
        self._taken[place], self._shown[place] = before._taken[earlier], before._shown[earlier]
        rings = [(self._steps, before._steps), (self._times, before._times)]
        rings += [(values, before._values[name]) for name, values in self._values.items()]
        for mine, known in rings:
            mine[:, place] = known[:, earlier]
        if self._state is not None:
            self._state[place] = before._state[earlier]

    def take(self, place: Integers) -> None:
        """Agents are at other places of the world now; at -1, no more."""
        remaining = np.flatnonzero(place[self.rows] >= 0)
        self.rows = place[self.rows[remaining]]
        self.members = [self.members[index] for index in remaining]
        self._columns, self._sensor = options_of(self._columns, remaining), None
        for name in ("_period", "_lag", "_dropout", "_keys", "_taken", "_shown"):
            setattr(self, name, getattr(self, name)[remaining])
        self._steps, self._times = self._steps[:, remaining], self._times[:, remaining]
        self._values = {name: values[:, remaining] for name, values in self._values.items()}
        self._state = None if self._state is None else self._state[remaining]

    def _slot(self, number: Integers) -> Any:
        return number % len(self._steps)

    def _measure(
        self, due: Integers, moment: MeasuringMoment, delivered: Mapping[int, Arrays]
    ) -> None:
        rows, number = self.rows[due], self._taken[due]
        keys = mix(numbered(self._keys[due], number))
        random = BatchRandom(keys)
        found = self._found(due, moment, random, delivered)
        lost = (number > 0) & (random.uniform(1, _LOST)[:, 0] < self._dropout[due])
        slot, before = self._slot(number), self._slot(number - 1)
        self._times[slot, due] = np.where(lost, self._times[before, due], moment.time[rows])
        self._steps[slot, due] = moment.steps[rows]
        for name, values in self._values.items():
            shape = (-1,) + (1,) * (values.ndim - 2)
            new = found[name]
            if lost.any():
                new = np.where(lost.reshape(shape), values[before, due], new)
            # Controllers may hold views of a ring of one reading (`current`).
            ring = values.copy() if len(values) == 1 else values
            ring[slot, due] = new
            self._values[name] = ring
        self._taken[due] += 1
        self._record(due, lost, moment)

    def _found(
        self,
        due: Integers,
        moment: MeasuringMoment,
        random: BatchRandom,
        delivered: Mapping[int, Arrays],
    ) -> Arrays:
        rows = self.rows[due]
        if not self.guarded.is_computed:
            parts = [delivered[int(row)] for row in rows]
            return {name: np.stack([part[name] for part in parts]) for name in self._values}
        everyone = len(due) == len(self.rows)
        sensor = self._of_all if everyone else self.guarded.built(options_of(self._columns, due))
        last = self._steps[self._slot(self._taken[due] - 1), due]
        passed = np.where(self._taken[due] > 0, moment.steps[rows] - last, 0)
        around = partial(moment.things, rows)
        sensed = SensedBatch(
            moment.seen(rows), passed * moment.step, random, moment.rays(rows), around
        )
        state = None if self._state is None else self._state[due]
        found = self.guarded.measure(sensor, sensed, state)
        if state is not None:
            self._state[due] = state
        return found

    def _arrive(self, moment: MeasuringMoment) -> None:
        """The next reading of each is shown when its delay is over, the first at once."""
        following = self._shown + 1
        steps = self._steps[self._slot(following), np.arange(len(following))]
        over = (following == 0) | (steps + self._lag <= moment.steps[self.rows])
        self._shown = np.where((following < self._taken) & over, following, self._shown)

    def _record(self, due: Integers, lost: Booleans, moment: MeasuringMoment) -> None:
        for place in due[~lost]:
            recorder = self.members[place].guarded.recorder
            if recorder is not None:
                slot = self._slot(self._taken[place] - 1)
                time = float(self._times[slot, place])
                late = self._lag[place] if self._taken[place] > 1 else 0
                arrays = {name: v[slot, place].copy() for name, v in self._values.items()}
                recorder.add(time, time + float(late) * moment.step, arrays)


def _decisions(seconds: Any, step: float, least: int) -> int:
    """A time in decisions of the controllers."""
    return least if seconds is None else max(least, round(float(seconds) / step))
