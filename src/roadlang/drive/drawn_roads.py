"""The roads of a drive's figure: surfaces, lanes beside and between those that are driven on, lines
and what is painted at junctions."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

from ..geometry.arrays import Floats
from ..geometry.lanes.strokes_of_lanes import LaneStroke
from ..ir.scene import Scene, SceneRoad
from ..ir.scene_junctions import SceneJunction
from ..scenes.figure_colors import FIGURE_COLORS
from ..scenes.junction_paint import crosswalk_paint, junction_paint
from ..scenes.shown_junctions import shown_junctions
from .lane_bands import bands_and_lines, lane_bands
from .lane_lines import TOLERANCE, painted_lines, shown_part
from .road_areas import road_areas

_SEAM = 2.0
"""Areas are drawn wider by this many pixels in total; otherwise thin lines of ground show between
them."""
_UNSEEN = 0.25
"""Pixels by which a drawn line may be off."""
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
    junctions = shown_junctions(scene, {road.name for road in roads})
    parts = [part for road in roads if (part := shown_part(road)) is not None]
    tolerance = min(TOLERANCE, _UNSEEN / scale)
    painted = [found for part in parts for found in painted_lines(part, scale)]
    bands, lines = bands_and_lines(
        [band for part in parts for band in lane_bands(part)],
        [line for line, _ in painted],
        tolerance,
    )
    for area in road_areas(bands, junctions, {road.name: road for road in scene.roads}):
        yield _area(place(*area.ring.T), area.color, 0.0 if area.inner else _SEAM)
    yield from _lane_lines(lines, [stroke for _, stroke in painted], place)
    yield from _paint(scene, junctions, place, scale)


def _area(ring: Floats, color: str, seam: float) -> str:
    points = ("%.1f,%.1f " * len(ring) % tuple(ring.ravel().tolist()))[:-1]
    stroke = f' stroke="{color}" stroke-width="{seam:g}"' if seam else ""
    return f'<polygon points="{points}" fill="{color}"{stroke}/>'


def _lane_lines(
    lines: Sequence[Floats], strokes: Sequence[LaneStroke], place: Place
) -> Iterator[str]:
    """The lines along lanes, a shape for all that look alike."""
    looks: dict[LaneStroke, list[str]] = {}
    for line, stroke in zip(lines, strokes, strict=True):
        look = replace(stroke, border=0, shift=0.0, width=round(stroke.width, 1))
        looks.setdefault(look, []).append(_path(place(*line.T)))
    for look, paths in looks.items():
        color = FIGURE_COLORS.curb if look.is_curb else FIGURE_COLORS.marking
        yield _stroke("".join(paths), color, look.width, look.dashes)


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
