"""`drive with stanley`: steer by heading error and cross-track error."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, ClassVar

from roadlang.api import FREQUENCY, Acceleration, Speed, option, quantity

from .driving_options import SlowsForBends, lateral_acceleration_option, target_speed_option
from .steering import difference, toward

if TYPE_CHECKING:
    from roadlang.api import ControlBatch, ObservationBatch

YAW_DAMPING = 0.1
"""Seconds: without it the car swings above 36 m/s, as tires slip and steering lags."""


@dataclass(frozen=True)
class Stanley(SlowsForBends):
    """Steer by heading error and cross-track error at the front axle, with damping of the yaw
    rate (Hoffmann et al. 2007)."""

    name: ClassVar[str] = "stanley"
    is_elementwise: ClassVar[bool] = True
    speed: Speed = target_speed_option()
    gain: Annotated[float, quantity(FREQUENCY)] = option(
        2.5, above=0, help="gain of the cross-track error"
    )
    softening: Speed = option(1.0, above=0, help="softens the steering at low speed")
    acceleration: Acceleration = option(3.0, above=0, maximum=20, help="maximum acceleration")
    deceleration: Acceleration = option(6.0, above=0, maximum=20, help="maximum deceleration")
    lateral_acceleration: Acceleration = lateral_acceleration_option()

    def controls(self, observations: ObservationBatch, state: None) -> ControlBatch:
        import numpy as np

        from roadlang.api import ControlBatch

        seen, half = observations, 0.5 * observations.wheelbase
        x, y, direction, curvature = seen.line_ahead(half)
        off_x = seen.x + half * np.cos(seen.heading) - x
        off_y = seen.y + half * np.sin(seen.heading) - y
        left = np.cos(direction) * off_y - np.sin(direction) * off_x
        turn = difference(seen.heading, direction)
        steering = turn - np.arctan2(self.gain * left, self.softening + seen.speed)
        steering = steering - YAW_DAMPING * (seen.yaw_rate - seen.speed * curvature)
        target = self.target_speed(seen)
        acceleration = toward(seen.speed, target, self.acceleration, self.deceleration)
        return ControlBatch(steering, acceleration)
