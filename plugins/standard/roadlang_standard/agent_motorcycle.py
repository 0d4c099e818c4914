"""Agents of the kind `motorcycle`."""

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
class Motorcycle(AgentKind):
    """A motorcycle."""

    name: ClassVar[str] = "motorcycle"
    also_called: ClassVar[tuple[str, ...]] = ("motorbike",)
    category: ClassVar[str] = "motorcycle"
    length: Length = length_option(2.2)
    width: Length = width_option(0.8)
    height: Length = height_option(1.4)
    wheelbase: Length = wheelbase_option(1.5)
    max_steering: Angle = max_steering_option(0.5236)
    mass: Mass = mass_option(280.0)
    color: String = color_option("#333333")
