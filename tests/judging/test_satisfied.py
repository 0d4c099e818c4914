"""One rule says "satisfied" everywhere: robustness above 0 holds, below 0 fails, and at exactly 0
Boolean evaluation of the formula decides.

Formulas and signals are drawn at the edges: equalities, strict and one-sided comparisons, intervals
`[a, a]`, values that are 0, -0, or the ends of a range.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, ClassVar

import numpy as np
import pytest

from roadlang import stl, testing
from roadlang.api import DriveSignal, Monitor, RoadOrNetwork, Signal, Trace
from roadlang.ir.dimension import PURE
from roadlang.ir.read_only import FrozenDict
from roadlang.ir.scenario import Scenario, ScenarioConstraint
from roadlang.ir.scene import Scene
from roadlang.ir.values import NO_OPTIONS, Condition, Entity, PassCall, SignalBinding
from roadlang.judging.drives import judge
from roadlang.plugins.discovery import registry_of
from roadlang.scenes.sampling import sample_scenes
from roadlang.stl.formula.evaluation_options import EvaluationOptions, Measure
from roadlang.stl.formula.formulas import ComparisonOperator
from tests.scene_texts import scenario_of
from tests.stl_draws import NAMES, FormulaDraw
from tests.stl_reference import Reference

SAMPLES = 51
"""Stations of the shortest road that is sampled every meter"""
POSITIONS = np.arange(float(SAMPLES))
FORMULAS = 160
EDGES = (0.0, -0.0, -1.0, 2.0)
VALUES: dict[str, list[float]] = {}
"""What the signals x, y, z of the kinds below are worth, set by each test"""


class EdgeDraw(FormulaDraw):
    """Formulas whose comparisons and intervals are at the edges."""

    def __init__(self, seed: int) -> None:
        super().__init__(seed)
        self.step = 1.0

    def term(self, depth: int = 1) -> stl.Term:
        if self.random.random() < 0.2:
            return stl.Constant(self.random.choice(EDGES))
        return super().term(depth)

    def interval(self) -> stl.Interval | None:
        low = float(self.random.choice([0, 0, 1, 7, SAMPLES - 1, SAMPLES]))
        high = low + self.random.choice([0, 0, 1, 5])
        return None if self.random.random() < 0.3 else stl.Interval(low, high)

    def _leaf(self) -> stl.Formula:
        ops: list[ComparisonOperator] = ["<", "<=", ">", ">=", "==", "!="]
        op = self.random.choice(ops)
        return stl.Comparison(op, self.term(), stl.Constant(self.random.choice(EDGES)))

    def signals(self) -> dict[str, list[float]]:
        values = {name: self.random.sample(EDGES, 2) for name in NAMES}
        return {name: self.random.choices(values[name], k=SAMPLES) for name in NAMES}


def road_signal(letter: str) -> type[Signal]:
    @dataclass(frozen=True)
    class Edge(Signal):
        """A signal of the test."""

        name: ClassVar[str] = letter
        road: RoadOrNetwork

        def values(self) -> Any:
            return np.array(VALUES[letter])[None, :]

    return Edge


def drive_signal(letter: str) -> type[DriveSignal]:
    @dataclass(frozen=True)
    class Edge(DriveSignal):
        """A signal of the test."""

        name: ClassVar[str] = f"{letter}t"
        member: ClassVar[bool] = False

        def values_in(self, trace: Trace) -> Any:
            return np.array(VALUES[letter])

    return Edge


@dataclass(frozen=True)
class Settled(Monitor):
    """Its robustness over roads is the first value of x."""

    name: ClassVar[str] = "settled"

    def robustness(self) -> Any:
        return np.array(VALUES["x"][:1])


@dataclass(frozen=True)
class Driven(Monitor):
    """Its robustness over drives is the first value of x."""

    name: ClassVar[str] = "driven"
    domain: ClassVar[str] = "drive"

    def judge(self, trace: Trace) -> float:
        return VALUES["x"][0]


KINDS = (*map(road_signal, NAMES), *map(drive_signal, NAMES), Settled, Driven)
REGISTRY = registry_of({"acme": testing.plugin_of(*KINDS)})
ROAD = """
road main { draw with waypoints { points: [(0m, 0m), (50m, 0m)] } }
sample with random { attempts: 1 }
"""
BASE = scenario_of(ROAD, REGISTRY)


def of_road(formula: stl.Formula) -> Condition:
    """The formula over arc length."""

    def call(name: str) -> PassCall:
        return PassCall(
            "signal", f"acme.{name}", FrozenDict({"road": Entity("main", "road")}), name
        )

    signals = [SignalBinding(name, call(name), PURE) for name in NAMES]
    return Condition(str(formula), formula, "road", tuple(signals))


def of_drive(formula: stl.Formula) -> Condition:
    """The formula over time."""

    def call(name: str) -> PassCall:
        return PassCall("drive_signal", f"acme.{name}t", NO_OPTIONS, name)

    signals = [SignalBinding(name, call(name), PURE) for name in NAMES]
    return Condition(str(formula), formula, "drive", tuple(signals))


def scene_with(*expectations: Condition | PassCall) -> Scene:
    tests = tuple(ScenarioConstraint(f"e{i}", test) for i, test in enumerate(expectations))
    return sample_scenes(replace(BASE, expectations=tests), REGISTRY).scenes[0]


def is_accepted(test: Condition | PassCall) -> bool:
    """Whether sampling accepts the only candidate where it is required."""
    scenario: Scenario = replace(BASE, requirements=(ScenarioConstraint("r", test),))
    found = sample_scenes(scenario, REGISTRY)
    if found.scenes:
        assert found.scenes[0].requirements[0].satisfied, "accepted, yet reported as violated"
    return bool(found.scenes)


def drive_of() -> Trace:
    return Trace(POSITIONS, {}, "test")


def verdicts_of(formula: stl.Formula, signals: Mapping[str, list[float]]) -> dict[str, Any]:
    """What each part of roadlang says of the formula."""
    VALUES.update(signals)
    parsed = stl.parse(str(formula))
    scene = scene_with(of_road(formula), of_drive(formula))
    over_drive = judge(scene, drive_of(), REGISTRY).verdicts[1]
    return {
        "require": is_accepted(of_road(formula)),
        "expect over roads": scene.expectations[0].satisfied,
        "expect over drives": over_drive.satisfied,
        "stl": bool(parsed.satisfied(POSITIONS, signals)),
        "truth": bool(parsed.truth(POSITIONS, signals)[0]),
    }


@pytest.mark.parametrize("seed", range(FORMULAS))
def test_every_part_gives_the_verdict_of_boolean_evaluation(seed: int) -> None:
    draw = EdgeDraw(seed)
    formula, signals = draw.formula(seed % 4), draw.signals()
    expected = Reference(POSITIONS.tolist(), signals).satisfied(formula)[0]
    assert verdicts_of(formula, signals) == dict.fromkeys(
        ("require", "expect over roads", "expect over drives", "stl", "truth"), expected
    )
    truth = formula.satisfied(POSITIONS, signals, wrap=float(SAMPLES))
    verdict = formula.verdict(POSITIONS, signals, wrap=float(SAMPLES))
    assert verdict == ("satisfied" if truth else "violated")


@pytest.mark.parametrize("measure", ["average", "time", "time_left"])
@pytest.mark.parametrize("seed", range(20))
def test_no_measure_of_robustness_changes_a_verdict(seed: int, measure: Measure) -> None:
    draw = EdgeDraw(seed)
    formula, signals = draw.formula(seed % 4), draw.signals()
    VALUES.update(signals)
    expected = Reference(POSITIONS.tolist(), signals).satisfied(formula)[0]
    options = EvaluationOptions(robustness=measure)
    road, drive = (replace(of(formula), evaluation=options) for of in (of_road, of_drive))
    scene = scene_with(road, drive)
    over_drive = judge(scene, drive_of(), REGISTRY).verdicts[1]
    assert is_accepted(road) is expected
    assert (scene.expectations[0].satisfied, over_drive.satisfied) == (expected, expected)


def test_the_formulas_are_drawn_at_the_edges() -> None:
    """At least a fifth of them have robustness 0, with both truth values."""
    at_zero = []
    for seed in range(FORMULAS):
        draw = EdgeDraw(seed)
        formula, signals = draw.formula(seed % 4), draw.signals()
        if formula.rho(POSITIONS, signals) == 0.0:
            at_zero.append(bool(formula.satisfied(POSITIONS, signals)))
    assert len(at_zero) > FORMULAS / 5
    assert min(at_zero.count(True), at_zero.count(False)) > FORMULAS / 10


@pytest.mark.parametrize(
    ("rho", "holds"), [(1e-300, True), (0.0, True), (-0.0, True), (-1e-300, False)]
)
def test_a_robustness_of_zero_satisfies_a_monitor(rho: float, holds: bool) -> None:
    VALUES["x"] = [rho]
    over_road = PassCall("monitor", "acme.settled", NO_OPTIONS, "m")
    scene = scene_with(over_road, PassCall("monitor", "acme.driven", NO_OPTIONS, "m"))
    assert is_accepted(over_road) is holds
    assert [v.satisfied for v in judge(scene, drive_of(), REGISTRY).verdicts] == [holds, holds]
