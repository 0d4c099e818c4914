"""`drive with pure_pursuit`: follow the road by aiming at a point ahead."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Acceleration, Controller, Duration, Length, Speed, option


@dataclass(frozen=True)
class PurePursuit(Controller):
    """Steer along the arc to a point ahead in the lane (Coulter 1992)."""

    name: ClassVar[str] = "pure_pursuit"
    speed: Speed = option(50 / 3.6, minimum=0, maximum=120, help="target speed")
    lookahead: Length = option(6.0, above=0, maximum=200, help="lookahead distance")
    lookahead_time: Duration = option(
        0.0, minimum=0, maximum=10, help="adds this time multiplied by the speed to `lookahead`"
    )
    acceleration: Acceleration = option(3.0, above=0, maximum=20, help="maximum acceleration")
    deceleration: Acceleration = option(6.0, above=0, maximum=20, help="maximum deceleration")
