"""What CARLA's own parser makes of OpenDRIVE files. Runs with the client's Python, no server.

Question: by file, points in the middles of lanes: `[road, lane, s, x, y]`, meters. Answer: by file,
how far the farthest is from where CARLA has the middle of that lane, and the connecting roads that
its waypoints do not drive from lane to lane.
"""

from __future__ import annotations

import json
import math
import sys
from typing import Any
from xml.etree import ElementTree

import carla

_STEP = 0.5
"""Meters from waypoint to waypoint."""
_BEFORE = 0.1
"""Meters before the end of a lane from which a turn is driven."""
_ALONG = 0.01
"""Meters: CARLA knows no waypoint at the very end of a road."""
Place = tuple[int, int]
"""Numbers of a road and a lane."""


def farthest(carla_map: Any, points: list[list[float]]) -> float:
    """Of points in the middles of lanes, how far the worst is from CARLA's, meters."""
    worst = 0.0
    for road, lane, s, x, y in points:
        found = carla_map.get_waypoint_xodr(int(road), int(lane), max(s - _ALONG, 0.0))
        if found is None:
            return math.inf
        at, yaw = found.transform.location, -math.radians(found.transform.rotation.yaw)
        # CARLA's y points south.
        dx, dy = x - at.x, y + at.y
        along = math.cos(yaw) * dx + math.sin(yaw) * dy
        across = math.cos(yaw) * dy - math.sin(yaw) * dx
        worst = max(worst, math.hypot(across, max(abs(along) - 2.0 * _ALONG, 0.0)))
    return worst


def undrivable(carla_map: Any, root: ElementTree.Element) -> list[str]:
    """The connecting roads that waypoints do not enter from the road before them, or that do not
    lead on to the lane after them."""
    lengths = {road.attrib["id"]: float(road.attrib["length"]) for road in root.iterfind("road")}
    faults = []
    for road in root.iterfind("road"):
        if road.get("junction") == "-1":
            continue
        (source, contact), (target, _) = (
            _linked(road, tag) for tag in ("predecessor", "successor")
        )
        length = lengths[str(source[0])]
        step = min(_BEFORE, length / 2)
        s = step if contact == "start" else length - step
        if not _drives(carla_map, source, s, int(road.attrib["id"]), target):
            faults.append(f"road {road.attrib['id']}, from {source} to {target}")
    return faults


def _linked(road: Any, tag: str) -> tuple[Place, str]:
    """The lane before or after a connecting road, and at which end of its road."""
    end = road.find(f"link/{tag}")
    (lane,) = (lane for lane in road.iterfind(".//lane") if lane.get("id") != "0")
    number = int(lane.find(f"link/{tag}").attrib["id"])
    return (int(end.attrib["elementId"]), number), end.attrib["contactPoint"]


def _drives(carla_map: Any, source: Place, s: float, through: int, target: Place) -> bool:
    """Whether waypoints lead from a place on a lane through a connecting road into a lane."""
    start = carla_map.get_waypoint_xodr(*source, s)
    at = [] if start is None else start.next(_STEP)
    has_entered = False
    while at:
        if any((place.road_id, place.lane_id) == target for place in at):
            return has_entered or any(place.road_id == through for place in start.next(0.15))
        at = [place for place in at if place.road_id == through]
        has_entered = has_entered or bool(at)
        at = [after for place in at for after in place.next(_STEP)]
    return False


def main() -> None:
    """Answer the question on standard input."""
    answer = {}
    for file, points in json.load(sys.stdin).items():
        with open(file, encoding="utf-8") as opened:
            text = opened.read()
        carla_map = carla.Map("map", text)
        root = ElementTree.fromstring(text.encode())
        answer[file] = [farthest(carla_map, points), undrivable(carla_map, root)]
    print(json.dumps(answer))


if __name__ == "__main__":
    main()
