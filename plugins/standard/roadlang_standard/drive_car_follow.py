"""`drive with car_follow`: keep a time gap to the vehicle ahead in the lane."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Acceleration, Controller, Duration, Length, Speed, option


@dataclass(frozen=True)
class CarFollow(Controller):
    """Follow the vehicle ahead in the lane (intelligent driver model, Treiber et al. 2000)."""

    name: ClassVar[str] = "car_follow"
    speed: Speed = option(50 / 3.6, minimum=0, maximum=120, help="target speed")
    headway: Duration = option(1.5, above=0, maximum=30, help="desired time gap")
    gap: Length = option(2.0, minimum=0, help="desired gap at standstill")
    acceleration: Acceleration = option(1.5, above=0, maximum=20, help="maximum acceleration")
    deceleration: Acceleration = option(2.0, above=0, maximum=20, help="comfortable deceleration")
