"""What a drawing of a file consists of."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from roadlang.geometry import Floats
from roadlang.geometry.areas.footprints import Footprints

from ..map_xml import MapElement, MapFile

MOST_COORDINATE = 1e8
Pose = tuple[float, float, float]
"""x and y in meters, and a heading."""


@dataclass(frozen=True)
class PlanShape:
    """Outlines on the ground, each (n, 2) points in meters, x east and y north, of one color. With
    `width`, lines of that many meters instead."""

    outlines: tuple[Floats, ...]
    color: str
    width: float | None = None
    label: str = ""


def rectangle(x: float, y: float, heading: float, length: float, width: float) -> Floats:
    """(4, 2) corners around a center."""
    return Footprints(*map(np.asarray, (x, y, heading, length, width))).corners


def placed(points: Floats, pose: Pose) -> Floats:
    """(n, 2) points given relative to a pose, in the coordinates that the pose is given in."""
    x, y, heading = pose
    cos, sin = math.cos(heading), math.sin(heading)
    return np.asarray(np.array([x, y]) + points @ np.array([[cos, sin], [-sin, cos]]))


def numbers(file: MapFile, element: MapElement, name: str, default: str | None = None) -> Floats:
    """An attribute that is a list of numbers. Raises RL479."""
    text = file.attribute(element, name, default)
    try:
        found = np.array([float(part) for part in text.replace(",", " ").split()])
    except ValueError:
        found = np.array([math.nan])
    if not (np.abs(found) <= MOST_COORDINATE).all():
        raise file.fault(element, f"`{name}` of `{element.tag}` is not a list of numbers")
    return found


def points(file: MapFile, element: MapElement, name: str, default: str | None = None) -> Floats:
    """(n, 2) points `x,y x,y`, or `x,y,z x,y,z`. Raises RL479."""
    rows = file.attribute(element, name, default).split()
    size = rows[0].count(",") + 1 if rows else 2
    found = numbers(file, element, name, default)
    if size < 2 or len(found) != size * len(rows):
        raise file.fault(element, f"`{name}` of `{element.tag}` is not a list of points")
    return found.reshape(-1, size)[:, :2]


def joined(left: Sequence[Floats] | Floats, right: Sequence[Floats] | Floats) -> Floats:
    """The outline between two borders that run the same way."""
    return np.concatenate((np.asarray(left), np.asarray(right)[::-1]))


def hex_color(components: Sequence[float] | Floats) -> str:
    """`#rrggbb` of red, green and blue from 0 to 1."""
    red, green, blue = np.rint(255.0 * np.clip(components, 0.0, 1.0)).astype(int).tolist()
    return f"#{red:02x}{green:02x}{blue:02x}"
