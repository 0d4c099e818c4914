"""Roads: surface, edges and lane markings, joined cleanly at the junctions of a network."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from . import palette
from .lanes import bands, lane_lines
from .markup import element, group, path_data

if TYPE_CHECKING:
    from roadlang.api import Scene

    from .ribbon import Ribbon
    from .viewport import Viewport

_CASING = 1.1
_NARROWEST_LANE = 4.0


def roads(
    scene: Scene, ribbons: Mapping[str, Ribbon], names: Sequence[str], viewport: Viewport
) -> str:
    """The roads called `names` in full, in layers so that junctions have no inner edges."""
    shown = [ribbons[name] for name in names]
    discs = list(_junction_discs(scene, ribbons, set(names), viewport))
    casing = [_surface(ribbon, 0.0) for ribbon in shown]
    beside = [shape for ribbon in shown for shape in bands(ribbon, _edge(ribbon), inner=False)]
    surface = [_roadway(ribbon, _edge(ribbon)) for ribbon in shown]
    between = [shape for ribbon in shown for shape in bands(ribbon, 0.0, inner=True)]
    casing += [_disc(x, y, radius) for x, y, radius, _ in discs]
    surface += [_disc(x, y, radius - edge) for x, y, radius, edge in discs]
    return group(
        [
            group(casing, fill=palette.CASING, stroke=palette.CASING, stroke_linejoin="round"),
            group(beside, class_="lanes", stroke="none"),
            group(surface, fill=palette.SURFACE, stroke="none"),
            group(between, class_="lanes", stroke="none"),
            group(_markings(scene, ribbons, shown, viewport), class_="markings"),
        ],
        class_="roads",
    )


def _edge(ribbon: Ribbon) -> float:
    """Pixels of casing to each side: less on roads that are thin in the drawing."""
    return min(_CASING, 0.22 * float(ribbon.half.mean()))


def _surface(ribbon: Ribbon, inset: float) -> str:
    # Nonzero filling keeps the inside of a bend filled that is tighter than half the width.
    return element("path", d=path_data(ribbon.outline(inset), closed=True), stroke_width=0)


def _roadway(ribbon: Ribbon, inset: float) -> str:
    """The drivable lanes, up to the casing where nothing lies beside them."""
    first, last = ribbon.drivable
    alone = (first, last) == (0, len(ribbon.lanes))
    shape = ribbon.outline(inset) if alone else ribbon.band(first, last)
    return element("path", d=path_data(shape, closed=True), stroke_width=0)


def _disc(x: float, y: float, radius: float) -> str:
    return element("circle", cx=x, cy=y, r=max(radius, 0.3), stroke_width=0)


def _junction_discs(
    scene: Scene, ribbons: Mapping[str, Ribbon], names: set[str], viewport: Viewport
) -> Iterator[tuple[float, float, float, float]]:
    """x, y, radius and casing in pixels of the disc that joins the roads at each node."""
    for network in scene.networks:
        for node in network.nodes:
            meeting = [ribbons[name] for name in node.roads if name in names]
            if len(meeting) > 1:
                x, y = viewport.place([node.x, node.y]).tolist()
                widest = max(meeting, key=lambda ribbon: _end_half(ribbon, x, y))
                yield x, y, _end_half(widest, x, y), _edge(widest)


def _end_half(ribbon: Ribbon, x: float, y: float) -> float:
    """Half the width at the end that is at (x, y)."""
    first, last = ribbon.center[0], ribbon.center[-1]
    at_start = abs(first - (x, y)).sum() <= abs(last - (x, y)).sum()
    # What was extracted at a junction may be the width of the whole crossing.
    usual = sorted(ribbon.half.tolist())[len(ribbon.half) // 2]
    return min(float(ribbon.half[0 if at_start else -1]), 1.2 * float(usual))


def _markings(
    scene: Scene, ribbons: Mapping[str, Ribbon], shown: Sequence[Ribbon], viewport: Viewport
) -> Iterator[str]:
    trimmed = _trims(scene, ribbons)
    for ribbon in shown:
        lane = 2 * float(ribbon.half.mean()) / max(sum(lane.drivable for lane in ribbon.lanes), 1)
        if ribbon.widened or lane < _NARROWEST_LANE:
            continue
        before, after = trimmed.get(ribbon.name, (0.0, 0.0))
        end = float(ribbon.stations[-1])
        if before + after >= end:
            continue
        part = ribbon.part(before, end - after) if before or after else ribbon
        yield from lane_lines(part, lane, viewport.pixels_per_meter)


def _trims(scene: Scene, ribbons: Mapping[str, Ribbon]) -> dict[str, tuple[float, float]]:
    """Meters at the start and end of each road that lie in a junction of three or more."""
    trims: dict[str, list[float]] = {}
    roads = {road.name: road for road in scene.roads}
    for network in scene.networks:
        for node in network.nodes:
            if len(node.roads) < 3:
                continue
            radius = 0.62 * max(max(roads[name].width) for name in node.roads if name in roads)
            for name in node.roads:
                road = roads[name]
                ends = [(road.x[0], road.y[0]), (road.x[-1], road.y[-1])]
                near = min(
                    (0, 1), key=lambda i: abs(ends[i][0] - node.x) + abs(ends[i][1] - node.y)
                )
                trims.setdefault(name, [0.0, 0.0])[near] = radius
    return {name: (before, after) for name, (before, after) in trims.items()}
