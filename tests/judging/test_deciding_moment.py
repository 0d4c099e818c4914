"""When and for whom a drive decides an expectation, beside drives of which it is known."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from roadlang.ir.scene import Verdict
from roadlang.ir.trace import Trace
from roadlang.judging.deciding_moment import DecidingMoment, deciding_moment, first_violation
from tests.judging.test_drives import REGISTRY, TIME, agent, condition, trace

FAST = condition({"always": {"<": ["v", 12.0]}}, v=("speed", {"agent": "ego"}))
APART = condition({"always": {">": ["d", 5.0]}}, d=("distance", {"first": "ego", "second": "cars"}))


def of(formula: Any, domain: str = "drive") -> Verdict:
    return Verdict("ok", "", domain, None, None, formula=formula)


def seen(moment: DecidingMoment | None) -> tuple[int, list[str]]:
    assert moment is not None
    return moment.sample, [actor.name for actor in moment.actors]


def test_the_moment_is_that_of_the_least_robustness_and_the_violation_is_the_first() -> None:
    """It goes faster and faster: first too fast after 2 s, most so at the end."""
    drive = trace(agent("ego", 100.0 * TIME, speed=6.0 + 3.01 * TIME))
    assert seen(deciding_moment(of(FAST), drive, REGISTRY)) == (100, ["ego"])
    assert seen(first_violation(of(FAST), drive, REGISTRY)) == (20, ["ego"])


@pytest.mark.parametrize("seed", range(20))
def test_a_single_comparison_goes_wrong_when_it_would_in_a_conjunction(seed: int) -> None:
    """It is looked for without blame for each sample; speeds come near 12 m/s, reach it, or not."""
    random = np.random.default_rng(seed)
    speed = np.round(random.normal(random.choice([8.0, 11.0]), 1.5, TIME.shape))
    drive = trace(agent("ego", 100.0 * TIME, speed=speed))
    slow = {"<": ["v", 12.0]}
    both = condition({"always": {"and": [slow, slow]}}, v=("speed", {"agent": "ego"}))
    found = first_violation(of(FAST), drive, REGISTRY)
    assert found is not None
    assert seen(found) == seen(first_violation(of(both), drive, REGISTRY))
    reached = np.flatnonzero(speed >= 12.0)
    assert found.sample == (reached[0] if len(reached) else speed.argmax())
    deciding = seen(deciding_moment(of(FAST), drive, REGISTRY))
    assert deciding == seen(deciding_moment(of(both), drive, REGISTRY))
    assert deciding[0] == speed.argmax()


@pytest.mark.parametrize(
    "formula",
    [
        {"eventually": {">": ["v", 12.0]}},
        {"not": {"always": {"<=": ["v", 12.0]}}},
        {"and": [{"eventually": {">": ["v", 12.0]}}, {"always": {">": ["v", 0.0]}}]},
    ],
    ids=["eventually", "not always", "in a conjunction"],
)
def test_what_never_comes_about_goes_wrong_when_it_was_nearest(formula: Any) -> None:
    """Fastest after 4 s, and never as fast as it should be: that it was slow at 0 s is nothing
    to look at."""
    drive = trace(agent("ego", 100.0 * TIME, speed=10.0 - 0.5 * np.abs(TIME - 4.0)))
    fast = condition(formula, v=("speed", {"agent": "ego"}))
    assert seen(first_violation(of(fast), drive, REGISTRY)) == (40, ["ego"])


def test_what_does_not_follow_in_time_goes_wrong_where_it_should_have_begun() -> None:
    """Too slow from 3 s on, and not fast again within 2 s."""
    drive = trace(agent("ego", 100.0 * TIME, speed=np.where(TIME < 2.95, 10.0, 5.0)))
    formula = {"always": {"implies": [
        {"<": ["v", 8.0]}, {"eventually": {">": ["v", 8.0]}, "interval": [0.0, 2.0]}
    ]}}  # fmt: skip
    slow = condition(formula, v=("speed", {"agent": "ego"}))
    assert seen(first_violation(of(slow), drive, REGISTRY))[0] == 30


@pytest.mark.parametrize(
    "verdict",
    [of(None), of(FAST, "road"), of(FAST, "scene"), of({"monitor": {"kind": "calm"}})],
    ids=["no formula", "over a road", "of numbers", "a monitor"],
)
def test_what_is_no_formula_over_the_drive_has_no_moment(verdict: Verdict) -> None:
    drive = trace(agent("ego", 10.0 * TIME))
    assert deciding_moment(verdict, drive, REGISTRY) is None
    assert first_violation(verdict, drive, REGISTRY) is None


def test_a_drive_without_samples_has_no_moment() -> None:
    assert deciding_moment(of(FAST), Trace(TIME[:0], {}), REGISTRY) is None


@pytest.mark.parametrize(
    ("first", "second", "nearer"),
    [((30.0, 0.0), (-20.0, 0.0), "cars[1]"), ((-20.0, 0.0), (30.0, 0.0), "cars[0]"),
     ((0.0, -30.0), (0.0, 20.0), "cars[1]"), ((25.0, 25.0), (-30.0, 0.0), "cars[1]")],
)  # fmt: skip
def test_of_a_group_the_one_that_is_nearest_to_the_other_decides(
    first: tuple[float, float], second: tuple[float, float], nearer: str
) -> None:
    """Whatever side of it the members are on, and wherever on Earth they all are."""
    zero = np.zeros_like(TIME)
    cars = [
        agent(f"cars[{number}]", zero + 500.0 + x, -300.0 + y)
        for number, (x, y) in enumerate((first, second))
    ]
    drive = trace(agent("ego", zero + 500.0, -300.0), *cars)
    assert seen(deciding_moment(of(APART), drive, REGISTRY))[1] == ["ego", nearer]
