"""`drive with lane_follow`: keep to the lane, exactly, at a speed."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Acceleration, Controller, Speed, option


@dataclass(frozen=True)
class LaneFollow(Controller):
    """Follow the middle of the lane at a set speed."""

    name: ClassVar[str] = "lane_follow"
    speed: Speed = option(50 / 3.6, minimum=0, maximum=120, help="what it tries to keep")
    acceleration: Acceleration = option(2.0, above=0, maximum=20, help="the most it speeds up")
    deceleration: Acceleration = option(4.0, above=0, maximum=20, help="the most it slows down")
