"""Agents of the kind `bus`."""

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
class Bus(AgentKind):
    """A city bus."""

    name: ClassVar[str] = "bus"
    category: ClassVar[str] = "bus"
    length: Length = length_option(12.0)
    width: Length = width_option(2.55)
    height: Length = height_option(3.1)
    wheelbase: Length = wheelbase_option(5.9)
    max_steering: Angle = max_steering_option(0.6981)
    mass: Mass = mass_option(14000.0)
    color: String = color_option("#c8a415")
