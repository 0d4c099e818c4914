"""JSON Schemas say what every member is, and refuse what is no scene."""

from __future__ import annotations

import copy
import json
from typing import Any

import jsonschema
import pytest

import roadlang
from roadlang import stl
from roadlang.diagnostics import DiagnosticError
from roadlang.ir.scenario_json import scenario_schema
from roadlang.ir.scene_schema import manifest_schema, scene_schema
from roadlang.plugins.discovery import load_registry
from roadlang.plugins.json_schema import schema_of_kind
from roadlang.stl.formats.json_schema import FORMULA, formula_definitions

SCENE = """
road main { draw with waypoints { points: [(0m, 0m), (80m, 20m), (160m, 0m)] } }
agent ego is car on main at 5m {
  drive with pure_pursuit { speed: 9m/s }
  drive with brake { when: once[0s, 2s] (ego.speed / 2 > 8m/s) }
}
require bend: always (abs(curvature(main)) < 0.5/m) and eventually[20m, 60m] (width(main) > 1m)
expect arrives: eventually (ego.progress > 95%)
world { time_of_day: 14h, sun: { azimuth: 90deg, elevation: 30deg } }
"""


@pytest.mark.parametrize("schema", [scene_schema(), manifest_schema()], ids=["scene", "manifest"])
def test_every_member_is_described(schema: Any) -> None:
    jsonschema.Draft202012Validator.check_schema(schema)
    for name, definition in schema["$defs"].items():
        assert definition["description"], name
        for member, described in definition.get("properties", {}).items():
            assert described.get("description") or "const" in described or "$ref" in described, (
                f"{name}.{member}"
            )


def test_a_scene_fits_and_one_with_a_wrong_member_does_not() -> None:
    record = json.loads(roadlang.loads(SCENE).sample()[0].to_json())
    validator = jsonschema.Draft202012Validator(scene_schema())
    validator.validate(record)
    for path, value in [
        (("roads", 0, "x", 3), "east"),
        (("agents", 0, "drive", 1, "when", "formula"), {"once": 3}),
        (("agents", 0, "drive", 1, "when", "signals"), ["speed"]),
        (("agents", 0, "drive", 1, "when", "text"), 3),
        (("agents", 0, "drive", 1, "when", "numbers"), {"a": "3"}),
        (("agents", 0, "drive", 1, "when"), {"text": "true"}),
        (("expectations", 0, "formula", "signals"), {"e1": {"kind": "progress"}}),
        (("expectations", 0, "formula", "signals"), {"e1": {"kind": 3, "options": {}}}),
        (("expectations", 0, "satisfied"), "yes"),
        (("roads", 0, "center_marking"), "dotted"),
        (("roads", 0, "trim"), [0.0]),
        (("agents", 0, "lane"), 1.5),
        (("provenance", "seed"), None),
    ]:
        broken = copy.deepcopy(record)
        target = broken
        for step in path[:-1]:
            target = target[step]
        target[path[-1]] = value
        assert not validator.is_valid(broken), path


@pytest.mark.parametrize(
    "text",
    ["always[0, 5] (x > -y)", "true or x + 1 < 2", "(x > 1) until[2, inf] (min(x, y) != 3)",
     "not (x ^ 2 > 1) iff y < 0 and x > 0"],
)  # fmt: skip
def test_json_formulas_fit_the_schema_of_formulas(text: str) -> None:
    schema = {**FORMULA, "$defs": formula_definitions()}
    jsonschema.validate(stl.parse(text).to_json(), schema)


@pytest.mark.parametrize(
    "formula", [3, {"alway": True}, {"and": True}, {"<": [1]}, {"not": [True]}, {"implies": [True]}]
)
def test_what_is_no_formula_does_not_fit(formula: Any) -> None:
    schema = {**FORMULA, "$defs": formula_definitions()}
    assert not jsonschema.Draft202012Validator(schema).is_valid(formula)
    with pytest.raises(DiagnosticError, match="RL310"):
        stl.from_json(formula)


def test_the_schema_of_scenarios_knows_formulas() -> None:
    definitions = scenario_schema()["$defs"]
    assert definitions["Condition"]["properties"]["formula"]["$ref"] == FORMULA["$ref"]
    assert "Formula" in definitions


def test_the_version_is_said_once() -> None:
    version = scene_schema()["$defs"]["Scene"]["properties"]["schema"]
    assert version.keys() == {"description", "const"}


def test_limits_of_options_are_those_of_json_schema() -> None:
    registry = load_registry()
    sine = schema_of_kind(registry.find("perturb", "sine"))["properties"]
    assert sine["wavelength"]["exclusiveMinimum"] == 0
    assert "minimum" not in sine["wavelength"]
    pursuit = schema_of_kind(registry.find("drive", "pure_pursuit"))["properties"]
    time = pursuit["lookahead_time"]
    assert (time["minimum"], time["maximum"]) == (0, 10)
    speed, nothing = pursuit["speed"]["anyOf"]
    assert (speed["minimum"], speed["maximum"]) == (0, 120)
    assert nothing == {"type": "null"}
    lookahead, nothing = pursuit["lookahead"]["anyOf"]
    assert lookahead["exclusiveMinimum"] == 0
    assert nothing == {"type": "null"}


def test_files_words_and_names_are_strings_of_json() -> None:
    registry = load_registry()
    onnx = schema_of_kind(registry.find("extract", "onnx"))["properties"]
    assert onnx["model"]["type"] == "string"
    contour = schema_of_kind(registry.find("extract", "contour"))["properties"]
    assert contour["road"]["enum"] == ["auto", "dark", "light"]
    assert contour["spline"]["type"] == "boolean"
