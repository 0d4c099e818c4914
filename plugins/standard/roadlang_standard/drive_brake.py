"""`drive with brake`: slow down to a stop, keeping to the lane."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Acceleration, Controller, Speed, option


@dataclass(frozen=True)
class Brake(Controller):
    """Brake steadily, down to `speed`, and stay there."""

    name: ClassVar[str] = "brake"
    deceleration: Acceleration = option(6.0, above=0, maximum=20, help="how hard")
    speed: Speed = option(0.0, minimum=0, help="where the braking ends")
