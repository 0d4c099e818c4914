"""`drive with stanley`: steer by heading error and cross-track error."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar

from roadlang.api import FREQUENCY, Acceleration, Controller, Speed, option, quantity


@dataclass(frozen=True)
class Stanley(Controller):
    """Steer by heading error and cross-track error at the front axle (Hoffmann et al. 2007)."""

    name: ClassVar[str] = "stanley"
    speed: Speed = option(50 / 3.6, minimum=0, maximum=120, help="target speed")
    gain: Annotated[float, quantity(FREQUENCY)] = option(
        2.5, above=0, help="gain of the cross-track error"
    )
    softening: Speed = option(1.0, above=0, help="softens the steering at low speed")
    acceleration: Acceleration = option(3.0, above=0, maximum=20, help="maximum acceleration")
    deceleration: Acceleration = option(6.0, above=0, maximum=20, help="maximum deceleration")
