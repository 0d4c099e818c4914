"""Lists of numbers as JSON, the texts of Python's `json` in a twentieth of its time."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from typing import Any


def floats_text(values: Sequence[float], separator: str = ", ") -> str:
    """Floating point numbers as the items of a JSON list; `null` where one is not finite."""
    content: bytes = _encoder().encode(values)
    if b"e" in content or _SMALL.encode() in content:
        return _as_python_writes(content[1:-1].decode()).replace(",", separator)
    return content[1:-1].replace(b",", separator.encode()).decode()


def _as_python_writes(text: str) -> str:
    """The same numbers; those with an exponent, or so small that Python would write one, anew."""
    text = f",{text},"
    places: set[int] = set()
    for sign in ("e", f",{_SMALL}", f",-{_SMALL}"):
        at = text.find(sign)
        while at >= 0:
            places.add(text.rfind(",", 0, at + 1))
            at = text.find(sign, at + 1)
    parts, last = [], 0
    for place in sorted(places):
        end = text.index(",", place + 1)
        parts += [text[last : place + 1], repr(float(text[place + 1 : end]))]
        last = end
    return "".join([*parts, text[last:]])[1:-1]


def is_floats(values: Sequence[Any]) -> bool:
    """Whether all items are floating point numbers, finite or not."""
    return set(map(type, values)) == {float}


_SMALL = "0.0000"
"""How msgspec writes some numbers that Python writes with an exponent."""


@cache
def _encoder() -> Any:
    import msgspec

    return msgspec.json.Encoder()
