"""Sensors of agents, guarded: one that fails is named with its plugin, in whatever engine."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from ...diagnostics import Span
from ...ir.readings import ARRAYS_ENDING, SensorRecord
from ...ir.scene import SceneSensor
from ...ir.sensed_batch import SensedBatch
from ...plugins.guard import plugin_guard, wrong_result
from ...plugins.kinds import ReadingArray, Sensor
from ...plugins.option_types import QuantityType
from ...plugins.options import schema_of
from ...plugins.registry import KindEntry
from .option_columns import words_of
from .plugin_states import first_state
from .reading_arrays import Arrays, checked_arrays, stated_arrays

_ENDING = re.compile(r"[\w-]+(\.[\w-]+)*")


@dataclass
class SensorRecorder:
    """The readings of one sensor in a drive, as they are measured."""

    agent: str
    sensor: str
    stated: Mapping[str, ReadingArray]
    files_of: Callable[[SensorRecord], Mapping[str, bytes]]
    """what the kind writes of a record"""
    times: list[float] = field(default_factory=list)
    arrivals: list[float] = field(default_factory=list)
    readings: list[Arrays] = field(default_factory=list)

    def restart(self) -> None:
        """The drive begins anew: what was measured before was lost with an engine."""
        self.times, self.arrivals, self.readings = [], [], []

    def add(self, time: float, arrival: float, arrays: Arrays) -> None:
        """One more, of which nobody changes the arrays."""
        self.times.append(time)
        self.arrivals.append(arrival)
        self.readings.append(arrays)

    @property
    def record(self) -> SensorRecord:
        """All of them. Raises RL470, RL474 of the kind."""
        arrays = {
            name: np.array([reading[name] for reading in self.readings], dtype=array.dtype).reshape(
                -1, *array.shape
            )
            for name, array in self.stated.items()
        }
        times, arrivals = np.array(self.times), np.array(self.arrivals)
        record = SensorRecord(self.agent, self.sensor, times, arrivals, arrays)
        return replace(record, files=self.files_of(record))


class GuardedSensor:
    """A sensor of a scene with its kind. `recorder`: where its readings are to be kept; `span`:
    where it is written, if that is known."""

    def __init__(
        self, sensor: SceneSensor, kind: type[Sensor], entry: KindEntry, span: Span | None = None
    ) -> None:
        self.sensor = sensor
        self.kind = kind
        self.entry = entry
        self.span = span
        self.recorder: SensorRecorder | None = None
        schema = schema_of(kind)
        names = [option.name for option in schema]
        self.options = {name: sensor.options[name] for name in names if name in sensor.options}
        integers = {
            option.name
            for option in schema
            if isinstance(option.type, QuantityType) and option.type.is_integer
        }
        self.integers = {name: int(value) for name, value in self.options.items()
                         if name in integers and value is not None}  # fmt: skip
        """the same for every agent of a group"""
        single = self.built(self.options | self.integers)
        self.arrays: Mapping[str, ReadingArray] = stated_arrays(entry, single)

    @property
    def is_computed(self) -> bool:
        """Whether Python measures, rather than the engine that draws."""
        return self.kind.is_computed()

    @property
    def layout(self) -> tuple[Any, ...]:
        """What agents have to have in common so that their readings fit into one array."""
        arrays = ((name, array.shape, array.dtype) for name, array in self.arrays.items())
        integers = tuple(sorted(self.integers.items()))
        return (self.sensor.name, self.kind, integers, words_of(self.options), *arrays)

    def built(self, options: Mapping[str, Any]) -> Sensor:
        """The sensor with other options, which may be columns. Raises RL470."""
        with plugin_guard(self.entry, self.span):
            return self.kind(**options)

    def first_state(self, sensor: Sensor, count: int) -> Any:
        """The state of `count` agents at the start. Raises RL470, RL474."""
        return first_state(self.entry, self.span, sensor, count)

    def measure(self, sensor: Sensor, sensed: SensedBatch, state: Any) -> Arrays:
        """What it measures at N agents. Raises RL470, RL474."""
        with plugin_guard(self.entry, self.span):
            found: object = sensor.readings(sensed, state)
        return self.checked(found, (len(sensed.interval),))

    def files(self, record: SensorRecord) -> Mapping[str, bytes]:
        """What the kind writes of the readings of a drive. Raises RL470, RL474."""
        single = self.built(self.options | self.integers)
        with plugin_guard(self.entry, self.span):
            files = dict(single.files(record))
        for ending, content in files.items():
            if (
                not isinstance(ending, str)
                or not _ENDING.fullmatch(ending)
                or ending == ARRAYS_ENDING
            ):
                raise wrong_result(self.entry, self.span, f"gave a file with the ending {ending!r}")
            if not isinstance(content, bytes):
                fault = f"gave {type(content).__name__} as the file `{ending}`, not bytes"
                raise wrong_result(self.entry, self.span, fault)
        return files

    def checked(self, found: object, leading: tuple[int, ...]) -> Arrays:
        """Arrays with these leading axes, as the sensor describes them. Raises RL474."""
        return checked_arrays(self.entry, self.arrays, found, leading)
