"""`drive with lane_follow`: follow the center of the lane exactly."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Acceleration, Speed, option

from .driving_options import SlowsForBends, lateral_acceleration_option, target_speed_option
from .steering import along_line, toward

if TYPE_CHECKING:
    from roadlang.api import ControlBatch, ObservationBatch


@dataclass(frozen=True)
class LaneFollow(SlowsForBends):
    """Follow the center of the lane exactly, at a given speed."""

    name: ClassVar[str] = "lane_follow"
    also_called: ClassVar[tuple[str, ...]] = (
        "follow_lane",
        "FollowLane",
        "FollowLaneBehavior",
        "lane_keep",
        "lane_keeping",
        "keep_lane",
        "follow_path",
        "constant_speed",
        "keep_speed",
        "lka",
        "constant_velocity",
    )
    is_elementwise: ClassVar[bool] = True
    speed: Speed = target_speed_option()
    acceleration: Acceleration = option(2.0, above=0, maximum=20, help="maximum acceleration")
    deceleration: Acceleration = option(4.0, above=0, maximum=20, help="maximum deceleration")
    lateral_acceleration: Acceleration = lateral_acceleration_option()

    def controls(self, observations: ObservationBatch, state: None) -> ControlBatch:
        from roadlang.api import ControlBatch

        seen = observations
        target = self.target_speed(seen)
        acceleration = toward(seen.speed, target, self.acceleration, self.deceleration)
        return ControlBatch(along_line(seen), acceleration)
