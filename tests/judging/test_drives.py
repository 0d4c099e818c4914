"""Expectations judged on a trace: signals of one agent, distances, groups."""

from __future__ import annotations

import math
import pickle
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
import pytest

from roadlang import testing
from roadlang.api import AgentName, AgentTrace, DiagnosticError, Monitor, Trace, option
from roadlang.drive.trace_files import from_json, to_csv, to_json
from roadlang.ir.scene import Provenance, Scene, Verdict
from roadlang.judging.drives import DriveCondition, judge
from roadlang.judging.robustness_series import robustness_series
from roadlang.plugins.discovery import load_registry
from tests.straight_road import STRAIGHT

TIME = np.linspace(0.0, 10.0, 101)
REGISTRY = load_registry()


def agent(name: str, x: np.ndarray, y: float = 0.0, **more: Any) -> AgentTrace:
    """Someone who goes along the x axis."""
    zero = np.zeros_like(TIME)
    columns = {"steering": zero, "station": x, "cross_track_error": zero + y, "progress": x / 100}
    columns |= {"contacts": zero, "acceleration": zero, "heading": zero}
    columns |= {"speed": np.gradient(x, TIME)}
    return AgentTrace(name=name, time=TIME, x=x, y=zero + y, **{**columns, **more})


def trace(*agents: AgentTrace) -> Trace:
    return Trace(TIME, {one.name: one for one in agents}, "test")


def condition(formula: Any, **signals: tuple[str, dict[str, str]]) -> dict[str, Any]:
    calls = {name: {"kind": kind, "options": options} for name, (kind, options) in signals.items()}
    return {"formula": formula, "signals": calls}


def rho_of(formula: Mapping[str, Any], drive: Trace) -> float:
    return DriveCondition(formula, drive, REGISTRY).rho


def test_always_takes_the_worst_moment() -> None:
    slow = condition({"always": {"<": ["v", 12.0]}}, v=("speed", {"agent": "ego"}))
    assert rho_of(slow, trace(agent("ego", 10 * TIME))) == pytest.approx(2.0)


def verdict_of(formula: Mapping[str, Any], drive: Trace) -> Verdict:
    """What a scene with this one expectation says of a drive."""
    expectation = Verdict("ok", "", "drive", None, None, formula=formula)
    scene = Scene("scene", "", 0, Provenance("", 0, 0, 0), expectations=(expectation,))
    return judge(scene, drive, REGISTRY).verdicts[0]


@pytest.mark.parametrize(("operator", "holds"), [("==", True), ("<=", True), ("<", False)])
def test_no_contact_at_all_is_exactly_what_was_asked_for(operator: str, holds: bool) -> None:
    clear = condition({"always": {operator: ["n", 0.0]}}, n=("contacts", {"agent": "ego"}))
    verdict = verdict_of(clear, trace(agent("ego", 10 * TIME)))
    assert verdict.satisfied is holds
    assert f"{verdict.robustness:g}" == "0", "not -0, which reads like a violation"


def test_a_contact_breaks_it() -> None:
    touched = np.where(TIME == 5.0, 1.0, 0.0)
    clear = condition({"always": {"==": ["n", 0.0]}}, n=("contacts", {"agent": "ego"}))
    verdict = verdict_of(clear, trace(agent("ego", 10 * TIME, contacts=touched)))
    assert (verdict.satisfied, verdict.robustness) == (False, -1.0)


def test_every_member_of_a_group_must_hold_at_zero() -> None:
    cars = [agent("cars[0]", 0 * TIME), agent("cars[1]", 0 * TIME, 5.0)]
    rest = condition({"always": {"<=": ["v", 0.0]}}, v=("speed", {"agent": "cars"}))
    assert verdict_of(rest, trace(*cars)).satisfied
    strict = condition({"always": {"<": ["v", 0.0]}}, v=("speed", {"agent": "cars"}))
    assert not verdict_of(strict, trace(*cars)).satisfied


