"""Speed limits, right of way and traffic lights of a Lanelet2 map."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from roadlang.api import SceneConnection, signal_heads
from roadlang_formats.lanelets.model import LaneletJunction, LaneletMap, LinePoint
from roadlang_formats.speed_units import in_kmh

from .primitives import Primitives

Member = tuple[str, str, int]
_LIGHT_WIDTH, _LIGHT_HEIGHT = 0.4, 3.0
"""Meters."""


class RegulatoryElements:
    """What holds on lanelets, by their numbers; `ids` are those in the file."""

    def __init__(
        self, primitives: Primitives, lanelets: LaneletMap, ids: Mapping[int, int]
    ) -> None:
        self._primitives, self._lanelets, self._ids = primitives, lanelets, ids
        self._rules: dict[int, list[int]] = {}
        self._pending: list[tuple[int, list[Member], dict[str, str]]] = []
        self._lines: dict[tuple[tuple[float, float], tuple[float, float]], int] = {}

    def of(self, lanelet: int) -> Sequence[int]:
        """The ids of the elements of a lanelet."""
        return self._rules.get(lanelet, ())

    def write(self) -> None:
        """After the lanelets that they refer to."""
        for id, members, tags in self._pending:
            self._primitives.relation(members, tags, id)

    def add_limits(self) -> None:
        """One for each road and limit."""
        by_limit: dict[tuple[str, float], list[int]] = {}
        for number in self._ids:
            lanelet = self._lanelets.lanelets[number]
            limit = lanelet.speed_limit
            if limit is not None and math.isfinite(limit) and lanelet.drivable:
                by_limit.setdefault((lanelet.road, limit), []).append(number)
        for (_, limit), numbers in by_limit.items():
            right = self._lanelets.line(self._lanelets.lanelets[numbers[0]].right)
            sign = self._primitives.way(
                right[:2], {"type": "traffic_sign", "subtype": "de274", "virtual": "yes"}
            )
            tags = {"subtype": "speed_limit", "sign_type": f"{in_kmh(limit)} km/h"}
            self._add([("way", "refers", sign)], tags, numbers)

    def add_junction(self, junction: LaneletJunction) -> None:
        """Its lights; who yields to whom where there are none, or where they do not decide."""
        control = junction.junction.control
        for head in signal_heads(junction.junction):
            self._add_light(junction, (head.x, head.y, head.heading), head.connections)
        if control.kind == "all_way_stop":
            self._add_all_way_stop(junction)
            return
        prior: dict[int, list[int]] = {}
        for low, high in junction.junction.yields:
            prior.setdefault(low, []).append(high)
        for low, highs in prior.items():
            self._add_right_of_way(junction, low, highs)

    def _add_light(
        self,
        junction: LaneletJunction,
        at: tuple[float, float, float],
        connections: Sequence[int],
    ) -> None:
        x, y, heading = at
        aside = -math.sin(heading) * _LIGHT_WIDTH / 2.0, math.cos(heading) * _LIGHT_WIDTH / 2.0
        ends: list[LinePoint] = [
            (round(x + side * aside[0], 6), round(y + side * aside[1], 6), _LIGHT_HEIGHT)
            for side in (1.0, -1.0)
        ]
        light = self._primitives.way(
            ends, {"type": "traffic_light", "subtype": "red_yellow_green", "height": "1"}
        )
        numbers = self._numbers(junction, connections)
        if numbers:
            line = self._stop_line(junction.connection(connections[0]))
            members = [("way", "refers", light), ("way", "ref_line", line)]
            self._add(members, {"subtype": "traffic_light"}, numbers)

    def _add_right_of_way(self, junction: LaneletJunction, low: int, highs: Sequence[int]) -> None:
        yields, prior = self._numbers(junction, [low]), self._numbers(junction, highs)
        if not yields or not prior:
            return
        line = self._stop_line(junction.connection(low))
        members = [
            *(("relation", "yield", self._ids[number]) for number in yields),
            *(("relation", "right_of_way", self._ids[number]) for number in prior),
            ("way", "ref_line", line),
        ]
        self._add(members, {"subtype": "right_of_way"}, [*yields, *prior])

    def _add_all_way_stop(self, junction: LaneletJunction) -> None:
        numbers = self._numbers(junction, list(junction.connections))
        if not numbers:
            return
        members: list[Member] = [("relation", "yield", self._ids[number]) for number in numbers]
        lines = [self._stop_line(junction.connection(id)) for id in junction.connections]
        members += [("way", "ref_line", line) for line in lines]
        self._add(members, {"subtype": "all_way_stop"}, numbers)

    def _numbers(self, junction: LaneletJunction, connections: Sequence[int]) -> list[int]:
        found = [junction.connections[id] for id in connections if id in junction.connections]
        return [number for number in found if number in self._ids]

    def _stop_line(self, connection: SceneConnection) -> int:
        left, right = connection.stop_line
        if (left, right) not in self._lines:
            points: list[LinePoint] = [(round(x, 6), round(y, 6), 0.0) for x, y in (left, right)]
            self._lines[left, right] = self._primitives.way(points, {"type": "stop_line"})
        return self._lines[left, right]

    def _add(
        self, members: Sequence[Member], tags: Mapping[str, str], numbers: Sequence[int]
    ) -> None:
        id = self._primitives.id()
        self._pending.append((id, list(members), {"type": "regulatory_element", **tags}))
        for number in numbers:
            self._rules.setdefault(number, []).append(id)
