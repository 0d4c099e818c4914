"""Values of a scenario for many candidates: numbers, or columns (V, 1) where they are random.

Values hold calls of kinds and the options of kinds hold values, so that `evaluate` and `build`
call each other.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable
from functools import reduce
from typing import Any

import numpy as np

from ..diagnostics import Code, DiagnosticError, diagnose
from ..ir.read_only import frozen
from ..ir.values import (
    Condition,
    ConstantValue,
    Entity,
    Entries,
    Flag,
    Items,
    Measure,
    Operation,
    PassCall,
    RandomValue,
    Reference,
    TextValue,
    Value,
)
from ..plugins.guard import plugin_guard, wrong_result
from ..plugins.option_types import CallType, ListType, OptionType, QuantityType, UnionType
from ..plugins.options import OptionSchema, draws_numbers, schema_of
from ..plugins.results import real_numbers
from .candidates import CandidateBatch
from .indexed_scenario import IndexedScenario
from .kind_instance import KindInstance, scalar
from .option_bounds import check_bounds

Resolve = Callable[[Entity], Any]

_BINARY: dict[str, Callable[[Any, Any], Any]] = {
    "+": operator.add,
    "-": operator.sub,
    "*": operator.mul,
    "/": np.divide,
    "^": np.power,
    "min": np.minimum,
    "max": np.maximum,
}


def evaluate(value: Value, candidates: CandidateBatch, element: int = 0) -> Any:
    """What a value is for these candidates.

    `element` counts the roads of a network and the copies of a group from 1: draws made for each
    of them differ by it. A call stays a call: it is built where it is used.
    """
    if isinstance(value, ConstantValue | Flag | TextValue):
        return value.value
    if isinstance(value, Reference):
        return named(value.name, candidates)
    if isinstance(value, RandomValue):
        return drawn(value, candidates, element)
    if isinstance(value, Operation):
        return _operation(value, candidates, element)
    if isinstance(value, Measure):
        return candidates.scenario.measure(value.call, candidates, element)
    if isinstance(value, Items):
        return tuple(evaluate(item, candidates, element) for item in value.items)
    if isinstance(value, Entries):
        return {key: evaluate(item, candidates, element) for key, item in value.entries.items()}
    assert isinstance(value, Entity | PassCall | Condition)
    return value


def named(name: str, candidates: CandidateBatch) -> Any:
    """The value of a `param` or `let`. Raises RL478 where it is not a number, as after 0 / 0."""

    def make(batch: CandidateBatch) -> Any:
        found = evaluate(declared.value, batch)
        if isinstance(found, float | np.ndarray) and _has_nan(np.asarray(found)):
            raise DiagnosticError(diagnose(Code.NON_FINITE_VALUE, declared.span, name=name))
        return found

    declared = candidates.scenario.values[name]
    return candidates.of_scene(
        lambda scene_batch: scene_batch.once(("value", name), lambda: make(scene_batch))
    )


def _has_nan(values: np.ndarray) -> bool:
    return values.dtype.kind == "f" and bool(np.isnan(values).any())


def drawn(draw: RandomValue, candidates: CandidateBatch, element: int = 0) -> Any:
    """(V, 1) values of a draw."""
    element = 0 if draw.per == "scene" else element

    def quantile() -> Any:
        built = build(draw.call, candidates, element)
        with built.guarded:
            result = built.kind.quantile(frozen(candidates.uniform(draw.place, element)))
            found = np.asarray(result)
            if found.dtype == object and draws_numbers(type(built.kind)):
                found = np.asarray(found.tolist())  # numbers, where all of the objects are
        # Of what a call names, words, kinds and other things may be drawn as well.
        if found.dtype.kind not in "OU" or draws_numbers(type(built.kind)):
            found = real_numbers(found, "values", built.entry, draw.call.span)
            if not np.isfinite(found).all():
                fault = "gave values that are not finite numbers"
                raise wrong_result(built.entry, draw.call.span, fault)
        if found.size != candidates.count:
            fault = f"gave values of shape {found.shape}, not ({candidates.count}, 1)"
            raise wrong_result(built.entry, draw.call.span, fault)
        found = found.reshape(candidates.count, 1)
        return _within_support(found, draw, built, candidates.scenario)

    values = candidates.once(("draw", draw.place, element), quantile)
    candidates.note_draw(draw.place, element, values)
    return values


def _within_support(
    found: Any, draw: RandomValue, built: KindInstance, scenario: IndexedScenario
) -> Any:
    """The values of a draw, none beyond the support by rounding. Raises RL474 where one is."""
    low, high = scenario.value_bounds.of(draw)
    if found.dtype.kind not in "fiu" or (math.isinf(low) and math.isinf(high)):
        return found
    slack = 1e-9 * max(1.0, *(abs(end) for end in (low, high) if math.isfinite(end)))
    least, greatest = found.min(), found.max()
    if not (low - slack <= least and greatest <= high + slack):
        value = greatest if low - slack <= least else least
        fault = f"gave {value:g}, which is beyond its support, {low:g} to {high:g}"
        raise wrong_result(built.entry, built.call.span, fault)
    return found if low <= least and greatest <= high else np.clip(found, low, high)


def _operation(value: Operation, candidates: CandidateBatch, element: int) -> Any:
    operands = [evaluate(operand, candidates, element) for operand in value.operands]
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        if value.operator == "negate":
            return -operands[0]
        if value.operator == "abs":
            return np.abs(operands[0])
        return reduce(_BINARY[value.operator], operands)


def build(
    call: PassCall,
    candidates: CandidateBatch,
    element: int = 0,
    *,
    single: bool = False,
    resolve: Resolve | None = None,
) -> KindInstance:
    """The kind of a call. `single`: plain numbers of one candidate instead of columns.

    Raises RL470 where the kind cannot be loaded or refuses its options, RL473 for a drawn option
    that is out of bounds.
    """
    entry, kind = candidates.scenario.kind(call)
    written = call.options
    fields: dict[str, Any] = {}
    for option in schema_of(kind):
        if option.name in written:
            value = evaluate(written[option.name], candidates, element)
            value = scalar(value) if single else value
            check_bounds(option, value, call)
            option_value = converted(option, value, candidates, element, single, resolve)
            fields[option.name] = frozen(option_value)
        elif not option.required:
            fields[option.name] = option.default
    with plugin_guard(entry, call.span, call.option_spans):
        return KindInstance(kind(**fields), entry, call)


def converted(
    option: OptionSchema,
    value: Any,
    candidates: CandidateBatch,
    element: int,
    single: bool,
    resolve: Resolve | None = None,
) -> Any:
    """A value of an option as its kind holds it: calls built, whole numbers whole."""
    if isinstance(value, Entity):
        return resolve(value) if resolve is not None else value.name
    if isinstance(value, PassCall) and not _takes_calls(option.type):
        return value
    if isinstance(value, PassCall):
        return build(value, candidates, element, single=single, resolve=resolve).kind
    if isinstance(value, tuple):
        return tuple(converted(option, v, candidates, element, single, resolve) for v in value)
    number = option.type.item if isinstance(option.type, ListType) else option.type
    if isinstance(number, QuantityType) and number.is_integer and not isinstance(value, str):
        return np.rint(value).astype(np.int64) if isinstance(value, np.ndarray) else round(value)
    return value


def _takes_calls(type: OptionType) -> bool:
    """Whether a call in an option is built with it; in other options it is left to be chosen."""
    if isinstance(type, ListType):
        return _takes_calls(type.item)
    if isinstance(type, UnionType):
        return any(map(_takes_calls, type.alternatives))
    return isinstance(type, CallType)
