"""How a formula is evaluated, as a JSON value and back."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields
from math import inf
from typing import Any, get_args

from ...diagnostics import DiagnosticError
from ..formula.evaluation_options import PLAIN, EvaluationOptions, Measure, Semantics
from ..formula.formulas import Formula
from .json_form import from_json, to_json


class UnreadableEvaluation(ValueError):
    """A member that is not as `evaluation_to_json` writes it; `place` is the way to it."""

    def __init__(self, place: str, reason: str) -> None:
        super().__init__(reason)
        self.place = place


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
    """What `evaluation_to_json` wrote. Raises UnreadableEvaluation for anything else."""
    known = [each.name for each in fields(EvaluationOptions)]
    for name in record:
        if name not in known:
            raise UnreadableEvaluation(name, f"the members are {', '.join(known)}")
    found = EvaluationOptions(
        _word("semantics", get_args(Semantics), record),
        _word("robustness", get_args(Measure), record),
        _weights(record.get("weights", [])),
        _flag("strict", record),
    )
    if found.conflict is not None:
        raise UnreadableEvaluation(found.conflict[0], f"not together with `{found.conflict[1]}`")
    return found


def _word(name: str, words: tuple[str, ...], record: Mapping[str, Any]) -> Any:
    value = record.get(name, getattr(PLAIN, name))
    if value not in words:
        raise UnreadableEvaluation(name, f"this is one of {', '.join(words)}")
    return value


def _flag(name: str, record: Mapping[str, Any]) -> bool:
    value = record.get(name, False)
    if not isinstance(value, bool):
        raise UnreadableEvaluation(name, "this is true or false")
    return value


def _weights(listed: Any) -> tuple[tuple[Formula, float], ...]:
    if not isinstance(listed, list | tuple):
        raise UnreadableEvaluation("weights", "this is a list of formulas, each with its weight")
    return tuple(_weight(number, item) for number, item in enumerate(listed))


def _weight(number: int, item: Any) -> tuple[Formula, float]:
    place = f"weights[{number}]"
    if not isinstance(item, list | tuple) or len(item) != 2:
        raise UnreadableEvaluation(place, "this is a formula and its weight")
    weight = item[1]
    if isinstance(weight, bool) or not isinstance(weight, int | float) or not 0.0 < weight < inf:
        raise UnreadableEvaluation(f"{place}[1]", "a weight is a number above 0")
    try:
        return from_json(item[0]), float(weight)
    except DiagnosticError as error:
        raise UnreadableEvaluation(f"{place}[0]", error.diagnostics[0].message) from error
