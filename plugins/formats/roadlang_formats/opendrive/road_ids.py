"""Ids of roads: those of the network, so that a map keeps them when it is read and
written again."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .road_parts import OpenDriveRoad


def with_own_ids(parts: Sequence[OpenDriveRoad]) -> tuple[OpenDriveRoad, ...]:
    """Parts that are numbered one after the other with their final ids.

    The first part of `town/5` gets 5, unless roads of several networks have one number; further
    parts of a road, and roads outside of networks, get the ids after the greatest of these.
    """
    ids = _ids(parts)
    return tuple(
        replace(
            part,
            id=ids[part.id],
            links={
                end: replace(link, id=ids[link.id])
                for end, link in part.links.items()
                if link.id in ids
            },
            reverse_of=None if part.reverse_of is None else ids[part.reverse_of],
        )
        for part in parts
    )


def _ids(parts: Sequence[OpenDriveRoad]) -> Mapping[int, int]:
    first: dict[str, OpenDriveRoad] = {}
    for part in parts:
        first.setdefault(part.road.name, part)
    own = {part.id: part.road.edge for part in first.values() if part.road.edge is not None}
    if len(set(own.values())) < len(own):
        return {part.id: part.id for part in parts}
    following = iter(range(max(own.values(), default=0) + 1, 10**9))
    return {part.id: own[part.id] if part.id in own else next(following) for part in parts}
