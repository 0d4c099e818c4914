"""Evenly spaced points of smooth curves."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from roadlang.geometry import Floats

from .cubic_spline import splined
from .smoothing import evenly, stations
from .spline_rows import FEWEST, splined_each

_APART = 1e-9
"""Neighbors that are nearer to each other, in pixels, are one point."""


def even_points(points: Floats, closed: bool = False, step: float = 1.0) -> Floats:
    """Points (m, 2) about every `step` along the cubic spline through `points` (n, 2).

    A closed curve repeats its first point at the end, and so does the result.
    """
    steps = points[1:] - points[:-1]
    apart = np.hypot(steps[:, 0], steps[:, 1]) > _APART
    if not apart.all():
        points = points[np.append(True, apart)]
    if len(points) < 3:
        length = float(stations(points)[-1])
        share = np.linspace(0.0, 1.0, max(2, round(length / step) + 1))
        return np.asarray(points[0] + share[:, None] * (points[-1] - points[0]))
    if closed:
        points = np.vstack([points[:-1], points[:1]])
    station = stations(points)
    return splined(station, points, _even(station, step), closed)


def even_points_of(lines: Sequence[Floats], steps: Sequence[float]) -> list[Floats]:
    """As `even_points` of each of many open lines, with a step of its own."""
    along = _stations(lines)
    many = [index for index, station in enumerate(along) if station is not None]
    rows = [lines[index] for index in many]
    known = [station for station in along if station is not None]
    places = [_even(station, steps[i]) for i, station in zip(many, known, strict=True)]
    found = dict(zip(many, splined_each(rows, known, places), strict=True)) if many else {}
    return [
        found[index] if index in found else even_points(line, step=steps[index])
        for index, line in enumerate(lines)
    ]


def _stations(lines: Sequence[Floats]) -> list[Floats | None]:
    """Length (n,) along each line at its points; None where it has few, or two in one place."""
    if not lines:
        return []
    points = np.concatenate(lines)
    steps = points[1:] - points[:-1]
    lengths = np.hypot(steps[:, 0], steps[:, 1])
    ends = np.cumsum([len(line) for line in lines])
    apart = lengths > _APART
    apart[ends[:-1] - 1] = True  # from line to line
    doubtful = set(np.searchsorted(ends, np.flatnonzero(~apart), side="right").tolist())
    found: list[Floats | None] = []
    first = 0
    for index, last in enumerate(ends.tolist()):
        station = np.zeros(last - first)
        np.cumsum(lengths[first : last - 1], out=station[1:])
        found.append(None if len(station) < FEWEST or index in doubtful else station)
        first = last
    return found


def _even(station: Floats, step: float) -> Floats:
    """Places (m,) about every `step` from the first station to the last."""
    length = float(station[-1])
    return evenly(length, max(2, round(length / step) + 1))
