"""The JSON Schemas of what a compilation writes: scenes and their manifest."""

from __future__ import annotations

from ..stl.formats.json_schema import FORMULA, formula_definitions
from .manifest import Manifest
from .scene import Scene
from .schema import Schema, any_of, reference, schema_of_dataclass

_NULL: Schema = {"type": "null"}
_CONDITION: Schema = {
    "description": "a formula with what its variables stand for",
    "type": "object",
    "properties": {
        "text": {"type": "string", "description": "the formula as the language writes it"},
        "formula": FORMULA,
        "signals": {
            "description": "the signals, by the name that the formula has for each",
            "type": "object",
            "additionalProperties": reference("SignalCall"),
        },
        "numbers": {
            "description": "the numbers of this scene, by the name that the formula has for each",
            "type": "object",
            "additionalProperties": {"type": "number"},
        },
    },
    "required": ["text", "formula", "signals", "numbers"],
}
_SIGNAL_CALL: Schema = {
    "description": "a kind of signal, such as `speed`, with every option that is set",
    "type": "object",
    "properties": {
        "kind": {"type": "string", "description": "its name"},
        "options": {"type": "object", "description": "by name, in SI units and radians"},
    },
    "required": ["kind", "options"],
}


def scene_schema(world: Schema | None = None) -> Schema:
    """The JSON Schema of a scene. `world` is that of the options of the `world` statement."""
    condition = any_of([reference("Condition"), _NULL])
    return schema_of_dataclass(
        Scene,
        {
            "Call.when": condition,
            "Call.during": condition,
            "Verdict.formula": condition,
            "Scene.world": world or {"type": "object"},
        },
        {"Condition": _CONDITION, "SignalCall": _SIGNAL_CALL, **formula_definitions()},
    )


def manifest_schema() -> Schema:
    """The JSON Schema of a manifest."""
    return schema_of_dataclass(Manifest)
