"""The roads of a drive's figure: surfaces, lanes beside and between those that are driven on, lines
and what is painted at junctions."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..geometry.arrays import Floats
from ..geometry.cross_section import drivable_borders
from ..geometry.strokes_of_lanes import LaneStroke
from ..ir.scene import Scene, SceneRoad
from ..ir.scene_junctions import SceneJunction
from ..scenes.figure_colors import FIGURE_COLORS
from ..scenes.junction_paint import crosswalk_paint, junction_paint
from .lane_lines import ShownPart, painted_lines, shown_part

_SEAM = 2.0
"""Pixels: areas are drawn so much wider in all, or thin lines of ground show between them."""
_SMALLEST_PAINT = 2.5
"""Pixels of a meter, below which arrows are left out and the stripes of crossings blur."""
_THINNEST = 0.8
"""Pixels, of a painted line."""

Place = Callable[[Floats, Floats], Floats]
"""x and y (n,) in meters as points (n, 2) of the figure."""


def drawn_roads(
    scene: Scene, roads: Sequence[SceneRoad], place: Place, scale: float
) -> Iterator[str]:
    """SVG elements, `scale` pixels for each meter."""
    shown = {road.name for road in roads}
    junctions = [
        junction
        for network in scene.networks
        for junction in network.junctions
        if shown.issuperset(arm.road for arm in junction.arms)
    ]
    parts = [part for road in roads if (part := _Part.of(road)) is not None]
    for part in parts:
        yield from part.bands(place, inner=False)
    for junction in junctions:
        yield _area(place(*np.array(junction.area).T), FIGURE_COLORS.surface)
    for part in parts:
        yield _area(place(*part.between(*part.driven)), FIGURE_COLORS.surface)
    for part in parts:
        yield from part.bands(place, inner=True)
    yield from _lane_lines(roads, place, scale)
    yield from _paint(scene, junctions, place, scale)


@dataclass(frozen=True, eq=False)
class _Part:
    """What the junctions leave of a road, with its lanes."""

    shown: ShownPart
    borders: Floats
    """(L + 1, n) meters left of the curve"""
    colors: tuple[str | None, ...]
    """of each lane; None: plain roadway"""
    driven: tuple[int, int]
    """the outer borders of the drivable lanes"""

    @classmethod
    def of(cls, road: SceneRoad) -> _Part | None:
        part, section = shown_part(road), road.cross_section()
        if part is None:
            return None
        colors = tuple(
            None if lane.drivable else FIGURE_COLORS.raised if lane.raised else FIGURE_COLORS.beside
            for lane in section.lanes
        )
        drivable = np.array([lane.drivable for lane in section.lanes])
        return cls(part, section.border_offsets(part.stations), colors, drivable_borders(drivable))

    def between(self, left: int, right: int) -> Floats:
        """(2, n) x and y around what is between two borders."""
        sides = [self.shown.beside(self.borders[border]) for border in (left, right)]
        return np.concatenate([sides[0], sides[1][::-1]]).T

    def bands(self, place: Place, *, inner: bool) -> Iterator[str]:
        """Lanes with a color of their own: beside the drivable ones, or between them."""
        first, last = self.driven
        for lane, color in enumerate(self.colors):
            if color is not None and inner == (first <= lane < last):
                yield _area(place(*self.between(lane, lane + 1)), color, 0.0 if inner else _SEAM)


def _area(ring: Floats, color: str, seam: float = _SEAM) -> str:
    points = ("%.1f,%.1f " * len(ring) % tuple(ring.ravel().tolist()))[:-1]
    stroke = f' stroke="{color}" stroke-width="{seam:g}"' if seam else ""
    return f'<polygon points="{points}" fill="{color}"{stroke}/>'


def _lane_lines(roads: Sequence[SceneRoad], place: Place, scale: float) -> Iterator[str]:
    """The lines along lanes, a shape for all that look alike."""
    looks: dict[LaneStroke, list[str]] = {}
    for road in roads:
        for line, stroke in painted_lines(road, scale):
            look = replace(stroke, border=0, shift=0.0, width=round(stroke.width, 1))
            looks.setdefault(look, []).append(_path(place(*line.T)))
    for look, lines in looks.items():
        color = FIGURE_COLORS.curb if look.is_curb else FIGURE_COLORS.marking
        yield _stroke("".join(lines), color, look.width, look.dashes)


def _paint(
    scene: Scene, junctions: Sequence[SceneJunction], place: Place, scale: float
) -> Iterator[str]:
    """Stop lines, arrows and crossings: a shape for all that look alike."""
    is_small = scale < _SMALLEST_PAINT
    filled: dict[str, list[str]] = {}
    lines: dict[tuple[float, tuple[float, float] | None], list[str]] = {}
    for shape in (*junction_paint(scene, junctions), *crosswalk_paint(scene)):
        path = _path(place(*shape.points.T))
        if shape.kind == "arrow" and is_small:
            continue
        if shape.width:
            lines.setdefault((shape.width, shape.dashes), []).append(path)
            continue
        faint = is_small and shape.kind == "crossing"
        color = FIGURE_COLORS.faint_marking if faint else FIGURE_COLORS.marking
        filled.setdefault(color, []).append(path + "Z")
    for color, paths in filled.items():
        yield f'<path d="{"".join(paths)}" fill="{color}"/>'
    for (width, dashes), paths in lines.items():
        drawn = None if dashes is None else (dashes[0] * scale, dashes[1] * scale)
        wide = max(width * scale, _THINNEST)
        yield _stroke("".join(paths), FIGURE_COLORS.marking, wide, drawn)


def _path(line: Floats) -> str:
    return "M" + " ".join(["%.1f,%.1f"] * len(line)) % tuple(line.ravel().tolist())


def _stroke(path: str, color: str, width: float, dashes: tuple[float, float] | None) -> str:
    lengths = " ".join(f"{part:.1f}" for part in dashes or ())
    broken = f' stroke-dasharray="{lengths}"' if lengths else ""
    return f'<path d="{path}" fill="none" stroke="{color}" stroke-width="{width:.1f}"{broken}/>'
