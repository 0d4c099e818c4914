"""Handles as things: those of one road together, each agent and object by itself."""

from __future__ import annotations

import struct
from collections.abc import Iterable
from itertools import groupby
from typing import TYPE_CHECKING

import numpy as np

from ..net.protocol import Message
from ..net.scene_part import BULK_BODY, ScenePart
from .frame import SceneOrigin

if TYPE_CHECKING:
    from roadlang.commands import Handle

_SORTS = {"waypoint": 0, "place": 1, "object": 2, "agent": 3, "junction": 4, "street": 5}
_LONGEST_NAME = 64
MOST_IN_A_PART = (BULK_BODY - 4 - _LONGEST_NAME) // 8

HandleGroups = dict[int, tuple["Handle", ...]]
"""The handles by the ids of the things that show them."""


def handle_parts(
    handles: Iterable[Handle], frame: SceneOrigin
) -> tuple[list[ScenePart], HandleGroups]:
    """What shows the handles, and which each thing shows."""
    parts: list[ScenePart] = []
    groups: HandleGroups = {}
    for (sort, name), members in groupby(handles, key=lambda handle: (handle.sort, handle.name)):
        every = tuple(members)
        for start in range(0, len(every), MOST_IN_A_PART):
            id, batch = len(parts) + 1, every[start : start + MOST_IN_A_PART]
            parts.append(_part(id, sort, name, batch, frame))
            groups[id] = batch
    return parts, groups


def _part(
    id: int, sort: str, name: str, handles: tuple[Handle, ...], frame: SceneOrigin
) -> ScenePart:
    places = np.array([(h.x - frame.x, h.y - frame.y) for h in handles], dtype="<f4").tobytes()
    title = name.encode("ascii", "replace")[:_LONGEST_NAME]
    head = struct.pack("<BB", _SORTS[sort], len(title)) + title + struct.pack("<H", len(handles))
    return ScenePart(Message.HANDLES, id, head + places, places, f"handles of {name}")
