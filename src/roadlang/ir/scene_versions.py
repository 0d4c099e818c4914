"""Scenes of earlier schema versions, read as the present one."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from .category import AGENTS, OBJECTS, category_by_size
from .renamed_words import KINDS, OPERANDS, OPTIONS
from .scene import SCENE_SCHEMA, Scene, SceneActor


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
    named = "it names no schema" if found is None else f"the schema is {found!r}"
    raise UnknownSceneSchema(f"{named}, not {SCENE_SCHEMA!r} or 'roadlang.scene/1'")


def with_categories(scene: Scene) -> Scene:
    """A scene whose agents and objects all have a category, which earlier versions did not write.

    It is the name of the kind if that is one; else that of a vehicle of this size, or an obstacle.
    """
    agents, objects = _categorized(scene.agents, AGENTS), _categorized(scene.objects, OBJECTS)
    return replace(scene, agents=agents, objects=objects)


def _categorized(actors: Sequence[SceneActor], names: Sequence[str]) -> tuple[SceneActor, ...]:
    return tuple(
        actor if actor.category else replace(actor, category=_category(actor, names))
        for actor in actors
    )


def _category(actor: SceneActor, names: Sequence[str]) -> str:
    name = actor.kind.rpartition(".")[2].removeprefix("parked_")
    if name in names:
        return name
    is_agent = names is AGENTS
    return category_by_size(actor.length, actor.width, actor.height) if is_agent else "obstacle"


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
