"""Scenes of earlier schema versions, read as the present one."""

from __future__ import annotations

from typing import Any

from .renamed_words import KINDS, OPERANDS, OPTIONS
from .scene import SCENE_SCHEMA


class UnknownSceneSchema(ValueError):
    """The record names no schema that can be read."""


def current(record: Any) -> Any:
    """A scene as plain maps and lists, as `roadlang.scene/2` has it.

    `roadlang.scene/1` differs in some names; what was added since takes its default.
    Raises `UnknownSceneSchema`.
    """
    found = record.get("schema") if isinstance(record, dict) else None
    if found == SCENE_SCHEMA:
        return record
    if found == "roadlang.scene/1":
        return {**_renamed(record), "schema": SCENE_SCHEMA}
    raise UnknownSceneSchema(f"the schema is {found!r}, not {SCENE_SCHEMA!r} or 'roadlang.scene/1'")


def _renamed(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _member(key, member) for key, member in value.items()}
    if isinstance(value, list):
        return [_renamed(item) for item in value]
    return value


def _member(key: str, member: Any) -> Any:
    if key == "options" and isinstance(member, dict):
        names = OPTIONS | (OPERANDS if "one" in member else {})
        return {names.get(name, name): value for name, value in member.items()}
    if key == "kind" and isinstance(member, str):
        plugin, dot, name = member.rpartition(".")
        return f"{plugin}{dot}{KINDS.get(name, name)}"
    return _renamed(member)
