"""Agents of the kind `fire_truck`."""

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
class FireTruck(AgentKind):
    """A fire truck."""

    name: ClassVar[str] = "fire_truck"
    category: ClassVar[str] = "truck"
    role: ClassVar[str] = "fire"
    length: Length = length_option(8.5)
    width: Length = width_option(2.5)
    height: Length = height_option(3.3)
    wheelbase: Length = wheelbase_option(4.8)
    max_steering: Angle = max_steering_option(0.6109)
    mass: Mass = mass_option(14000.0)
    color: String = color_option("#c62828")
