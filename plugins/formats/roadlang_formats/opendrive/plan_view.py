"""The reference line of a road: few pieces that stay within a tolerance of its curve."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from roadlang.geometry import Floats, poses_along

from .pieces import FLATTEST_ARC, ReferencePiece, along_cubic, cubic, cubic_length, pose_on

if TYPE_CHECKING:
    from roadlang.api import SceneRoad

_EXACT = 1e-5
"""Meters: what is nearer to a line, arc or clothoid is one."""
_ALONG = 1e-3
"""Meters by which stations on such a piece may be off along it."""
_STRETCHED = 1e-3
"""Share by which its length may differ from that of the stations."""
_STRAIGHT = 1e-7
"""1/m: what bends less does not, and curvatures that differ by less are one."""
_ALL_BUT_STRAIGHT = 1e-6
"""1/m: from what bends less on the average, no length can be told."""
_TURNED = 2e-3
"""Radians by which the direction of a cubic may be off."""
_LONGEST = 100.0
"""Meters of a cubic."""
_WORTH_IT = 5.0
"""Meters from which on an exact piece is preferred to a longer cubic."""


@dataclass(frozen=True)
class SampledLine:
    """Stations (n,), poses (n, 3) there, curvatures (n,), and the poses (n - 1, 3) in between."""

    stations: Floats
    poses: Floats
    curvature: Floats
    between: Floats

    @classmethod
    def of(cls, road: SceneRoad, stations: Floats) -> SampledLine:
        """Of a road of a scene, exactly as it has them where the stations are its own."""
        middles = (stations[1:] + stations[:-1]) / 2.0
        at, curvature = whole_turns(road), np.array(road.curvature)
        if road.closed:
            curvature = np.append(curvature, curvature[0])
        return cls(
            stations,
            poses_between(at, stations),
            np.interp(stations, at[:, 0], curvature),
            poses_between(at, middles),
        )


def whole_turns(road: SceneRoad) -> Floats:
    """(n, 4) station, x, y and heading of all points of a road; a loop ends where it begins."""
    table = np.column_stack((road.stations, road.x, road.y, road.heading))
    if not road.closed:
        return table
    turn = 2.0 * np.pi * np.round((table[-1, 3] - table[0, 3]) / (2.0 * np.pi))
    return np.vstack((table, (road.length, *table[0, 1:3], table[0, 3] + turn)))


def poses_between(table: Floats, stations: Floats) -> Floats:
    """(n, 3) poses at stations (n,): cubics between the rows of station, x, y and heading."""
    after = np.clip(np.searchsorted(table[:, 0], stations), 1, len(table) - 1)
    one, other = table[after - 1], table[after]
    length = (other[:, 0] - one[:, 0])[:, None]
    p = ((stations - one[:, 0]) / length[:, 0])[:, None]
    leaves, enters = (np.column_stack((np.cos(r[:, 3]), np.sin(r[:, 3]))) for r in (one, other))
    step = (other - one)[:, 1:3]
    c = 3.0 * step - length * (2.0 * leaves + enters)
    d = length * (leaves + enters) - 2.0 * step
    points = one[:, 1:3] + p * (length * leaves + p * (c + p * d))
    slope = length * leaves + p * (2.0 * c + 3.0 * p * d)
    near = one[:, 3] + p[:, 0] * (other[:, 3] - one[:, 3])
    heading = np.arctan2(slope[:, 1], slope[:, 0])
    heading += 2.0 * np.pi * np.round((near - heading) / (2.0 * np.pi))
    return np.column_stack((points, heading))


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
    exact = _reach(line, first, lambda end: _is_clothoid(line, first, end))
    free = max(first + 1, _reach(line, first, lambda end: _is_cubic(line, first, end, tolerance)))
    span = line.stations[exact] - line.stations[first]
    if exact >= free or span >= _WORTH_IT:
        return exact, lambda end, s: _clothoid(line, first, end, s)
    return free, lambda end, s: _cubic(line, first, end, s)


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
        np.abs(across).max() < _EXACT
        and np.hypot(*off.T).max() < _ALONG
        and np.hypot(*off[-1]) < 10.0 * _EXACT
        and np.abs(found[:, 2] - poses[:, 2]).max() < 10.0 * _EXACT
    )


def _clothoid_through(line: SampledLine, first: int, end: int) -> tuple[float, float, float]:
    """The curvatures at both ends and the length of what may be a line, an arc or a clothoid.

    Curvatures and headings are exact where stations are off by the error of a long sum of chords,
    so the length is that which turns as far as the headings do.
    """
    curvature = line.curvature[first : end + 1]
    span = float(line.stations[end] - line.stations[first])
    if np.abs(curvature).max() < _STRAIGHT:
        return 0.0, 0.0, span
    inner = curvature[1:-1] if len(curvature) > 2 else curvature
    if np.ptp(inner) < _STRAIGHT:
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
    return bool(np.abs(across).max() < _EXACT and turned.max() < _EXACT)


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
