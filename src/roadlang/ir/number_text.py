"""Lists of numbers as JSON, the texts of Python's `json` in a twentieth of its time."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from typing import Any


def floats_text(values: Sequence[float], separator: str = ", ") -> str:
    """Floating point numbers as the items of a JSON list; `null` where one is not finite."""
    text: str = _encoder().encode(values).decode()[1:-1]
    if "e" not in text and _SMALL[0] not in text:
        return text.replace(",", separator)
    parts = text.split(",")
    for place, part in enumerate(parts):
        if "e" in part or part.startswith(_SMALL):
            parts[place] = repr(values[place])
    return separator.join(parts)


def is_floats(values: Sequence[Any]) -> bool:
    """Whether all items are floating point numbers, finite or not."""
    return set(map(type, values)) == {float}


_SMALL = ("0.0000", "-0.0000")
"""How msgspec writes some numbers that Python writes with an exponent."""


@cache
def _encoder() -> Any:
    import msgspec

    return msgspec.json.Encoder()
