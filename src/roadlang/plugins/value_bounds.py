"""The least and the greatest number that a value of a scenario can be, whatever is drawn."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from ..ir.values import (
    ConstantValue,
    Flag,
    Items,
    Operation,
    PassCall,
    RandomValue,
    Reference,
    TextValue,
    Value,
)
from ..stl.evaluate.interval_arithmetic import (
    UNKNOWN,
    Bounds,
    arithmetic,
    negated,
    of_function,
)
from .kinds import Kind
from .registry import KindEntry
from .stated_bounds import OptionRange, stated_support

FindKind = Callable[[PassCall], tuple[KindEntry, type[Kind]]]


def _nothing_known(value: Value) -> Bounds | None:
    return None


@dataclass(frozen=True)
class ValueBounds:
    """`named`: the value of a `param` or `let`; `kind`: the class that a call names; `known`: the
    bounds of values that the caller knows more of, None for others."""

    named: Callable[[str], Value | None]
    kind: FindKind
    known: Callable[[Value], Bounds | None] = _nothing_known
    _of_names: dict[str, Bounds] = field(default_factory=dict)
    _of_draws: dict[str, Bounds] = field(default_factory=dict)

    def of(self, value: Value | None) -> Bounds:
        """Bounds of a number; nothing is known of what the geometry decides, or of what is not a
        number.

        Raises RL474 where a distribution states a support that is not a range.
        """
        found = None if value is None else self.known(value)
        if found is not None:
            return found
        if isinstance(value, ConstantValue):
            return value.value, value.value
        if isinstance(value, Reference):
            if value.name not in self._of_names:
                self._of_names[value.name] = self.of(self.named(value.name))
            return self._of_names[value.name]
        if isinstance(value, RandomValue):
            if value.place not in self._of_draws:
                self._of_draws[value.place] = self._of_draw(value)
            return self._of_draws[value.place]
        if isinstance(value, Operation):
            return self._of_operation(value)
        return UNKNOWN

    def option(self, value: Value | None) -> Any:
        """The value of an option: a number as an `OptionRange`, a list as a tuple of them.

        None where nothing is known of it.
        """
        if isinstance(value, Reference):
            declared = self.named(value.name)
            if isinstance(declared, TextValue | Flag | Items):
                return self.option(declared)
        if isinstance(value, TextValue | Flag):
            return value.value
        if isinstance(value, Items):
            return tuple(self.option(item) for item in value.items)
        low, high = self.of(value)
        return OptionRange(low, high)

    def options(self, call: PassCall) -> dict[str, Any]:
        """What is known of each option of a call that is written."""
        return {name: self.option(value) for name, value in call.options.items()}

    def _of_draw(self, draw: RandomValue) -> Bounds:
        entry, kind = self.kind(draw.call)
        ends = stated_support(entry, kind, self.options(draw.call), draw.call.span)
        return min(ends), max(ends)

    def _of_operation(self, value: Operation) -> Bounds:
        parts = [self.of(operand) for operand in value.operands]
        if value.operator == "negate" or (value.operator == "-" and len(parts) == 1):
            return negated(parts[0])
        if value.operator in ("abs", "min", "max"):
            return of_function(value.operator, parts)
        found = parts[0]
        for part in parts[1:]:
            found = arithmetic(value.operator, found, part)
        return found
