"""Divided roads of photos: where a wide road shows a median, it is two roads side by side.

The network sees one wide surface: a narrow median is no break in it, and its roads would be one
line along the median.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import cv2
import numpy as np
from scipy.ndimage import binary_closing, label, uniform_filter1d

from roadlang.geometry import Booleans, Floats

from .found_network import FoundNetwork, FoundRoad
from .photo_evidence import Seen
from .sampled import sampled
from .smoothing import gradient
from .tones import Image

_WIDE, _WIDEST, _WIDER = 15.0, 29.0, 1.4
"""Widths in pixels from which on, and up to which, a road is examined, if it is so many times as
wide as the usual road: still wider ones are avenues of photos that are finer than 1 m/px."""
_USUAL = 14.0
"""Pixels: where the usual road is wider, the photo is finer, and markings look like medians."""
_CONTRAST = 8.0
"""Of a median, by its mean color (Lab, each channel 0..255), to both carriageways: the distance to
the mean of both, less their distance from each other and their unevenness. Of 44 divided roads
of renderings and photos 17 have more over half of their length, of 80 others 7."""
_EVEN, _GAP = 11, 21
"""Points of the road over which colors are averaged, and across which a median goes on."""
_OFF, _NEAR, _FAR = 0.15, 0.12, 0.32
"""Shares of the width: how far a median may lie off the middle of the road, and where, from the
median, a carriageway begins and ends."""
_SHORTEST, _SHORT, _MOST = 40.0, 25.0, 0.7
"""Pixels that a median is long, or else this long and this share of its road."""
_CROSSING = 12.0
"""Pixels around places where four roads meet: there is no median there."""
_STRIP, _NARROWEST = 0.25, 5
"""Share of the road's width, and pixels, that are cleared of evidence for a median."""


@dataclass(frozen=True)
class _Median:
    """Along a road, at each of its points (n,): contrast, and pixels to the right of the middle."""

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
        width = float(np.median(road.widths))
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
