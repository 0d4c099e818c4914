"""Agents of the kind `pedestrian`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import AgentKind, Length, Mass, String, option

from .agent_options import color_option


@dataclass(frozen=True)
class Pedestrian(AgentKind):
    """A pedestrian."""

    name: ClassVar[str] = "pedestrian"
    also_called: ClassVar[tuple[str, ...]] = ("person", "human", "walker")
    category: ClassVar[str] = "pedestrian"
    length: Length = option(0.4, above=0, maximum=2, help="front-to-back depth")
    width: Length = option(0.6, above=0, maximum=2, help="shoulder width")
    height: Length = option(1.75, above=0, maximum=3, help="height")
    mass: Mass = option(75.0, above=0, help="body mass")
    color: String = color_option("#b03a2e")
