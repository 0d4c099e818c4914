"""`{ robustness: ... }`, `{ weights: ... }` and `{ semantics: ... }` behind a formula."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from roadlang import stl
from roadlang.cli.main import main
from roadlang.ir.scene import Scene
from roadlang.ir.trace import AgentTrace, Trace
from roadlang.judging.deciding_moment import deciding_moment
from roadlang.judging.drives import judge
from roadlang.judging.robustness_series import robustness_series
from roadlang.judging.running_drives import judge_so_far
from roadlang.plugins.discovery import load_registry
from roadlang.scenes.sampling import SamplingResult
from roadlang.stl.evaluate.time_robustness import time_rho
from tests.straight_road import STRAIGHT

Sample = Callable[..., SamplingResult]
REGISTRY = load_registry()
BUMP = "road bent from main { perturb with bump { at: 100m, height: 3m, length: 80m } }\n"
EGO = "agent ego is car on main at 5m { drive with pure_pursuit }\n"
TIME = np.linspace(0.0, 4.0, 9)
OFFSET = np.array([0.0, 0.5, 2.0, 0.5, 0.0, 0.0, 0.0, 0.0, 0.0])


def road_verdict(sample: Sample, text: str) -> Any:
    (scene,) = sample(STRAIGHT + BUMP + text).scenes
    return scene.expectations[-1]


def driven(sample: Sample, text: str) -> tuple[Scene, Trace]:
    (scene,) = sample(STRAIGHT + EGO + text).scenes
    zero = np.zeros_like(TIME)
    moving = (10 * TIME, zero, zero, zero + 10, zero, zero, 10 * TIME, OFFSET, zero, zero)
    ego = AgentTrace("ego", TIME, *moving)
    return scene, Trace(TIME, {"ego": ego}, "test")


def deviation_of(sample: Sample) -> tuple[Any, Any]:
    """Stations and the deviation at them."""
    (profile,) = road_verdict(sample, "expect e: always (deviation(bent, main) > 0m)\n").profiles
    return np.array(profile.stations), np.array(profile.values)


@pytest.mark.parametrize("measure", ["average", "time", "time_left"])
def test_over_roads_it_is_what_the_library_computes(sample: Sample, measure: str) -> None:
    text = f"always (deviation(bent, main) < 5m) {{ robustness: {measure} }}"
    found = road_verdict(sample, f"expect e: {text}\n")
    stations, values = deviation_of(sample)
    formula, signals = stl.parse("always (d < 5)"), {"d": values}
    expected = {
        "average": stl.average_robustness(formula, stations, signals)[0],
        "time": stl.time_robustness(formula, stations, signals)[0],
        "time_left": stl.time_robustness(formula, stations, signals, direction="left")[0],
    }[measure]
    assert found.robustness == pytest.approx(expected, abs=1e-9)
    assert (found.satisfied, found.text) == (True, text)


def test_weights_are_those_of_named_operands(sample: Sample) -> None:
    found = road_verdict(
        sample,
        "let near = deviation(bent, main) < 5m\nlet far = length(bent) > 10m\n"
        "expect e: always (near and far) { weights: { near: 3 } }\n",
    )
    assert found.robustness == pytest.approx((1 - 3 / 4) * 2.0)


def test_an_operand_may_itself_be_joined(sample: Sample) -> None:
    """`near` stays one operand; it is not dissolved in the conjunction around it."""
    found = road_verdict(
        sample,
        "let near = deviation(bent, main) < 5m and deviation(bent, main) < 6m\n"
        "expect e: always (near and length(bent) > 10m) { weights: { near: 3 } }\n",
    )
    assert found.robustness == pytest.approx((1 - 3 / 4) * 2.0)


def test_only_between_the_stations_is_it_violated(sample: Sample) -> None:
    """`eventually[0.2m, 0.8m]` holds no station; between them the signal is a line."""
    formula = "expect e: eventually[99.2m, 99.8m] (deviation(bent, main) > 1m)"
    assert road_verdict(sample, f"{formula}\n").satisfied is False
    found = road_verdict(sample, f"{formula} {{ semantics: linear }}\n")
    assert found.satisfied is True
    assert 1.9 < found.robustness < 2.0


@pytest.mark.parametrize(
    ("options", "robustness"),
    [
        ("", 1.0),
        ("{ robustness: average }", (3.0 + 2.5 + 7 * 1.0) / 9),
        ("{ robustness: time }", 0.0),
        ("{ robustness: time_left }", 0.0),
        ("{ semantics: linear }", 1.0),
        ("{ semantics: held }", 1.0),
    ],
)
def test_over_drives(sample: Sample, options: str, robustness: float) -> None:
    text = f"expect e: always (abs(ego.cross_track_error) < 3m) {options}\n"
    scene, trace = driven(sample, text)
    (verdict,) = judge(scene, trace, REGISTRY).verdicts
    assert verdict.robustness == pytest.approx(robustness)
    assert verdict.satisfied is True
    assert judge_so_far(scene, trace, REGISTRY)[0].robustness == verdict.robustness
    assert deciding_moment(verdict, trace, REGISTRY) is not None


def test_the_series_along_a_drive_is_that_of_the_measure(sample: Sample) -> None:
    text = "expect e: always (abs(ego.cross_track_error) < 1m) { robustness: time }\n"
    scene, trace = driven(sample, text)
    series = robustness_series(scene.expectations[0], trace, REGISTRY)
    formula = stl.parse("abs(x) < 1")
    assert series is not None
    np.testing.assert_array_equal(series, stl.time_robustness(formula, TIME, {"x": OFFSET}))
    assert time_rho(formula, TIME, {"x": OFFSET}) == series[0] == 0.5


def test_what_judges_a_drive_later_knows_the_options(sample: Sample) -> None:
    scene, _ = driven(
        sample,
        "let near = abs(ego.cross_track_error) < 1m\n"
        "expect e: always (near and ego.speed < 9m/s) { weights: { near: 3 } }\n"
        "expect plain: always (near)\n",
    )
    with_options, plain = scene.expectations
    assert isinstance(with_options.formula, Mapping)
    ((operand, weight),) = with_options.formula["evaluation"]["weights"]
    assert (stl.from_json(operand), weight) == (stl.parse("abs(`ego.cross_track_error`) < 1"), 3.0)
    assert plain.formula is not None
    assert "evaluation" not in plain.formula


def test_on_a_lap_time_robustness_goes_around_once() -> None:
    formula, x = stl.parse("x > 0"), {"x": [1.0, -1.0, 1.0, 1.0]}
    found = stl.time_robustness(formula, [0, 1, 2, 3], x, wrap=4)
    assert found.tolist() == [0, 0, 2, 1]
    found = stl.time_robustness(formula, [0, 1, 2, 3], x, direction="left", wrap=4)
    assert found.tolist() == [2, 0, 0, 1]
    found = stl.time_robustness(formula, [0, 1], {"x": [1.0, 1.0]}, wrap=4)
    assert found.tolist() == [4, 4]


def test_a_search_goes_by_the_measure(tmp_path: Path) -> None:
    scene = tmp_path / "s.rl"
    scene.write_text(
        "road main { draw with waypoints { points: [(0m, 0m), (80m, 30m), (160m, 0m)] } }\n"
        "agent ego is car on main at 5m { drive with pure_pursuit { speed: 8m/s..12m/s } }\n"
        "expect plain: always (abs(ego.cross_track_error) < 5m)\n"
        "expect mean: always (abs(ego.cross_track_error) < 5m) { robustness: average }\n"
        "simulate with builtin { duration: 3s }\n"
        "falsify with random { expects: [plain, mean], evaluations: 2 }\n"
    )
    with pytest.raises(SystemExit):
        main(["falsify", str(scene), "-o", str(tmp_path / "out")])
    _, *lines = (tmp_path / "out" / "journal.jsonl").read_text().splitlines()
    found = [json.loads(line)["expectations"] for line in lines]
    assert len(found) == 2
    assert all(outcome["mean"] > outcome["plain"] for outcome in found)
