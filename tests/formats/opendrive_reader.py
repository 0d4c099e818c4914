"""A reader of OpenDRIVE that is written from the standard alone: points and lanes of its roads."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any
from xml.etree.ElementTree import Element, fromstring

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
_STEP = 0.001
"""Share of a piece by which it is integrated."""


@dataclass(frozen=True)
class ReadRoad:
    """A road by its element."""

    element: Element

    @property
    def length(self) -> float:
        return number(self.element, "length")

    @property
    def junction(self) -> int:
        return int(self.element.attrib["junction"])

    def pieces(self) -> list[Element]:
        return list(self.element.iterfind("planView/geometry"))

    def pose(self, s: float) -> tuple[float, float, float]:
        """x, y and heading of the reference line."""
        piece = [g for g in self.pieces() if number(g, "s") <= s + 1e-9][-1]
        return pose_of(piece, s - number(piece, "s"))

    def lane_offset(self, s: float) -> float:
        return polynomial(self.element.findall("lanes/laneOffset"), "s", s)

    def lane(self, id: int) -> Element:
        (found,) = (
            lane for lane in self.element.iterfind(".//lane") if lane.attrib["id"] == str(id)
        )
        return found

    def lane_ids(self) -> list[int]:
        return [int(lane.attrib["id"]) for lane in self.element.iterfind(".//lane")]

    def width(self, id: int, s: float) -> float:
        return polynomial(self.lane(id).findall("width"), "sOffset", s)

    def middle(self, id: int, s: float) -> tuple[float, float]:
        """x and y of the middle of a lane."""
        x, y, heading = self.pose(s)
        sign = 1 if id > 0 else -1
        inner = sum(self.width(sign * lane, s) for lane in range(1, abs(id)))
        t = self.lane_offset(s) + sign * (inner + self.width(id, s) / 2)
        return x - t * math.sin(heading), y + t * math.cos(heading)


@dataclass(frozen=True)
class ReadFile:
    """All that a file holds."""

    root: Element
    roads: dict[int, ReadRoad]

    @classmethod
    def of(cls, text: str) -> ReadFile:
        root = fromstring(text)
        roads = {int(road.attrib["id"]): ReadRoad(road) for road in root.iterfind("road")}
        return cls(root, roads)


def pose_of(piece: Element, s: float) -> tuple[float, float, float]:
    """Where a geometry element is, `s` meters after its beginning."""
    x, y, heading = (number(piece, name) for name in ("x", "y", "hdg"))
    shape = piece[0]
    if shape.tag == "paramPoly3":
        assert shape.attrib["pRange"] == "normalized"
        p = s / number(piece, "length")
        u, v = (sum(number(shape, c + a) * p**n for n, c in enumerate("abcd")) for a in "UV")
        du, dv = (
            sum(n * number(shape, c + a) * p ** (n - 1) for n, c in enumerate("abcd") if n)
            for a in "UV"
        )
        cos, sin = math.cos(heading), math.sin(heading)
        return x + cos * u - sin * v, y + sin * u + cos * v, heading + math.atan2(dv, du)
    length = number(piece, "length")
    before, after = {
        "line": lambda: (0.0, 0.0),
        "arc": lambda: (number(shape, "curvature"),) * 2,
        "spiral": lambda: (number(shape, "curvStart"), number(shape, "curvEnd")),
    }[shape.tag]()
    at = (np.arange(0.0, 1.0, _STEP) + _STEP / 2) * s
    angle = heading + before * at + (after - before) / (2 * length) * at**2
    end = heading + before * s + (after - before) / (2 * length) * s**2
    return x + float(np.cos(angle).mean() * s), y + float(np.sin(angle).mean() * s), end


def arc_length(piece: Element, count: int = 501) -> float:
    """How long a geometry element is, by points on it: `count` where it is a cubic."""
    at = np.linspace(
        0.0, number(piece, "length"), {"line": 2, "spiral": 201}.get(piece[0].tag, count)
    )
    points = np.array([pose_of(piece, s)[:2] for s in at])
    return float(np.hypot(*np.diff(points, axis=0).T).sum())


def polynomial(elements: list[Element], start: str, s: float) -> float:
    """The value of the last cubic that has begun at `s`."""
    last = [element for element in elements if number(element, start) <= s + 1e-9][-1]
    ds = s - number(last, start)
    return sum(number(last, name) * ds**n for n, name in enumerate("abcd"))


def number(element: Any, name: str) -> float:
    """An attribute, which has to be finite."""
    value = float(element.attrib[name])
    assert math.isfinite(value), (element.tag, name)
    return value
