"""Agents of the kind `child`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import AgentKind, Length, Mass, String, option

from .agent_options import color_option


@dataclass(frozen=True)
class Child(AgentKind):
    """A child on foot."""

    name: ClassVar[str] = "child"
    category: ClassVar[str] = "pedestrian"
    length: Length = option(0.3, above=0, maximum=2, help="front-to-back depth")
    width: Length = option(0.4, above=0, maximum=2, help="shoulder width")
    height: Length = option(1.1, above=0, maximum=3, help="height")
    mass: Mass = option(25.0, above=0, help="body mass")
    color: String = color_option("#ef6c00")
