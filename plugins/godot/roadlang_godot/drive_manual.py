"""`drive with manual`: a human drives."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Acceleration, Angle, Controller, Speed, option


@dataclass(frozen=True)
class Manual(Controller):
    """A human drives in Godot's window, with the arrow keys or WASD (space bar: brake hard)
    or with the left stick and the triggers of a gamepad. Needs `run --window` or `watch`;
    `drive with replay` replays the trace."""

    name: ClassVar[str] = "manual"
    also_called: ClassVar[tuple[str, ...]] = ("keyboard", "joystick")
    speed: Speed = option(30.0, above=0, help="top speed")
    acceleration: Acceleration = option(
        4.0, above=0, maximum=20, help="acceleration at full throttle"
    )
    deceleration: Acceleration = option(
        8.0, above=0, maximum=20, help="deceleration at full braking"
    )
    steering: Angle = option(0.5, above=0, maximum=1.2, help="largest steering angle at low speed")
