"""Objects, paths, agents and the world, as things."""

from __future__ import annotations

import json
import struct
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from roadlang.api import Code

from ..faults import fault
from ..net.protocol import Message
from ..net.scene_part import BULK_BODY, LONGEST_BODY, ScenePart
from .frame import SceneOrigin
from .line import RoadSamples
from .sky import world_settings
from .surface_table import surface_table

PATH_SPACING = 1.0
_RECORD_BYTES = 28
_POINTS_A_PIECE = (BULK_BODY - 8) // 12


@dataclass(frozen=True, slots=True)
class Placed:
    """An object in the world: sizes along its heading, across it and up, in meters."""

    sort: str
    x: float
    y: float
    heading: float
    length: float
    width: float
    height: float
    color: str = ""
    solid: bool = True
    name: str = ""
    alone: bool = False
    """whether it is a thing by itself, to be moved"""


def object_parts(
    objects: Iterable[Placed], frame: SceneOrigin, first_id: int = 1
) -> tuple[list[ScenePart], dict[int, tuple[str, ...]]]:
    """Objects of one sort together, as many as fit, and their names by the ids of the things."""
    groups: dict[tuple[str, str, bool, str], list[Placed]] = {}
    for placed in objects:
        key = (placed.sort, placed.color, placed.solid, placed.name if placed.alone else "")
        groups.setdefault(key, []).append(placed)
    parts: list[Any] = []
    names = {}
    for (sort, color, solid, _), members in groups.items():
        most = (BULK_BODY - 8 - len(sort) - len(color)) // _RECORD_BYTES
        for at in range(0, len(members), most):
            batch = members[at : at + most]
            names[first_id + len(parts)] = tuple(placed.name for placed in batch)
            parts.append(_objects(first_id + len(parts), sort, color, solid, batch, frame))
    return parts, names


def path_parts(line: RoadSamples, path: int, frame: SceneOrigin) -> list[ScenePart]:
    """The center line that agents follow, a meter a point, in pieces."""
    count = max(2, round(line.length / PATH_SPACING) + 1)
    s = np.linspace(line.s[0], line.s[-1], count)
    points, _, width = line.at(s)
    if line.closed:
        points, width = points[:-1], width[:-1]
    rows = frame.ground(points)
    rows[:, 1] = rows[:, 2]
    rows[:, 2] = width / 2
    pieces = -(-len(rows) // _POINTS_A_PIECE)
    parts: list[Any] = []
    for piece in range(pieces):
        part = rows[piece * _POINTS_A_PIECE : (piece + 1) * _POINTS_A_PIECE].tobytes()
        head = struct.pack("<BHH", int(line.closed), pieces, len(part) // 12)
        label = f"path of {line.name}, piece {piece + 1}"
        parts.append(ScenePart(Message.PATH, path << 16 | piece, head + part, part, label))
    return parts


def agent_part(id: int, spec: Mapping[str, Any]) -> ScenePart:
    """An agent; `docs/godot.md` lists what its specification may hold."""
    return _json_part(Message.AGENT, id, spec, f"agent {spec.get('name', id)}")


def world_part(world: Mapping[str, Any], extent: float | None = None) -> ScenePart:
    """Sun, weather and surfaces; `extent` of the ground, where that has grown."""
    settings = {**world_settings(world), "surfaces": surface_table(world)}
    if extent is not None:
        settings["extent"] = extent
    return _json_part(Message.WORLD, 1, settings, "the world's settings")


def _objects(
    id: int, sort: str, color: str, solid: bool, batch: list[Placed], frame: SceneOrigin
) -> ScenePart:
    places = frame.ground(np.array([[placed.x, placed.y] for placed in batch]))
    records = np.empty((len(batch), 7), dtype="<f4")
    records[:, :3] = places
    records[:, 3] = [placed.heading for placed in batch]
    records[:, 4:] = [(placed.length, placed.height, placed.width) for placed in batch]
    name = sort.encode("ascii", "replace")[:64]
    paint = color.encode("ascii", "replace")[:32]
    head = struct.pack("<BHB", int(solid), len(batch), len(name)) + name
    head += struct.pack("<B", len(paint)) + paint
    label = batch[0].name if batch[0].alone else f"{len(batch)} x {sort}"
    return ScenePart(Message.OBJECTS, id, head + records.tobytes(), places.tobytes(), label)


def _json_part(kind: Message, id: int, value: Mapping[str, Any], label: str) -> ScenePart:
    body = json.dumps(value, allow_nan=False, separators=(",", ":"), sort_keys=True).encode()
    if len(body) > LONGEST_BODY:
        raise fault(Code.MESSAGE_TOO_LARGE, what=label, size=len(body), limit=LONGEST_BODY)
    return ScenePart(kind, id, body, body, label)
