"""Which columns of a trace keep a drive signal from being known: those that the engine left out."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from ..geometry.arrays import Floats
from ..ir.trace import AgentTrace, Trace
from ..plugins.drive_signals import drive_signal_values
from ..plugins.registry import KindEntry

Agents = Callable[[Trace], Mapping[str, Any]]


def unrecorded_columns(entry: KindEntry, options: Agents, trace: Trace) -> tuple[str, ...]:
    """The columns that a signal reads and that hold NaN, such as `ego.steering`, by name.

    `options` gives the options of the signal with the agents of a trace. None are found where the
    engine recorded all that is read: the signal itself then gives NaN.
    """
    read: set[str] = set()

    def column(agent: AgentTrace, name: str) -> Floats:
        values: Floats = getattr(agent, name)
        if np.isnan(values).any():
            read.add(f"{agent.name}.{name}")
        return values

    watched = {
        name: AgentTrace.recorded(agent, agent.time, partial(column, agent))
        for name, agent in trace.agents.items()
    }
    again = replace(trace, agents=watched)
    drive_signal_values(entry, options(again), again)
    return tuple(sorted(read))
