"""Agents of the kind `police_car`."""

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
class PoliceCar(AgentKind):
    """A police car."""

    name: ClassVar[str] = "police_car"
    category: ClassVar[str] = "car"
    role: ClassVar[str] = "police"
    length: Length = length_option(4.8)
    width: Length = width_option(1.85)
    height: Length = height_option(1.5)
    wheelbase: Length = wheelbase_option(2.85)
    max_steering: Angle = max_steering_option(0.6109)
    mass: Mass = mass_option(1800.0)
    color: String = color_option("#1565c0")
