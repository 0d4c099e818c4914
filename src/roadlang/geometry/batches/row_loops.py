"""Loops over rows of moved curves that numba compiles. Python never runs them; what they do to the
last bit is what `moved_batch` and `smooth_moves` do with numpy.

A row stays in the fastest cache from its first number to its last result, where numpy goes through
all rows once for each sum and product.
"""

from __future__ import annotations

from typing import Any

import numpy as np


def pushed(
    state: Any, distance: Any, rows: Any, stencil: Any, limits: Any, smooth: Any, velocity: Any
) -> None:
    """Move curves by rows of `distance` (n or 1, S) along their left normals, in place.

    `state`: (B, 6, S) x, y, speed, curvature, and the unit vector along the curve, to the east and
    to the north. `smooth` (B,): stays True where a curve is certain not to fold by `limits`, the
    least advance and the greatest bend, and whether it is closed. `velocity` (2, B, S), where there
    is one: forward and to the left of what was moved.
    """
    scale, slowest, ends = stencil
    count = state.shape[2]
    moved, faster, turning = np.empty(count), np.empty(count), np.empty(count)
    before, forward, sideways = np.empty((6, count)), np.empty(count), np.empty(count)
    for row in range(len(rows)):
        now = state[row]
        of = rows[row] if len(distance) > 1 else 0
        # Loops: to copy whole arrays numba would compile texts of errors, for three seconds.
        for column in range(6):
            for at in range(count):
                before[column, at] = now[column, at]
        for at in range(count):
            moved[at] = distance[of, at]
        pushed_points(before, moved, now)
        differenced(moved, scale, ends, sideways)
        speed, curvature = before[2], before[3]
        for at in range(count):
            forward[at] = (1.0 - curvature[at] * moved[at]) * speed[at]
        if velocity.shape[1] > 0:
            for at in range(count):
                velocity[0, row, at], velocity[1, row, at] = forward[at], sideways[at]
        differenced(forward, scale, ends, faster)
        differenced(sideways, scale, ends, turning)
        pushed_frame(before, (forward, sideways), (faster, turning), slowest, now)
        smooth[row] = smooth[row] and is_smooth(before, now, limits)


def pushed_points(before: Any, moved: Any, now: Any) -> None:
    """x and y."""
    old_x, old_y, east, north = before[0], before[1], before[4], before[5]
    x, y = now[0], now[1]
    for at in range(len(moved)):
        x[at] = old_x[at] - moved[at] * north[at]
        y[at] = old_y[at] + moved[at] * east[at]


def pushed_frame(before: Any, velocity: Any, change: Any, slowest: float, now: Any) -> None:
    """Speed, curvature and direction."""
    (forward, sideways), (faster, turning) = velocity, change
    old_speed, old_curvature, east, north = before[2], before[3], before[4], before[5]
    speed, curvature, to_east, to_north = now[2], now[3], now[4], now[5]
    for at in range(len(forward)):
        speed[at] = np.sqrt(forward[at] * forward[at] + sideways[at] * sideways[at])
    for at in range(len(forward)):
        least = speed[at] if speed[at] > slowest else slowest
        bend = turning[at] * forward[at] - faster[at] * sideways[at]
        curvature[at] = (bend / (least * least) + old_speed[at] * old_curvature[at]) / least
    for at in range(len(forward)):
        least = speed[at] if speed[at] > slowest else slowest
        to_east[at] = (east[at] * forward[at] - north[at] * sideways[at]) / least
        to_north[at] = (north[at] * forward[at] + east[at] * sideways[at]) / least


def differenced(values: Any, scale: float, ends: Any, out: Any) -> None:
    """The first derivative along even stations."""
    for at in range(1, len(values) - 1):
        out[at] = (values[at + 1] - values[at - 1]) * scale
    for at, places, weights in ((0, ends[0], ends[1]), (len(values) - 1, ends[2], ends[3])):
        total = values[places[0]] * weights[0]
        for index in range(1, len(places)):
            total += values[places[index]] * weights[index]
        out[at] = total


def is_smooth(before: Any, now: Any, limits: Any) -> bool:
    """Whether a curve that was moved is certain not to fold."""
    least, most, closed = limits
    count = before.shape[1]
    advance, onward, bend = np.inf, np.inf, 0.0
    east, north, old_east, old_north = 0.0, 0.0, 0.0, 0.0
    # Of a closed curve the step before the first is the last one.
    x, y = now[0, 0] - now[0, count - 1], now[1, 0] - now[1, count - 1]
    for at in range(count if closed else count - 1):
        end = at + 1 if at + 1 < count else 0
        earlier_x, earlier_y = x, y
        x, y = now[0, end] - now[0, at], now[1, end] - now[1, at]
        old_x, old_y = before[0, end] - before[0, at], before[1, end] - before[1, at]
        advance = min(advance, x * old_x + y * old_y)
        if closed or at > 0:
            onward = min(onward, earlier_x * x + earlier_y * y)
        east, north = max(east, abs(x)), max(north, abs(y))
        old_east, old_north = max(old_east, abs(old_x)), max(old_north, abs(old_y))
    for at in range(count):
        bend = max(bend, abs(now[3, at]))
    longest = np.sqrt(east * east + north * north)
    old_longest = np.sqrt(old_east * old_east + old_north * old_north)
    return bool(advance > least * old_longest and onward > 0.0 and not bend * longest >= most)
