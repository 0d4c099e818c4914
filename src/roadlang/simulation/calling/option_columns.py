"""The options of many agents as columns, so that one kind decides or measures for all of them."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from ...geometry.arrays import Integers


def columns_of(
    options: Sequence[Mapping[str, Any]], same: Mapping[str, Any] | None = None
) -> dict[str, Any]:
    """Options that are numbers as arrays (N, ...), the others as those of the first agent. `same`:
    numbers that all agents share, and that stay numbers."""
    return {
        name: value
        if shape_of(value) is None
        else np.array([each[name] for each in options], dtype=np.float64)
        for name, value in options[0].items()
    } | dict(same or {})


def words_of(options: Mapping[str, Any]) -> str:
    """The options that are not numbers, as one text; of numbers their shape."""
    if _NUMBERS.issuperset(map(type, options.values())):  # as those of most
        return ""
    shapes = {name: shape_of(value) for name, value in options.items()}
    words = {
        name: options[name] if shape is None else shape
        for name, shape in shapes.items()
        if shape != ()
    }
    return json.dumps(words, sort_keys=True) if words else ""


_NUMBERS = frozenset((int, float))


def shape_of(value: Any) -> tuple[int, ...] | None:
    """() of a number, (2,) of a pair, (3, 2) of three pairs; None of what is not numbers alone."""
    if isinstance(value, list | tuple):
        parts = {shape_of(item) for item in value}
        part = parts.pop() if len(parts) == 1 else None
        return None if part is None else (len(value), *part)
    return () if isinstance(value, int | float) and not isinstance(value, bool) else None


def options_of(columns: Mapping[str, Any], rows: Integers) -> dict[str, Any]:
    """The options of some agents of a group."""
    return {
        name: value[rows] if isinstance(value, np.ndarray) else value
        for name, value in columns.items()
    }
