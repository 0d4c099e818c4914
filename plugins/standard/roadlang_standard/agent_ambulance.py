"""Agents of the kind `ambulance`."""

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
class Ambulance(AgentKind):
    """An ambulance."""

    name: ClassVar[str] = "ambulance"
    category: ClassVar[str] = "van"
    role: ClassVar[str] = "ambulance"
    length: Length = length_option(6.2)
    width: Length = width_option(2.1)
    height: Length = height_option(2.7)
    wheelbase: Length = wheelbase_option(3.7)
    max_steering: Angle = max_steering_option(0.6109)
    mass: Mass = mass_option(3800.0)
    color: String = color_option("#f5f5f5")
