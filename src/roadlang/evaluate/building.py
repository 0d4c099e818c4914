"""From the call of a kind to the kind itself, with its options evaluated."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from contextlib import AbstractContextManager
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..diagnostics import Code, DiagnosticError, diagnose
from ..ir.values import Entity, PassCall
from ..plugins.guard import plugin_guard
from ..plugins.kinds import Kind
from ..plugins.option_types import CallType, ListType, OptionType, QuantityType, UnionType
from ..plugins.options import OptionSchema, schema_of
from ..plugins.registry import KindEntry
from .candidates import CandidateBatch
from .evaluation import evaluate, scalar

Resolve = Callable[[Entity], Any]


@dataclass(frozen=True)
class KindInstance:
    """A kind with concrete options, and whom to blame when it fails."""

    kind: Any
    entry: KindEntry
    call: PassCall

    @property
    def guarded(self) -> AbstractContextManager[None]:
        """A context in which what is raised is attributed to the plugin of this kind."""
        return plugin_guard(self.entry, self.call.span)


def build(
    call: PassCall,
    candidates: CandidateBatch,
    element: int = 0,
    *,
    single: bool = False,
    resolve: Resolve | None = None,
) -> KindInstance:
    """The kind of a call. `single`: plain numbers of one candidate instead of columns."""
    entry, kind = candidates.scenario.kind(call)
    given = dict(call.options)
    fields: dict[str, Any] = {}
    for option in schema_of(kind):
        if option.name in given:
            value = evaluate(given[option.name], candidates, element)
            value = scalar(value) if single else value
            _check_bounds(option, value, call)
            fields[option.name] = _converted(option, value, candidates, element, single, resolve)
        elif not option.required:
            fields[option.name] = option.default
    with plugin_guard(entry, call.span):
        return KindInstance(kind(**fields), entry, call)


def one_of_batch(kind: Any, row: int) -> Any:
    """The kind of one candidate of a batch: its columns become plain numbers and words."""
    picked = {
        field.name: _at_row(getattr(kind, field.name), row) for field in dataclasses.fields(kind)
    }
    return dataclasses.replace(kind, **picked)


def _at_row(value: Any, row: int) -> Any:
    """The value of one candidate, also of columns inside lists, points, maps and calls."""
    if isinstance(value, np.ndarray) and value.ndim == 2:
        return scalar(value[row : row + 1] if value.shape[0] > 1 else value)
    if isinstance(value, tuple):
        return tuple(_at_row(item, row) for item in value)
    if isinstance(value, dict):
        return {key: _at_row(item, row) for key, item in value.items()}
    return one_of_batch(value, row) if isinstance(value, Kind) else value


def _converted(
    option: OptionSchema,
    value: Any,
    candidates: CandidateBatch,
    element: int,
    single: bool,
    resolve: Resolve | None,
) -> Any:
    if isinstance(value, Entity):
        return resolve(value) if resolve is not None else value.name
    if isinstance(value, PassCall) and not _takes_calls(option.type):
        return value
    if isinstance(value, PassCall):
        return build(value, candidates, element, single=single, resolve=resolve).kind
    if isinstance(value, tuple):
        return tuple(_converted(option, v, candidates, element, single, resolve) for v in value)
    if isinstance(option.type, QuantityType) and option.type.whole and not isinstance(value, str):
        return np.rint(value).astype(np.int64) if isinstance(value, np.ndarray) else round(value)
    return value


def _takes_calls(type: OptionType) -> bool:
    """Whether a call in an option is built with it; in other options it is left to be chosen."""
    if isinstance(type, ListType):
        return _takes_calls(type.item)
    if isinstance(type, UnionType):
        return any(map(_takes_calls, type.alternatives))
    return isinstance(type, CallType)


def _check_bounds(option: OptionSchema, value: Any, call: PassCall) -> None:
    """Constants are checked with the file; drawn and computed values here (RL473)."""
    if not isinstance(value, float | int | np.ndarray) or isinstance(value, bool):
        return
    numbers = np.asarray(value)
    if numbers.dtype.kind not in "fiu":
        return
    limits = option.constraints
    wrong = np.isnan(numbers)
    for bound, outside in (
        (limits.minimum, np.less),
        (limits.maximum, np.greater),
        (limits.above, np.less_equal),
        (limits.below, np.greater_equal),
    ):
        if bound is not None:
            wrong = wrong | outside(numbers, bound)
    if wrong.any():
        found = float(numbers[wrong].reshape(-1)[0])
        raise DiagnosticError(
            diagnose(
                Code.DRAWN_VALUE_OUT_OF_BOUNDS,
                call.span,
                option=option.name,
                kind=call.kind.rpartition(".")[2],
                value=f"{found:g}",
            )
        )
