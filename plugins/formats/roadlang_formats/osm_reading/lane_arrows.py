"""Where lanes lead: the tags `turn:lanes` of OpenStreetMap."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Literal, TypeAlias

from roadlang.geometry import CrossSection

from .way_lanes import Tags, one_way

LaneArrow: TypeAlias = tuple[Literal["start", "end"], int, tuple[float, ...]]

_AIMS: Mapping[str, float] = {
    "left": 90.0,
    "slight_left": 30.0,
    "sharp_left": 135.0,
    "through": 0.0,
    "right": -90.0,
    "slight_right": -30.0,
    "sharp_right": -135.0,
    "reverse": 180.0,
    "merge_to_left": 0.0,
    "merge_to_right": 0.0,
}
"""Changes of heading in degrees, left positive."""


def written_arrows(tags: Tags) -> tuple[str, str]:
    """The markings of the lanes of a way for who comes to its first node, and to its last."""
    way = one_way(tags)
    every = tags.get("turn:lanes", "")
    return (
        tags.get("turn:lanes:backward", every if way is False else ""),
        tags.get("turn:lanes:forward", every if way is True else ""),
    )


def lane_arrows(written: tuple[str, str], lanes: CrossSection) -> tuple[LaneArrow, ...]:
    """By the ids of lanes, where their markings point, for the start and the end of a street.

    Tags that do not have a value for each lane, from left to right as it is driven, are left out,
    and so are lanes without a value.
    """
    found: list[LaneArrow] = []
    forward = [lane.id for lane in lanes.lanes if lane.direction == "forward"]
    backward = [lane.id for lane in reversed(lanes.lanes) if lane.direction == "backward"]
    ends: tuple[Literal["start", "end"], ...] = ("start", "end")
    for end, ids, tag in zip(ends, (backward, forward), written, strict=True):
        values = tag.split("|")
        if not tag or len(values) != len(ids):
            continue
        for id, value in zip(ids, values, strict=True):
            aims = [_AIMS[word] for word in value.replace(" ", "").split(";") if word in _AIMS]
            if aims:
                found.append((end, id, tuple(map(math.radians, aims))))
    return tuple(found)
