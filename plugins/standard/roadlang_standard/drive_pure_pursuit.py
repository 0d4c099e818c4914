"""`drive with pure_pursuit`: follow the road by aiming at a point ahead."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Acceleration, Duration, Length, Speed, option

from .driving_options import SlowsForBends, lateral_acceleration_option, target_speed_option
from .steering import pursuit, toward

if TYPE_CHECKING:
    from roadlang.api import ControlBatch, ObservationBatch
    from roadlang.geometry import Floats

NEAR, FAST, LATER = 6.0, 15.0, 0.5
"""Meters to the point that a car steers to, m/s from which on it is farther, and seconds of what
it is faster."""


@dataclass(frozen=True)
class PurePursuit(SlowsForBends):
    """Steer along the arc to a point ahead in the lane (Coulter 1992)."""

    name: ClassVar[str] = "pure_pursuit"
    is_elementwise: ClassVar[bool] = True
    speed: Speed = target_speed_option()
    lookahead: Length | None = option(
        None, above=0, maximum=200,
        help="lookahead distance; by default 6 m, and above 54 km/h 0.5 m more for each m/s",
        example="6m",
    )  # fmt: skip
    lookahead_time: Duration = option(
        0.0, minimum=0, maximum=10, help="adds this time multiplied by the speed to `lookahead`"
    )
    acceleration: Acceleration = option(3.0, above=0, maximum=20, help="maximum acceleration")
    deceleration: Acceleration = option(6.0, above=0, maximum=20, help="maximum deceleration")
    lateral_acceleration: Acceleration = lateral_acceleration_option()

    def controls(self, observations: ObservationBatch, state: None) -> ControlBatch:
        from roadlang.api import ControlBatch

        seen = observations
        steering = pursuit(seen, self._lookahead(seen) + self.lookahead_time * seen.speed)
        target = self.target_speed(seen)
        acceleration = toward(seen.speed, target, self.acceleration, self.deceleration)
        return ControlBatch(steering, acceleration)

    def _lookahead(self, seen: ObservationBatch) -> Floats | float:
        """(N,) meters. A point so near that the steering is late for it makes fast cars weave."""
        import numpy as np

        if self.lookahead is not None:
            return self.lookahead
        farther: Floats = NEAR + LATER * np.maximum(seen.speed - FAST, 0.0)
        return farther
