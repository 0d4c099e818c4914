"""Agents of the kind `tractor`."""

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
class Tractor(AgentKind):
    """A farm tractor."""

    name: ClassVar[str] = "tractor"
    category: ClassVar[str] = "tractor"
    length: Length = length_option(4.6)
    width: Length = width_option(2.3)
    height: Length = height_option(2.9)
    wheelbase: Length = wheelbase_option(2.6)
    max_steering: Angle = max_steering_option(0.7)
    mass: Mass = mass_option(6000.0)
    color: String = color_option("#2e7d32")
