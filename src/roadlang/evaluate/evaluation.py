"""Values of a scenario for many candidates: numbers, or columns (V, 1) where they are random."""

from __future__ import annotations

import operator
from collections.abc import Callable
from functools import reduce
from typing import Any

import numpy as np

from ..diagnostics import Code, DiagnosticError, diagnose
from ..ir.values import (
    Condition,
    Constant,
    Draw,
    Entity,
    Entries,
    Flag,
    Items,
    Measure,
    Operation,
    PassCall,
    Reference,
    Text,
    Value,
)
from .candidates import CandidateBatch

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
    if isinstance(value, Constant | Flag | Text):
        return value.value
    if isinstance(value, Reference):
        return named(value.name, candidates)
    if isinstance(value, Draw):
        return drawn(value, candidates, element)
    if isinstance(value, Operation):
        return _operation(value, candidates, element)
    if isinstance(value, Measure):
        from ..world.signals import measured

        return measured(value.call, candidates, element)
    if isinstance(value, Items):
        return tuple(evaluate(item, candidates, element) for item in value.items)
    if isinstance(value, Entries):
        return {key: evaluate(item, candidates, element) for key, item in value.entries}
    assert isinstance(value, Entity | PassCall | Condition)
    return value


def named(name: str, candidates: CandidateBatch) -> Any:
    """What a `param` or `let` is. Raises RL478 where it is no number, as after 0 / 0."""

    def make() -> Any:
        found = evaluate(declared.value, candidates)
        numbers = np.asarray(found) if isinstance(found, float | np.ndarray) else np.zeros(1)
        if numbers.dtype.kind == "f" and np.isnan(numbers).any():
            raise DiagnosticError(diagnose(Code.NON_FINITE_VALUE, declared.span, name=name))
        return found

    declared = candidates.scenario.values[name]
    return candidates.once(("value", name), make)


def drawn(draw: Draw, candidates: CandidateBatch, element: int = 0) -> Any:
    """(V, 1) values of a draw."""
    from .building import build

    element = 0 if draw.per == "scene" else element

    def quantile() -> Any:
        built = build(draw.call, candidates, element)
        with built.guarded:
            found = built.kind.quantile(candidates.uniform(draw.place, element))
            return np.asarray(found).reshape(candidates.count, 1)

    return candidates.once(("draw", draw.place, element), quantile)


def _operation(value: Operation, candidates: CandidateBatch, element: int) -> Any:
    operands = [evaluate(operand, candidates, element) for operand in value.operands]
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        if value.operator == "negate":
            return -operands[0]
        if value.operator == "abs":
            return np.abs(operands[0])
        if len(operands) == 1 and value.operator == "-":
            return -operands[0]
        return reduce(_BINARY[value.operator], operands)


def scalar(value: Any) -> Any:
    """A value of a single candidate without its column: plain Python numbers and strings."""
    if isinstance(value, np.ndarray):
        return value.reshape(-1)[0].item() if value.dtype != object else value.reshape(-1)[0]
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, tuple | list):
        return tuple(scalar(item) for item in value)
    if isinstance(value, dict):
        return {key: scalar(item) for key, item in value.items()}
    return value
