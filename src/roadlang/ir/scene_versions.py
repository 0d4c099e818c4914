"""Scenes of earlier schema versions, read as the present one."""

from __future__ import annotations

from typing import Any

from .scene import SCENE_SCHEMA

_RENAMED_OPTIONS = {"colour": "color"}
"""Options of kinds that had another name in `roadlang.scene/1`."""


class UnknownSceneSchema(ValueError):
    """The record names no schema that can be read."""


def current(record: Any) -> Any:
    """A scene as plain maps and lists, as `roadlang.scene/2` has it.

    `roadlang.scene/1` differs in the spelling of options; what was added since takes its default.
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
        return {
            key: _options(member) if key == "options" else _renamed(member)
            for key, member in value.items()
        }
    if isinstance(value, list):
        return [_renamed(item) for item in value]
    return value


def _options(options: Any) -> Any:
    if not isinstance(options, dict):
        return options
    return {_RENAMED_OPTIONS.get(name, name): value for name, value in options.items()}
