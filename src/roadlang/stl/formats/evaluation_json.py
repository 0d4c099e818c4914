"""How a formula is evaluated, as a JSON value and back."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import fields
from math import inf
from typing import Any, get_args

from ...diagnostics import DiagnosticError, did_you_mean
from ..formula.evaluation_options import PLAIN, EvaluationOptions, Measure, Semantics
from ..formula.formulas import Formula
from .json_form import from_json, shown, to_json

MEMBERS = tuple(each.name for each in fields(EvaluationOptions))
"""of an evaluation in JSON"""


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
    for name in record:
        if name not in MEMBERS:
            meant = did_you_mean(name, MEMBERS) or (f"it has {_one_of(MEMBERS, 'and')}",)
            raise UnreadableEvaluation(name, f"an evaluation has no member `{name}`: {meant[0]}")
    found = EvaluationOptions(
        _word("semantics", get_args(Semantics), record),
        _word("robustness", get_args(Measure), record),
        _weights(record.get("weights", [])),
        _flag("strict", record),
    )
    if found.conflict is not None:
        name, other = found.conflict
        fault = f"`{name}` and `{other}` cannot be used together: leave out one of them"
        raise UnreadableEvaluation(name, fault)
    return found


def _word(name: str, words: tuple[str, ...], record: Mapping[str, Any]) -> Any:
    value = record.get(name, getattr(PLAIN, name))
    if value not in words:
        meant = did_you_mean(value, words) if isinstance(value, str) else ()
        raise _unexpected(name, _one_of(words), value, *meant)
    return value


def _flag(name: str, record: Mapping[str, Any]) -> bool:
    value = record.get(name, False)
    if not isinstance(value, bool):
        raise _unexpected(name, "`true` or `false`", value)
    return value


def _weights(listed: Any) -> tuple[tuple[Formula, float], ...]:
    if not isinstance(listed, list | tuple):
        raise _unexpected("weights", "a list of pairs, each a formula and its weight", listed)
    return tuple(_weight(number, item) for number, item in enumerate(listed))


def _weight(number: int, item: Any) -> tuple[Formula, float]:
    place = f"weights[{number}]"
    if not isinstance(item, list | tuple) or len(item) != 2:
        raise _unexpected(place, "a pair, a formula and its weight", item)
    weight = item[1]
    if isinstance(weight, bool) or not isinstance(weight, int | float) or not 0.0 < weight < inf:
        raise _unexpected(f"{place}[1]", "a weight, a number above 0", weight)
    try:
        return from_json(item[0]), float(weight)
    except DiagnosticError as error:
        raise UnreadableEvaluation(f"{place}[0]", error.diagnostics[0].message) from error


def _unexpected(place: str, expected: str, value: Any, meant: str = "") -> UnreadableEvaluation:
    found = f"expected {expected}, found `{shown(value)}`"
    return UnreadableEvaluation(place, f"{found}: {meant}" if meant else found)


def _one_of(words: Sequence[str], joint: str = "or") -> str:
    """`a`, `b` or `c`."""
    *first, last = (f"`{word}`" for word in words)
    return f"{', '.join(first)} {joint} {last}"
