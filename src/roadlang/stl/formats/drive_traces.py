"""Traces of drives, as `roadlang run` writes them: of each agent several columns.

In CSV there is a row for each agent at each time, in JSON an object for each agent. Here they are
columns named `ego.speed`, and those of one agent also by their plain names.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Any

from ...diagnostics import did_you_mean

SCHEMA = "roadlang.trace/"
_HEAD = ["time", "agent"]

Table = dict[str, list[Any]]


class DriveTraceFault(ValueError):
    """What is wrong with a trace of a drive; `help` says what there is instead."""

    def __init__(self, problem: str, help: tuple[str, ...] = ()) -> None:
        super().__init__(problem)
        self.help = help


def is_table(names: Sequence[str]) -> bool:
    """Whether the columns of a CSV file are those of a drive."""
    return list(names[:2]) == _HEAD


def is_document(value: Any) -> bool:
    """Whether a JSON value is the trace of a drive."""
    return isinstance(value, dict) and str(value.get("schema", "")).startswith(SCHEMA)


def is_start_of_document(text: str) -> bool:
    """Whether a JSON text begins as the trace of a drive does."""
    return re.match(rf'\s*\{{\s*"schema"\s*:\s*"{re.escape(SCHEMA)}', text) is not None


def columns_of_rows(
    names: Sequence[str], rows: Sequence[Sequence[str]], agent: str | None
) -> Table:
    """The rows of a CSV file as columns over time; an agent without a row has a gap there."""
    times = list(dict.fromkeys(row[0] for row in rows))
    place = {time: index for index, time in enumerate(times)}
    agents: dict[str, Table] = {}
    for row in rows:
        columns = agents.setdefault(row[1], {name: [None] * len(times) for name in names[2:]})
        for name, cell in zip(names[2:], row[2:], strict=True):
            columns[name][place[row[0]]] = cell
    return {"time": list(times), **_named(agents, agent)}


def columns_of_document(document: Mapping[str, Any], agent: str | None) -> Table:
    """The columns of a JSON document. Raises `DriveTraceFault`."""
    time, agents = document.get("time"), document.get("agents")
    if not isinstance(time, list) or not isinstance(agents, dict):
        raise DriveTraceFault("it has no `time` or no `agents`")
    columns = {
        name: {key: column for key, column in found.items() if isinstance(column, list)}
        for name, found in agents.items()
        if isinstance(found, dict)
    }
    return {"time": time, **_named(columns, agent)}


def _named(agents: Mapping[str, Table], agent: str | None) -> Table:
    if agent is not None and agent not in agents:
        hints = did_you_mean(agent, agents) or (f"its agents are {', '.join(agents)}",)
        raise DriveTraceFault(f"it has no agent `{agent}`", hints)
    chosen = agent if agent is not None or len(agents) != 1 else next(iter(agents))
    named = {f"{name}.{key}": c for name, columns in agents.items() for key, c in columns.items()}
    return {**named, **(agents[chosen] if chosen is not None else {})}
