"""Many frozen records at once, of a column of values for each field."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Mapping
from dataclasses import fields
from itertools import repeat
from typing import Any, TypeVar

from .read_only import changeable_fields, frozen

T = TypeVar("T")


def records_of(kind: type[T], count: int, columns: Mapping[str, Iterable[Any]]) -> list[T]:
    """`count` records of a frozen dataclass with slots: the same as `kind(...)` gives for each row,
    in a fifth of the time. `columns` has as many values of every field."""
    made = [*map(object.__new__, repeat(kind, count))]
    of_kind: Any = kind
    changeable = changeable_fields(of_kind)
    for name in [field.name for field in fields(of_kind)]:
        values = columns[name]
        if name in changeable:
            values = _frozen(values)
        deque(map(getattr(of_kind, name).__set__, made, values), maxlen=0)
    return made


def _frozen(values: Iterable[Any]) -> Iterable[Any]:
    if isinstance(values, repeat):
        return repeat(frozen(next(values)))
    listed = list(values)
    distinct = {id(value): value for value in listed}
    shown = {key: frozen(value) for key, value in distinct.items()}
    return [shown[key] for key in map(id, listed)]
