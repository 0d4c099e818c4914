"""The surfaces, markings and curbs of a road."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from roadlang.api import CURB_HEIGHT, PAINT_HEIGHT
from roadlang.geometry import Floats

from ..surfaces.built import is_loop
from ..surfaces.road_surface import RoadSurface
from .materials import lane_material
from .meshes import Faces, strip

_LINE = 0.14
"""Width of a painted line, meters."""
_INSET = 0.25
"""Of a line along the edge of the road, or beside a curb, from there."""
_APART = 0.13
"""Of each line of a double one from the middle."""
_DASH, _PERIOD = 3.0, 9.0
"""Painted meters of a broken line, and from one to the next."""
_UP = np.array([0.0, 0.0, 1.0])


def lane_parts(surface: RoadSurface) -> Iterator[tuple[int, str, Faces]]:
    """The id, kind and surface of each lane that has any width."""
    for place, lane in enumerate(surface.section.lanes):
        lift = lane_height(surface, place) * _UP
        left, right = surface.borders[place] + lift, surface.borders[place + 1] + lift
        material = lane_material(lane.kind, lane.raised)
        part = strip(material, left, right, normals_up(surface), surface.stations)
        if part is not None:
            yield lane.id, lane.kind, part


def lane_height(surface: RoadSurface, place: int) -> float:
    """Of the lane at this place from the left above the roadway, meters; 0 beside the road."""
    lanes = surface.section.lanes
    raised = 0 <= place < len(lanes) and lanes[place].raised
    return CURB_HEIGHT if raised else 0.0


def curb_parts(surface: RoadSurface) -> Iterator[Faces | None]:
    """The upright faces between lanes of different heights, and at the ends of raised lanes."""
    last = len(surface.section.lanes)
    for place in range(last + 1):
        line = surface.borders[place]
        left, right = lane_height(surface, place - 1), lane_height(surface, place)
        low, high = line + min(left, right) * _UP, line + max(left, right) * _UP
        sides = np.column_stack((surface.left, np.zeros(len(line))))
        if left < right:  # seen from the left
            yield strip("curb", low, high, sides)
        elif right < left:
            yield strip("curb", high, low, -sides)
    if not is_loop(surface.road):
        for place in range(last):
            if lane_height(surface, place):
                yield from _ends(surface, place)


def embankment_parts(surface: RoadSurface, ground: float) -> Iterator[Faces | None]:
    """The sides of the road down to the ground, which lies at this height."""
    sides = np.column_stack((surface.left, np.zeros(len(surface.left))))
    for place, outward in ((0, 1.0), (len(surface.section.lanes), -1.0)):
        line = surface.borders[place]
        foot = np.column_stack((line[:, :2], np.full(len(line), ground)))
        left, right = (foot, line) if outward > 0 else (line, foot)
        yield strip("embankment", left, right, outward * sides)


def marking_parts(surface: RoadSurface) -> Iterator[Faces | None]:
    """The painted lines along the borders of lanes."""
    for place, marking in enumerate(surface.section.markings):
        shift, height = _inward(surface, place, marking)
        line = surface.borders[place] + (height + PAINT_HEIGHT) * _UP
        spread = (_APART, -_APART) if marking == "double" else (0.0,)
        for away in spread if marking in ("solid", "broken", "double") else ():
            left, right = (
                line + np.column_stack(((shift + away + side) * surface.left, 0.0 * surface.slope))
                for side in (_LINE / 2, -_LINE / 2)
            )
            if marking == "broken":
                yield from _dashes(surface, left, right)
            else:
                yield strip("paint", left, right, normals_up(surface))


def normals_up(surface: RoadSurface) -> Floats:
    """(n, 3) unit normals of the road."""
    along = np.column_stack((surface.left[:, 1], -surface.left[:, 0]))
    up = np.column_stack((-surface.slope[:, None] * along, np.ones(len(along))))
    return np.asarray(up / np.linalg.norm(up, axis=1)[:, None])


def _inward(surface: RoadSurface, place: int, marking: str) -> tuple[float, float]:
    """How far to the left of its border a line is painted, and how high."""
    left, right = lane_height(surface, place - 1), lane_height(surface, place)
    at_left = place == 0 or left > right
    at_right = place == len(surface.section.lanes) or right > left
    if at_left == at_right or (marking == "broken" and left == right):
        return 0.0, max(left, right)
    return (-_INSET, right) if at_left else (_INSET, left)


def _dashes(surface: RoadSurface, left: Floats, right: Floats) -> Iterator[Faces | None]:
    s = surface.stations
    first = np.ceil(s[0] / _PERIOD) * _PERIOD
    for start in np.arange(first, s[-1] - 0.5, _PERIOD):
        stop = min(start + _DASH, s[-1])
        at = np.concatenate(([start], s[(s > start + 0.01) & (s < stop - 0.01)], [stop]))
        one, other = (
            np.column_stack([np.interp(at, s, column) for column in line.T])
            for line in (left, right)
        )
        slope = np.interp(at, s, surface.slope)
        aside = one - other
        away = aside[:, :2] / np.maximum(np.hypot(aside[:, 0], aside[:, 1]), 1e-9)[:, None]
        up = np.column_stack((-slope * away[:, 1], slope * away[:, 0], np.ones(len(at))))
        yield strip("paint", one, other, up / np.linalg.norm(up, axis=1)[:, None])


def _ends(surface: RoadSurface, place: int) -> Iterator[Faces | None]:
    """The upright faces of a raised lane where the road begins and where it ends."""
    for at, outward in ((0, -1.0), (-1, 1.0)):
        along = outward * np.array([surface.left[at, 1], -surface.left[at, 0], 0.0])
        low = np.stack([surface.borders[place, at], surface.borders[place + 1, at]])
        low = low if at == 0 else low[::-1]
        yield strip("curb", low + CURB_HEIGHT * _UP, low, along)
