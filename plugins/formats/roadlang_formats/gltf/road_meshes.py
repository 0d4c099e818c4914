"""The surfaces, markings and curbs of a road."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from roadlang.api import CURB_HEIGHT, PAINT_HEIGHT
from roadlang.geometry import (
    LINE_WIDTH,
    PARKING_LINE_WIDTH,
    DashPattern,
    Floats,
    border_lines,
    parking_lines,
)
from roadlang_standard.lane_looks import LaneLook, lane_look

from ..surfaces.built import is_loop
from ..surfaces.road_surface import RoadSurface
from .materials import lane_material
from .meshes import Faces, strip

_UP = np.array([0.0, 0.0, 1.0])


def lane_parts(surface: RoadSurface) -> Iterator[tuple[int, str, Faces]]:
    """The id, kind and surface of each lane that has any width."""
    for place, lane in enumerate(surface.section.lanes):
        lift = lane_height(surface, place) * _UP
        left, right = surface.borders[place] + lift, surface.borders[place + 1] + lift
        material = lane_material(lane)
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
    """The painted lines along the borders of lanes, and across parking strips; curbs are faces."""
    for mark in border_lines(surface.section.lanes, surface.section.markings):
        if mark.is_curb:
            continue
        height = _paint_height(surface, mark.border, mark.inset)
        line = surface.borders[mark.border] + height * _UP
        left, right = (
            line + np.column_stack(((mark.shift + side) * surface.left, 0.0 * surface.slope))
            for side in (LINE_WIDTH / 2, -LINE_WIDTH / 2)
        )
        if mark.is_broken:
            yield from _dashes(surface, left, right)
        else:
            yield strip("paint", left, right, normals_up(surface))
    for place, lane in enumerate(surface.section.lanes):
        if lane_look(lane) == LaneLook.PARKING:
            yield from _parking_lines(surface, place)


def normals_up(surface: RoadSurface) -> Floats:
    """(n, 3) unit normals of the road."""
    along = np.column_stack((surface.left[:, 1], -surface.left[:, 0]))
    up = np.column_stack((-surface.slope[:, None] * along, np.ones(len(along))))
    return np.asarray(up / np.linalg.norm(up, axis=1)[:, None])


def _parking_lines(surface: RoadSurface, place: int) -> Iterator[Faces | None]:
    """The lines across a strip for parked cars."""
    s = surface.stations
    half = PARKING_LINE_WIDTH / 2
    for station in parking_lines(float(s[0]), float(s[-1])):
        at = np.clip([station - half, station + half], s[0], s[-1])
        left, right = (
            np.column_stack([np.interp(at, s, column) for column in border.T]) + PAINT_HEIGHT * _UP
            for border in surface.borders[place : place + 2]
        )
        yield strip("paint", left, right, np.tile(_UP, (2, 1)))


def _paint_height(surface: RoadSurface, border: int, inset: int) -> float:
    """Of the lane that a line lies on; on a border, of the higher one."""
    left, right = lane_height(surface, border - 1), lane_height(surface, border)
    height = max(left, right) if inset == 0 else left if inset > 0 else right
    return height + PAINT_HEIGHT


def _dashes(surface: RoadSurface, left: Floats, right: Floats) -> Iterator[Faces | None]:
    s = surface.stations
    start, end = float(s[0]), float(s[-1])
    pattern = DashPattern.between(start, end, (0.0, surface.road.length))
    for low, high in pattern.dashes(start, end):
        at = np.concatenate(([low], s[(s > low + 0.01) & (s < high - 0.01)], [high]))
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
