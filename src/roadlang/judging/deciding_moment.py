"""When and for whom a drive decides an expectation."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..ir.scene import Verdict
from ..ir.trace import AgentTrace, Trace
from ..plugins.registry import Registry
from ..stl import Formula
from ..stl.explain.explanation import decider, first_cause
from .drives import DriveCondition

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class DecidingMoment:
    """The sample of the trace that decides a formula, and the agents and objects that the deciding
    comparison is about, in the order in which it names them."""

    sample: int
    actors: tuple[AgentTrace, ...]


def deciding_moment(verdict: Verdict, trace: Trace, registry: Registry) -> DecidingMoment | None:
    """The moment of the robustness. None for what is no formula over the drive."""
    return _moment(verdict, trace, registry, decider)


def first_violation(verdict: Verdict, trace: Trace, registry: Registry) -> DecidingMoment | None:
    """When a violated formula goes wrong: the first sample at which a comparison fails that it
    would have needed; of something that has not come about, when it was nearest to. None for what
    is no formula over the drive."""
    return _moment(verdict, trace, registry, first_cause)


def _moment(
    verdict: Verdict,
    trace: Trace,
    registry: Registry,
    find: Callable[[Formula, Floats, Mapping[str, Any]], tuple[frozenset[str], int]],
) -> DecidingMoment | None:
    if verdict.domain != "drive" or verdict.formula is None or "monitor" in verdict.formula:
        return None
    condition = DriveCondition(verdict.formula, trace, registry)
    formula, time = condition.formula, trace.time
    choices = list(condition.choices())
    if not choices or not len(time):
        return None
    chosen, values = choices[0]
    if len(choices) > 1:
        chosen, values = min(choices, key=lambda choice: condition.rho_of(choice[1]))
    variables, sample = find(formula, time, values)
    signals = {
        name: call for name, call in verdict.formula.get("signals", {}).items() if name in variables
    }
    return DecidingMoment(sample, tuple(_actors(signals, chosen, trace, sample)))


def _actors(
    signals: Mapping[str, Any], chosen: Mapping[str, AgentTrace], trace: Trace, sample: int
) -> list[AgentTrace]:
    """Each once; of a group that a distance is measured to, the member that is nearest then."""
    found: dict[str, AgentTrace] = {}
    for call in signals.values():
        for name in call.get("options", {}).values():
            members = trace.named(name) if isinstance(name, str) else ()
            if name in chosen:
                members = (chosen[name],)
            if members:
                first = next(iter(found.values()), members[0])
                nearest = min(members, key=lambda other: _distance(first, other, sample))
                found.setdefault(nearest.name, nearest)
    return list(found.values())


def _distance(first: AgentTrace, other: AgentTrace, sample: int) -> float:
    x = float(first.x[sample] - other.x[sample])
    y = float(first.y[sample] - other.y[sample])
    return x * x + y * y
