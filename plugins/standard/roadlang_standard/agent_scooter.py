"""Agents of the kind `scooter`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import AgentKind, Angle, Length, Mass, String

from .agent_options import (
    color_option,
    height_option,
    length_option,
    mass_option,
    max_steering_option,
    wheelbase_option,
    width_option,
)


@dataclass(frozen=True)
class Scooter(AgentKind):
    """An electric kick scooter with its rider."""

    name: ClassVar[str] = "scooter"
    category: ClassVar[str] = "bicycle"
    length: Length = length_option(1.2)
    width: Length = width_option(0.6)
    height: Length = height_option(1.75)
    wheelbase: Length = wheelbase_option(0.95)
    max_steering: Angle = max_steering_option(0.6109)
    mass: Mass = mass_option(90.0)
    color: String = color_option("#455a64")
