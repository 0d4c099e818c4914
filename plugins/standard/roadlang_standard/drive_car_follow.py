"""`drive with car_follow`: keep a time gap to the vehicle ahead in the lane."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import STANDING_GAP, Acceleration, Duration, Length, Speed, option

from .driving_options import SlowsForBends, lateral_acceleration_option, target_speed_option
from .steering import ahead_in_lane, along_line, toward

if TYPE_CHECKING:
    from roadlang.api import ControlBatch, ObservationBatch

HARDEST = 9.0
"""m/s^2: deceleration in an emergency."""
SLOWEST = 0.1
"""m/s: target speeds are no lower, and gaps no smaller in meters."""


@dataclass(frozen=True)
class CarFollow(SlowsForBends):
    """Follow the vehicle ahead in the lane, and stop before objects that stand in it (intelligent
    driver model, Treiber et al. 2000)."""

    name: ClassVar[str] = "car_follow"
    also_called: ClassVar[tuple[str, ...]] = (
        "idm",
        "acc",
        "follow_vehicle",
        "follow_car",
        "follow_leader",
        "cruise_control",
        "adaptive_cruise_control",
    )
    keeps_distance: ClassVar[bool] = True
    for_vehicles: ClassVar[bool] = True
    speed: Speed = target_speed_option()
    headway: Duration = option(1.5, above=0, maximum=30, help="desired time gap")
    gap: Length = option(STANDING_GAP, minimum=0, help="desired gap at standstill")
    acceleration: Acceleration = option(1.5, above=0, maximum=20, help="maximum acceleration")
    deceleration: Acceleration = option(2.0, above=0, maximum=20, help="comfortable deceleration")
    lateral_acceleration: Acceleration = lateral_acceleration_option()

    def controls(self, observations: ObservationBatch, state: None) -> ControlBatch:
        import numpy as np

        from roadlang.api import ControlBatch

        seen, speed = observations, observations.speed
        target = self.target_speed(seen)
        share = speed / np.maximum(target, SLOWEST)
        gap, ahead = ahead_in_lane(seen)
        braking = speed * (speed - ahead)
        braking = braking / (2.0 * np.sqrt(self.acceleration * self.deceleration))
        wanted = self.gap + np.maximum(0.0, speed * self.headway + braking)
        pull = np.where(np.isfinite(gap), wanted / np.maximum(gap, SLOWEST), 0.0)
        free = 1.0 - share * share * share * share
        acceleration = self.acceleration * (free - pull * pull)
        acceleration = np.minimum(np.maximum(acceleration, -HARDEST), self.acceleration)
        # The model brakes too little where the target falls: before bends and lower limits.
        slower = toward(speed, target, self.acceleration, self.deceleration)
        acceleration = np.where(speed > target, np.minimum(acceleration, slower), acceleration)
        return ControlBatch(along_line(seen), acceleration)
