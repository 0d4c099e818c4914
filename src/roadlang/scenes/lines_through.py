"""Lines of a priority road that go on through a junction, broken, so that others can cross them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Literal

import numpy as np

from ..geometry import CrossSection, CurveFrame
from ..geometry.arrays import Floats
from ..geometry.lanes.lane_paint import DASH, EDGE_INSET, border_lines
from ..ir.scene_junctions import SceneConnection, SceneJunction, SceneLaneEnd
from ..ir.scene_road import SceneRoad
from ..world.networks.connection_roads import connection_curve

EDGE_DASH = 1.5
"""Meters, of edge lines along the mouth of a minor road."""
_POINT_SPACING = 1.0


@dataclass(frozen=True, slots=True, eq=False)
class LineThrough:
    """One dash."""

    kind: Literal["lane_line", "edge_line"]
    points: Floats
    """(n, 2) meters"""


def lines_through(junction: SceneJunction, roads: Mapping[str, SceneRoad]) -> Iterator[LineThrough]:
    """The dashes of lane lines, and of edge lines along the mouths of minor roads.

    Only where signs decide who goes first, and two arms have priority: with signals, a stop at
    all arms or priority to the right, the lines end at the junction.
    """
    control = junction.control
    major = {(arm.road, arm.end) for arm in junction.arms if arm.road not in control.minor}
    if junction.kind != "junction" or control.kind not in ("yield", "stop") or len(major) != 2:
        return
    drawn: set[frozenset[tuple[str, str, int]]] = set()
    for connection in junction.connections:
        ends = connection.source, connection.target
        if connection.turn != "straight" or {(end.road, end.end) for end in ends} != major:
            continue
        for side in (1, -1):
            borders = [
                _Border.of(end, roads[end.road], _side(i, side)) for i, end in enumerate(ends)
            ]
            if any(border is None for border in borders):
                continue
            first, last = (border for border in borders if border is not None)
            key = frozenset({first.key, last.key})
            if first.kind != last.kind or key in drawn:
                continue
            if first.kind == "edge_line" and not _mouth(junction, connection, side):
                continue
            drawn.add(key)
            yield from _dashes(first.kind, connection, side, (first.inset, last.inset))


def _side(place: int, side: int) -> int:
    """A side of a connection as seen by who enters the junction on that arm."""
    return side if place == 0 else -side


@dataclass(frozen=True, slots=True)
class _Border:
    """A marked border of a lane at the end of its road."""

    kind: Literal["lane_line", "edge_line"]
    key: tuple[str, str, int]
    inset: float
    """Meters from the border into the lane, of the line on the road"""

    @classmethod
    def of(cls, end: SceneLaneEnd, road: SceneRoad, side: int) -> _Border | None:
        """The one on the left (1) or right (-1) of who drives toward the junction."""
        section = road.cross_section()
        lane = section.ids.index(end.lane)
        is_left = (side > 0) == (end.end == "end")
        place = lane if is_left else lane + 1
        lines = border_lines(section.lanes, section.markings)
        line = next((one for one in lines if one.border == place), None)
        if line is None or line.is_curb:
            return None
        is_inner = _drivable(section, place - 1) and _drivable(section, place)
        inset = EDGE_INSET * (-line.inset if place == lane else line.inset)
        return cls("lane_line" if is_inner else "edge_line", (end.road, end.end, place), inset)


def _drivable(section: CrossSection, lane: int) -> bool:
    return 0 <= lane < len(section.lanes) and section.lanes[lane].drivable


def _mouth(junction: SceneJunction, connection: SceneConnection, side: int) -> bool:
    """Whether another road enters on this side of a connection."""
    places = {(arm.road, arm.end): place for place, arm in enumerate(junction.arms)}
    source, target = (places[end.road, end.end] for end in (connection.source, connection.target))
    # Arms run counter-clockwise: from the source on, those on the right come first.
    first, last = (source, target) if side < 0 else (target, source)
    return (last - first) % len(junction.arms) > 1


def _dashes(
    kind: Literal["lane_line", "edge_line"],
    connection: SceneConnection,
    side: int,
    insets: tuple[float, float],
) -> Iterator[LineThrough]:
    """Whole dashes, as long as the gaps: a lane line begins and ends with a dash, after the gap
    that ends the road; an edge line begins and ends with a gap, after its solid line."""
    curve = connection_curve(connection)
    is_edge = kind == "edge_line"
    unit = EDGE_DASH if is_edge else DASH
    lead = 1 if is_edge else -1
    count = max(1, round((curve.length / unit - lead) / 2.0))
    unit = curve.length / (2 * count + lead)
    for dash in range(count):
        start = (2 * dash + max(lead, 0)) * unit
        s = np.linspace(start, start + unit, 1 + max(1, int(np.ceil(unit / _POINT_SPACING))))
        ends = [0.0, curve.length]
        away = 0.5 * np.interp(s, ends, connection.widths) - np.interp(s, ends, insets)
        frame = CurveFrame.of(curve, s)
        yield LineThrough(kind, frame.points + side * away[:, None] * frame.normal)
