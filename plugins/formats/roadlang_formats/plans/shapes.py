"""What a drawing of a file consists of."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from roadlang.geometry import Floats

from ..map_xml import MapElement, MapFile

MOST_COORDINATE = 1e8


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
    along = np.array((math.cos(heading), math.sin(heading))) * (length / 2.0)
    across = np.array((-math.sin(heading), math.cos(heading))) * (width / 2.0)
    corners = [along + across, -along + across, -along - across, along - across]
    return np.array([x, y]) + np.array(corners)


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
