"""Roads: surface, edges and lane markings, joined cleanly at the junctions of a network."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from roadlang.api import FIGURE_COLORS, junction_surface, shown_junctions

from . import palette
from .junctions import curbs, heads, paint, surface
from .lanes import bands, covers, lane_lines
from .markup import element, group, path_data

if TYPE_CHECKING:
    from roadlang.api import Scene

    from .ribbon import Ribbon
    from .viewport import Viewport

_CASING = 1.1
_SEAM = 0.3


def roads(
    scene: Scene, ribbons: Mapping[str, Ribbon], names: Sequence[str], viewport: Viewport
) -> str:
    """The roads called `names` in full, in layers so that junctions have no inner edges."""
    shown = list(_outside_junctions(scene, ribbons, names, _SEAM))
    marked = _outside_junctions(scene, ribbons, names)
    places = shown_junctions(scene, set(names))
    discs = list(_junction_discs(scene, ribbons, set(names), viewport))
    areas = [surface(place, viewport) for place in places]
    edge = min((_edge(ribbon) for ribbon in shown), default=_CASING)
    curb = [line for place in places for line in curbs(place, viewport, edge)]
    casing = [*areas, *(_surface(ribbon, 0.0) for ribbon in shown)]
    beside = [shape for ribbon in shown for shape in bands(ribbon, _edge(ribbon), inner=False)]
    top = [*areas, *(_roadway(ribbon, _edge(ribbon)) for ribbon in shown)]
    between = [shape for ribbon in shown for shape in bands(ribbon, 0.0, inner=True)]
    covered = [shape for ribbon in shown for shape in covers(ribbon, _edge(ribbon))]
    by_name = {road.name: road for road in scene.roads}
    for place in places:
        color = FIGURE_COLORS.of_surface(junction_surface(place, by_name))
        covered += [surface(place, viewport, color)] if color else []
    casing += [_disc(x, y, radius) for x, y, radius, _ in discs]
    top += [_disc(x, y, radius - edge) for x, y, radius, edge in discs]
    return group(
        [
            group(casing, fill=palette.CASING, stroke=palette.CASING, stroke_linejoin="round"),
            group(beside, class_="lanes", stroke="none"),
            group(top, fill=palette.SURFACE, stroke="none"),
            group(between, class_="lanes", stroke="none"),
            *([group(covered, class_="covers", stroke="none")] if covered else []),
            group(curb, class_="curbs"),
            group(_markings(marked, viewport), class_="markings"),
            group(paint(scene, places, viewport), class_="paint"),
            group(heads(places, viewport), class_="signals"),
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
    """x, y, radius and casing in pixels of the disc that joins the roads at each node, in a scene
    of an earlier version, which has no junctions."""
    for network in scene.networks:
        for node in () if network.junctions else network.nodes:
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
    median = sorted(ribbon.half.tolist())[len(ribbon.half) // 2]
    return min(float(ribbon.half[0 if at_start else -1]), 1.2 * float(median))


def _outside_junctions(
    scene: Scene, ribbons: Mapping[str, Ribbon], names: Sequence[str], seam: float = 0.0
) -> Iterator[Ribbon]:
    """What the junctions leave of the roads, and `seam` meters more where they meet."""
    trims = {road.name: road.trim for road in scene.roads}
    for name in names:
        ribbon, (before, after) = ribbons[name], trims[name]
        end = float(ribbon.stations[-1])
        if ribbon.widened or not (before or after):
            yield ribbon
        elif before + after < end - 0.01:
            yield ribbon.part(before - min(seam, before), end - after + min(seam, after))


def _markings(shown: Iterable[Ribbon], viewport: Viewport) -> Iterator[str]:
    for ribbon in shown:
        lane = 2 * float(ribbon.half.mean()) / max(sum(lane.drivable for lane in ribbon.lanes), 1)
        yield from lane_lines(ribbon, lane, viewport.pixels_per_meter)
