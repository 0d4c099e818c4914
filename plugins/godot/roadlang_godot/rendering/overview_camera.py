"""Where a camera stands that sees all of a scene."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from roadlang.geometry import Floats

from ..net.protocol import Message
from ..net.scene_part import ScenePart

FIELD = math.radians(60)
"""Vertical field of view of the free camera."""
_PITCHES = {-26: 1.0, -32: 0.95, -38: 0.88}
"""Degrees, and how much each is liked: the flatter, the more of the sky is seen."""
_YAWS = (45, 135, 65, 115)
"""Degrees: from the south, where the sun is, so that what the camera sees is lit."""
_ROOM_ABOVE, _ROOM_BELOW, _ROOM_ASIDE = 0.8, 0.9, 0.93
_MARGIN_SHARE, _LEAST_MARGIN = 0.03, 5.0
_NEAR_ROADS = 40.0
"""Meters from the roads up to which objects are in the frame."""
_LEAST_HEIGHT = 12.0


@dataclass(frozen=True, slots=True)
class TopFrame:
    """A view from above: its middle, east and north of the origin, and meters from its upper to its
    lower edge."""

    x: float
    y: float
    size: float


@dataclass(frozen=True, slots=True)
class FreePose:
    """A camera: meters from the origin, radians counter-clockwise from east and upward."""

    x: float
    y: float
    z: float
    yaw: float
    pitch: float


def built_places(parts: Iterable[ScenePart]) -> Floats:
    """(n, 2) places east and north of the origin that a picture should show: the corners of roads,
    and of objects near them."""
    roads, objects = [np.zeros((0, 3))], [np.zeros((0, 4, 2))]
    for part in parts:
        if part.kind == Message.SEGMENT:
            roads.append(np.frombuffer(part.content, dtype="<f4").reshape(-1, 3))
        elif part.kind == Message.PATCH:
            corners = int.from_bytes(part.body[:2], "little")
            roads.append(np.frombuffer(part.body, "<f4", 3 * corners, 4).reshape(-1, 3))
        elif part.kind == Message.TILES:
            roads.append(_cells(part))
        elif part.kind == Message.OBJECTS:
            objects.append(_outlines(part))
    places = np.concatenate(roads)[:, [0, 2]] * (1.0, -1.0)
    beside = np.concatenate(objects)
    if not len(places):
        return beside.reshape(-1, 2) if len(beside) else np.zeros((1, 2))
    low, high = places.min(axis=0) - _NEAR_ROADS, places.max(axis=0) + _NEAR_ROADS
    middles = beside.mean(axis=1)
    near = ((middles >= low) & (middles <= high)).all(axis=1)
    return np.concatenate([places, beside[near].reshape(-1, 2)])


def top_frame(places: Floats, aspect: float) -> TopFrame:
    """The narrowest view from above, with a margin, of (n, 2) places; `aspect`: width by height."""
    low, high = places.min(axis=0), places.max(axis=0)
    across, along = high - low
    size = max(along, across / aspect)
    size += 2.0 * max(_LEAST_MARGIN, _MARGIN_SHARE * size)
    middle = 0.5 * (low + high)
    return TopFrame(float(middle[0]), float(middle[1]), float(size))


def free_pose(places: Floats, aspect: float) -> FreePose:
    """The camera that sees (n, 2) places, in the direction in which they fill the picture best."""
    best, most = None, -1.0
    for pitch, liked in _PITCHES.items():
        for yaw in _YAWS:
            axes = _axes(math.radians(yaw), math.radians(pitch))
            place = _nearest(places, axes, aspect)
            share = liked * _filled(places, axes, place)
            if share > most:
                pose = (*map(float, place), math.radians(yaw), math.radians(pitch))
                best, most = FreePose(*pose), share
    assert best is not None
    return best


def _axes(yaw: float, pitch: float) -> Floats:
    """(3, 3): where right, up and ahead of a camera point to."""
    ahead = np.array([math.cos(yaw) * math.cos(pitch), math.sin(yaw) * math.cos(pitch),
                      math.sin(pitch)])  # fmt: skip
    right = np.array([math.sin(yaw), -math.cos(yaw), 0.0])
    return np.stack([right, np.cross(right, ahead), ahead])


def _nearest(places: Floats, axes: Floats, aspect: float) -> Floats:
    """The place of the nearest camera in this direction.

    In its own axes, each border of the picture leaves a half-space in which it may stand; the
    farthest forward of all such places is taken.
    """
    a, b, c = axes[:, :2] @ places.T
    tall = math.tan(0.5 * FIELD)
    wide, above, below = _ROOM_ASIDE * tall * aspect, _ROOM_ABOVE * tall, _ROOM_BELOW * tall
    left_most, right_most = (a + wide * c).min(), (a - wide * c).max()
    lowest, highest = (b + below * c).min(), (b - above * c).max()
    forward = min((left_most - right_most) / (2.0 * wide), (lowest - highest) / (above + below))
    aside = 0.5 * (left_most + right_most)
    upward = 0.5 * (highest + above * forward + lowest - below * forward)
    place = np.array([aside, upward, forward]) @ axes
    if place[2] < _LEAST_HEIGHT:
        place += (_LEAST_HEIGHT - place[2]) / axes[2, 2] * axes[2]
    return np.asarray(place)


def _filled(places: Floats, axes: Floats, place: Floats) -> float:
    """The area in the picture of the rectangle around all places, less where some are much nearer
    than others."""
    points = np.column_stack([places, np.zeros(len(places))]) - place
    a, b, c = axes @ points.T
    return float(np.ptp(a / c) * np.ptp(b / c) * c.min() / c.max())


def _outlines(part: ScenePart) -> Floats:
    """(n, 4, 2) corners of the objects of a thing, east and north of the origin."""
    count = len(part.content) // 12
    rows = np.frombuffer(part.body[len(part.body) - 28 * count :], "<f4").reshape(-1, 7)
    x, _, z, heading, length, _, width = rows.astype(float).T[:, :, None]
    along = 0.5 * length * (1.0, 1.0, -1.0, -1.0)
    across = 0.5 * width * (1.0, -1.0, -1.0, 1.0)
    turn_x, turn_y = np.cos(heading), np.sin(heading)
    east, north = along * turn_x - across * turn_y, along * turn_y + across * turn_x
    return np.stack([x + east, north - z], axis=-1)


def _cells(part: ScenePart) -> Floats:
    """Opposite corners of the tiles of a thing."""
    cell, x, z = np.frombuffer(part.body, "<f4", 3)
    rows = np.frombuffer(part.body[14:], np.dtype([("x", "<i2"), ("z", "<i2"), ("mask", "u1")]))
    corners = np.zeros((2 * len(rows), 3))
    for i in (0, 1):
        corners[i::2, 0] = (rows["x"] + i) * cell + x
        corners[i::2, 2] = (rows["z"] + i) * cell + z
    return corners
