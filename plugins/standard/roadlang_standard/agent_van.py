"""Agents of the kind `van`."""

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
class Van(AgentKind):
    """A delivery van."""

    name: ClassVar[str] = "van"
    category: ClassVar[str] = "van"
    length: Length = length_option(5.9)
    width: Length = width_option(2.0)
    height: Length = height_option(2.5)
    wheelbase: Length = wheelbase_option(3.6)
    max_steering: Angle = max_steering_option(0.6109)
    mass: Mass = mass_option(2500.0)
    color: String = color_option("#e8e8e8")
