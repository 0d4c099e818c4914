"""A scenario as JSON: nothing is missing, and it fits its own schema."""

from __future__ import annotations

import json
from pathlib import Path

import jsonschema
import pytest

from roadlang.ir.scenario import Scenario
from roadlang.ir.scenario_json import scenario_schema, scenario_to_json
from roadlang.plugins.discovery import load_registry
from roadlang.semantics import check_text
from roadlang.stl.formats.evaluation_json import evaluation_from_json
from roadlang.stl.formats.json_form import from_json

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


def test_formulas_and_how_they_are_evaluated_are_all_there(scenario: Scenario) -> None:
    record = json.loads(json.dumps(scenario_to_json(scenario)))
    assert [road["name"] for road in record["roads"]] == ["main", "bent"]
    (phi, _) = record["requirements"]
    assert from_json(phi["test"]["formula"]) == scenario.requirements[0].test.formula  # type: ignore[union-attr]
    evaluations = [
        evaluation_from_json(each["test"].get("evaluation", {})) for each in record["expectations"]
    ]
    assert evaluations == [each.test.evaluation for each in scenario.expectations]  # type: ignore[union-attr]


def test_places_are_lines_and_columns(scenario: Scenario) -> None:
    place = scenario_to_json(scenario)["roads"][1]["span"]
    assert (place["file"], place["line"], place["column"]) == ("scene.rl", 5, 1)


def test_numbers_are_finite_or_text(scenario: Scenario) -> None:
    json.dumps(scenario_to_json(scenario), allow_nan=False)
