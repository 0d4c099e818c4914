"""`drive with brake`: brake to a stop in the lane."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Acceleration, Controller, InitialSpeed, Speed, option

from .steering import toward

if TYPE_CHECKING:
    from roadlang.api import ControlBatch, ObservationBatch

STANDING = 0.15
"""m/s: slower is standing."""
HOLDING = 2.0
"""m/s^2: what holds what stands."""
HARDEST_START = 3.0
"""m/s^2: acceleration at most, back to a speed that is kept."""


@dataclass(frozen=True)
class Brake(Controller):
    """Brake at a constant rate down to `speed`, and keep that speed."""

    name: ClassVar[str] = "brake"
    also_called: ClassVar[tuple[str, ...]] = ("decelerate", "slow_down")
    deceleration: Acceleration = option(6.0, above=0, maximum=20, help="deceleration")
    speed: Speed = option(0.0, minimum=0, help="speed at which braking ends")

    def initial_speed(self) -> InitialSpeed:
        return InitialSpeed(self.speed)

    def controls(self, observations: ObservationBatch, state: None) -> ControlBatch:
        import numpy as np

        from roadlang.api import ControlBatch

        now = observations.speed
        held = toward(now, self.speed, HARDEST_START, self.deceleration)
        keeping = np.where(now > self.speed + STANDING, -self.deceleration, held)
        stopping = np.where(np.abs(now) > STANDING, -self.deceleration, -HOLDING)
        acceleration = np.where(self.speed > 0.0, keeping, stopping)
        return ControlBatch(np.full(len(now), np.nan), acceleration)
