"""Whether a value differs between scenes."""

from __future__ import annotations

from ...ir.contained_values import values_in
from ...ir.values import Measure, RandomValue, Reference, Value
from ..checker import Checker


def is_random(checker: Checker, value: Value) -> bool:
    """Whether a value is drawn, measured, or depends on one that is."""
    if isinstance(value, RandomValue | Measure):
        return True
    if isinstance(value, Reference):
        return checker.definition(value.name).random
    return any(is_random(checker, part) for part in values_in(value))
