"""A `Scenario` as JSON, and its JSON Schema.

A dataclass becomes an object with its class's name under `is`; a dimension its unit; a formula
its JSON form; a place in a source its file, line, column and offsets (the text is not repeated).
"""

from __future__ import annotations

import dataclasses
import math
from typing import Any, get_args

from ..diagnostics import Span
from ..stl.formats.json_schema import FORMULA, formula_definitions
from ..stl.formula.evaluation_options import EvaluationOptions, Measure, Semantics
from ..stl.formula.formulas import Formula
from .dimension import Dimension
from .read_only import FrozenDict
from .scenario import SCENARIO_SCHEMA, Scenario
from .schema import DataclassWriter, any_of, array, document, reference, written_fields


def scenario_to_json(scenario: Scenario) -> dict[str, Any]:
    """The scenario as plain dicts, lists, strings and numbers."""
    plain: dict[str, Any] = _plain(scenario)
    return {"schema": plain.pop("schema"), **plain}


def scenario_schema() -> dict[str, Any]:
    """The JSON Schema of a scenario, derived from the dataclasses."""
    writer = DataclassWriter(
        {"Scenario.schema": {"const": SCENARIO_SCHEMA}},
        special={
            Formula: FORMULA,
            EvaluationOptions: reference("EvaluationOptions"),
            Dimension: reference("Dimension"),
            Span: reference("Span"),
        },
        tag="is",
        number=any_of([{"type": "number"}, {"enum": ["inf", "-inf", "nan"]}]),
    )
    body = writer.of(Scenario)
    definitions = {**writer.definitions, **formula_definitions(), **_SPECIAL}
    return document(SCENARIO_SCHEMA, body, definitions=definitions)


_SPECIAL: dict[str, Any] = {
    "EvaluationOptions": {
        "description": "how the formula is evaluated, where it is not by its margins at samples",
        "type": "object",
        "properties": {
            "semantics": {"enum": list(get_args(Semantics))},
            "robustness": {"enum": list(get_args(Measure))},
            "weights": array(array({"anyOf": [FORMULA, {"type": "number"}]}, 2, 2)),
            "strict": {"const": True},
        },
    },
    "Dimension": {
        "description": "exponents of length, pixel, time, angle and mass",
        "type": "object",
        "properties": {
            "is": {"const": "Dimension"},
            "unit": {"type": "string"},
            "exponents": array({"type": "number"}, 5, 5),
        },
        "required": ["is", "unit", "exponents"],
    },
    "Span": {
        "description": "a place in a source file",
        "type": "object",
        "properties": {
            "file": {"type": "string"},
            "line": {"type": "integer", "description": "of the start, counted from 1"},
            "column": {"type": "integer", "description": "of the start, counted from 1"},
            "start": {"type": "integer", "description": "offset in characters"},
            "end": {"type": "integer", "description": "offset in characters"},
        },
        "required": ["file", "line", "column", "start", "end"],
    },
}


def _plain(value: Any) -> Any:
    if isinstance(value, Formula):
        from ..stl.formats.json_form import to_json

        return to_json(value)
    if isinstance(value, EvaluationOptions):
        from ..stl.formats.evaluation_json import evaluation_to_json

        return evaluation_to_json(value)
    if isinstance(value, Dimension):
        return {"is": "Dimension", "unit": value.unit, "exponents": list(value.exponents)}
    if isinstance(value, Span):
        place = {"file": value.source.path, "line": value.line, "column": value.column}
        return {**place, "start": value.start, "end": value.end}
    if dataclasses.is_dataclass(value) and not isinstance(value, type):
        members = {
            field.name: _plain(getattr(value, field.name)) for field in written_fields(value)
        }
        return {"is": type(value).__name__, **members}
    if isinstance(value, FrozenDict):  # pairs: a JSON object promises no order
        return [[name, _plain(item)] for name, item in value.items()]
    if isinstance(value, tuple | list):
        return [_plain(item) for item in value]
    if isinstance(value, float) and not math.isfinite(value):
        return str(value)
    return value
