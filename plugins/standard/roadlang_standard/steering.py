"""What several controllers share: pursuit of a point ahead, and the way to a target speed."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from roadlang.api import ObservationBatch
    from roadlang.geometry import Floats

    Column = Floats | float

SPEED_GAIN = 2.0
"""From a difference in speed to an acceleration, 1/s."""
PLANNED_SHARE = 0.5
"""Share of the greatest deceleration with which drivers plan to brake before a bend."""
NEAREST = 0.5
"""Meters: a point to steer to is no nearer."""


def toward(speed: Floats, target: Column, acceleration: Column, deceleration: Column) -> Floats:
    """(N,) acceleration toward a target speed, within limits."""
    import numpy as np

    return np.minimum(np.maximum(SPEED_GAIN * (target - speed), -deceleration), acceleration)


def target_speed(seen: ObservationBatch, speed: Column | None, deceleration: Column) -> Column:
    """`speed`, or where there is none what the speed limits here and ahead allow: (N,)."""
    import numpy as np

    if speed is not None:
        return speed
    planned = PLANNED_SHARE * deceleration
    now = seen.speed_limit_ahead(planned, 0.0)
    soon = seen.speed_limit_ahead(planned, seen.speed / SPEED_GAIN)
    place = seen.lane_place()
    limit = np.minimum(place.speed_limit, np.minimum(now, soon))
    return np.where(np.isfinite(limit), limit, place.default_speed)


def bend_speed(
    seen: ObservationBatch, speed: Column | None, lateral: Column, deceleration: Column
) -> Floats:
    """(N,) target speed: `speed` or the speed limits, and what the bends ahead allow; it is asked
    for early by as much as `toward` lags behind a target that falls."""
    import numpy as np

    speed = target_speed(seen, speed, deceleration)
    planned = PLANNED_SHARE * deceleration
    now = seen.speed_for_bends(lateral, planned, 0.0)
    soon = seen.speed_for_bends(lateral, planned, seen.speed / SPEED_GAIN)
    return np.minimum(speed, np.minimum(now, soon))


def pursuit(seen: ObservationBatch, distance: Column) -> Floats:
    """(N,) steering angle of the arc from the rear axle through the line, `distance` m on
    (Coulter 1992)."""
    import numpy as np

    x, y, _, _ = seen.line_ahead(distance)
    cosine, sine = np.cos(seen.heading), np.sin(seen.heading)
    to_x = x - seen.x + 0.5 * seen.wheelbase * cosine
    to_y = y - seen.y + 0.5 * seen.wheelbase * sine
    left = cosine * to_y - sine * to_x
    away = np.hypot(to_x, to_y)
    sine_of_bearing = left / np.maximum(away, 1e-9)
    return np.arctan2(2.0 * seen.wheelbase * sine_of_bearing, np.maximum(away, NEAREST))


def along_line(seen: ObservationBatch) -> Floats:
    """(N,) steering angle that keeps to the line."""
    from roadlang.api import line_steering

    return line_steering(seen)


def difference(heading: Floats, other: Floats) -> Floats:
    """(N,) turn from `heading` to `other`, within half a turn."""
    import numpy as np

    turn: Floats = (other - heading + np.pi) % (2.0 * np.pi) - np.pi
    return turn


def ahead_in_lane(seen: ObservationBatch) -> tuple[Floats, Floats]:
    """(N,) gap to the next agent or object in the lane, infinite for none, and its speed."""
    import numpy as np

    gap, speed = seen.vehicle_ahead()
    standing = seen.obstacle_ahead()
    return np.minimum(gap, standing), np.where(standing < gap, 0.0, speed)
