"""Roads as outlines in meters, with few points."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ..drive.lane_bands import bands_and_lines, lane_bands
from ..drive.lane_lines import line_beside, painted_lines, shown_part, with_few_points
from ..geometry.arrays import Floats
from ..ir.scene import Scene, SceneRoad
from ..ir.scene_junctions import SceneJunction
from ..ir.surface_stretches import junction_surface
from ..scenes.figure_colors import FIGURE_COLORS
from ..scenes.junction_paint import PaintedShape, crosswalk_paint, junction_paint
from ..scenes.paint_rings import paint_rings
from ..scenes.shown_junctions import shown_junctions
from .decimation import deltas

CENTIMETERS = 100.0
_SCALE = 10.0
"""Pixels per meter of the page when it shows a stretch of road close by"""
_SEEN = ("crossing", "stop_line", "yield_line")
"""What is painted for a report, of all that is painted."""


@dataclass(frozen=True)
class Outline:
    """What is drawn of a road or junction. Meters."""

    surface: Floats
    """(n, 2) a ring"""
    lines: tuple[tuple[Floats, bool], ...] = ()
    """between lanes, and whether each is broken"""
    bands: tuple[tuple[Floats, bool], ...] = ()
    """rings of lanes that nobody drives on, and whether each is raised"""
    paint: tuple[Floats, ...] = ()
    """rings of what is painted"""
    covers: tuple[tuple[Floats, str], ...] = ()
    """rings of lanes with another surface than asphalt, and their colors"""

    def record(self) -> dict[str, Any]:
        """For the page: deltas in centimeters."""
        return {
            "surface": _flat(self.surface),
            "lines": [[_flat(line), int(broken)] for line, broken in self.lines],
            "bands": [[_flat(ring), int(raised)] for ring, raised in self.bands],
            "paint": [_flat(ring) for ring in self.paint],
            "covers": [[_flat(ring), color] for ring, color in self.covers],
        }


def outlines(scene: Scene) -> list[Outline]:
    """The roads that are driven, and the junctions of their networks, with what is painted."""
    roads = [outline(road, _crosswalks(scene, road)) for road in _driven(scene)]
    by_name = {road.name: road for road in scene.roads}
    for junction in _junctions(scene):
        area, paint = np.array(junction.area), _painted(junction_paint(scene, [junction]))
        color = FIGURE_COLORS.of_surface(junction_surface(junction, by_name))
        roads.append(Outline(area, paint=paint, covers=((area, color),) if color else ()))
    return roads


def surfaces(scene: Scene) -> list[Floats]:
    """The surfaces of `outlines`, (n, 2) each."""
    areas = (np.array(junction.area) for junction in _junctions(scene))
    return [*map(surface, _driven(scene)), *areas]


def _driven(scene: Scene) -> list[SceneRoad]:
    return [road for road in scene.roads if road.derived] or list(scene.roads)


def _junctions(scene: Scene) -> Iterator[SceneJunction]:
    names = {road.name for road in _driven(scene)}
    return (one for one in shown_junctions(scene, names) if len(one.area) > 2)


def _crosswalks(scene: Scene, road: SceneRoad) -> tuple[Floats, ...]:
    here = tuple(marking for marking in scene.markings if marking.road == road.name)
    return _painted(crosswalk_paint(replace(scene, markings=here))) if here else ()


def _painted(shapes: Iterable[PaintedShape]) -> tuple[Floats, ...]:
    """Rings of what is seen when a whole town is shown."""
    return tuple(paint_rings(shape for shape in shapes if shape.kind in _SEEN))


def outline(road: SceneRoad, paint: tuple[Floats, ...] = ()) -> Outline:
    """A road with its lanes, and what is painted across them."""
    part = shown_part(road)
    if part is None:
        return Outline(surface(road), paint=paint)
    last = len(part.section.lanes)
    # The surface shows where the road ends: a page of many roads stays small.
    inner = [(line, s) for line, s in painted_lines(part, _SCALE) if 0 < s.border < last]
    beside = [band for band in lane_bands(part) if band.cover or not band.is_driven]
    bands, lines = bands_and_lines(beside, [line for line, _ in inner])
    return Outline(
        surface(road),
        tuple((line, s.dashes is not None) for line, (_, s) in zip(lines, inner, strict=True)),
        tuple((band.ring, band.raised) for band in bands if band.cover is None),
        paint,
        tuple((band.ring, band.cover) for band in bands if band.cover is not None),
    )


def surface(road: SceneRoad) -> Floats:
    """(n, 2) around all lanes of a road, inside junctions too."""
    borders = road.cross_section().border_offsets(np.array(road.stations))
    sides = [line_beside(road, border) for border in (borders[0], borders[-1])]
    if road.closed:  # out along one side, back along the other: a ring with a hole
        sides = [np.concatenate([side, side[:1]]) for side in sides]
    left, right = with_few_points(sides)
    return np.concatenate([left, right[::-1]])


def _flat(points: Floats) -> list[list[int]]:
    return [deltas(points[:, 0], CENTIMETERS), deltas(points[:, 1], CENTIMETERS)]
