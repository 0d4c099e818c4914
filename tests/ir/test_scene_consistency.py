"""A scene whose members do not fit together is refused when it is read, with the place."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any

import pytest

from roadlang import DiagnosticError, Scene, testing
from roadlang.ir.scene_consistency import InconsistentScene, check_scene

TEXT = """
road main { draw with waypoints { points: [(0m, 0m), (60m, 0m)] }, width: 7m, lanes: 2 }
agent ego is car on main at 5m {
  drive with lane_follow { speed: 5m/s }
  drive with brake { when: ego.station > 30m, while: ego.speed > 1m/s }
}
object tree is tree on main at 20m { side: left, offset: 2m }
object zebra is crosswalk on main at 40m
let slow = ego.speed < 9m/s
expect in_lane: always (abs(ego.cross_track_error) < 1m and slow) { weights: { slow: 2 } }
expect held: always (ego.speed < 9m/s) { semantics: held, strict: true }
"""


@pytest.fixture(scope="module")
def written() -> str:
    (scene,) = testing.sample(TEXT)
    return scene.to_json()


def shorter(road: str) -> Callable[[Any], None]:
    return lambda scene: scene["roads"][0][road].pop()


def put(value: Any, *way: Any) -> Callable[[Any], None]:
    def change(scene: Any) -> None:
        for step in way[:-1]:
            scene = scene[step]
        scene[way[-1]] = value

    return change


CONDITION = "expectations[0].formula"
EVALUATION = ("expectations", 0, "formula", "evaluation")
OPERAND = {">": ["ego.speed", 1.0]}
COLUMNS = "reference_stations", "x", "y", "heading", "curvature", "width"
BRAKE = ("agents", 0, "drive", 1)
FORMULA = ("expectations", 0, "formula")
SIGNAL = (*FORMULA, "signals", "ego.cross_track_error")
FAULTS: dict[str, tuple[Callable[[Any], None], str]] = {
    **{f"{name} too short": (shorter(name), f"roads[0].{name}") for name in COLUMNS},
    "offsets too short": (put([0.0, 0.0], "roads", 0, "center_offset"), "roads[0].center_offset"),
    "elevations too short": (put([1.0], "roads", 0, "elevation"), "roads[0].elevation"),
    "one station": (put([0.0], "roads", 0, "stations"), "roads[0].stations"),
    "a station twice": (put(0.0, "roads", 0, "stations", 1), "roads[0].stations"),
    "stations back": (put(5.0, "roads", 0, "stations", 2), "roads[0].stations"),
    "a lane without width": (
        put([0.0], "roads", 0, "lane_list", 0, "width"),
        "roads[0].lane_list",
    ),
    "an agent on no road": (put("other", "agents", 0, "road"), "agents[0].road"),
    "an object on no road": (put("other", "objects", 0, "road"), "objects[0].road"),
    "a marking on no road": (put("other", "markings", 0, "road"), "markings[0].road"),
    "no formula": (put({}, *FORMULA), "expectations[0].formula"),
    "what is no formula": (put({"zz": 1}, *FORMULA, "formula"), "expectations[0].formula.formula"),
    "a signal in a word": (put("x", *SIGNAL), "expectations[0].formula.signals"),
    "options of a signal": (put("x", *SIGNAL, "options"), "expectations[0].formula.signals"),
    "a number in words": (
        put({"n": "x"}, *BRAKE, "when", "numbers"),
        "agents[0].drive[1].when.numbers",
    ),
    "what is no term": (
        put({">": ["ego.station", True]}, *BRAKE, "when", "formula"),
        "agents[0].drive[1].when.formula",
    ),
    "an unknown variable": (
        put({">": ["ego.sped", 1.0]}, *BRAKE, "when", "formula"),
        "agents[0].drive[1].when.formula",
    ),
    "a truth among numbers": (
        put({"n": True}, *BRAKE, "when", "numbers"),
        "agents[0].drive[1].when.numbers",
    ),
    "an evaluation in a word": (put("held", *EVALUATION), f"{CONDITION}.evaluation"),
    "unknown semantics": (
        put({"semantics": "helt"}, *EVALUATION),
        f"{CONDITION}.evaluation.semantics",
    ),
    "an unknown robustness": (
        put({"robustness": ["time"]}, *EVALUATION),
        f"{CONDITION}.evaluation.robustness",
    ),
    "what is no truth": (put({"strict": 1}, *EVALUATION), f"{CONDITION}.evaluation.strict"),
    "an unknown word of evaluation": (
        put({"strikt": True}, *EVALUATION),
        f"{CONDITION}.evaluation.strikt",
    ),
    "two that do not go together": (
        put({"semantics": "held", "robustness": "time"}, *EVALUATION),
        f"{CONDITION}.evaluation.semantics",
    ),
    "weights in a map": (
        put({"weights": {"a": 1}}, *EVALUATION),
        f"{CONDITION}.evaluation.weights",
    ),
    "a weight without operand": (
        put({"weights": [2.0]}, *EVALUATION),
        f"{CONDITION}.evaluation.weights[0]",
    ),
    "a weight of zero": (
        put({"weights": [[OPERAND, 0]]}, *EVALUATION),
        f"{CONDITION}.evaluation.weights[0][1]",
    ),
    "a weight of no formula": (
        put({"weights": [[OPERAND, 1.5], [{"zz": 1}, 2]]}, *EVALUATION),
        f"{CONDITION}.evaluation.weights[1][0]",
    ),
    "a list of numbers": (
        put([], *BRAKE, "during", "numbers"),
        "agents[0].drive[1].during.numbers",
    ),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_the_place_that_does_not_fit_is_named(written: str, fault: str) -> None:
    change, place = FAULTS[fault]
    document = json.loads(written)
    change(document)
    with pytest.raises(DiagnosticError) as caught:
        Scene.from_json(json.dumps(document))
    (found,) = caught.value.diagnostics
    assert found.code == "RL461"
    assert found.message.endswith(f" - at `$.{place}`")


def test_a_scene_that_was_sampled_is_consistent(written: str) -> None:
    check_scene(Scene.from_json(written).record)


def test_a_monitor_needs_no_formula(written: str) -> None:
    document = json.loads(written)
    put({"monitor": "any"}, *FORMULA)(document)
    assert Scene.from_json(json.dumps(document)).record.expectations[0].formula is not None


def test_the_place_is_a_member_of_the_error(written: str) -> None:
    document = json.loads(written)
    shorter("y")(document)
    with pytest.raises(DiagnosticError) as caught:
        Scene.from_json(json.dumps(document))
    assert isinstance(caught.value.__cause__, InconsistentScene)
    assert caught.value.__cause__.place == "roads[0].y"
