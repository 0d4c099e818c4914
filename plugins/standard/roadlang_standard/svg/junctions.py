"""Junctions: one surface each, its curb, and what is painted at its edge."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from . import palette
from .arrows import arrow
from .markup import element, path_data

if TYPE_CHECKING:
    from roadlang.api import Scene, SceneConnection, SceneJunction, SceneRoad
    from roadlang.geometry import Floats

    from .viewport import Viewport

_STOP_LINE = 0.4
_TEETH = "0.5 0.4"
_ARROW_BEFORE = 9.0
_ARROW_ROOM = 14.0
_SMALLEST_ARROW = 2.5


def shown_junctions(scene: Scene, names: set[str]) -> list[SceneJunction]:
    """The junctions all of whose roads are drawn."""
    return [
        junction
        for network in scene.networks
        for junction in network.junctions
        if names.issuperset(arm.road for arm in junction.arms)
    ]


def surface(junction: SceneJunction, viewport: Viewport) -> str:
    """Its area."""
    return element("path", d=path_data(viewport.place(junction.area), closed=True), stroke_width=0)


def curbs(junction: SceneJunction, viewport: Viewport, width: float) -> Iterator[str]:
    """The lines round its area, but where roads begin."""
    import numpy as np

    ring = viewport.place(junction.area)
    inner = ring + width / 2.0 * _inward(ring)
    count = len(ring)
    faces = {frozenset((arm.left, arm.right)) for arm in junction.arms}
    breaks = [i for i in range(count) if frozenset((i, (i + 1) % count)) in faces]
    for place, first in enumerate(breaks):
        last = breaks[(place + 1) % len(breaks)]
        length = (last - first - 1) % count
        line = inner[(first + 1 + np.arange(length + 1)) % count]
        if length:
            yield element(
                "path", d=path_data(line), fill="none", stroke=palette.CASING, stroke_width=width
            )


def _inward(ring: Floats) -> Floats:
    """(n, 2) unit vectors into a ring that runs clockwise in pixels (y is down)."""
    import numpy as np

    step = np.roll(ring, -1, axis=0) - ring
    normal = np.stack([step[:, 1], -step[:, 0]], axis=-1)
    normal /= np.maximum(np.hypot(*normal.T), 1e-9)[:, None]
    both = normal + np.roll(normal, 1, axis=0)
    return np.asarray(both / np.maximum(np.hypot(*both.T), 1e-9)[:, None])


def paint(scene: Scene, junctions: Sequence[SceneJunction], viewport: Viewport) -> Iterator[str]:
    """Stop lines, lines to yield at, and turn arrows."""
    roads = {road.name: road for road in scene.roads}
    for junction in junctions:
        if junction.kind == "joint":
            continue
        lanes = _by_lane(junction.connections)
        for connections in lanes.values():
            yield from _line(junction, connections[0], viewport)
        for (road, end, _), connections in lanes.items():
            beside = sum(key[:2] == (road, end) for key in lanes)
            if beside > 1 and roads[road].length - sum(roads[road].trim) > _ARROW_ROOM:
                yield from _arrow(roads[road], connections, viewport)


def _by_lane(
    connections: Iterable[SceneConnection],
) -> dict[tuple[str, str, int], list[SceneConnection]]:
    lanes: dict[tuple[str, str, int], list[SceneConnection]] = {}
    for connection in connections:
        source = connection.source
        lanes.setdefault((source.road, source.end, source.lane), []).append(connection)
    return lanes


def _line(
    junction: SceneJunction, connection: SceneConnection, viewport: Viewport
) -> Iterator[str]:
    """Solid where vehicles stop, broken where they yield."""
    control, road = junction.control, connection.source.road
    stops = control.kind in ("all_way_stop", "signals") or (
        control.kind == "stop" and road in control.minor
    )
    ids = {c.id for c in junction.connections if c.source == connection.source}
    enters = junction.kind == "roundabout" and any(a in ids for a, _ in junction.yields)
    yields = enters or (control.kind == "yield" and road in control.minor)
    if not stops and not yields:
        return
    scale = viewport.pixels_per_meter
    dash = None if stops else " ".join(f"{float(part) * scale:.2f}" for part in _TEETH.split())
    yield element(
        "path",
        d=path_data(viewport.place(connection.stop_line)),
        stroke=palette.MARKING,
        stroke_width=max(_STOP_LINE * scale, 1.4),
        stroke_dasharray=dash,
    )


def _arrow(
    road: SceneRoad, connections: Sequence[SceneConnection], viewport: Viewport
) -> Iterator[str]:
    """Where the lane of the connections leads, painted some meters before the stop line."""
    import numpy as np

    first = connections[0]
    if viewport.pixels_per_meter < _SMALLEST_ARROW:
        return
    at_end = first.source.end == "end"
    face = road.stations[-1] - road.trim[1] if at_end else road.trim[0]
    before = face - _ARROW_BEFORE if at_end else face + _ARROW_BEFORE
    place = np.mean(first.stop_line, axis=0)
    offset = (place - _point(road, face)) @ _left(road, face)
    x, y = _point(road, before) + offset * _left(road, before)
    heading = float(np.interp(before, road.stations, road.heading)) + (0.0 if at_end else np.pi)
    turns = {connection.turn for connection in connections}
    points = arrow(turns, x, y, heading)
    for line, closed in points:
        fill = palette.MARKING if closed else "none"
        width = None if closed else max(0.15 * viewport.pixels_per_meter, 0.4)
        yield element("path", d=path_data(viewport.place(line), closed), fill=fill,
                      stroke=None if closed else palette.MARKING, stroke_width=width)  # fmt: skip


def _point(road: SceneRoad, station: float) -> Floats:
    import numpy as np

    return np.array([np.interp(station, road.stations, column) for column in (road.x, road.y)])


def _left(road: SceneRoad, station: float) -> Floats:
    import numpy as np

    heading = np.interp(station, road.stations, road.heading)
    return np.array([-np.sin(heading), np.cos(heading)])


def signal_heads(junctions: Sequence[SceneJunction], viewport: Viewport) -> Iterator[str]:
    """A box beside each stop line, with the light of the first moment."""
    import numpy as np

    for junction in junctions:
        if junction.control.kind != "signals" or not junction.control.phases:
            continue
        for (_, _, _), connections in _by_lane(junction.connections).items():
            right = np.array(connections[0].stop_line[1])
            x, y = viewport.place(right).tolist()
            yield _head(x, y, light(junction, connections[0].id), viewport.pixels_per_meter)


def _head(x: float, y: float, color: str, scale: float) -> str:
    size = max(0.55 * scale, 2.6)
    return element("circle", cx=x, cy=y, r=size, fill=palette.LIGHTS[color],
                   stroke=palette.INK, stroke_width=0.35 * size)  # fmt: skip


def light(junction: SceneJunction, connection: int, time: float = 0.0) -> str:
    """`green`, `yellow` or `red` of a connection, `time` seconds into the drive."""
    phases = junction.control.phases
    cycle = sum(phase.green + phase.yellow + phase.all_red for phase in phases)
    left = (time + junction.control.offset) % cycle
    for phase in phases:
        has_green = connection in phase.connections
        for color, seconds in (("green", phase.green), ("yellow", phase.yellow)):
            if left < seconds:
                return color if has_green else "red"
            left -= seconds
        if left < phase.all_red:
            return "red"
        left -= phase.all_red
    return "red"
