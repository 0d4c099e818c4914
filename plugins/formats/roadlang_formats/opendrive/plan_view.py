"""The reference line of a road: few pieces that stay within a tolerance of its curve."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from roadlang.geometry import Floats, poses_along

from .pieces import FLATTEST_ARC, ReferencePiece, along_cubic, cubic, cubic_length, pose_on
from .sampled_line import EXACT, STRAIGHT, SampledLine

_ALONG = 1e-3
"""Meters by which stations on such a piece may be off along it."""
_STRETCHED = 1e-3
"""Share by which its length may differ from that of the stations."""
_ALL_BUT_STRAIGHT = 1e-6
"""1/m: from what bends less on the average, no length can be told."""
_TURNED = 4e-3
"""Radians by which the direction of a cubic may be off."""
_LONGEST = 100.0
"""Meters of a cubic."""
_WORTH_IT = 5.0
"""Meters from which on an exact piece is preferred to a longer cubic."""
_MIXED = 3
"""Spans of stations, at most, that one exact piece ends in and the next one begins in."""


@dataclass(frozen=True)
class ReferenceLine:
    """Pieces, and how stations of the road become arc lengths of the pieces."""

    pieces: tuple[ReferencePiece, ...]
    length: float
    _stations: Floats
    _arc_lengths: Floats

    def at(self, stations: Floats) -> Floats:
        """Arc lengths of the reference line at stations of the road."""
        return np.interp(stations, self._stations, self._arc_lengths)

    def pose(self, s: float) -> tuple[float, float, float]:
        """x, y and heading at an arc length of the reference line."""
        piece = self.pieces[max(0, bisect_right(self.pieces, s, key=lambda piece: piece.s) - 1)]
        return pose_on(piece, s - piece.s)


def reference_line(line: SampledLine, tolerance: float) -> ReferenceLine:
    """Lines, arcs and clothoids where the curve has them, else cubics within the tolerance."""
    pieces: list[ReferencePiece] = []
    knots, lengths = [0], [0.0]
    last = len(line.stations) - 1
    while knots[-1] < last:
        first = knots[-1]
        end, make = _longest(line, first, tolerance)
        piece = make(end, lengths[-1])
        pieces.append(piece)
        knots.append(end)
        lengths.append(lengths[-1] + piece.length)
    return ReferenceLine(tuple(pieces), lengths[-1], line.stations[knots], np.array(lengths))


def _longest(
    line: SampledLine, first: int, tolerance: float
) -> tuple[int, Callable[[int, float], ReferencePiece]]:
    """How far one piece reaches from a station, and what makes it."""
    exact = _exact_reach(line, first)
    free = max(first + 1, _reach(line, first, lambda end: _is_cubic(line, first, end, tolerance)))
    span = line.stations[exact] - line.stations[first]
    free = _before_exact(line, first, free)
    if exact >= free or span >= _WORTH_IT or _is_followed(line, first, exact):
        return exact, lambda end, s: _clothoid(line, first, end, s)
    return free, lambda end, s: _cubic(line, first, end, s)


def _before_exact(line: SampledLine, first: int, free: int) -> int:
    """Where the cubic that could end at `free` is to end: where a line, an arc or a clothoid begins
    that is worth it and reaches farther, or is twice as long. A clothoid is looked for only after
    the spans of stations in which another piece ends."""
    for start in range(first + 1, min(first + 1 + _MIXED, free)):
        reached = _exact_reach(line, start)
        span = line.stations[reached] - line.stations[start]
        if span >= (_WORTH_IT if reached >= free else 2.0 * _WORTH_IT):
            return start
    beyond = min(free + 1, len(line.stations) - 1)
    even = np.abs(line.curvature[first:beyond] - line.curvature[beyond - 1]) < STRAIGHT
    start = beyond - int(np.argmin(even[::-1])) if not even.all() else first
    long = line.stations[beyond] - line.stations[start] >= _WORTH_IT
    if long and first < start < free and _is_clothoid(line, start, beyond):
        return start
    return free


def _exact_reach(line: SampledLine, first: int) -> int:
    """How far a line, an arc or a clothoid reaches from a station."""
    return _reach(line, first, lambda end: _is_clothoid(line, first, end))


def _is_followed(line: SampledLine, first: int, end: int) -> bool:
    """Whether a short exact piece leads to one that is worth it."""
    if end == first or end == len(line.stations) - 1:
        return False
    after = _exact_reach(line, end)
    return float(line.stations[after] - line.stations[end]) >= _WORTH_IT


def _reach(line: SampledLine, first: int, fits: Callable[[int], bool]) -> int:
    """The last station up to which a piece fits, by doubling and halving; `first` if none does."""
    last = len(line.stations) - 1
    good, step = first, 1
    while good + step <= last and fits(good + step):
        good += step
        step *= 2
    while step >= 1:
        if good + step <= last and fits(good + step):
            good += step
        step //= 2
    return good


def _is_clothoid(line: SampledLine, first: int, end: int) -> bool:
    before, after, length = _clothoid_through(line, first, end)
    poses = line.poses[first : end + 1]
    if before == after == 0.0:
        return _is_straight(poses)
    if before == after and abs(before) < FLATTEST_ARC:
        return False
    span = line.stations[first : end + 1] - line.stations[first]
    if abs(length / span[-1] - 1.0) > _STRETCHED:
        return False
    found = poses_along(poses[0], (before, after), span * (length / span[-1]))
    off = found[:, :2] - poses[:, :2]
    across = off[:, 1] * np.cos(poses[:, 2]) - off[:, 0] * np.sin(poses[:, 2])
    return bool(
        np.abs(across).max() < EXACT
        and np.hypot(*off.T).max() < _ALONG
        and np.hypot(*off[-1]) < 10.0 * EXACT
        and np.abs(found[:, 2] - poses[:, 2]).max() < 10.0 * EXACT
    )


def _clothoid_through(line: SampledLine, first: int, end: int) -> tuple[float, float, float]:
    """The curvatures at both ends and the length of what may be a line, an arc or a clothoid.

    Curvatures and headings are exact where stations are off by the error of a long sum of chords,
    so the length is that which turns as far as the headings do.
    """
    curvature = np.append(line.curvature[first:end], line.curvature_before[end])
    span = float(line.stations[end] - line.stations[first])
    if np.abs(curvature).max() < STRAIGHT:
        return 0.0, 0.0, span
    inner = curvature[1:-1] if len(curvature) > 2 else curvature
    if np.ptp(inner) < STRAIGHT:
        before = after = float(inner.mean())
    else:
        before, after = float(curvature[0]), float(curvature[-1])
    turn = float(line.poses[end, 2] - line.poses[first, 2])
    mean = (before + after) / 2.0
    return before, after, turn / mean if abs(mean) > _ALL_BUT_STRAIGHT else span


def _is_straight(poses: Floats) -> bool:
    """Whether all points are on the chord, so that long lines are not cut where angles are a
    rounding error off."""
    dx, dy = poses[-1, :2] - poses[0, :2]
    along = np.arctan2(dy, dx)
    off = poses[:, :2] - poses[0, :2]
    across = np.cos(along) * off[:, 1] - np.sin(along) * off[:, 0]
    turned = np.abs(np.sin(poses[:, 2] - along))
    return bool(np.abs(across).max() < EXACT and turned.max() < EXACT)


def _clothoid(line: SampledLine, first: int, end: int, s: float) -> ReferencePiece:
    before, after, length = _clothoid_through(line, first, end)
    x, y, heading = line.poses[first].tolist()
    if before == after == 0.0:
        # From point to point, so that no gap is left.
        dx, dy = (line.poses[end] - line.poses[first])[:2].tolist()
        return ReferencePiece(s, x, y, float(np.arctan2(dy, dx)), float(np.hypot(dx, dy)), "line")
    if before == after:
        return ReferencePiece(s, x, y, heading, length, "arc", (before,))
    return ReferencePiece(s, x, y, heading, length, "spiral", (before, after))


def _is_cubic(line: SampledLine, first: int, end: int, tolerance: float) -> bool:
    length = line.stations[end] - line.stations[first]
    if length > _LONGEST or abs(line.poses[end, 2] - line.poses[first, 2]) > 1.0:
        return False
    numbers = cubic(line.poses[first], line.poses[end], float(length))
    s = line.stations[first : end + 1]
    wanted = np.concatenate((line.poses[first : end + 1], line.between[first:end]))
    at = np.concatenate((s, (s[1:] + s[:-1]) / 2.0))
    points, slopes = along_cubic(numbers, (at - s[0]) / length)
    x, y, heading = line.poses[first]
    cos, sin = np.cos(heading), np.sin(heading)
    off = points @ np.array([[cos, sin], [-sin, cos]]) + (x, y) - wanted[:, :2]
    across = off[:, 1] * np.cos(wanted[:, 2]) - off[:, 0] * np.sin(wanted[:, 2])
    turned = heading + np.arctan2(slopes[:, 1], slopes[:, 0]) - wanted[:, 2]
    return bool(
        np.abs(across).max() < tolerance
        and np.hypot(*off.T).max() < 1.5 * tolerance
        and np.abs(turned).max() < _TURNED
    )


def _cubic(line: SampledLine, first: int, end: int, s: float) -> ReferencePiece:
    length = float(line.stations[end] - line.stations[first])
    numbers = cubic(line.poses[first], line.poses[end], length)
    x, y, heading = line.poses[first].tolist()
    return ReferencePiece(s, x, y, heading, cubic_length(numbers), "paramPoly3", numbers)
