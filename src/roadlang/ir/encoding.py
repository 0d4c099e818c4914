"""Scenes as JSON and back."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Mapping
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from .number_text import floats_text, is_floats

if TYPE_CHECKING:
    from .scene import Scene


class NotFinite(ValueError):
    """A number that JSON cannot hold; `place` is the way to it (`roads[0].x[3]`)."""

    def __init__(self, place: str) -> None:
        super().__init__(f"`{place}` is not a finite number")
        self.place = place


def to_json(value: Any) -> str:
    """A dataclass of the IR as JSON: one member a line, lists of numbers on one line.

    The same value gives the same text: members in the order of the fields, maps sorted, numbers
    in the shortest form that reads back exactly. Raises `NotFinite`.
    """
    import msgspec

    plain = msgspec.to_builtins(value, enc_hook=_plain_number, order="deterministic")
    try:
        return _written(_ordered(value, plain), 0) + "\n"
    except ValueError:
        _refuse_non_finite(plain, "")
        raise


def scene_from_json(text: str | bytes) -> Scene:
    """Read a scene file of this version or an earlier one.

    Raises `msgspec.ValidationError` where it does not fit the schema, `msgspec.DecodeError` where
    it is no JSON, `UnknownSceneSchema` for another schema; all of them are `ValueError`s.
    """
    import msgspec

    from .scene import Scene
    from .scene_versions import current

    return msgspec.convert(current(msgspec.json.decode(text)), type=Scene)


def _plain_number(value: Any) -> Any:
    if hasattr(value, "tolist"):
        return value.tolist()
    raise TypeError(f"{type(value).__name__} cannot be written as JSON")


def _refuse_non_finite(value: Any, place: str) -> None:
    if isinstance(value, float):
        if not math.isfinite(value):
            raise NotFinite(place)
    elif isinstance(value, dict):
        for key, member in value.items():
            _refuse_non_finite(member, f"{place}.{key}" if place else str(key))
    elif isinstance(value, list | tuple):
        for index, item in enumerate(value):
            _refuse_non_finite(item, f"{place}[{index}]")


def _ordered(value: Any, plain: dict[str, Any]) -> dict[str, Any]:
    """`schema` first, so that a reader sees at once what it has."""
    return {"schema": plain["schema"], **plain} if "schema" in plain else plain


def _written(value: Any, depth: int) -> str:
    """Raises `ValueError` for a number that is not finite."""
    leaf = _LEAVES.get(type(value))
    if leaf is not None:
        return leaf(value)
    if isinstance(value, dict) and value:
        inner = "  " * (depth + 1)
        members = [
            f"{inner}{_name(key)}: {leaf(member)}"
            if (leaf := _LEAVES.get(type(member))) is not None
            else f"{inner}{_name(key)}: {_written(member, depth + 1)}"
            for key, member in value.items()
        ]
        return "{\n" + ",\n".join(members) + "\n" + "  " * depth + "}"
    if not isinstance(value, list | tuple):
        return _other(value)
    if is_floats(value):
        text = floats_text(value)
        if "null" in text:
            raise ValueError("a number is not finite")
        return f"[{text}]"
    if any(isinstance(item, dict | list) for item in value):
        inner = "  " * (depth + 1)
        return (
            "[\n" + ",\n".join([inner + _written(item, depth + 1) for item in value])
            + "\n" + "  " * depth + "]"
        )  # fmt: skip
    return _other(value)


def _number(value: float) -> str:
    text = repr(value)
    if "n" in text:  # nan, inf
        raise ValueError("a number is not finite")
    return text


_other = json.JSONEncoder(ensure_ascii=False, allow_nan=False).encode
_name = lru_cache(maxsize=4096)(_other)
"""of a member: few names, many members"""
_LEAVES: Mapping[type, Callable[[Any], str]] = {
    str: json.encoder.encode_basestring,
    float: _number,
    int: repr,
    bool: {False: "false", True: "true"}.__getitem__,
    type(None): {None: "null"}.__getitem__,
}
"""What `_other` gives, in a fraction of its time"""
