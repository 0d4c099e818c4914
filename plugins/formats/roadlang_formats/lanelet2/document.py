"""A scene as the text of a Lanelet2 map."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING
from xml.etree.ElementTree import indent, tostring

from roadlang.geometry.earth.local_projection import LocalProjection
from roadlang_formats.lanelets.model import Lanelet, LaneletMap
from roadlang_formats.lanelets.network import lanelet_map
from roadlang_formats.place_on_earth import map_origin
from roadlang_formats.speed_units import in_kmh

from .primitives import Primitives, Tags
from .regulatory_elements import RegulatoryElements

if TYPE_CHECKING:
    from roadlang.api import Scene

TOLERANCE = 0.01
"""Meters by which borders may be off."""
_SUBTYPES = {
    "drive": "road",
    "bus": "bus_lane",
    "bike": "bicycle_lane",
    "sidewalk": "walkway",
    "shoulder": "emergency_lane",
}
_LINES: dict[str, Tags] = {
    "solid": {"type": "line_thin", "subtype": "solid"},
    "broken": {"type": "line_thin", "subtype": "dashed"},
    "double": {"type": "line_thin", "subtype": "solid_solid"},
    "none": {"type": "virtual"},
    "curb": {"type": "curbstone", "subtype": "high"},
}
_TURNS = {"left": "left", "straight": "straight", "right": "right", "u": "left"}


def document(scene: Scene, origin: tuple[float, float] | None) -> str:
    """The map of a scene, whose (0, 0) is at `origin`: latitude and longitude, degrees."""
    at = origin or map_origin(scene) or (0.0, 0.0)
    lanelets = lanelet_map(scene, TOLERANCE)
    left_hand = scene.world.get("traffic") == "left"
    ids = written_lanelets(lanelets)
    primitives = Primitives(LocalProjection(*at), reserved=len(ids))
    rules = RegulatoryElements(primitives, lanelets, ids)
    rules.add_limits()
    for junction in lanelets.junctions:
        rules.add_junction(junction)
    _add_lanelets(primitives, lanelets, ids, rules, left_hand)
    rules.write()
    root = primitives.root()
    indent(root, " ")
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + tostring(root, encoding="unicode") + "\n"


def written_lanelets(lanelets: LaneletMap) -> dict[int, int]:
    """The ids of those that somebody moves on, by their numbers: 1, 2, ..."""
    written = [number for number, item in enumerate(lanelets.lanelets) if _subtype(item)]
    return {number: id for id, number in enumerate(written, 1)}


def _subtype(lanelet: Lanelet) -> str | None:
    """None for what nobody moves on."""
    return _SUBTYPES.get(lanelet.kind, "road" if lanelet.drivable else None)


def _add_lanelets(
    primitives: Primitives,
    lanelets: LaneletMap,
    ids: dict[int, int],
    rules: RegulatoryElements,
    left_hand: bool,
) -> None:
    ways: dict[int, int] = {}
    for number, id in ids.items():
        lanelet = lanelets.lanelets[number]
        for side in (lanelet.left, lanelet.right):
            if side.border not in ways:
                border = lanelets.borders[side.border]
                ways[side.border] = primitives.way(border.points, _LINES[border.marking])
        members = [
            ("way", "left", ways[lanelet.left.border]),
            ("way", "right", ways[lanelet.right.border]),
            *(("relation", "regulatory_element", rule) for rule in rules.of(number)),
        ]
        primitives.relation(members, _tags(lanelet, left_hand), id)


def _tags(lanelet: Lanelet, left_hand: bool) -> dict[str, str]:
    found = {
        "type": "lanelet",
        "subtype": str(_subtype(lanelet)),
        "location": "urban",
        "region": "de" if not left_hand else "gb",
        "one_way": "no" if lanelet.both_ways else "yes",
    }
    if lanelet.drivable:
        found["participant:vehicle" if "car" in lanelet.users or not lanelet.users else
              "participant:vehicle:bus"] = "yes"  # fmt: skip
    limit = lanelet.speed_limit
    if limit is not None and math.isfinite(limit):
        found["speed_limit"] = f"{in_kmh(limit)} km/h"
    if lanelet.turn:
        found["turn_direction"] = _TURNS[lanelet.turn]
    if lanelet.road:
        found |= {"road": lanelet.road, "lane": str(lanelet.lane)}
    return found