def test_a_member_that_only_just_misses_it_breaks_it_for_the_group() -> None:
    """Both have robustness 0; only the one at rest satisfies `v <= 0`."""
    either = condition(
        {"or": [{"<=": ["v", 0.0]}, {"<": ["a", 0.0]}]},
        v=("speed", {"agent": "cars"}), a=("acceleration", {"agent": "cars"}),
    )  # fmt: skip
    cars = [agent("cars[0]", 0 * TIME), agent("cars[1]", 5 * TIME)]
    verdict = verdict_of(either, trace(*cars))
    assert (verdict.robustness, verdict.satisfied) == (0.0, False)


def test_a_robustness_without_bound_is_none() -> None:
    anything = condition(True)
    assert verdict_of(anything, trace(agent("ego", TIME))).robustness is None


def test_the_time_of_the_drive_is_a_signal() -> None:
    early = condition({"eventually": {">=": ["t", 10.0]}}, t=("time", {}))
    assert verdict_of(early, trace(agent("ego", TIME))).satisfied


def test_the_distance_between_middles_and_between_outlines() -> None:
    both = trace(agent("ego", 0 * TIME), agent("lead", 0 * TIME + 20.0))
    who = {"first": "ego", "second": "lead"}
    apart = condition({"always": {">": ["d", 0.0]}}, d=("distance", who))
    assert rho_of(apart, both) == pytest.approx(20.0)
    free = condition({"always": {">": ["d", 0.0]}}, d=("gap", who))
    assert rho_of(free, both) == pytest.approx(15.5)


def test_a_turned_outline_reaches_elsewhere() -> None:
    turned = agent("lead", 0 * TIME + 20.0, heading=np.zeros_like(TIME) + math.pi / 2)
    free = condition({"always": {">": ["d", 0.0]}}, d=("gap", {"first": "ego", "second": "lead"}))
    assert rho_of(free, trace(agent("ego", 0 * TIME), turned)) == pytest.approx(20.0 - 2.25 - 0.9)


def test_the_distance_to_a_group_is_that_to_the_nearest() -> None:
    group = [agent(f"walkers[{i}]", 0 * TIME + 5.0 * (i + 1)) for i in range(3)]
    apart = condition(
        {"always": {">": ["d", 0.0]}}, d=("distance", {"first": "ego", "second": "walkers"})
    )
    assert rho_of(apart, trace(agent("ego", 0 * TIME), *group)) == pytest.approx(5.0)


def test_a_formula_of_a_group_must_hold_for_each_member() -> None:
    group = [agent(f"cars[{i}]", (i + 1) * TIME) for i in range(3)]
    slow = condition({"always": {"<": ["v", 2.5]}}, v=("speed", {"agent": "cars"}))
    assert rho_of(slow, trace(*group)) == pytest.approx(-0.5)


@pytest.mark.parametrize("missing", [slice(None), slice(-1, None)])
def test_what_the_engine_does_not_record_throughout_is_refused(missing: slice) -> None:
    steering = np.zeros_like(TIME)
    steering[missing] = np.nan
    blind = agent("ego", TIME, steering=steering)
    straight = condition({"always": {"<": ["a", 0.1]}}, a=("steering", {"agent": "ego"}))
    with pytest.raises(DiagnosticError, match="RL701"):
        rho_of(straight, trace(blind))


def test_a_trace_survives_its_file() -> None:
    whole = trace(agent("ego", 3 * TIME), agent("lead", 2 * TIME + 9))
    again = from_json(to_json(whole))
    assert np.array_equal(again.agents["lead"].x, whole.agents["lead"].x)
    assert to_csv(again) == to_csv(whole)
    assert to_csv(whole).splitlines()[0].startswith("time,agent,x,y")


