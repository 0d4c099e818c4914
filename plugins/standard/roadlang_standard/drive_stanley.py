"""`drive with stanley`: follow the road by its error and heading at the front axle."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import FREQUENCY, Acceleration, Controller, Speed, option, quantity


@dataclass(frozen=True)
class Stanley(Controller):
    """Steer by heading error and cross-track error at the front axle (Hoffmann et al. 2007)."""

    name: ClassVar[str] = "stanley"
    speed: Speed = option(50 / 3.6, minimum=0, maximum=120, help="what it tries to keep")
    gain: quantity(FREQUENCY) = option(2.5, above=0, help="steering for cross-track error")
    softening: Speed = option(1.0, above=0, help="keeps the steering calm when slow")
    acceleration: Acceleration = option(3.0, above=0, maximum=20, help="the most it speeds up")
    deceleration: Acceleration = option(6.0, above=0, maximum=20, help="the most it slows down")
