"""Agents of the kind `bicycle`."""

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
class Bicycle(AgentKind):
    """A bicycle with its rider."""

    name: ClassVar[str] = "bicycle"
    also_called: ClassVar[tuple[str, ...]] = ("bike", "cyclist")
    category: ClassVar[str] = "bicycle"
    length: Length = length_option(1.8)
    width: Length = width_option(0.6)
    height: Length = height_option(1.7)
    wheelbase: Length = wheelbase_option(1.1)
    max_steering: Angle = max_steering_option(0.6109)
    mass: Mass = mass_option(95.0)
    color: String = color_option("#3a8f3a")
