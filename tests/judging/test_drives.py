"""Expectations judged on a trace: signals of one agent, distances, groups."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest

from roadlang.api import AgentTrace, DiagnosticError, Trace
from roadlang.drive.trace_files import from_json, to_csv, to_json
from roadlang.judging.drives import robustness
from roadlang.plugins.discovery import load_registry

TIME = np.linspace(0.0, 10.0, 101)
REGISTRY = load_registry()


def agent(name: str, x: np.ndarray, y: float = 0.0, **more: Any) -> AgentTrace:
    """Someone who goes along the x axis."""
    zero = np.zeros_like(TIME)
    columns = {"steering": zero, "station": x, "cross_track": zero + y, "progress": x / 100}
    columns |= {"contacts": zero, "acceleration": zero, "heading": zero}
    speed = np.gradient(x, TIME)
    return AgentTrace(name=name, time=TIME, x=x, y=zero + y, speed=speed, **{**columns, **more})


def trace(*agents: AgentTrace) -> Trace:
    return Trace(TIME, {one.name: one for one in agents}, "test")


def condition(formula: Mapping[str, Any], **signals: tuple[str, dict[str, str]]) -> dict[str, Any]:
    calls = {name: {"kind": kind, "options": options} for name, (kind, options) in signals.items()}
    return {"formula": formula, "signals": calls}


def test_always_takes_the_worst_moment() -> None:
    slow = condition({"always": {"<": ["v", 12.0]}}, v=("speed", {"agent": "ego"}))
    assert robustness(slow, trace(agent("ego", 10 * TIME)), REGISTRY) == pytest.approx(2.0)


def test_the_distance_between_middles_and_between_outlines() -> None:
    both = trace(agent("ego", 0 * TIME), agent("lead", 0 * TIME + 20.0))
    who = {"one": "ego", "other": "lead"}
    apart = condition({"always": {">": ["d", 0.0]}}, d=("distance", who))
    assert robustness(apart, both, REGISTRY) == pytest.approx(20.0)
    free = condition({"always": {">": ["d", 0.0]}}, d=("gap", who))
    assert robustness(free, both, REGISTRY) == pytest.approx(15.5)


def test_a_turned_outline_reaches_elsewhere() -> None:
    turned = agent("lead", 0 * TIME + 20.0, heading=np.zeros_like(TIME) + math.pi / 2)
    free = condition({"always": {">": ["d", 0.0]}}, d=("gap", {"one": "ego", "other": "lead"}))
    assert robustness(free, trace(agent("ego", 0 * TIME), turned), REGISTRY) == pytest.approx(
        20.0 - 2.25 - 0.9
    )


def test_the_distance_to_a_group_is_that_to_the_nearest() -> None:
    group = [agent(f"walkers[{i}]", 0 * TIME + 5.0 * (i + 1)) for i in range(3)]
    apart = condition(
        {"always": {">": ["d", 0.0]}}, d=("distance", {"one": "ego", "other": "walkers"})
    )
    assert robustness(apart, trace(agent("ego", 0 * TIME), *group), REGISTRY) == pytest.approx(5.0)


def test_a_formula_of_a_group_must_hold_for_each_member() -> None:
    group = [agent(f"cars[{i}]", (i + 1) * TIME) for i in range(3)]
    slow = condition({"always": {"<": ["v", 2.5]}}, v=("speed", {"agent": "cars"}))
    assert robustness(slow, trace(*group), REGISTRY) == pytest.approx(-0.5)


def test_what_the_engine_does_not_record_is_refused() -> None:
    blind = agent("ego", TIME, steering=np.full_like(TIME, np.nan))
    straight = condition({"always": {"<": ["a", 0.1]}}, a=("steering", {"agent": "ego"}))
    with pytest.raises(DiagnosticError, match="RL701"):
        robustness(straight, trace(blind), REGISTRY)


def test_a_trace_survives_its_file() -> None:
    whole = trace(agent("ego", 3 * TIME), agent("lead", 2 * TIME + 9))
    again = from_json(to_json(whole))
    assert np.array_equal(again.agents["lead"].x, whole.agents["lead"].x)
    assert to_csv(again) == to_csv(whole)
    assert to_csv(whole).splitlines()[0].startswith("time,agent,x,y")
