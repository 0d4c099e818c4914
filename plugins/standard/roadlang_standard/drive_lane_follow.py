"""`drive with lane_follow`: follow the center of the lane exactly."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Acceleration, Controller, Speed, option

from .steering import bend_speed, difference, toward

if TYPE_CHECKING:
    from roadlang.api import ControlBatch, ObservationBatch

PREVIEW_TIME = 0.12
"""Seconds by which the curvature is looked up ahead."""
SLOWEST = 3.0
"""m/s: below it, a cross-track error is corrected as at this speed."""


@dataclass(frozen=True)
class LaneFollow(Controller):
    """Follow the center of the lane exactly, at a given speed."""

    name: ClassVar[str] = "lane_follow"
    speed: Speed = option(50 / 3.6, minimum=0, maximum=120, help="target speed")
    acceleration: Acceleration = option(2.0, above=0, maximum=20, help="maximum acceleration")
    deceleration: Acceleration = option(4.0, above=0, maximum=20, help="maximum deceleration")
    lateral_acceleration: Acceleration = option(
        4.5, above=0, maximum=100, help="maximum lateral acceleration; it slows down before bends"
    )

    def controls(self, observations: ObservationBatch, state: None) -> ControlBatch:
        import numpy as np

        from roadlang.api import ControlBatch

        seen = observations
        _, _, _, curvature = seen.line_ahead(PREVIEW_TIME * seen.speed)
        # A car on a circle points along the circle at its rear axle.
        _, _, rear_heading, _ = seen.line_ahead(-0.5 * seen.wheelbase)
        correction = np.arctan(2.0 * seen.cross_track_error / np.maximum(seen.speed, SLOWEST))
        bend = np.arctan(seen.wheelbase * curvature)
        steering = bend + difference(seen.heading, rear_heading) - correction
        target = bend_speed(seen, self.speed, self.lateral_acceleration, self.deceleration)
        acceleration = toward(seen.speed, target, self.acceleration, self.deceleration)
        return ControlBatch(steering, acceleration)
