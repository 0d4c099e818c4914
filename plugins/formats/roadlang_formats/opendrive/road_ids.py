"""Ids of roads: those of the network, so that a map keeps them when it is read and written."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import count
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from roadlang.api import SceneRoad


def own_ids(roads: Mapping[int, SceneRoad]) -> Mapping[int, int]:
    """The id of each part of a road by its number; numbers go up.

    The first part of `town/5` gets 5, unless roads of several networks have one number; further
    parts of a road, and roads outside of networks, get the ids after the greatest of these.
    """
    first: dict[str, int] = {}
    for number, road in roads.items():
        first.setdefault(road.name, number)
    own = {n: edge for n in first.values() if (edge := roads[n].edge) is not None}
    if len(set(own.values())) < len(own):
        return {number: number for number in roads}
    following = count(max(own.values(), default=0) + 1)
    return {number: own[number] if number in own else next(following) for number in roads}
