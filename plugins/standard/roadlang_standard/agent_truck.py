"""Agents of the kind `truck`."""

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
class Truck(AgentKind):
    """A truck."""

    name: ClassVar[str] = "truck"
    also_called: ClassVar[tuple[str, ...]] = ("lorry",)
    category: ClassVar[str] = "truck"
    length: Length = length_option(9.0)
    width: Length = width_option(2.5)
    height: Length = height_option(3.5)
    wheelbase: Length = wheelbase_option(5.2)
    max_steering: Angle = max_steering_option(0.6109)
    mass: Mass = mass_option(12000.0)
    color: String = color_option("#8a4b2a")
