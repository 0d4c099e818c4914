"""What single agents see: for controllers that decide for one agent."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cached_property

import numpy as np

from ...geometry.arrays import Integers, wrapped_angle
from ...ir.observation import Observation, ObservationBatch
from ...ir.read_only import ReadOnlyMapping
from ...ir.readings import Reading, Readings
from ...ir.scene import Scene
from ...ir.surroundings import LaneChoice, LanePlace, Neighbor
from .lazy_observations import LazyObservations
from .observing import View

_NOTHING = Readings({})
_NOBODY: Mapping[str, Observation] = {}
_NUMBERS = ObservationBatch.number_columns()


class OthersSeen(ReadOnlyMapping[str, Observation]):
    """What all agents of one scene see, by name; few controllers look at it."""

    def __init__(self, view: View, scene: Scene, first: int) -> None:
        """`first`: the column of the world that is that of the first agent of the scene."""
        self._view = view
        self._scene = scene
        self._first = first
        self._known: dict[str, Observation] = {}

    @cached_property
    def _rows(self) -> dict[str, int]:
        return {actor.name: row for row, actor in enumerate(self._scene.agents, self._first)}

    def __getitem__(self, name: str) -> Observation:
        if name not in self._known:
            (self._known[name],) = observations(self._view, np.array([self._rows[name]]))
        return self._known[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._rows)

    def __len__(self) -> int:
        return len(self._rows)


class _LinesAhead:
    """Of the lines of some agents, for as long as nobody moves. Who asks how a line goes on is
    often followed by others that ask for the same distance: it is looked up for all at once."""

    def __init__(self, view: View, rows: Integers) -> None:
        self._view = view
        self._rows = rows
        self._known: dict[float, list[list[float]]] = {}

    def at(self, place: int, distance: float) -> tuple[float, float, float, float]:
        """Of the agent at a place among those: x, y, heading and curvature."""
        distance = float(distance)
        known = self._known.get(distance)
        if known is None:
            found = self._view.line_ahead(self._rows, distance)
            known = self._known[distance] = [column.tolist() for column in found]
        x, y, heading, curvature = known
        return x[place], y[place], heading[place], curvature[place]


class _SingleAgent:
    """What is looked up for one agent when its controller asks for it."""

    def __init__(self, view: View, row: int, lines: _LinesAhead, place: int) -> None:
        self._view = view
        self._rows = np.array([row])
        self._lines = lines
        self._place = place

    @cached_property
    def _seen(self) -> ObservationBatch:
        return self._view.of(self._rows)

    @property
    def sensors(self) -> Mapping[str, Reading]:
        if self._view.sensing is None:
            return _NOTHING
        found = self._seen.sensors
        return Readings({name: reading.single(0) for name, reading in found.items()})

    def line_ahead(self, distance: float) -> tuple[float, float, float, float]:
        return self._lines.at(self._place, distance)

    def vehicle_ahead(self) -> tuple[float, float]:
        gap, speed = self._view.vehicle_ahead(self._rows)
        return float(gap[0]), float(speed[0])

    def acceleration_ahead(self) -> float:
        return float(self._view.acceleration_ahead(self._rows)[0])

    def obstacle_ahead(self) -> float:
        return float(self._seen.obstacle_ahead()[0])

    def lane_end(self) -> float:
        return float(self._seen.lane_end()[0])

    def right_of_way(self, politeness: float, aggression: float) -> tuple[float, float, float]:
        stop, gap, speed = self._seen.right_of_way(politeness, aggression)
        return float(stop[0]), float(gap[0]), float(speed[0])

    def speed_for_bends(self, lateral: float, braking: float, on: float) -> float:
        return float(self._seen.speed_for_bends(lateral, braking, on)[0])

    def lane_place(self) -> LanePlace:
        return self._seen.lane_place().single(0)

    def offset_of_lane(self, which: LaneChoice) -> float:
        return float(self._seen.offset_of_lane(which)[0])

    def direction_of_lane(self, which: LaneChoice) -> float:
        return float(self._seen.direction_of_lane(which)[0])

    def speed_limit_ahead(self, braking: float, on: float) -> float:
        return float(self._seen.speed_limit_ahead(braking, on)[0])

    def stop_ahead(self) -> float:
        return float(self._seen.stop_ahead()[0])

    def junction_ahead(self) -> tuple[float, float, float]:
        distance, length, green = self._seen.junction_ahead()
        return float(distance[0]), float(length[0]), float(green[0])

    def nearby(self, distance: float) -> tuple[Neighbor, ...]:
        return self._seen.nearby(distance).single(0)


def observations(
    view: View, rows: Integers, others: Mapping[str, Observation] | None = None
) -> list[Observation]:
    """What some agents of one scene see, each as controllers get it that decide for one."""
    seen = LazyObservations(view, rows)
    columns = seen.numbers(_NUMBERS)
    out: list[Observation] = []
    lines = _LinesAhead(view, rows)
    for row, agent, *values in zip(rows.tolist(), seen.agent, *columns, strict=True):
        single = _SingleAgent(view, row, lines, len(out))
        numbers = dict(zip(_NUMBERS, values, strict=True))
        numbers["heading_error"] = wrapped_angle(numbers["heading_error"])
        out.append(
            Observation(
                **numbers,
                step=view.step,
                agent=agent,
                line_ahead=single.line_ahead,
                others=_NOBODY if others is None else others,
                speed_for_bends=single.speed_for_bends,
                vehicle_ahead=single.vehicle_ahead,
                acceleration_ahead=single.acceleration_ahead,
                obstacle_ahead=single.obstacle_ahead,
                lane_end=single.lane_end,
                lane_place=single.lane_place,
                offset_of_lane=single.offset_of_lane,
                direction_of_lane=single.direction_of_lane,
                speed_limit_ahead=single.speed_limit_ahead,
                stop_ahead=single.stop_ahead,
                junction_ahead=single.junction_ahead,
                right_of_way=single.right_of_way,
                nearby=single.nearby,
                sensors=single.sensors,
            )
        )
    return out
