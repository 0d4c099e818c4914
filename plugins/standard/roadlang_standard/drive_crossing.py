"""`drive with crossing`: walk straight across the road."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Controller, Length, Speed, option


@dataclass(frozen=True)
class Crossing(Controller):
    """Cross the road at a right angle and stop on the other side."""

    name: ClassVar[str] = "crossing"
    speed: Speed = option(1.4, above=0, maximum=20, help="walking speed")
    beyond: Length = option(1.0, minimum=0, help="distance to walk past the opposite edge")
