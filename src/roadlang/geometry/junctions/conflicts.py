"""Which connections of a junction vehicles can meet on, and where."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

import numpy as np

from ..arrays import Floats, Integers
from ..networks.junction_model import Conflict, Connection

VEHICLE_GAP = 2.3
"""Meters between the middles of two vehicles of 2 m that pass each other with 0.3 m to spare."""
SWEEP = 4.0
"""Square meters: in a bend, a car takes this times the curvature more to the outside, where its
corners are (`l^2 / 8` for a length of 5.7 m)."""
_FEWEST, _SPACING = 25, 1.6
_BLOCK = 512


def conflicts_of(connections: Sequence[Connection], points: Floats) -> tuple[Conflict, ...]:
    """All pairs whose middle lines, `points` (N, k, 2) at `line_shares`, come closer than
    `VEHICLE_GAP` (or than their lanes are wide) and what cars sweep in their bends."""
    if len(connections) < 2:
        return ()
    widths = np.array([max(c.widths) for c in connections])
    sweeps = SWEEP * np.array([c.curvature for c in connections])
    lengths = np.array([c.length for c in connections])
    first, second = _near_pairs(points, sweeps)
    found = []
    for block in range(0, len(first), _BLOCK):
        a, b = first[block : block + _BLOCK], second[block : block + _BLOCK]
        gap = np.minimum(VEHICLE_GAP, 0.45 * (widths[a] + widths[b]))
        gap = gap + sweeps[a] + sweeps[b]
        away = points[a, :, None] - points[b, None, :]
        close = (away**2).sum(axis=-1) < gap[:, None, None] ** 2
        for row in np.flatnonzero(close.any(axis=(1, 2))).tolist():
            i, j = int(a[row]), int(b[row])
            found.append(
                Conflict(
                    connections[i].id,
                    connections[j].id,
                    _kind(connections[i], connections[j]),
                    _interval(close[row].any(axis=1), float(lengths[i])),
                    _interval(close[row].any(axis=0), float(lengths[j])),
                )
            )
    return tuple(found)


def line_shares(longest: float) -> Floats:
    """(k,) the shares of its length at which `conflicts_of` needs the points of a connection, given
    the length in meters of the longest one: close enough that no crossing is missed."""
    return np.linspace(0.0, 1.0, max(_FEWEST, int(np.ceil(longest / _SPACING)) + 1))


def _near_pairs(points: Floats, sweeps: Floats) -> tuple[Integers, Integers]:
    """Pairs whose boxes come close."""
    around = (VEHICLE_GAP + sweeps)[:, None]
    low, high = points.min(axis=1) - around, points.max(axis=1) + around
    first, second = np.triu_indices(len(points), 1)
    near = ((low[first] <= high[second]) & (low[second] <= high[first])).all(axis=1)
    return first[near], second[near]


def _kind(a: Connection, b: Connection) -> Literal["cross", "merge", "diverge"]:
    if a.source == b.source:
        return "diverge"
    return "merge" if a.target == b.target else "cross"


def _interval(close: np.ndarray, length: float) -> tuple[float, float]:
    """From the first to the last close point, and half a step more."""
    places = np.flatnonzero(close)
    steps = len(close) - 1
    start = max(float(places[0]) - 0.5, 0.0) / steps * length
    return start, min(float(places[-1]) + 0.5, steps) / steps * length
