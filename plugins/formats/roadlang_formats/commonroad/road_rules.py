"""Traffic lights, signs, stop lines and intersections of CommonRoad."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from itertools import groupby, pairwise
from xml.etree.ElementTree import Element

import numpy as np

from roadlang.api import SceneControl, SceneJunction, signal_heads
from roadlang.geometry import Floats
from roadlang_formats.lanelets.model import LaneletJunction, LaneletMap, LinePoint

from ..road_signs import SIGNS
from .elements import put, put_point, put_references
from .numbering import Numbering

_SPEED_LIMIT = "274"
_PRIORITY = "301"
_TURNS = {"left": "successorsLeft", "u": "successorsLeft", "right": "successorsRight"}
_MOST_TO_THE_RIGHT = math.radians(150.0)
"""From one arm to the next counter-clockwise, up to which that one is to its right."""


@dataclass(frozen=True)
class _Light:
    id: int
    x: float
    y: float
    cycle: tuple[tuple[str, int], ...]
    offset: int


@dataclass(frozen=True)
class _Sign:
    id: int
    kind: str
    value: str
    x: float
    y: float


@dataclass
class RoadRules:
    """What holds on lanelets, by their numbers."""

    lights: list[_Light] = field(default_factory=list)
    signs: list[_Sign] = field(default_factory=list)
    _lights: dict[int, list[int]] = field(default_factory=dict)
    _signs: dict[int, list[int]] = field(default_factory=dict)
    _stop_lines: dict[int, tuple[tuple[tuple[float, float], ...], str]] = field(
        default_factory=dict
    )

    @classmethod
    def of(
        cls, lanelets: LaneletMap, ids: Mapping[int, int], numbering: Numbering, step: float
    ) -> RoadRules:
        """Those of a map. `step`: seconds of a time step."""
        rules = cls()
        for junction in lanelets.junctions:
            rules._add_lights(lanelets, junction, numbering, step)
            rules._add_signs(lanelets, junction, numbering)
        rules._add_limits(lanelets, ids, numbering)
        return rules

    def _add_lights(
        self, lanelets: LaneletMap, junction: LaneletJunction, numbering: Numbering, step: float
    ) -> None:
        control = junction.junction.control
        for head in signal_heads(junction.junction):
            cycle = _cycle(control, head.connections[0], step)
            if not cycle:
                continue
            offset = round(-control.offset / step) % sum(duration for _, duration in cycle)
            light = _Light(numbering.next(), head.x, head.y, cycle, offset)
            self.lights.append(light)
            for source in _sources(lanelets, junction, head.connections):
                self._lights.setdefault(source, []).append(light.id)
                self._stop_lines[source] = (_stop_line(lanelets, source), "solid")

    def _add_signs(
        self, lanelets: LaneletMap, junction: LaneletJunction, numbering: Numbering
    ) -> None:
        control = junction.junction.control
        if control.kind not in SIGNS:
            return
        by_road: dict[str, list[int]] = {}
        for connection in junction.junction.connections:
            by_road.setdefault(connection.source.road, []).append(connection.id)
        for road, connections in by_road.items():
            minor = control.kind == "all_way_stop" or road in control.minor
            kind = SIGNS[control.kind] if minor else _PRIORITY
            sources = _sources(lanelets, junction, connections)
            if not sources:
                continue
            x, y, _ = lanelets.line(lanelets.lanelets[sources[0]].right)[-1]
            sign = _Sign(numbering.next(), kind, "", x, y)
            self.signs.append(sign)
            for source in sources:
                self._signs.setdefault(source, []).append(sign.id)
                if minor:
                    line = "dashed" if control.kind == "yield" else "solid"
                    self._stop_lines[source] = (_stop_line(lanelets, source), line)

    def _add_limits(
        self, lanelets: LaneletMap, ids: Mapping[int, int], numbering: Numbering
    ) -> None:
        """One sign for all lanelets of a road with the same limit, at the first of them."""
        found: dict[tuple[str, float], _Sign] = {}
        for number in ids:
            lanelet = lanelets.lanelets[number]
            limit = lanelet.speed_limit
            if limit is None or not math.isfinite(limit) or not lanelet.drivable:
                continue
            sign = found.get((lanelet.road, limit))
            if sign is None:
                x, y, _ = lanelets.line(lanelet.right)[0]
                sign = _Sign(numbering.next(), _SPEED_LIMIT, f"{limit:.6g}", x, y)
                found[lanelet.road, limit] = sign
                self.signs.append(sign)
            self._signs.setdefault(number, []).append(sign.id)

    def signs_of(self, lanelet: int) -> Sequence[int]:
        """The ids of signs."""
        return self._signs.get(lanelet, ())

    def lights_of(self, lanelet: int) -> Sequence[int]:
        """The ids of lights."""
        return self._lights.get(lanelet, ())

    def put_stop_line(self, parent: Element, lanelet: int) -> None:
        """The `stopLine` of a lanelet, if it has one."""
        if lanelet not in self._stop_lines:
            return
        points, marking = self._stop_lines[lanelet]
        line = put(parent, "stopLine")
        for x, y in points:
            put_point(line, x, y)
        put(line, "lineMarking", marking)
        put_references(line, "trafficLightRef", self.lights_of(lanelet))

    def put(self, root: Element) -> None:
        """All signs and lights."""
        for sign in self.signs:
            element = put(root, "trafficSign", id=sign.id)
            part = put(element, "trafficSignElement")
            put(part, "trafficSignID", sign.kind)
            if sign.value:
                put(part, "additionalValue", sign.value)
            put_point(put(element, "position"), sign.x, sign.y)
        for light in self.lights:
            element = put(root, "trafficLight", id=light.id)
            cycle = put(element, "cycle")
            for color, duration in light.cycle:
                part = put(cycle, "cycleElement")
                put(part, "duration", duration)
                put(part, "color", color)
            if light.offset:
                put(cycle, "timeOffset", light.offset)
            put_point(put(element, "position"), light.x, light.y)
            put(element, "active", "true")


def _sources(
    lanelets: LaneletMap, junction: LaneletJunction, connections: Sequence[int]
) -> list[int]:
    """The lanelets that lead into connections, each once."""
    found = [
        source
        for id in connections
        if id in junction.connections
        for source in lanelets.predecessors(junction.connections[id])
    ]
    return list(dict.fromkeys(found))


def _stop_line(lanelets: LaneletMap, lanelet: int) -> tuple[tuple[float, float], ...]:
    """Across the end of a lanelet."""
    at: list[LinePoint] = [
        lanelets.line(side)[-1]
        for side in (lanelets.lanelets[lanelet].left, lanelets.lanelets[lanelet].right)
    ]
    return tuple((x, y) for x, y, _ in at)


def _cycle(control: SceneControl, connection: int, step: float) -> tuple[tuple[str, int], ...]:
    """The colors that a connection sees, and for how many time steps, from the first phase on."""
    colors: list[tuple[str, float]] = []
    for phase, (begin, yellow, red, end) in zip(control.phases, control.changes, strict=True):
        goes = connection in phase.connections
        colors += [
            ("green" if goes else "red", yellow - begin),
            ("yellow" if goes else "red", red - yellow),
            ("red", end - red),
        ]
    found, at = [], 0.0
    for color, group in groupby(colors, key=lambda item: item[0]):
        begin, at = at, at + sum(duration for _, duration in group)
        steps = round(at / step) - round(begin / step)
        if steps > 0:
            found.append((color, steps))
    return tuple(found)


def put_intersections(
    root: Element, lanelets: LaneletMap, ids: Mapping[int, int], numbering: Numbering
) -> None:
    """An `intersection` for each junction whose arms lead somewhere."""
    for junction in lanelets.junctions:
        if junction.junction.kind == "joint" or not junction.connections:
            continue
        incoming = _incoming(lanelets, junction)
        numbers = {arm: numbering.next() for arm in incoming}
        element = put(root, "intersection", id=numbering.next())
        beside = _to_the_right(junction.junction, list(incoming))
        for arm, connections in incoming.items():
            part = put(element, "incoming", id=numbers[arm])
            sources = _sources(lanelets, junction, connections)
            put_references(part, "incomingLanelet", (ids[source] for source in sources))
            for tag in ("successorsRight", "successorsStraight", "successorsLeft"):
                put_references(
                    part,
                    tag,
                    (
                        ids[junction.connections[id]]
                        for id in connections
                        if _TURNS.get(junction.connection(id).turn, "successorsStraight") == tag
                    ),
                )
            if arm in beside:
                put(part, "isLeftOf", ref=numbers[beside[arm]])


def _incoming(lanelets: LaneletMap, junction: LaneletJunction) -> dict[tuple[str, str], list[int]]:
    """The connections by the end of the road that they come from, counter-clockwise."""
    found: dict[tuple[str, str], list[int]] = {
        (arm.road, arm.end): [] for arm in junction.junction.arms
    }
    for id in junction.connections:
        source = junction.connection(id).source
        found[source.road, source.end].append(id)
    return {arm: connections for arm, connections in found.items() if connections}


def _to_the_right(
    junction: SceneJunction, arms: list[tuple[str, str]]
) -> dict[tuple[str, str], tuple[str, str]]:
    """By each arm, the one to the right of those who come from it."""
    area = np.array(junction.area)
    middle = area.mean(axis=0)
    at: dict[tuple[str, str], Floats] = {
        (arm.road, arm.end): (area[arm.left] + area[arm.right]) / 2.0 - middle
        for arm in junction.arms
    }
    found = {}
    for one, other in pairwise([*arms, arms[0]]):
        (x, y), (u, v) = at[one], at[other]
        gap = math.atan2(x * v - y * u, x * u + y * v) % math.tau
        if one != other and 0.0 < gap < _MOST_TO_THE_RIGHT:
            found[one] = other
    return found
