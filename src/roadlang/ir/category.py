"""The categories of agents and objects: what a kind is in other formats and engines."""

from __future__ import annotations

PEDESTRIAN = "pedestrian"
"""Also among the `users` of lanes"""
ON_FOOT = (PEDESTRIAN, "animal")
VEHICLES = ("car", "van", "truck", "bus", "tractor", "trailer", "motorcycle", "bicycle")
"""An object of one of these is parked."""
AGENTS = (*(name for name in VEHICLES if name != "trailer"), *ON_FOOT)
OBJECTS = (
    *VEHICLES, "tree", "bush", "hedge", "building", "shelter", "wall", "fence", "guardrail",
    "barrier", "cone", "pole", "lamp", "sign", "traffic_light", "water",
    "obstacle", "crosswalk",
)  # fmt: skip
GREENERY = ("tree", "bush")
"""Objects with crowns of leaves: round, from above."""
BUILDING = "building"
"""Objects with a roof."""
PAINTED = ("crosswalk",)
"""Objects that are paint on the road: nothing hits them, stops for them or keeps clear of them."""
ROLES = ("", "taxi", "police", "ambulance", "fire")
"""Of vehicles that others have to know: formats that have no such vehicle go by the category."""


def category_by_size(length: float, width: float, height: float) -> str:
    """The vehicle with sizes like these, in meters: of a kind of agent that states no category."""
    if width <= 1.2:
        return "bicycle" if length <= 2.0 else "motorcycle"
    if height > 2.8:
        return "bus" if length > 10.0 else "truck"
    return "van" if height > 1.95 else "car"
