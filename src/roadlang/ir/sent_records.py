"""Records of which many are sent from one process to another."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import fields
from operator import attrgetter
from typing import Any, TypeVar

T = TypeVar("T")


def sent_by_members(kind: type[T]) -> type[T]:
    """A frozen dataclass with slots and at least two members that is pickled by these alone, as its
    constructor takes them: what `dataclasses` adds for this looks the members up each time."""
    found: Any = kind
    members: Callable[[T], tuple[Any, ...]] = attrgetter(*(each.name for each in fields(found)))

    def reduce(record: T) -> tuple[type[T], tuple[Any, ...]]:
        return kind, members(record)

    found.__reduce__ = reduce
    return kind
