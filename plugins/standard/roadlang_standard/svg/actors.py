"""Agents and objects at their places, turned as they stand, large enough to be seen."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from functools import lru_cache
from typing import TYPE_CHECKING

from roadlang.api import GREENERY

from . import palette, shapes, trees
from .markup import group, title

if TYPE_CHECKING:
    from roadlang.api import Scene, SceneActor

    from .viewport import Viewport

_CARS = ("car", "van", "bus")
_TWO_WHEELERS = ("bicycle", "motorcycle")
SHORTEST_AGENT = 15.0
"""Pixels, of the longer side of its drawing."""
_SMALLEST_OBJECT = 3.0
_COLOR = re.compile(r"#[0-9a-fA-F]{3,8}\Z|[a-z]+\Z")


def objects(scene: Scene, viewport: Viewport) -> str:
    """Everything that does not move; trees last, their crowns over the rest."""
    ordered = sorted(scene.objects, key=lambda actor: actor.category in GREENERY)
    return group(_drawn(ordered, viewport, _SMALLEST_OBJECT), class_="objects")


def agents(scene: Scene, viewport: Viewport) -> str:
    """Everything that moves."""
    return group(_drawn(scene.agents, viewport, SHORTEST_AGENT), class_="agents")


def _drawn(actors: Sequence[SceneActor], viewport: Viewport, least: float) -> list[str]:
    if not actors:
        return []
    places = viewport.place([(actor.x, actor.y) for actor in actors]).tolist()
    scales = [_enlarged(actor, viewport.pixels_per_meter, least) for actor in actors]
    green = [
        (max(actor.length * scale, actor.width * scale), index)
        for index, (actor, scale) in enumerate(zip(actors, scales, strict=True))
        if actor.category in GREENERY
    ]
    crowns = iter(trees.crowns(*zip(*green, strict=True))) if green else iter(())
    return [
        _drawn_at(
            place, actor, next(crowns) if actor.category in GREENERY else _shape(actor, scale)
        )
        for place, actor, scale in zip(places, actors, scales, strict=True)
    ]


def _enlarged(actor: SceneActor, scale: float, least: float) -> float:
    longest = max(actor.length, actor.width, 0.01) * scale
    return scale * max(1.0, least / longest)


def _drawn_at(place: Sequence[float], actor: SceneActor, shape: str) -> str:
    x, y = place
    turn = f"translate({x:.2f} {y:.2f}) rotate({-math.degrees(actor.heading):.2f})"
    return f'<g transform="{turn}">{title(_hint(actor))}{shape}</g>'


def _shape(actor: SceneActor, scale: float) -> str:
    return _shape_of(actor.category, actor.length * scale, actor.width * scale, _color(actor))


@lru_cache(maxsize=1024)
def _shape_of(category: str, length: float, width: float, color: str) -> str:
    return "".join(_parts(category, length, width, color))


def _parts(category: str, length: float, width: float, color: str) -> Sequence[str]:
    if category in _CARS:
        return shapes.car(length, width, color)
    if category == "truck":
        return shapes.truck(length, width, color)
    if category in _TWO_WHEELERS:
        return shapes.bicycle(length, width, color)
    if category == "pedestrian":
        return shapes.pedestrian(length, width, color)
    if category == "building":
        return shapes.building(length, width)
    return shapes.block(length, width, color)


def _plain(kind: str) -> str:
    return kind.rpartition(".")[2]


def _color(actor: SceneActor) -> str:
    color = actor.options.get("color")
    return color if isinstance(color, str) and _COLOR.match(color) else palette.OBJECT


def _hint(actor: SceneActor) -> str:
    place = f" at {actor.start:.1f} m on {actor.road}" if actor.start is not None else ""
    return f"{actor.name}: {_plain(actor.kind)}{place}"
