"""The objects along the roads of an OpenDRIVE map: trees, poles, buildings, barriers, obstacles."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from roadlang.api import FoundObject
from roadlang.geometry import Floats
from roadlang_formats.map_xml import MapElement, MapFile
from roadlang_formats.rectangles import smallest_rectangle

from .built_roads import BuiltRoad

_KINDS: Mapping[str, str] = {
    "tree": "tree",
    "vegetation": "bush",
    "pole": "pole",
    "streetLamp": "lamp",
    "building": "building",
    "barrier": "barrier",
    "railing": "guardrail",
    "soundBarrier": "wall",
    "obstacle": "box",
    "car": "parked_car",
    "van": "parked_van",
    "bus": "parked_bus",
    "bike": "parked_bicycle",
    "motorbike": "parked_motorcycle",
    "trailer": "trailer",
}
"""Kinds of objects by types; all others, such as crosswalks, leave the ground free."""
_NAMED: Mapping[str, Mapping[str, str]] = {
    "barrier": {
        "guard": "guardrail",
        "rail": "guardrail",
        "fence": "fence",
        "wall": "wall",
        "hedge": "hedge",
    },
    "pole": {"lamp": "lamp", "light": "lamp"},
    "obstacle": {"cone": "cone", "bench": "bench", "bin": "bin", "rock": "rock"},
    "vegetation": {"tree": "tree", "hedge": "hedge"},
}
"""How words in the names or subtypes of objects begin or end that say more than their types."""
_WORD = re.compile(r"[A-Z]?[a-z]+|[A-Z]+")
_SIZES: Mapping[str, tuple[float, float]] = {
    "tree": (4.0, 4.0),
    "building": (12.0, 10.0),
    "barrier": (2.0, 0.4),
    "guardrail": (2.0, 0.4),
    "wall": (2.0, 0.3),
    "fence": (2.0, 0.1),
}
"""Length and width where the file says neither."""
_USUAL_SIZE = (0.5, 0.5)
_SMALLEST, _LARGEST = 0.05, 500.0
"""Meters of a side, of a height, and of the distance from the road."""
_OVERHEAD = 3.0
"""Meters above the road from which on an object is out of the way."""
_SAGITTA, _LONGEST_PART = 0.1, 40.0
"""Meters: a barrier that follows its road becomes straight parts, this near to it and this long."""
_MOST = 20_000
"""Objects of a map."""
_HELP = "`read with opendrive { objects: false }` reads the map without its objects"


@dataclass(frozen=True, slots=True)
class _Copy:
    """Where one copy of an object stands, and its size; None: not stated."""

    s: float
    t: float
    length: float | None
    width: float | None
    height: float | None


def objects_of(file: MapFile, roads: Mapping[str, BuiltRoad]) -> tuple[FoundObject, ...]:
    """The objects that vehicles must not touch, in the order of the file. Raises RL479."""
    found: list[FoundObject] = []
    for road in roads.values():
        for element in road.record.element.all("objects", "object"):
            kind = _kind(element)
            if kind is None or file.number(element, "zOffset", 0.0) >= _OVERHEAD:
                continue
            for each in _placed(file, road, element, kind):
                found.append(each)
                if len(found) > _MOST:
                    raise file.fault(element, f"the map has more than {_MOST:,} objects", _HELP)
    return tuple(found)


def _kind(element: MapElement) -> str | None:
    type = element.attributes.get("type", "")
    written = " ".join(element.attributes.get(key, "") for key in ("name", "subtype"))
    words = [word.lower() for word in _WORD.findall(written)]
    for name, kind in _NAMED.get(type, {}).items():
        if any(word.startswith(name) or word.endswith(name) for word in words):
            return kind
    return _KINDS.get(type)


def _placed(
    file: MapFile, road: BuiltRoad, element: MapElement, kind: str
) -> Iterator[FoundObject]:
    repeats = list(element.all("repeat"))
    corners = None if repeats else _corners(file, road, element)
    if corners is not None:
        x, y, length, width, heading = smallest_rectangle(corners)
        sides = max(length, _SMALLEST), max(width, _SMALLEST)
        height = _size(file, element, "height") or _highest(file, _outline(element))
        yield FoundObject(kind, x, y, *sides, heading, height)
        return
    at = _Copy(
        min(max(file.number(element, "s", 0.0), 0.0), road.record.length),
        _across(file, element, "t"),
        _size(file, element, "length"),
        _size(file, element, "width"),
        _size(file, element, "height"),
    )
    radius = _size(file, element, "radius")
    if radius is not None:
        at = replace(at, length=2.0 * radius, width=2.0 * radius)
    heading = file.number(element, "hdg", 0.0)
    for repeat in repeats:
        yield from _repeated(file, road, repeat, at, kind, heading)
    if not repeats:
        yield _standing(road, at, kind, heading)


def _standing(road: BuiltRoad, at: _Copy, kind: str, heading: float) -> FoundObject:
    x, y, along = (float(value) for value in _points(road, np.array([at.s]), np.array([at.t]))[0])
    usual = _SIZES.get(kind, _USUAL_SIZE)
    length, width = at.length or usual[0], at.width or usual[1]
    turned = math.remainder(along + heading, 2.0 * math.pi)
    return FoundObject(kind, x, y, length, width, turned, at.height)


def _repeated(
    file: MapFile, road: BuiltRoad, repeat: MapElement, at: _Copy, kind: str, heading: float
) -> Iterator[FoundObject]:
    """Copies at even distances; with the distance 0, parts that follow the road."""
    start = min(max(file.number(repeat, "s", at.s), 0.0), road.record.length)
    stop = min(start + max(file.number(repeat, "length"), 0.0), road.record.length)
    if file.number(repeat, "zOffsetStart", 0.0) >= _OVERHEAD:
        return
    distance = file.number(repeat, "distance")
    follows = distance <= 0.0
    step = _part(road, start, stop) if follows else max(distance, _SMALLEST)
    count = int((stop - start) / step + 1e-6) + 1
    if count > _MOST:
        raise file.fault(repeat, f"an object is repeated {count:,} times", _HELP)
    s = np.linspace(start, start + step * (count - 1), count)
    share = (s - start) / max(stop - start, step)

    def between(name: str, otherwise: float | None) -> list[float | None]:
        number = _across if name == "t" else _side
        first = number(file, repeat, f"{name}Start", otherwise or 0.0)
        values = first + (number(file, repeat, f"{name}End", first) - first) * share
        return [float(value) if name == "t" or value >= _SMALLEST else None for value in values]

    t = [value or 0.0 for value in between("t", at.t)]
    widths, heights = between("width", at.width), between("height", at.height)
    if follows:
        points = _points(road, s, np.array(t))[:, :2]
        for index, (one, other) in enumerate(pairwise(points)):
            x, y = (one + other) / 2.0
            length, turned = math.dist(one, other), math.atan2(*(other - one)[::-1])
            width = widths[index] or _SIZES.get(kind, _USUAL_SIZE)[1]
            sides = max(length, _SMALLEST), width
            yield FoundObject(kind, float(x), float(y), *sides, float(turned), heights[index])
        return
    lengths = between("length", at.length)
    for place in zip(s.tolist(), t, lengths, widths, heights, strict=True):
        yield _standing(road, _Copy(*place), kind, heading)


def _part(road: BuiltRoad, start: float, stop: float) -> float:
    """The length of even parts of what follows a road, by its sharpest bend."""
    at = road.line.along(np.linspace(start, stop, max(int(stop - start), 2)))
    bend = float(np.abs(road.curve.curvature(at)).max())
    longest = min(math.sqrt(8.0 * _SAGITTA / max(bend, 1e-9)), _LONGEST_PART)
    return max((stop - start) / max(math.ceil((stop - start) / longest), 1), _SMALLEST)


def _outline(element: MapElement) -> list[MapElement]:
    """The corners of the first outline."""
    outline = element.first("outline") or element.first("outlines", "outline")
    return [] if outline is None else outline.children


def _corners(file: MapFile, road: BuiltRoad, element: MapElement) -> Floats | None:
    """(n, 2), or None without an outline."""
    corners = _outline(element)
    on_road = [corner for corner in corners if corner.tag == "cornerRoad"]
    local = [corner for corner in corners if corner.tag == "cornerLocal"]
    if len(on_road) > 2:
        s = np.array([file.number(corner, "s") for corner in on_road])
        t = np.array([_across(file, corner, "t") for corner in on_road])
        return _points(road, s, t)[:, :2]
    if len(local) < 3:
        return None
    at = file.number(element, "s", 0.0), _across(file, element, "t")
    x, y, along = _points(road, np.array([at[0]]), np.array([at[1]]))[0]
    heading = float(along) + file.number(element, "hdg", 0.0)
    cosine, sine = math.cos(heading), math.sin(heading)
    uv = np.array([(_across(file, corner, "u"), _across(file, corner, "v")) for corner in local])
    return np.asarray(np.array([x, y]) + uv @ np.array([[cosine, sine], [-sine, cosine]]))


def _points(road: BuiltRoad, s: Floats, t: Floats) -> Floats:
    """(n, 3): x and y of places beside a road, and its heading there."""
    at = np.clip(road.line.along(s), 0.0, road.curve.length)
    points = road.curve.at(at) + t[:, None] * road.curve.normal(at)
    return np.column_stack((points, road.curve.heading(at)))


def _highest(file: MapFile, corners: Sequence[MapElement]) -> float | None:
    heights = [_size(file, corner, "height") for corner in corners]
    return max((height for height in heights if height is not None), default=None)


def _size(file: MapFile, element: MapElement, name: str) -> float | None:
    """None where it is not stated, or too small."""
    size = _side(file, element, name)
    return size if size >= _SMALLEST else None


def _side(file: MapFile, element: MapElement, name: str, default: float = 0.0) -> float:
    found = file.number(element, name, default)
    if found > _LARGEST:
        reason = f"`{name}` of an object is {found:g} m, and {_LARGEST:g} m is the most"
        raise file.fault(element, reason, _HELP)
    return found


def _across(file: MapFile, element: MapElement, name: str, default: float = 0.0) -> float:
    found = file.number(element, name, default)
    if abs(found) > _LARGEST:
        reason = f"an object is {abs(found):g} m away from its road, and {_LARGEST:g} m is the most"
        raise file.fault(element, reason, _HELP)
    return found
