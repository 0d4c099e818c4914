"""Rows of moved curves by numpy: what `row_loops` does, to the last bit.

Few rows at a time go through all their moves, so that what is known of them stays in the cache.
`MovedBatch` keeps all there is between two moves: with hundreds of rows most of its time goes into
memory.
"""

from __future__ import annotations

import numpy as np

from ..arrays import Booleans, Floats, Integers
from ..numbers.differences import Differences

Steps = tuple[Floats, Floats]
"""East and north of the steps from station to station; round a closed curve the last one too."""


def pushed(
    state: Floats,
    distance: Floats,
    rows: Integers,
    differences: Differences,
    slowest: float,
    limits: tuple[float, float, bool],
    smooth: Booleans,
    velocity: Floats | None = None,
) -> None:
    """As `row_loops.pushed`."""
    x, y, speed, curvature, east, north = (state[:, column] for column in range(6))
    moved = distance[rows] if len(distance) > 1 else distance
    closed = limits[2]
    before = _steps(x, y, closed)
    forward = curvature * moved
    np.subtract(1.0, forward, out=forward)
    forward *= speed
    sideways = differences.derivative(moved)
    if velocity is not None:
        velocity[0], velocity[1] = forward, sideways
    x -= moved * north
    y += moved * east
    bend = differences.derivative(sideways) * forward
    faster = differences.derivative(forward)
    faster *= sideways
    bend -= faster
    size = np.multiply(forward, forward, out=faster)
    size += sideways * sideways
    np.sqrt(size, out=size)
    least = np.maximum(size, slowest)
    bend /= least * least
    bend += speed * curvature
    bend /= least
    toward_east = east * forward
    toward_east -= north * sideways
    north *= forward
    north += east * sideways
    north /= least
    speed[:], curvature[:] = size, bend
    np.divide(toward_east, least, out=east)
    smooth &= _is_smooth(before, _steps(x, y, closed), bend, limits)


def _steps(x: Floats, y: Floats, closed: bool) -> Steps:
    if not closed:
        return x[:, 1:] - x[:, :-1], y[:, 1:] - y[:, :-1]
    around = (np.empty_like(x), np.empty_like(y))
    for line, step in zip((x, y), around, strict=True):
        np.subtract(line[:, 1:], line[:, :-1], out=step[:, :-1])
        np.subtract(line[:, 0], line[:, -1], out=step[:, -1])
    return around


def _is_smooth(
    before: Steps, now: Steps, curvature: Floats, limits: tuple[float, float, bool]
) -> Booleans:
    """(n,) as `smooth_moves.surely_smooth`."""
    least, most, closed = limits
    (old_east, old_north), (east, north) = before, now
    advance = _products(east, north, old_east, old_north).min(axis=1, initial=np.inf)
    onward = _products(east[:, :-1], north[:, :-1], east[:, 1:], north[:, 1:])
    least_onward = onward.min(axis=1, initial=np.inf)
    if closed:
        around = east[:, -1] * east[:, 0] + north[:, -1] * north[:, 0]
        least_onward = np.minimum(least_onward, around)
    is_bent = _greatest(curvature) * _longest(east, north) >= most
    found = (advance > least * _longest(old_east, old_north)) & (least_onward > 0.0) & ~is_bent
    return np.asarray(found)


def _products(a: Floats, b: Floats, c: Floats, d: Floats) -> Floats:
    """a c + b d."""
    found = a * c
    found += b * d
    return found


def _longest(east: Floats, north: Floats) -> Floats:
    """(n,) meters that no step is longer than."""
    across, along = _greatest(east), _greatest(north)
    return np.asarray(np.sqrt(across * across + along * along))


def _greatest(values: Floats) -> Floats:
    """(n,) the greatest size of a row."""
    return np.asarray(np.maximum(values.max(axis=1), -values.min(axis=1)))
