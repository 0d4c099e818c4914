"""Drives with the same samples in time are judged together, to the last bit as by themselves; by
formulas that look at all samples alike, drives of different lengths too."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import pytest

from roadlang.ir.scene import Provenance, Scene, Verdict
from roadlang.ir.trace import AgentTrace, Trace
from roadlang.judging.drives import DriveCondition, judge
from roadlang.judging.drives_together import robustness_together
from tests.judging.test_drives import REGISTRY, TIME, agent, condition, trace

SPEED: dict[str, Any] = {"v": ("speed", {"agent": "ego"})}
SLOW = condition({"always": {"<": ["v", 12.0]}}, **SPEED)


def scene(*formulas: Mapping[str, Any]) -> Scene:
    """One with these expectations."""
    expected = tuple(
        Verdict(f"e{place}", "", "drive", None, None, formula=formula)
        for place, formula in enumerate(formulas)
    )
    return Scene("scene", "", 0, Provenance("", 0, 0, 0), expectations=expected)


def drives(count: int) -> list[Trace]:
    """Of an agent that goes now faster, now slower; every third is shorter than the others."""
    random = np.random.default_rng(7)
    found = []
    for number in range(count):
        full = agent("ego", 10.0 * TIME, speed=random.normal(10.0, 3.0, TIME.shape))
        found.append(shortened(full, 60) if number % 3 == 0 else trace(full))
    return found


def shortened(full: AgentTrace, samples: int) -> Trace:
    columns: dict[str, Any] = {
        name: values[:samples]
        for name, values in vars(full).items()
        if isinstance(values, np.ndarray)
    }
    return Trace(TIME[:samples], {"ego": AgentTrace(name="ego", **columns)}, "test")


def together(of: Scene, traces: Sequence[Trace]) -> list[dict[str, float]]:
    return robustness_together([of] * len(traces), traces, REGISTRY)


@pytest.mark.parametrize(
    "formula",
    [
        {"always": {"<": ["v", 12.0]}},
        {"eventually": {"always": {">": ["v", 6.5]}, "interval": [0, 0.4]}, "interval": [1, 3]},
        {"until": [{"<": ["v", 15.0]}, {">": ["v", 14.0]}]},
        True,
    ],
    ids=["always", "in windows", "until", "of no signal"],
)  # fmt: skip
def test_robustness_is_that_of_each_drive_alone(formula: Any) -> None:
    one = scene(condition(formula, **SPEED))
    traces = drives(9)
    written = one.expectations[0].formula
    assert written is not None
    alone = [DriveCondition(written, each, REGISTRY).rho for each in traces]
    assert together(one, traces) == [{"e0": rho} for rho in alone]


def test_verdicts_are_the_same_with_robustness_that_is_known() -> None:
    one = scene(SLOW, condition({"always": {">": ["v", 0.0]}}, **SPEED))
    traces = drives(6)
    for each, known in zip(traces, together(one, traces), strict=True):
        assert set(known) == {"e0", "e1"}
        assert judge(one, each, REGISTRY, known) == judge(one, each, REGISTRY)


def test_sums_depend_on_how_many_rows_there_are_and_groups_have_several_members() -> None:
    """What averages, and what is about each of a group, is evaluated alone."""
    average = {**SLOW, "evaluation": {"robustness": "average"}}
    cars = condition({"always": {"<": ["v", 12.0]}}, v=("speed", {"agent": "cars"}))
    group = trace(agent("ego", TIME), agent("cars[0]", TIME), agent("cars[1]", 2.0 * TIME))
    assert together(scene(average, cars), [group, group]) == [{}, {}]


def test_a_drive_that_cannot_be_judged_leaves_the_others_as_they_are() -> None:
    """A fault is reported when the drive itself is judged."""
    broken = agent("ego", 10.0 * TIME, speed=np.full_like(TIME, np.nan))
    one, traces = scene(SLOW), [*drives(5), trace(broken)]
    found = together(one, traces)
    assert [set(each) for each in found] == [{"e0"}] * 5 + [set()]
    assert set(judge(one, traces[-1], REGISTRY, found[-1]).faults) == {"e0"}


@pytest.mark.parametrize(
    "formula",
    [
        {"always": {"<": ["v", 12.0]}},
        {"eventually": {"and": [{"<": ["v", 9.0]}, {">": ["v", 5.0]}]}},
        {"eventually": {"always": {">": ["v", 8.0]}}},
        {">": ["v", 8.0]},
    ],
    ids=["always", "eventually both", "in the end", "at the start"],
)
def test_drives_of_different_lengths_are_judged_together(formula: Any) -> None:
    one = scene(condition(formula, **SPEED))
    traces = [shortened(each.agents["ego"], 20 + 3 * row) for row, each in enumerate(drives(5))]
    written = one.expectations[0].formula
    assert written is not None
    alone = [DriveCondition(written, each, REGISTRY).rho for each in traces]
    assert together(one, traces) == [{"e0": rho} for rho in alone]


@pytest.mark.parametrize(
    "formula",
    [
        {"always": {"<": ["v", 12.0]}, "interval": [0, 1]},
        {"historically": {"<": ["v", 12.0]}},
        {"next": {"<": ["v", 12.0]}},
        {"until": [{"<": ["v", 15.0]}, {">": ["v", 14.0]}]},
    ],
    ids=["in a window", "in the past", "at the next sample", "until"],
)
def test_what_tells_samples_apart_needs_the_same_ones(formula: Any) -> None:
    short, full = shortened(agent("ego", 10.0 * TIME), 40), drives(2)[1]
    assert together(scene(condition(formula, **SPEED)), [full, short]) == [{}, {}]


def test_a_drive_with_samples_of_its_own_is_judged_alone() -> None:
    full = drives(2)[1]
    late = Trace(TIME + 0.01, {"ego": full.agents["ego"]}, "test")
    assert together(scene(SLOW), [full, late]) == [{}, {}]
