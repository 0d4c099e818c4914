"""`drive with manual`: a human drives."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Acceleration, Angle, Controller, Speed, option


@dataclass(frozen=True)
class Manual(Controller):
    """A human drives in Godot's window: arrows or WASD, space to brake hard; or a gamepad, with the
    left stick and the triggers. Needs `run --window` or `watch`; `drive with replay` drives the
    trace again."""

    name: ClassVar[str] = "manual"
    speed: Speed = option(30.0, above=0, help="speed at which it accelerates no more")
    acceleration: Acceleration = option(4.0, above=0, maximum=20, help="acceleration of full drive")
    deceleration: Acceleration = option(
        8.0, above=0, maximum=20, help="deceleration of full brakes"
    )
    steering: Angle = option(
        0.5, above=0, maximum=1.2, help="greatest steering angle when it is slow"
    )
