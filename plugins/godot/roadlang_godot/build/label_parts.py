"""What each part of a scene is called in pictures: its class, and the numbers of its instances."""

from __future__ import annotations

import struct
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from roadlang_standard.lane_looks import LaneLook
from roadlang_standard.semantic_classes import SemanticClass, class_of_category

from ..net.protocol import Message
from ..net.scene_part import BULK_BODY, Key, ScenePart

if TYPE_CHECKING:
    from roadlang.api import Scene, SceneActor

MOST_INSTANCES = 65535
_RECORD = struct.Struct("<IBBH")
_MOST = (BULK_BODY - 4) // _RECORD.size
_SCENERY = 0
"""Stands for the kind of what the engine adds by itself (`sensors/labels.gd`)."""
_SCENERY_CLASSES = {0: SemanticClass.OTHER, 1: SemanticClass.TERRAIN, 2: SemanticClass.VEGETATION}
"""By its number; 0 is everything without a label."""
_PART_CLASSES = {
    Message.PATCH: SemanticClass.ROAD,
    Message.TILES: SemanticClass.ROAD,
    Message.PAINT: SemanticClass.ROAD_PAINT,
    Message.SIGNALS: SemanticClass.TRAFFIC_LIGHT,
}
_SURFACE_CLASSES = {
    LaneLook.SIDEWALK: SemanticClass.SIDEWALK,
    LaneLook.GRASS: SemanticClass.TERRAIN,
}
_SURFACE_BYTE = 1
"""Of the body of a SEGMENT."""


@dataclass(frozen=True, slots=True)
class Instance:
    """An agent or object in pictures: its number from 1, and its class."""

    number: int
    actor: SceneActor
    category: SemanticClass


def instances_of(scene: Scene, sent: Mapping[int, Sequence[str]]) -> tuple[Instance, ...]:
    """The agents of a scene, then its objects in the order in which they are sent, as far as there
    are numbers. `sent`: names of objects by the ids of the things that hold them."""
    objects = {actor.name: actor for actor in scene.objects}
    out = [*scene.agents, *(objects[name] for id in sorted(sent) for name in sent[id])]
    return tuple(
        Instance(number, actor, class_of_category(actor.category))
        for number, actor in enumerate(out[:MOST_INSTANCES], start=1)
    )


def label_parts(
    sent: Iterable[ScenePart],
    agents: Mapping[str, int],
    objects: Mapping[int, Sequence[str]],
    instances: Iterable[Instance],
) -> list[ScenePart]:
    """The labels of all that is sent. `agents`: numbers by name; `objects`: names by id."""
    by_name = {instance.actor.name: instance for instance in instances}
    numbered: dict[Key, Instance | None] = {
        (Message.AGENT, number): by_name.get(name) for name, number in agents.items()
    }
    numbered |= {(Message.OBJECTS, id): by_name.get(names[0]) for id, names in objects.items()}
    records = {_SCENERY: [_RECORD.pack(id, *row) for id, row in _scenery().items()]}
    for part in sent:
        row = _label(part, numbered)
        if row is not None:
            records.setdefault(part.kind, []).append(_RECORD.pack(part.id, *row))
    parts: list[ScenePart] = []
    for kind, rows in records.items():
        for at in range(0, len(rows), _MOST):
            body = b"".join(rows[at : at + _MOST])
            head = struct.pack("<BH", kind, len(body) // _RECORD.size)
            id = len(parts) + 1
            parts.append(ScenePart(Message.LABELS, id, head + body, body, "the labels of things"))
    return parts


def _scenery() -> dict[int, tuple[int, int, int]]:
    return {id: (found, 0, 0) for id, found in _SCENERY_CLASSES.items()}


def _label(part: ScenePart, numbered: Mapping[Key, Instance | None]) -> tuple[int, int, int] | None:
    """Class, whether its copies are numbered one by one, and the number of the first."""
    if part.kind == Message.SEGMENT:
        surface = LaneLook(part.body[_SURFACE_BYTE] & 15)
        return _SURFACE_CLASSES.get(surface, SemanticClass.ROAD), 0, 0
    if part.key in numbered:
        found = numbered[part.key]
        has_copies = int(part.kind == Message.OBJECTS)
        return None if found is None else (found.category, has_copies, found.number)
    category = _PART_CLASSES.get(part.kind)
    return None if category is None else (category, 0, 0)
