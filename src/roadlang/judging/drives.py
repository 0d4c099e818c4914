"""Judges the `expect`s of a scene on the trace of its drive."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterator, Mapping
from itertools import product
from typing import Any

import numpy as np

from ..diagnostics import Code, DiagnosticError, diagnose
from ..ir.scene import Scene, Verdict
from ..ir.trace import AgentTrace, Trace
from ..plugins.guard import plugin_guard, wrong_result
from ..plugins.kinds import DriveSignal
from ..plugins.registry import Registry
from ..stl import from_json


def judge(scene: Scene, trace: Trace, registry: Registry) -> tuple[Verdict, ...]:
    """The expectations with robustness; those over roads were judged when the scene was made.

    A member signal of a group (`walkers.speed`) makes the formula hold for each of its members;
    `distance` to a group is that to the nearest.
    """
    return tuple(
        _judged(verdict, trace, registry) if verdict.domain == "drive" else verdict
        for verdict in scene.expectations
    )


def _judged(verdict: Verdict, trace: Trace, registry: Registry) -> Verdict:
    if verdict.formula is None:
        return verdict
    if "monitor" in verdict.formula:
        rho = _monitored(verdict.formula, trace, registry)
    else:
        rho = robustness(verdict.formula, trace, registry)
    return dataclasses.replace(verdict, robustness=rho, satisfied=rho > 0)


def robustness(condition: Mapping[str, Any], trace: Trace, registry: Registry) -> float:
    """Robustness of a condition `{formula, signals, numbers}` on a trace, for its worst member."""
    formula = from_json(condition["formula"])
    numbers = {name: float(value) for name, value in condition.get("numbers", {}).items()}
    signals: Mapping[str, Any] = condition.get("signals", {})
    worst = math.inf
    for chosen in _members(signals, trace, registry):
        values = {
            name: _values(call, chosen, trace, registry, name) for name, call in signals.items()
        }
        worst = min(worst, float(np.min(formula.rho(trace.time, {**numbers, **values}))))
    return worst


def group(name: str, trace: Trace) -> tuple[AgentTrace, ...]:
    """The agents that a name stands for: itself, or all copies `name[i]`."""
    if name in trace.agents:
        return (trace.agents[name],)
    return tuple(agent for key, agent in trace.agents.items() if key.startswith(f"{name}["))


def _members(
    signals: Mapping[str, Any], trace: Trace, registry: Registry
) -> Iterator[Mapping[str, AgentTrace]]:
    """Every way to choose one member of each group that a member signal speaks of."""
    names = sorted(
        {
            str(value)
            for call in signals.values()
            if _kind(call, registry).member
            for value in call["options"].values()
            if group(str(value), trace)
        }
    )
    for choice in product(*(group(name, trace) for name in names)):
        yield dict(zip(names, choice, strict=True))


def _values(
    call: Mapping[str, Any],
    chosen: Mapping[str, AgentTrace],
    trace: Trace,
    registry: Registry,
    shown: str,
) -> Any:
    kind = _kind(call, registry)
    options = {}
    for key, value in call.get("options", {}).items():
        members = group(value, trace) if isinstance(value, str) else ()
        if not members:
            options[key] = value
        elif kind.member:
            options[key] = chosen[value]
        else:
            options[key] = members
    if kind.name == "time":
        return trace.time
    entry = registry.find_recorded("drive_signal", str(call["kind"]))
    with plugin_guard(entry, None):
        values = np.asarray(kind(**options).values(), dtype=float)
    if values.shape != trace.time.shape and entry.origin.plugin != "standard":
        fault = f"gave values of shape {values.shape}, not {trace.time.shape}"
        raise wrong_result(entry, None, fault)
    if values.shape != trace.time.shape or not np.isfinite(values).all():
        raise DiagnosticError(diagnose(Code.SIGNAL_NOT_RECORDED, signal=shown, engine=trace.engine))
    return values


def _kind(call: Mapping[str, Any], registry: Registry) -> type[DriveSignal]:
    kind = registry.find_recorded("drive_signal", str(call["kind"])).load()
    assert issubclass(kind, DriveSignal)
    return kind


def _monitored(call: Mapping[str, Any], trace: Trace, registry: Registry) -> float:
    entry = registry.find("monitor", str(call["monitor"]))
    options = {
        key: (group(value, trace) or (value,))[0] if isinstance(value, str) else value
        for key, value in call.get("options", {}).items()
    }
    with plugin_guard(entry, None):
        kind: Any = entry.load()
        rho = float(kind(**options).judge(trace))
    if math.isnan(rho):
        raise wrong_result(entry, None, "gave a robustness that is no number")
    return rho
