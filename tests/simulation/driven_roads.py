"""Short scene files, driven in the embedded engine."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from roadlang import testing
from roadlang.ir.trace import AgentTrace, Trace

from .routed_scenes import CONTROL_STEP, drive_scenes


def drive(text: str, n: int = 1, seed: int = 0, **options: Any) -> list[Trace]:
    """The traces of `n` scenes of a text, by default with few decisions a second."""
    scenes = testing.sample(text, n, seed=seed)
    options = {"control_step": CONTROL_STEP, **options}
    return [one.trace for one in scenes.run("builtin", **options)]


def driven(text: str, **options: Any) -> AgentTrace:
    """The trace of `ego` in one scene of a text."""
    (trace,) = drive(text, **options)
    return trace.agents["ego"]


def drive_together(texts: Iterable[str], **options: Any) -> list[Trace]:
    """The trace of one scene of each text, all in one block: much faster than one by one."""
    return drive_scenes([testing.sample(text, 1)[0].record for text in texts], **options)


def straight(drives: str, *, world: str = "", length: int = 1500, agent: str = "car") -> str:
    """One agent on a straight road; `drives` is the body of the agent."""
    return f"""
    road main {{ draw with waypoints {{ points: [(0m, 0m), ({length}m, 0m)] }}, width: 8m }}
    agent ego is {agent} on main at 5m {{ {drives} }}
    world {{ {world} }}
    """
