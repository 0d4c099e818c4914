"""Roads joined end to end: one curve, and one cross-section whose lanes begin and end."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..arrays import Floats
from ..curves.curve import Curve
from ..curves.profile import OffsetProfile
from ..curves.spline import PiecewiseCubic
from ..curves.width import WidthProfile
from ..curves.window import ease
from ..errors import GeometryError
from .cross_section import CrossSection
from .lane import Lane
from .lane_alignment import aligned, places_in

SPACING = 1.0
"""Meters between the stations of tapers, at most."""
_SEAM = 1e-6
"""Meters on either side of a seam between which widths that differ may jump."""


@dataclass(frozen=True, eq=False)
class RoadToJoin:
    """A part of a joined road: an open curve with its lanes."""

    curve: Curve
    section: CrossSection


def joined_curve(curves: Sequence[Curve]) -> Curve:
    """The curves end to end, each moved and turned to go on where the one before ends.

    Positions and headings are continuous; the curvature is that of the curves, and jumps where
    they differ. Raises GeometryError for a closed curve.
    """
    if any(curve.closed for curve in curves):
        raise GeometryError("a closed curve cannot be joined to another")
    moved = [curves[0]]
    for curve in curves[1:]:
        moved.append(_continued(moved[-1], curve))
    knots, coefficients, points = [moved[0].spline.knots[:1]], [], [moved[0].points[:1]]
    for curve in moved:
        spline = curve.spline
        knots.append(spline.knots[1:] - spline.knots[0] + knots[-1][-1])
        coefficients.append(spline.coefficients)
        points.append(curve.points[1:])
    spline = PiecewiseCubic(np.concatenate(knots), np.concatenate(coefficients))
    return Curve(spline, False, np.concatenate(points))


def _continued(before: Curve, curve: Curve) -> Curve:
    """A curve, moved and turned to begin where another ends."""
    turn = float(before.heading(before.length)) - float(curve.heading(0.0))
    cosine, sine = math.cos(turn), math.sin(turn)
    rotation = np.array([[cosine, -sine], [sine, cosine]])
    return curve.transformed(rotation, before.points[-1] - rotation @ curve.points[0])


def joined_section(parts: Sequence[RoadToJoin], taper: float) -> CrossSection:
    """The lanes along `joined_curve`: those of all parts, without width where a part has none.

    Lanes of the same kind and direction go on, from the middle outwards. A lane that only one of
    two neighbors has, or whose width differs, tapers over the last or first `taper` meters of the
    wider one, at most half of its length. The reference line goes on without a step, so that what
    lies next to it does too. `SPACING` apart in the tapers.
    """
    sides = [_side(parts, sign) for sign in (1, -1)]
    lanes = [lane for side, sign in zip(sides, (-1, 1), strict=True) for lane in side[::sign]]
    starts = seams([part.curve for part in parts])
    stations = _stations(parts, taper)
    pieces = []
    for lane in lanes:
        columns = _widths(lane.of_parts, parts, stations, taper)
        width = WidthProfile(np.concatenate(_placed(stations, starts)), np.concatenate(columns))
        pieces.append(replace(_pattern(lane.of_parts, parts), id=lane.id, width=width))
    widest = max(parts, key=lambda part: len(part.section.lanes))
    offset = _reference_line(parts, stations, starts)
    return CrossSection(tuple(pieces), widest.section.center_marking, offset)


def parts_with_cut_tapers(parts: Sequence[RoadToJoin], taper: float) -> list[int]:
    """The parts that are less than twice as long as `taper` and in which lanes taper."""
    lanes = [lane.of_parts for sign in (1, -1) for lane in _side(parts, sign)]
    return [
        index
        for index, part in enumerate(parts)
        if part.curve.length < 2.0 * taper and any(_narrows(lane, parts, index) for lane in lanes)
    ]


def _narrows(of_parts: Sequence[Lane | None], parts: Sequence[RoadToJoin], index: int) -> bool:
    """Whether a lane is wider in a part than where a neighbor of it begins or ends."""
    for other, last in ((index - 1, False), (index + 1, True)):
        if 0 <= other < len(parts):
            own = _end_width(of_parts[index], parts[index], last=last)
            if own > _end_width(of_parts[other], parts[other], last=not last) + _SEAM:
                return True
    return False


def seams(curves: Sequence[Curve]) -> list[float]:
    """Arc lengths of the joined curve where each part begins."""
    return [math.fsum(curve.length for curve in curves[:index]) for index in range(len(curves))]


@dataclass(frozen=True)
class _JoinedLane:
    """A lane of the joined road, with that of each part, None where a part has none."""

    id: int
    of_parts: tuple[Lane | None, ...]


def _side(parts: Sequence[RoadToJoin], sign: int) -> list[_JoinedLane]:
    """The lanes of one side, from the middle outwards."""
    listed = [
        sorted((lane for lane in part.section.lanes if lane.id * sign > 0), key=_outward)
        for part in parts
    ]
    keys = [[(lane.kind, lane.direction, lane.drivable) for lane in lanes] for lanes in listed]
    merged = aligned(keys)
    places = [places_in(merged, part) for part in keys]
    found: list[_JoinedLane] = []
    for index in range(len(merged)):
        of_parts = tuple(
            lanes[at.index(index)] if index in at else None
            for lanes, at in zip(listed, places, strict=True)
        )
        found.append(_JoinedLane(sign * (index + 1), of_parts))
    return found


def _outward(lane: Lane) -> int:
    return abs(lane.id)


def _pattern(of_parts: Sequence[Lane | None], parts: Sequence[RoadToJoin]) -> Lane:
    """The lane as the part with the most lanes has it: its line borders on all neighbors."""
    count = [len(part.section.lanes) for part in parts]
    there = [index for index, lane in enumerate(of_parts) if lane is not None]
    lane = of_parts[max(there, key=lambda index: (count[index], -index))]
    assert lane is not None
    limits = {other.speed_limit for other in of_parts if other is not None}
    known = [limit for limit in limits if limit is not None]
    return replace(lane, speed_limit=min(known, default=None))


def _stations(parts: Sequence[RoadToJoin], taper: float) -> list[Floats]:
    """Of each part, arc lengths from its start: where widths change, and close ones in tapers."""
    found = []
    for part in parts:
        length = part.curve.length
        near, close = min(taper, length / 2.0), 2.0 * _SEAM
        count = max(2, math.ceil(near / SPACING) + 1)
        listed = [lane.width.stations for lane in part.section.lanes]
        offset = part.section.center_offset
        listed += [] if offset is None else [offset.stations]
        inner = np.concatenate(listed)
        inner = inner[(inner > close) & (inner < length - close)]
        ends = np.linspace(0.0, near, count), np.linspace(length - near, length, count)
        every = np.unique(np.concatenate([*ends, inner]))
        # Two that differ by rounding alone may be one along the joined road.
        found.append(every[np.append(True, np.diff(every) > close)])
    return found


def _placed(stations: list[Floats], starts: list[float]) -> list[Floats]:
    """Stations of the parts along the joined road. The end of a part and the start of the next are
    a hair apart."""
    placed = []
    for index, (local, start) in enumerate(zip(stations, starts, strict=True)):
        along = start + local
        if index + 1 < len(stations):
            along[-1] -= _SEAM
        placed.append(along)
    return placed


def _widths(
    of_parts: Sequence[Lane | None],
    parts: Sequence[RoadToJoin],
    stations: list[Floats],
    taper: float,
) -> list[Floats]:
    """Of each part, the widths of a lane at its stations."""
    columns = []
    for index, (lane, part, local) in enumerate(zip(of_parts, parts, stations, strict=True)):
        width = np.zeros(len(local)) if lane is None else lane.width.at(local)
        near = min(taper, part.curve.length / 2.0)
        if index > 0:
            target = _end_width(of_parts[index - 1], parts[index - 1], last=True)
            width = _tapered(width, target, local / near)
        if index + 1 < len(parts):
            target = _end_width(of_parts[index + 1], parts[index + 1], last=False)
            width = _tapered(width, target, (part.curve.length - local) / near)
        columns.append(width)
    return columns


def _end_width(lane: Lane | None, part: RoadToJoin, *, last: bool) -> float:
    return 0.0 if lane is None else float(lane.width.at(part.curve.length if last else 0.0))


def _tapered(widths: Floats, target: float, share: Floats) -> Floats:
    """`widths`, narrowed toward `target` where `share` of the taper is below 1; never widened."""
    return np.where(widths > target, target + (widths - target) * ease(share), widths)


def _reference_line(
    parts: Sequence[RoadToJoin], stations: list[Floats], starts: list[float]
) -> OffsetProfile:
    """How far left of the curve the line between lanes 1 and -1 lies, without a step."""
    columns: list[Floats] = []
    for part, local in zip(parts, stations, strict=True):
        count = sum(lane.id > 0 for lane in part.section.lanes)
        border = part.section.border_offsets(local)[count]
        columns.append(border if not columns else border - border[0] + columns[-1][-1])
    return OffsetProfile(np.concatenate(_placed(stations, starts)), np.concatenate(columns))
