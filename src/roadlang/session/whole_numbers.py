"""Whole numbers that a program hands over, checked where it does: not deep in a plugin."""

from __future__ import annotations

import operator
from typing import SupportsIndex


def whole_number(name: str, value: SupportsIndex, *, least: int) -> int:
    """An integer of Python or numpy. Raises `TypeError` for anything else, `ValueError` below
    `least`."""
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"`{name}` must be an integer, not {value!r}") from None
    if number < least:
        raise ValueError(f"`{name}` must be at least {least}, not {number}")
    return number
