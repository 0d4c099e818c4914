"""Calls and formulas of one candidate as plain JSON values, every option concrete."""

from __future__ import annotations

import math
import sys
from typing import Any

from ..ir.scene import Call
from ..ir.values import Condition, ConstantValue, Entity, PassCall
from ..plugins.options import schema_of
from ..stl.formats.evaluation_json import evaluation_to_json
from ..stl.formats.json_form import to_json
from .candidates import CandidateBatch
from .evaluation import evaluate
from .kind_instance import scalar
from .option_bounds import check_bounds, options_of


def call_of(call: PassCall, candidates: CandidateBatch, element: int = 0) -> Call:
    """A call with every option concrete, defaults included. Raises RL473 for a number that is drawn
    or computed and out of bounds."""
    entry, kind = candidates.scenario.kind(call)
    known = options_of(kind, call.verb)
    options = {
        option.name: concrete(option.default) for option in schema_of(kind) if not option.required
    }
    for name, value in (*call.options.items(), *call.common.items()):
        if not isinstance(value, Condition):
            found = scalar(evaluate(value, candidates, element))
            if name in known and not isinstance(value, ConstantValue):
                check_bounds(known[name], found, call)
            options[name] = concrete(found, candidates, element)
    conditions = {
        name: condition_json(value, candidates, element)
        for name, value in (*call.options.items(), *call.common.items())
        if isinstance(value, Condition)
    }
    return Call(entry.recorded, options, conditions.get("when"), conditions.get("while"))


def condition_json(
    condition: Condition, candidates: CandidateBatch, element: int = 0
) -> dict[str, Any]:
    """A formula with its signals and numbers: what judges it later needs nothing else."""
    evaluation = evaluation_to_json(condition.evaluation)
    return {
        "text": condition.text,
        "formula": _finite(to_json(condition.formula)),
        "signals": {
            binding.variable: {
                "kind": candidates.scenario.kind(binding.call)[0].recorded,
                "options": {
                    name: concrete(evaluate(value, candidates, element), candidates, element)
                    for name, value in binding.call.options.items()
                },
            }
            for binding in condition.signals
        },
        "numbers": {
            binding.variable: _finite(float(scalar(evaluate(binding.value, candidates, element))))
            for binding in condition.numbers
        },
        **({"evaluation": _finite(evaluation)} if evaluation else {}),
    }


def _finite(value: Any) -> Any:
    """JSON has no infinity: the greatest number compares as it does."""
    if isinstance(value, float) and math.isinf(value):
        return math.copysign(sys.float_info.max, value)
    if isinstance(value, list | tuple):
        return [_finite(item) for item in value]
    if isinstance(value, dict):
        return {key: _finite(item) for key, item in value.items()}
    return value


def concrete(value: Any, candidates: CandidateBatch | None = None, element: int = 0) -> Any:
    """Plain JSON values of one candidate: names of things, nested calls as maps."""
    if isinstance(value, Entity):
        return value.text
    if isinstance(value, PassCall):
        assert candidates is not None
        call = call_of(value, candidates, element)
        return {"kind": call.kind, "options": call.options}
    value = scalar(value)
    if isinstance(value, float) and math.isinf(value):
        return "inf" if value > 0 else "-inf"
    if isinstance(value, tuple):
        return [concrete(item, candidates, element) for item in value]
    if isinstance(value, dict):
        return {key: concrete(item, candidates, element) for key, item in value.items()}
    return value
