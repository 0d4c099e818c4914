"""The `lanelet` elements of CommonRoad."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING
from xml.etree.ElementTree import Element

from roadlang_formats.lanelets.model import Lanelet, LaneletMap, Side

from .elements import put, put_point, put_references

if TYPE_CHECKING:
    from .road_rules import RoadRules

_TYPES = {
    "drive": "urban",
    "bus": "busLane",
    "bike": "bicycleLane",
    "sidewalk": "sidewalk",
    "shoulder": "shoulder",
    "parking": "parking",
}
_LEFT_OUT = ("median", "grass")
_MARKINGS = {
    "solid": "solid",
    "broken": "dashed",
    "double": "solid_solid",
    "none": "no_marking",
    "curb": "curb",
}
_USERS = {"car": "vehicle", "bus": "bus", "bicycle": "bicycle", "pedestrian": "pedestrian"}


def written_lanelets(lanelets: LaneletMap) -> tuple[int, ...]:
    """The numbers of those that are for somebody."""
    return tuple(
        number for number, lanelet in enumerate(lanelets.lanelets) if lanelet.kind not in _LEFT_OUT
    )


def put_lanelets(
    root: Element, lanelets: LaneletMap, ids: Mapping[int, int], rules: RoadRules
) -> None:
    """All that have ids."""
    before: dict[int, list[int]] = {}
    after: dict[int, list[int]] = {}
    for source, target in lanelets.links:
        if source in ids and target in ids:
            after.setdefault(source, []).append(ids[target])
            before.setdefault(target, []).append(ids[source])
    for number, id in ids.items():
        lanelet = lanelets.lanelets[number]
        found = put(root, "lanelet", id=id)
        _put_bound(found, "leftBound", lanelets, lanelet.left)
        _put_bound(found, "rightBound", lanelets, lanelet.right)
        put_references(found, "predecessor", before.get(number, ()))
        put_references(found, "successor", after.get(number, ()))
        _put_neighbor(found, "adjacentLeft", lanelet.beside_left, ids)
        _put_neighbor(found, "adjacentRight", lanelet.beside_right, ids)
        rules.put_stop_line(found, number)
        _put_types(found, lanelet)
        put_references(found, "trafficSignRef", rules.signs_of(number))
        put_references(found, "trafficLightRef", rules.lights_of(number))


def _put_bound(parent: Element, tag: str, lanelets: LaneletMap, side: Side) -> None:
    bound = put(parent, tag)
    for x, y, _ in lanelets.line(side):
        put_point(bound, x, y)
    put(bound, "lineMarking", _MARKINGS[lanelets.borders[side.border].marking])


def _put_neighbor(
    parent: Element, tag: str, beside: tuple[int, bool] | None, ids: Mapping[int, int]
) -> None:
    if beside is not None and beside[0] in ids:
        put(parent, tag, ref=ids[beside[0]], drivingDir="same" if beside[1] else "opposite")


def _put_types(parent: Element, lanelet: Lanelet) -> None:
    put(parent, "laneletType", _TYPES.get(lanelet.kind, "urban" if lanelet.drivable else "unknown"))
    if lanelet.turn:
        put(parent, "laneletType", "intersection")
    users = [_USERS[user] for user in lanelet.users if user in _USERS]
    if not users and lanelet.drivable:
        users = ["vehicle"]
    tag = "userBidirectional" if lanelet.both_ways else "userOneWay"
    for user in users:
        put(parent, tag, user)
