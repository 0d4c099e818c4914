"""Objects on roads and beside them, each written with the road nearest to it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING
from xml.etree.ElementTree import Element

import numpy as np

from .elements import put

if TYPE_CHECKING:
    from roadlang.api import SceneActor

    from .road_parts import OpenDriveRoad

_TYPES = {
    "tree": "tree",
    "bush": "vegetation",
    "hedge": "vegetation",
    "building": "building",
    "wall": "barrier",
    "fence": "barrier",
    "barrier": "barrier",
    "guardrail": "railing",
    "lamp": "streetLamp",
    "pole": "pole",
    "sign": "pole",
    "traffic_light": "pole",
    "crosswalk": "crosswalk",
}
_BEYOND = 0.01
"""Meters past the end of its road from which on an object is given by its corners."""
_STEPS = 3
"""Until the nearest point of the road's curve is that of the reference line, a bit away from it."""


def object_type(thing: SceneActor) -> str:
    """What OpenDRIVE and OpenSCENARIO call an object."""
    return _TYPES.get(thing.category, "obstacle")


def objects_by_part(
    things: Sequence[SceneActor], parts: Sequence[OpenDriveRoad]
) -> dict[int, list[tuple[int, SceneActor]]]:
    """Objects with their numbers, by the number of the nearest road."""
    if not things:
        return {}
    where = np.array([(thing.x, thing.y) for thing in things])
    away = np.stack([
        np.hypot(*(part.pose(part.nearest(where))[:, :2] - where).T) for part in parts
    ])  # fmt: skip
    found: dict[int, list[tuple[int, SceneActor]]] = {}
    for number, (thing, nearest) in enumerate(zip(things, away.argmin(axis=0), strict=True), 1):
        found.setdefault(parts[int(nearest)].id, []).append((number, thing))
    return found


def put_objects(
    parent: Element, part: OpenDriveRoad, things: Sequence[tuple[int, SceneActor]]
) -> None:
    """The `objects` of a road."""
    if not things:
        return
    group = put(parent, "objects")
    for number, thing in things:
        s, t, heading, past = _place(part, thing)
        element = put(
            group,
            "object",
            id=number,
            name=thing.name,
            type=object_type(thing),
            s=s,
            t=t,
            zOffset=0.0,
            hdg=thing.heading - heading,
            pitch=0.0,
            roll=0.0,
            orientation="none",
            length=thing.length,
            width=thing.width,
            height=thing.height,
        )
        if abs(past) > _BEYOND or thing.category == "crosswalk":
            _put_corners(element, thing, heading, past)


def _place(part: OpenDriveRoad, thing: SceneActor) -> tuple[float, float, float, float]:
    """Where a thing is beside a road: s, t, the heading of the road, and how far past its end."""
    (s,) = part.line.at(part.nearest(np.array([[thing.x, thing.y]]))).tolist()
    for _ in range(_STEPS):
        x, y, heading = part.line.pose(s)
        dx, dy = thing.x - x, thing.y - y
        past = math.cos(heading) * dx + math.sin(heading) * dy
        s = min(max(s + past, 0.0), part.line.length)
    x, y, heading = part.line.pose(s)
    dx, dy = thing.x - x, thing.y - y
    cos, sin = math.cos(heading), math.sin(heading)
    return s, cos * dy - sin * dx, heading, cos * dx + sin * dy


def _put_corners(element: Element, thing: SceneActor, heading: float, past: float) -> None:
    """The footprint by its corners, as s and t reach no farther than the road."""
    relative = thing.heading - heading
    u, v = past * math.cos(relative), -past * math.sin(relative)
    outline = put(element, "outline", id=0)
    for along, across in ((1, 1), (-1, 1), (-1, -1), (1, -1)):
        put(
            outline,
            "cornerLocal",
            u=u + along * thing.length / 2.0,
            v=v + across * thing.width / 2.0,
            z=0.0,
            height=thing.height,
        )
