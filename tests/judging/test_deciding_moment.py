"""When and for whom a drive decides an expectation, beside drives of which it is known."""

from __future__ import annotations

from typing import Any

import pytest

from roadlang.ir.scene import Verdict
from roadlang.ir.trace import Trace
from roadlang.judging.deciding_moment import DecidingMoment, deciding_moment, first_violation
from tests.judging.test_drives import REGISTRY, TIME, agent, condition, trace

FAST = condition({"always": {"<": ["v", 12.0]}}, v=("speed", {"agent": "ego"}))
APART = condition({"always": {">": ["d", 5.0]}}, d=("distance", {"from": "ego", "to": "cars"}))


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
