"""`drive with brake`: brake to a stop in the lane."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Acceleration, Controller, Speed, option


@dataclass(frozen=True)
class Brake(Controller):
    """Brake at a constant rate down to `speed`, and keep that speed."""

    name: ClassVar[str] = "brake"
    deceleration: Acceleration = option(6.0, above=0, maximum=20, help="deceleration")
    speed: Speed = option(0.0, minimum=0, help="speed at which braking ends")
