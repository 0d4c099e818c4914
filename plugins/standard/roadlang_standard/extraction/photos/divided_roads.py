"""Divided roads in photos: a wide road with a visible median becomes two roads side by side.

In the network's evidence a narrow median does not interrupt the surface, so the road would become a
single line along the median.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import cv2
import numpy as np
from scipy.ndimage import binary_closing, label, uniform_filter1d

from roadlang.geometry import Booleans, Floats

from ..colors.tones import Image
from ..curves.sampled import sampled
from ..curves.smoothing import gradient
from ..networks.found_network import FoundNetwork, FoundRoad
from .photo_evidence import Seen

_WIDE, _WIDEST, _WIDER = 15.0, 29.0, 1.4
"""A road is examined if its width is from `_WIDE` to `_WIDEST` pixels and at least `_WIDER` times
the usual width of the roads in the photo. Wider ones are avenues in photos finer than 1 m/px."""
_USUAL = 14.0
"""If the usual width of the roads is more than this, in pixels, none is examined: the photo is
finer than 1 m/px, and lane markings look like medians."""
_CONTRAST = 8.0
"""The contrast of a median is more than this. It is the difference in color between the median and
the mean of both carriageways, minus the difference between the carriageways, minus their
unevenness, in Lab with channels from 0 to 255. Of 44 divided roads in renderings and photos, 17
have such a contrast on more than half of their length; of 80 other roads, 7."""
_EVEN, _GAP = 11, 21
"""Colors are averaged over `_EVEN` points along the road, and gaps of fewer than `_GAP` points in a
median are closed."""
_OFF, _NEAR, _FAR = 0.15, 0.12, 0.32
"""In widths of the road: the greatest distance of a median from the middle of the road, and the
distances from the median at which the strip of a carriageway that it is compared with begins and
ends."""
_SHORTEST, _SHORT, _MOST = 40.0, 25.0, 0.7
"""A median is at least `_SHORTEST` pixels long, or longer than `_SHORT` pixels and `_MOST` of its
road."""
_CROSSING = 12.0
"""There is no median within this distance, in pixels, of a junction of four or more roads."""
_STRIP, _NARROWEST = 0.25, 5
"""The evidence is cleared along a median on a strip of `_STRIP` widths of the road, and of at least
`_NARROWEST` pixels."""


@dataclass(frozen=True)
class _Median:
    """At each point (n,) of a road: the contrast of the strip that differs most from both of its
    sides, and how far to the right of the middle it is, pixels."""

    contrast: Floats
    offset: Floats


def with_medians(image: Image, seen: Seen, found: FoundNetwork) -> Seen | None:
    """The evidence without that of the medians of the roads found; None if they have none.

    `image` (h, w, 3) is the picture that was `seen`.
    """
    if not found.roads:
        return None
    usual = float(np.median(np.concatenate([road.widths for road in found.roads])))
    if usual > _USUAL:
        return None
    ends = np.array([(road.start, road.end) for road in found.roads], np.intp)
    crossings = found.nodes[np.bincount(ends.ravel(), minlength=len(found.nodes)) > 3]
    strips = np.zeros(seen.surface.shape, np.uint8)
    for road in found.roads:
        width = road.usual_width
        wide = max(_WIDE, _WIDER * usual) <= width <= _WIDEST
        if wide and len(road.points) > 2:
            across = max(_NARROWEST, round(_STRIP * width))
            for strip in _medians(image, road, width, crossings):
                at = [np.round(strip * 16).astype(np.int32)]
                cv2.polylines(strips, at, False, 1, across, cv2.LINE_8, 4)
    if not strips.any():
        return None
    return Seen(*(np.where(strips > 0, np.float32(0), x) for x in (seen.surface, seen.blend)))


def _medians(image: Image, road: FoundRoad, width: float, crossings: Floats) -> Iterator[Floats]:
    """The middle lines (k, 2) of the medians of a road."""
    points, right = road.points, _right_of(road.points)
    median = _median(_colors(image, points, right, width), width)
    there = _bridged(median.contrast > _CONTRAST)
    for place in crossings:
        there &= np.hypot(*(points - place).T) > _CROSSING
    parts, count = label(there)
    for part in range(1, count + 1):
        chosen = np.flatnonzero(parts == part)
        share = len(chosen) / len(points)
        length = share * road.length
        if length >= _SHORTEST or (length > _SHORT and share > _MOST):
            yield points[chosen] + float(np.median(median.offset[chosen])) * right[chosen]


def _bridged(there: Booleans) -> Booleans:
    """The same (n,) with its shorter gaps filled."""
    closed = binary_closing(np.pad(there, _GAP), np.ones(_GAP, bool))
    return np.asarray(closed[_GAP:-_GAP])


def _right_of(points: Floats) -> Floats:
    """Unit vectors (n, 2) across a line, to the right in the picture, whose y points down."""
    along = gradient(points)
    along /= np.maximum(np.hypot(*along.T), 1e-9)[:, None]
    return np.column_stack([-along[:, 1], along[:, 0]])


def _colors(image: Image, points: Floats, right: Floats, width: float) -> Floats:
    """Lab colors (n, 2 k + 1, 3) across a road, pixel by pixel from left to right, averaged along
    it."""
    reach = int(np.ceil(width / 2))
    at = points[:, None] + np.arange(-reach, reach + 1.0)[:, None] * right[:, None]
    height, wide = image.shape[:2]
    low = np.clip(np.floor(at.min(axis=(0, 1))).astype(int) - 1, 0, (wide - 1, height - 1))
    high = np.clip(np.ceil(at.max(axis=(0, 1))).astype(int) + 2, low + 1, (wide, height))
    part = cv2.cvtColor(image[low[1] : high[1], low[0] : high[0]], cv2.COLOR_BGR2LAB)
    x, y = np.moveaxis((at - low).astype(np.float32), 2, 0)
    layers = (np.ascontiguousarray(part[..., channel], np.float32) for channel in range(3))
    places = np.ascontiguousarray(x), np.ascontiguousarray(y)
    colors = np.stack([sampled(layer, *places) for layer in layers], axis=2)
    return np.asarray(uniform_filter1d(colors.astype(float), _EVEN, axis=0, mode="nearest"))


def _median(colors: Floats, width: float) -> _Median:
    """Where the strip of three pixels lies that differs most from both sides."""
    middle = colors.shape[1] // 2
    near, far = max(2, int(_NEAR * width) + 1), max(4, int(_FAR * width))
    farthest = max(1, int(_OFF * width))
    offsets = np.arange(-farthest, farthest + 1)
    contrasts = np.array(
        [
            _contrast(
                colors[:, middle + offset - 1 : middle + offset + 2],
                colors[:, middle + offset - far : middle + offset - near + 1],
                colors[:, middle + offset + near : middle + offset + far + 1],
            )
            for offset in offsets
        ]
    )
    best = contrasts.argmax(axis=0)
    return _Median(contrasts.max(axis=0), offsets[best].astype(float))


def _contrast(strip: Floats, left: Floats, right: Floats) -> Floats:
    """How much a strip (n, k, 3) differs from both sides of it, (n,)."""
    sides = left.mean(axis=1), right.mean(axis=1)
    uneven = sum(np.sqrt(side.var(axis=1).sum(axis=1)) for side in (left, right)) / 2
    apart = np.linalg.norm(strip.mean(axis=1) - (sides[0] + sides[1]) / 2, axis=1)
    return np.asarray(apart - np.linalg.norm(sides[0] - sides[1], axis=1) - uneven)
