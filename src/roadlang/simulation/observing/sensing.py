"""The sensors of all agents of a world: measured before every decision, read by controllers."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...geometry.arrays import Floats, Integers, inverse_index
from ...ir.read_only import ReadOnlyMapping
from ...ir.readings import Reading, no_such_sensor
from ...ir.scene import SceneSensor
from ...plugins.kinds import Controller
from ..calling.controllers import Driver
from ..calling.reading_arrays import Arrays
from ..calling.sensor_groups import MeasuringMoment, PlacedSensor, SensorGroup
from ..state.world import World
from ..surroundings.ray_casts import RayCaster


@dataclass(frozen=True)
class DueReading:
    """A reading that the engine has to measure now."""

    agent: str
    sensor: SceneSensor


class Sensing:
    """What the agents of a world sense. `step`: seconds between decisions."""

    def __init__(self, world: World, placed: Sequence[PlacedSensor], step: float) -> None:
        self._step = step
        self._ticks = max(1, round(step / world.dt))
        members: dict[tuple[int, Any], list[PlacedSensor]] = {}
        self.layouts: dict[int, tuple[Any, ...]] = {}
        """by column of an agent, what its readings look like"""
        for sensor in placed:
            layout = sensor.guarded.layout
            if sensor.guarded.recorder is not None:
                sensor.guarded.recorder.restart()
            before = self.layouts.get(sensor.row, ())
            self.layouts[sensor.row] = (*before, layout)
            members.setdefault((len(before), layout), []).append(sensor)
        # In the order of each agent's own sensors: of two that replace a column the last one wins,
        # whoever else is in the world.
        ordered = sorted(members.items(), key=lambda item: item[0][0])
        self._groups = [SensorGroup(found, step) for _, found in ordered]
        self._rays = RayCaster(world)
        self._count = len(world.present)
        self._delivered: dict[tuple[int, str], Arrays] = {}
        self.replaced: dict[str, Floats] = {}
        """(N,) columns that controllers get in place of true ones; NaN: the true one"""

    @classmethod
    def of(
        cls, world: World, controllers: Sequence[Mapping[str, Controller]], step: float
    ) -> Sensing | None:
        """That of the sensors that drivers have; None where there are none."""
        placed = []
        for row, actor in enumerate(world.actors):
            number = row // world.slots
            driver = None if actor is None else controllers[number].get(actor.name)
            for guarded in driver.sensors if isinstance(driver, Driver) else ():
                assert actor is not None
                placed.append(PlacedSensor(row, actor.name, world.scenes[number], guarded))
        return cls(world, placed, step) if placed else None

    def due(self, view: Any) -> list[DueReading]:
        """What is not computed in Python and has to be delivered before `sense`."""
        moment = self._moment(view)
        return [
            DueReading(group.members[place].agent, group.members[place].guarded.sensor)
            for group in self._groups
            if not group.guarded.is_computed
            for place in group.due(moment)
        ]

    def deliver(self, row: int, sensor: str, arrays: Mapping[str, Any]) -> None:
        """What an engine has measured for an agent, now. Raises RL474 for other arrays than those
        of the sensor, `KeyError` where there is no such sensor."""
        guarded = next(
            member.guarded
            for group in self._groups
            for member in group.members
            if (member.row, member.guarded.sensor.name) == (row, sensor)
        )
        self._delivered[row, sensor] = guarded.checked(arrays, ())

    def sense(self, view: Any) -> None:
        """Measure what is due, unless that has been done at this time. `view`: a `View` of the
        world that shows the truth."""
        moment = self._moment(view)
        for group in self._groups:
            name = group.guarded.sensor.name
            delivered = {row: a for (row, sensor), a in self._delivered.items() if sensor == name}
            group.sense(moment, delivered)
            if group.guarded.kind.replaces:
                self._replace(group)
        self._delivered.clear()

    def readings(self, rows: Integers) -> Mapping[str, Reading]:
        """What some agents have got, by the names of sensors."""
        return _Readings(self._groups, rows, self._count)

    def restart(self, agents: Integers) -> None:
        """Some agents are at the start of a drive."""
        for group in self._groups:
            group.restart(agents)

    def carry_on(self, before: Sensing, column: Mapping[int, int]) -> None:
        """Sensors of agents that go on after an edit go on too. `column`: of an agent before it, by
        that after it."""
        known = {
            (member.row, member.guarded.sensor.name): (group, place)
            for group in before._groups
            for place, member in enumerate(group.members)
        }
        for group in self._groups:
            for place, member in enumerate(group.members):
                found = known.get((column.get(member.row, -1), member.guarded.sensor.name))
                if found is not None:
                    group.carry_on(place, *found)

    def take(self, agents: Integers, count: int, slots: int) -> None:
        """From now on the world has these of its `count` agents alone."""
        place = inverse_index(agents, count)
        self._count = len(agents)
        for group in self._groups:
            group.take(place)
        self._groups = [group for group in self._groups if len(group.rows)]
        self._rays.take(agents, slots)
        self.replaced = {name: column[agents] for name, column in self.replaced.items()}

    def _moment(self, view: Any) -> MeasuringMoment:
        world, poses = view.world, view.poses
        steps = (world.tick - world.began) // self._ticks
        return MeasuringMoment(
            world.age, steps, self._step, view.of,
            lambda rows: self._rays.of(world, poses, rows),
            lambda rows: self._rays.things(world, poses, rows),
        )  # fmt: skip

    def _replace(self, group: SensorGroup) -> None:
        _, arrays = group.current(slice(None))
        for name in group.guarded.kind.replaces:
            if name not in self.replaced:
                self.replaced[name] = np.full(self._count, math.nan)
            self.replaced[name][group.rows] = arrays[name]


class _Readings(ReadOnlyMapping[str, Reading]):
    """The readings of some agents, looked up when a controller asks for one."""

    __slots__ = ("_count", "_groups", "_known", "_rows")

    def __init__(self, groups: Sequence[SensorGroup], rows: Integers, count: int) -> None:
        self._groups, self._rows, self._count = groups, rows, count
        self._known: dict[str, Reading] = {}

    def _group(self, name: str) -> tuple[SensorGroup, Integers] | None:
        for group in self._groups:
            if group.guarded.sensor.name == name:
                places = inverse_index(group.rows, self._count)[self._rows]
                if (places >= 0).all():
                    return group, places
        return None

    def __getitem__(self, name: str) -> Reading:
        if name not in self._known:
            found = self._group(name)
            if found is None:
                raise KeyError(no_such_sensor(name, self))
            group, places = found
            everyone = len(places) == len(group.rows) and bool(
                (places == np.arange(len(places))).all()
            )
            self._known[name] = Reading(*group.current(slice(None) if everyone else places))
        return self._known[name]

    def __iter__(self) -> Iterator[str]:
        names = dict.fromkeys(group.guarded.sensor.name for group in self._groups)
        return (name for name in names if self._group(name) is not None)

    def __len__(self) -> int:
        return sum(1 for _ in self)
