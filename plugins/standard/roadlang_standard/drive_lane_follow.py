"""`drive with lane_follow`: follow the center of the lane exactly."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Acceleration, Controller, Speed, option


@dataclass(frozen=True)
class LaneFollow(Controller):
    """Follow the center of the lane exactly, at a given speed."""

    name: ClassVar[str] = "lane_follow"
    speed: Speed = option(50 / 3.6, minimum=0, maximum=120, help="target speed")
    acceleration: Acceleration = option(2.0, above=0, maximum=20, help="maximum acceleration")
    deceleration: Acceleration = option(4.0, above=0, maximum=20, help="maximum deceleration")
