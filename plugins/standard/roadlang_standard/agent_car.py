"""Agents of the kind `car`."""

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
class Car(AgentKind):
    """A passenger car."""

    name: ClassVar[str] = "car"
    also_called: ClassVar[tuple[str, ...]] = ("vehicle", "automobile", "sedan", "suv")
    category: ClassVar[str] = "car"
    length: Length = length_option(4.5)
    width: Length = width_option(1.8)
    height: Length = height_option(1.5)
    wheelbase: Length = wheelbase_option(2.7)
    max_steering: Angle = max_steering_option(0.6109)
    mass: Mass = mass_option(1500.0)
    color: String = color_option("#1f5fa8")
