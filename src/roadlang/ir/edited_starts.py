"""Which agents start elsewhere after an edit of a scenario: what is written of them is compared."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from typing import Any

from ..diagnostics import Span
from .read_only import FrozenDict
from .scenario import Scenario, ScenarioActor
from .values import Reference

START_OPTIONS = (
    "offset", "lane", "side", "facing", "heading", "spacing", "apart", "start_speed",
)  # fmt: skip
"""The options of agents that say where and how fast they start."""


def edited_starts(before: Scenario, after: Scenario) -> frozenset[str]:
    """Names, as declared, of the agents of both whose own start is written differently: the place,
    an option of it, or the value of a `param` or `let` in it.

    A road that has changed below an agent is no change of its start.
    """
    starts = {actor.name: _written_start(actor, before) for actor in before.agents}
    return frozenset(
        actor.name
        for actor in after.agents
        if actor.name in starts and starts[actor.name] != _written_start(actor, after)
    )


def _written_start(actor: ScenarioActor, scenario: Scenario) -> Any:
    values = {named.name: named.value for named in scenario.values}
    options = {name: actor.options.get(name) for name in START_OPTIONS}
    return _plain((actor.on, actor.at, actor.at_fraction, options), values)


def _plain(part: Any, values: Mapping[str, Any]) -> Any:
    """What is written, wherever it stands in the file."""
    if isinstance(part, Span):
        return None
    if isinstance(part, Reference):
        return part.name, _plain(values.get(part.name), values)
    if isinstance(part, dict | FrozenDict):
        return {name: _plain(item, values) for name, item in part.items()}
    if isinstance(part, tuple | list):
        return [_plain(item, values) for item in part]
    if dataclasses.is_dataclass(part) and not isinstance(part, type):
        return type(part).__name__, {
            field.name: _plain(getattr(part, field.name), values)
            for field in dataclasses.fields(part)
        }
    return part
