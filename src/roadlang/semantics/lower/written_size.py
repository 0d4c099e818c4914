"""Limits what values and formulas hold once every `let` in them is written out."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from ...diagnostics import Code
from ...ir import scenario as ir
from ...ir.contained_values import values_in
from ...ir.values import Condition, Reference, Value
from ...stl.formula.size import written_out_size
from ..checker import Checker
from ..names.formula_size import MOST_PARTS


def report_oversized(checker: Checker, scenario: ir.Scenario) -> None:
    """RL242 for the first statement that holds more than `MOST_PARTS`: those that use it grow too
    large with it."""
    sizes: dict[str, int] = {}
    for statement in _statements(scenario):
        values = list(values_in(statement))
        if sum(_written_out(value, sizes) for value in values) > MOST_PARTS:
            what = getattr(statement, "name", None) or statement.kind.rpartition(".")[2]
            most = f"{MOST_PARTS:,}"
            checker.report(Code.TOO_LARGE_WRITTEN_OUT, statement.span, what=what, most=most)
            return
        if isinstance(statement, ir.Named):
            is_number = statement.dimension is not None  # computed once, however often it is used
            sizes[statement.name] = 1 if is_number else _size(statement.value, sizes)


def _statements(scenario: ir.Scenario) -> Iterator[Any]:
    """Everything with a span and values, values by name first, each after those that it uses."""
    yield from scenario.values
    yield from scenario.signals
    yield from (*scenario.images, *scenario.networks, *scenario.roads)
    yield from (*scenario.requirements, *scenario.expectations)
    yield from (*scenario.agents, *scenario.objects, *scenario.emits)
    run = (scenario.sample, scenario.simulate, scenario.falsify)
    yield from (call for call in run if call is not None)


def _written_out(value: Value, sizes: dict[str, int]) -> int:
    """What a value holds through names, and the parts of its formulas."""
    if isinstance(value, Reference):
        return sizes[value.name]
    size = sum(_written_out(child, sizes) for child in values_in(value))
    return size + written_out_size(value.formula) if isinstance(value, Condition) else size


def _size(value: Value, sizes: dict[str, int]) -> int:
    """How many values a value is, those that it names included."""
    if isinstance(value, Reference):
        return sizes[value.name]
    return 1 + sum(_size(child, sizes) for child in values_in(value))
