"""What names stand for."""

from __future__ import annotations

from ...ir.values import Reference, Value
from ..checker import Checker


def resolved(checker: Checker, value: Value | None) -> Value | None:
    """The value behind a name, and behind the name that it may stand for."""
    while isinstance(value, Reference):
        value = checker.definition(value.name).value
    return value
