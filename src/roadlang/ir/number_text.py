"""Lists of numbers as JSON, the texts of Python's `json` in a twentieth of its time."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from typing import Any


def floats_text(values: Sequence[float], separator: str = ", ") -> str:
    """Floating point numbers as the items of a JSON list; `null` where one is not finite."""
    content: bytes = _encoder().encode(values)[1:-1]
    small = content.find(_SMALL)
    if small >= 0:
        content = _with_exponents(content, small)
    if b"e" in content:
        content = _with_long_exponents(content)
    if separator != ",":
        content = content.replace(b",", separator.encode())
    return content.decode()


def _with_exponents(content: bytes, at: int) -> bytes:
    """Python writes 1.25e-05 where msgspec writes 0.0000125. `at`: where that may first be."""
    parts, last = [], 0
    while at >= 0:
        start = at + len(_SMALL)
        if at == 0 or content[at - 1] in b",-":  # not the end of 10.00005
            end = content.find(b",", start)
            end = len(content) if end < 0 else end
            digits = content[start:end]
            point = b"." if len(digits) > 1 else b""
            parts += [content[last:at], digits[:1], point, digits[1:], b"e-05"]
            start = last = end
        at = content.find(_SMALL, start)
    return b"".join([*parts, content[last:]])


def _with_long_exponents(content: bytes) -> bytes:
    """Python writes e-08 and e+16 where msgspec writes e-8 and e16."""
    parts, last, at = [], 0, content.find(b"e")
    while at >= 0:
        at += 1
        if content[at : at + 1] != b"-":
            parts += [content[last:at], b"+"]
            last = at
        elif content[at + 2 : at + 3] in (b"", b","):
            parts += [content[last : at + 1], b"0"]
            last = at + 1
        at = content.find(b"e", at)
    return b"".join([*parts, content[last:]])


def is_floats(values: Sequence[Any]) -> bool:
    """Whether all items are floating point numbers, finite or not."""
    return set(map(type, values)) == {float}


_SMALL = b"0.0000"
"""How msgspec begins numbers from 0.00001 on that Python writes with an exponent."""


@cache
def _encoder() -> Any:
    import msgspec

    return msgspec.json.Encoder()
