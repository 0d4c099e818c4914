"""Lines through points as few arcs: biarcs (Bolton 1975) that stay within a tolerance."""

from __future__ import annotations

import math
from typing import TypeAlias

import numpy as np

from ..arrays import Floats, norm
from .arms import nearest_on
from .connection_curves import along

Pieces: TypeAlias = tuple[tuple[float, float], ...]
"""(length, curvature) in order"""

_SAME = 1e-4
"""Meters: arcs that part by less over their length are one."""
_SHORTEST = 1e-9
_SHARES = np.linspace(0.0, 1.0, 17)


def arc_spline(points: Floats, headings: Floats, tolerance: float) -> Pieces:
    """Arcs from the first of `points` (n, 2) to the last, with the `headings` (n,) there exactly
    and no farther than `tolerance` meters from the points between them."""
    found: list[tuple[float, float]] = []
    waiting = [(0, len(points) - 1)]
    while waiting:
        first, last = waiting.pop()
        pieces = _biarc(points[first], headings[first], points[last], headings[last])
        inner = points[first : last + 1]
        if last - first > 1 and _deviation(inner, float(headings[first]), pieces) > tolerance:
            middle = (first + last) // 2
            waiting += [(middle, last), (first, middle)]
        else:
            found += pieces
    return _merged(found)


def _biarc(start: Floats, heading: float, stop: Floats, end_heading: float) -> Pieces:
    """Two arcs with tangents of equal length."""
    u = np.array([math.cos(heading), math.sin(heading)])
    v = np.array([math.cos(end_heading), math.sin(end_heading)])
    between = stop - start
    squared, along_both = float(between @ between), float(between @ (u + v))
    root = math.sqrt(along_both**2 + 2.0 * (1.0 - float(u @ v)) * squared)
    reach = squared / max(along_both + root, 1e-12)
    joint = (start + stop + reach * (u - v)) / 2.0
    turn, length = _arc(heading, joint - start)
    turn_on, length_on = _arc(heading + turn, stop - joint)
    return tuple(
        (length, turn / length)
        for length, turn in ((length, turn), (length_on, turn_on))
        if length > _SHORTEST
    )


def _arc(heading: float, chord: Floats) -> tuple[float, float]:
    """The angle by which the arc with this first heading and chord turns, and its length."""
    cosine, sine = math.cos(heading), math.sin(heading)
    dx, dy = float(chord[0]), float(chord[1])
    half = math.atan2(cosine * dy - sine * dx, cosine * dx + sine * dy)
    return 2.0 * half, math.hypot(dx, dy) / max(float(np.sinc(half / math.pi)), 1e-9)


def _deviation(points: Floats, heading: float, pieces: Pieces) -> float:
    """How far the points are from the arcs, or these from the line through the points."""
    if not pieces:
        return float(norm(points - points[0]).max())
    table = np.array(pieces)
    line, _ = along(points[:1], np.array([heading]), table[:, :1].T, table[:, 1:].T, _SHARES)
    apart = nearest_on(points, line[0])[0].max(), nearest_on(line[0], points)[0].max()
    # A chord of the sampled arcs is off by its sagitta, which the other distance is not.
    return float(min(apart))


def _merged(pieces: list[tuple[float, float]]) -> Pieces:
    found: list[tuple[float, float]] = []
    for length, curvature in pieces:
        total = length + (found[-1][0] if found else 0.0)
        if found and abs(found[-1][1] - curvature) * total**2 < _SAME:
            before, bend = found.pop()
            curvature = (before * bend + length * curvature) / total
            length = total
        found.append((length, curvature))
    return tuple(found)
