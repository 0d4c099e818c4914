"""Where a scene file has what a drive may find faults with."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from ..diagnostics import Span
from ..ir.scenario import Scenario


@dataclass(frozen=True)
class WrittenPlaces:
    """Nothing is known of a scene that is read from its own file."""

    expectations: Mapping[str, Span | None] = field(default_factory=dict)
    """by name"""
    controllers: Mapping[tuple[str, int], Span | None] = field(default_factory=dict)
    """by the declared name of the agent and the place in its list"""
    sensors: Mapping[tuple[str, str], Span | None] = field(default_factory=dict)
    """by the declared name of the agent and the name of the sensor"""

    @classmethod
    def of(cls, scenario: Scenario) -> WrittenPlaces:
        """Those of a scene file and what it includes."""
        agents = scenario.agents
        return cls(
            {item.name: item.span for item in scenario.expectations},
            {
                (agent.name, place): call.span
                for agent in agents
                for place, call in enumerate(agent.drive)
            },
            {(agent.name, each.name): each.call.span for agent in agents for each in agent.sensors},
        )


UNKNOWN = WrittenPlaces()
