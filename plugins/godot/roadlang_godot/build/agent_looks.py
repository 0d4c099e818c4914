"""What agents and objects look like: a category and a color of its own for each agent."""

from __future__ import annotations

import colorsys
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from roadlang_standard import kinds_of
from roadlang_standard.engine_tables import BODIES

from .names import plain_name

if TYPE_CHECKING:
    from roadlang.api import SceneActor

EGO = "ego"
EGO_COLOR = "#d81f26"
_COLORS = (
    "#2f6fb7", "#e4e6e8", "#3d8f5f", "#2b2e33", "#e0a526", "#8fa3b0",
    "#7a4fa0", "#1d9a9a", "#b5651d", "#5b7c2c", "#d9c7a3", "#3b4a8c",
)  # fmt: skip
"""Of agents that have none: muted, and none like that of `ego`."""
_GOLDEN = 0.618033988749895
_ROLE_SHAPES = {
    "taxi": "taxi", "police": "police_car", "ambulance": "ambulance", "fire": "fire_truck",
}  # fmt: skip
_UNIFORM = {"taxi", "police_car", "ambulance", "fire_truck", "tractor", "animal", "dog"}
"""Told by their colors: they keep them."""
_VARIED = {"tree", "building", "parked_car", "parked_van", "parked_truck", "parked_bus"}
"""Objects that the engine gives several colors, where a scene chooses none."""
_DEFAULT_COLORS: Mapping[str, str] = {
    kind.name: kind.color
    for kind in kinds_of("agent", "object")
    if isinstance(getattr(kind, "color", None), str)
}


def look_of(actor: SceneActor, number: int) -> dict[str, Any]:
    """`category`, `color` and `marked` of an agent; `number` is that of the engine, from 1."""
    category = category_of(actor)
    chosen = actor.options.get("color")
    color = chosen if isinstance(chosen, str) else ""
    is_default = not color or color == _DEFAULT_COLORS.get(plain_name(actor.kind))
    marked = actor.name == EGO
    if is_default and category not in _UNIFORM:
        color = EGO_COLOR if marked else color_of(number)
    return {"category": category, "color": color or EGO_COLOR, "marked": marked}


def object_color(actor: SceneActor) -> str:
    """The color of an object, in hexadecimal or by name; empty where the engine chooses."""
    color, sort = actor.options.get("color", ""), plain_name(actor.kind)
    is_default = sort in _VARIED and color == _DEFAULT_COLORS.get(sort)
    return "" if is_default or not isinstance(color, str) else color


def color_of(number: int) -> str:
    """The color of the agent with a number, in hexadecimal: no two numbers have the same."""
    place = number - 1
    if place < len(_COLORS):
        return _COLORS[place]
    turn = place - len(_COLORS)
    hue = 0.08 + 0.84 * (turn * _GOLDEN % 1.0)
    value, saturation = 0.45 + 0.13 * (turn % 4), 0.35 + 0.1 * (turn % 5)
    red, green, blue = colorsys.hsv_to_rgb(hue, saturation, value)
    return f"#{round(255 * red):02x}{round(255 * green):02x}{round(255 * blue):02x}"


def category_of(actor: SceneActor) -> str:
    """Which of the shapes in `godot_backend/shapes` an agent has: that of its kind, else of its
    role, else of its category."""
    name = plain_name(actor.kind)
    if name in BODIES:
        return name
    return _ROLE_SHAPES.get(actor.role) or actor.category
