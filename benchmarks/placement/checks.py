"""What is wrong with the placement in a scene, by its JSON alone and with shapely alone."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Mapping
from typing import Any

from shapely import LineString, Point, Polygon, STRtree
from shapely.affinity import rotate, translate

DEFAULT_APART = 0.5
ROUNDING = 1e-3
"""Meters"""


def faults(scene: Mapping[str, Any]) -> list[str]:
    """Things nearer to each other than they are to be, and agents off their lanes."""
    return [*_too_near(scene), *_off_lane(scene)]


def footprint(thing: Mapping[str, Any]) -> Polygon:
    """The rectangle that an agent or object covers."""
    a, b = thing["length"] / 2, thing["width"] / 2
    box = Polygon([(-a, -b), (a, -b), (a, b), (-a, b)])
    turned = rotate(box, thing["heading"], origin=(0, 0), use_radians=True)
    return translate(turned, thing["x"], thing["y"])


def _too_near(scene: Mapping[str, Any]) -> Iterator[str]:
    things = [*scene["agents"], *scene["objects"]]
    shapes = [footprint(thing) for thing in things]
    tree = STRtree(shapes)
    for first, shape in enumerate(shapes):
        for second in tree.query(shape.buffer(DEFAULT_APART)).tolist():
            if second > first:
                gap = shape.distance(shapes[second])
                if gap < DEFAULT_APART - ROUNDING:
                    names = things[first]["name"], things[second]["name"]
                    yield f"{names[0]} and {names[1]} are {gap:.3f} m apart"


def _off_lane(scene: Mapping[str, Any]) -> Iterator[str]:
    """Middles of agents that are not amid their lane, or do not point along it."""
    roads = {road["name"]: road for road in scene["roads"]}
    for agent in scene["agents"]:
        if agent["lane"] is None:
            yield f"{agent['name']} is in no lane"
            continue
        road = roads[agent["road"]]
        line = LineString(zip(road["x"], road["y"], strict=True))
        station = line.project(Point(agent["x"], agent["y"]))
        share = station / line.length
        before, after = (line.interpolate(station + off) for off in (-0.5, 0.5))
        heading = math.atan2(after.y - before.y, after.x - before.x)
        foot = line.interpolate(station)
        left = math.cos(heading) * (agent["y"] - foot.y) - math.sin(heading) * (agent["x"] - foot.x)
        low, high = _borders(road, agent["lane"], share)
        if not low + agent["width"] / 2 - 0.3 <= left <= high - agent["width"] / 2 + 0.3:
            yield f"{agent['name']} is {left:.2f} m left of its road, lane {low:.2f} to {high:.2f}"
        off = math.remainder(agent["heading"] - heading, math.pi)
        if abs(off) > 0.05:
            yield f"{agent['name']} stands {math.degrees(off):.0f} degrees across its lane"
        if not (agent["length"] / 2 - 0.05 <= station <= line.length - agent["length"] / 2 + 0.05):
            yield f"{agent['name']} stands over an end of its road"


def _borders(road: Mapping[str, Any], lane: int, share: float) -> tuple[float, float]:
    """Offsets of the two sides of a lane from the line, low and high. The line runs amid the
    drivable lanes."""
    widths = {one["id"]: _at(one["width"], share) for one in road["lane_list"]}
    ids = [one["id"] for one in road["lane_list"]]
    drivable = [one["id"] for one in road["lane_list"] if one["drivable"]]
    across = ids[ids.index(drivable[0]) : ids.index(drivable[-1]) + 1]
    high = sum(widths[id] for id in across) / 2
    high += sum(widths[id] for id in itertools.takewhile(lambda id: id != across[0], ids))
    for id in ids:
        if id == lane:
            return high - widths[id], high
        high -= widths[id]
    raise KeyError(lane)


def _at(width: list[float], share: float) -> float:
    place = share * (len(width) - 1)
    low = min(int(place), len(width) - 1)
    high = min(low + 1, len(width) - 1)
    return width[low] + (width[high] - width[low]) * (place - low)
