"""A scenario as JSON: it comes back the same, and fits its own schema."""

from __future__ import annotations

import dataclasses
import json
from pathlib import Path

import jsonschema
import pytest

from roadlang.ir.scenario import Scenario
from roadlang.ir.scenario_json import scenario_from_json, scenario_schema, scenario_to_json
from roadlang.plugins.discovery import load_registry
from roadlang.semantics import check_text

TEXT = """
scenario both "Roads and drives"
param reach = 2m..8m
road main { draw with segments { pieces: [straight(80m), arc(40m, 60deg)] }, lanes: 2 }
road bent from main { perturb with sine { amplitude: reach, wavelength: 90m, over: [5m, 50m] } }
agent ego is choice(car, truck) on bent at 5m { drive with brake { when: time > 3s } }
object trees is tree on bent at 0%..100% { count: integer(3, 5), side: left }
require phi: always[0m, inf] (deviation(bent, main) < reach)
require long: length(bent) > 50m
expect in_lane: always (abs(ego.cross_track_error) < 1.5m) { robustness: average }
let near = ego.cross_track_error < 1m
expect careful: always (near and ego.speed < 20m/s) { weights: { near: 3 } }
expect smooth: always (near) { semantics: linear }
world { sun: { azimuth: 0deg..360deg }, weather: choice(clear, rain) }
emit json
"""


@pytest.fixture(scope="module")
def scenario() -> Scenario:
    found, diagnostics = check_text(TEXT, Path("scene.rl"), {}, load_registry())
    assert found is not None, [diagnostic.message for diagnostic in diagnostics]
    return found


def test_it_fits_the_schema(scenario: Scenario) -> None:
    jsonschema.validate(scenario_to_json(scenario), scenario_schema())


def test_it_comes_back_the_same(scenario: Scenario) -> None:
    record = json.loads(json.dumps(scenario_to_json(scenario)))
    again = scenario_from_json(record)
    assert again.requirements[0].test.formula == scenario.requirements[0].test.formula  # type: ignore[union-attr]
    assert [e.test.evaluation for e in again.expectations] == [  # type: ignore[union-attr]
        e.test.evaluation  # type: ignore[union-attr]
        for e in scenario.expectations
    ]
    assert scenario_to_json(dataclasses.replace(again)).keys() == record.keys()
    assert [road.name for road in again.roads] == ["main", "bent"]


def test_places_are_lines_and_columns(scenario: Scenario) -> None:
    place = scenario_to_json(scenario)["roads"][1]["span"]
    assert (place["file"], place["line"], place["column"]) == ("scene.rl", 5, 1)


def test_another_version_is_refused() -> None:
    with pytest.raises(ValueError, match=r"not a roadlang\.scenario/2"):
        scenario_from_json({"schema": "roadlang.scenario/9"})


def test_numbers_are_finite_or_text(scenario: Scenario) -> None:
    json.dumps(scenario_to_json(scenario), allow_nan=False)