def test_a_trace_of_the_first_schema_is_read() -> None:
    """`cross_track` became `cross_track_error`."""
    text = to_json(trace(agent("ego", 10 * TIME, 0.5)))
    old = text.replace("roadlang.trace/2", "roadlang.trace/1").replace(
        '"cross_track_error"', '"cross_track"'
    )
    assert old != text
    assert (from_json(old).agents["ego"].cross_track_error == 0.5).all()


def test_the_gap_is_the_same_from_either_side() -> None:
    """Of a long truck and a bollard beside its middle: no corner of the truck is near."""
    truck = agent("truck", np.zeros_like(TIME), length=12.0, width=2.5)
    post = agent("post", np.ones_like(TIME), 3.0, length=0.2, width=0.2)
    drive = trace(truck, post)
    for names in (("truck", "post"), ("post", "truck")):
        options = dict(zip(("first", "second"), names, strict=True))
        apart = condition({"always": {">": ["g", 0.0]}}, g=("gap", options))
        assert rho_of(apart, drive) == pytest.approx(1.65)


def test_a_group_without_members_satisfies_what_is_asked_of_each() -> None:
    """As of `count: integer(0, 3)` where 0 is drawn: nobody is too fast, and nobody is near."""
    ego = trace(agent("ego", 0 * TIME))
    slow = condition({"always": {"<": ["v", 1.0]}}, v=("speed", {"agent": "cars"}))
    assert rho_of(slow, ego) == math.inf
    pair = {"first": "ego", "second": "cars"}
    apart = condition({"always": {">": ["d", 1.0]}}, d=("distance", pair))
    assert rho_of(apart, ego) == math.inf


def test_a_group_is_as_robust_as_its_worst_member_at_each_time() -> None:
    """0.5 t, 10 - t and 3 m/s: the fastest of the three decides."""
    speeds = [0.5 * TIME, 10.0 - TIME, 0.0 * TIME + 3.0]
    cars = [agent(f"cars[{i}]", 0 * TIME, speed=speed) for i, speed in enumerate(speeds)]
    slow = condition({"always": {"<": ["v", 12.0]}}, v=("speed", {"agent": "cars"}))
    assert rho_of(slow, trace(*cars)) == 2.0
    verdict = verdict_of(slow, trace(*cars))
    assert verdict.robustness == 2.0
    series = robustness_series(verdict, trace(*cars), REGISTRY)
    assert series is not None
    np.testing.assert_allclose(series, 12.0 - np.max(speeds, axis=0))


@dataclass(frozen=True)
class StartsAt(Monitor):
    """How far east an agent starts."""

    name: ClassVar[str] = "starts_at"
    domain: ClassVar[str] = "drive"
    agent: AgentName = option(help="the agent")
    text: str = option("", help="words that may be those of an agent")

    def judge(self, trace: Trace) -> float:
        return float(self.agent.x[0])


def test_a_monitor_judges_the_worst_of_a_group_or_the_copy_that_it_names() -> None:
    text = STRAIGHT + (
        "agent cars is car on main at 10m { count: 3, spacing: 20m, drive with brake }\n"
        "expect all with starts_at { agent: cars }\n"
        "expect last with starts_at { agent: cars[2] }\n"
        'expect told with starts_at { agent: cars[1], text: "cars" }\n'
    )
    ((one,)) = testing.sample(text, 1, kinds=[StartsAt]).run("builtin", duration=1.0)
    found = {name: one.verdicts[name].robustness for name in ("all", "last", "told")}
    assert found == pytest.approx({"all": 10.0, "last": 50.0, "told": 30.0}, abs=0.1)


def test_a_drive_whose_verdicts_were_read_can_be_pickled() -> None:
    text = STRAIGHT + "agent ego is car on main at 5m { drive with brake }\n"
    text += "expect slow: always (ego.speed < 9m/s)\n"
    drive = testing.sample(text, 1)[0].run("builtin", duration=1.0)
    assert drive.verdicts["slow"].satisfied
    again = pickle.loads(pickle.dumps(drive))
    assert again.verdicts == drive.verdicts
    assert again.to_csv() == drive.to_csv()
