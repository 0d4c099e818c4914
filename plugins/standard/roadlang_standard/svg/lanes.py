"""Lanes in a drawing: strips of color by kind, and the lines between them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from roadlang.api import FIGURE_COLORS, geometry

from . import palette
from .markup import element, path_data

if TYPE_CHECKING:
    from roadlang.geometry import Floats

    from .ribbon import Ribbon

_NARROWEST_STALL = 4.0


def bands(ribbon: Ribbon, inset: float, *, inner: bool) -> Iterator[str]:
    """Lanes that are no plain roadway: beside the drivable lanes, or between them (`inner`).

    The outermost are `inset` pixels narrower, which leaves the casing of the road.
    """
    first, last = ribbon.drivable
    for place, lane in enumerate(ribbon.lanes):
        color = palette.lane_color(lane)
        if inner != (first <= place < last) or (lane.drivable and color == palette.SURFACE):
            continue
        left, right = ribbon.borders[:, place], ribbon.borders[:, place + 1]
        left = left - (inset if place == 0 else 0.0)
        right = right + (inset if place == len(ribbon.lanes) - 1 else 0.0)
        shape = _between(ribbon, left, right)
        yield element("path", d=path_data(shape, closed=True), fill=color, stroke_width=0)


def covers(ribbon: Ribbon, inset: float) -> Iterator[str]:
    """What lies on lanes or is not asphalt, as far as it has a color; the outermost lanes are
    `inset` pixels narrower."""
    last = len(ribbon.lanes)
    for stretch in ribbon.stretches:
        low = max(stretch.start, float(ribbon.stations[0]))
        high = min(stretch.end, float(ribbon.stations[-1]))
        part = ribbon.part(low, high) if high > low else None
        for place, (lane, surface) in enumerate(zip(ribbon.lanes, stretch.surfaces, strict=True)):
            color = FIGURE_COLORS.of_surface(surface)
            if part is None or color is None or lane.raised:
                continue
            left = part.borders[:, place] - (inset if place == 0 else 0.0)
            right = part.borders[:, place + 1] + (inset if place == last - 1 else 0.0)
            shape = _between(part, left, right)
            yield element("path", d=path_data(shape, closed=True), fill=color, stroke_width=0)


def lane_lines(ribbon: Ribbon, lane: float, pixels_per_meter: float) -> Iterator[str]:
    """The lines at the borders of lanes, `lane` pixels wide on average, and parking spaces; none
    where lanes are too narrow to see lines."""
    for stroke in geometry.lane_strokes(ribbon.lanes, ribbon.markings, lane, pixels_per_meter):
        line = ribbon.beside(ribbon.borders[:, stroke.border] + stroke.shift)
        color = palette.CURB if stroke.is_curb else palette.MARKING
        dashes = stroke.dashes and " ".join(f"{part:.2f}" for part in stroke.dashes)
        for part in geometry.unfolded_lines(line, ribbon.center):
            yield _stroke(part, stroke.width, color, dashes)
    for place, kind in enumerate(ribbon.lanes):
        if kind.kind == "parking" and geometry.are_lines_seen(lane):
            yield from _stalls(ribbon, place, geometry.line_width(lane), pixels_per_meter)


def _stalls(ribbon: Ribbon, place: int, thin: float, pixels_per_meter: float) -> Iterator[str]:
    """Lines across a parking strip, a car apart."""
    import numpy as np

    if geometry.PARKING_SPACE * pixels_per_meter < _NARROWEST_STALL:
        return
    at = geometry.parking_lines(float(ribbon.stations[0]), float(ribbon.stations[-1]))
    ends = [
        np.stack([np.interp(at, ribbon.stations, line[:, axis]) for axis in (0, 1)], axis=-1)
        for line in (ribbon.beside(ribbon.borders[:, place + side]) for side in (0, 1))
    ]
    for start, end in zip(*ends, strict=True):
        yield _stroke(np.stack([start, end]), 0.8 * thin, palette.MARKING, None)


def _between(ribbon: Ribbon, left: Floats, right: Floats) -> Floats:
    import numpy as np

    return np.concatenate([ribbon.beside(left), ribbon.beside(right)[::-1]])


def _stroke(points: Floats, width: float, color: str, dash: str | None) -> str:
    return element(
        "path",
        d=path_data(points),
        fill="none",
        stroke=color,
        stroke_width=width,
        stroke_dasharray=dash,
        stroke_linecap="butt",
        stroke_linejoin="round",
    )
