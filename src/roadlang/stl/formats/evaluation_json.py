"""How a formula is evaluated, as a JSON value and back."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ..formula.evaluation_options import PLAIN, EvaluationOptions
from .json_form import from_json, to_json


def evaluation_to_json(options: EvaluationOptions) -> dict[str, Any]:
    """What differs from the default: `semantics`, `robustness`, `weights` as pairs of an operand
    and its weight, and `strict`."""
    found: dict[str, Any] = {}
    if options.semantics != PLAIN.semantics:
        found["semantics"] = options.semantics
    if options.robustness != PLAIN.robustness:
        found["robustness"] = options.robustness
    if options.weights:
        found["weights"] = [[to_json(operand), weight] for operand, weight in options.weights]
    if options.strict:
        found["strict"] = True
    return found


def evaluation_from_json(record: Mapping[str, Any]) -> EvaluationOptions:
    """What `evaluation_to_json` wrote. Raises DiagnosticError for an operand that is none."""
    weights = tuple((from_json(part), float(weight)) for part, weight in record.get("weights", ()))
    return EvaluationOptions(
        record.get("semantics", PLAIN.semantics),
        record.get("robustness", PLAIN.robustness),
        weights,
        bool(record.get("strict", False)),
    )
