"""Random drawings of roads, as one draws them in a paint program: white on black, 0.5 m a pixel."""

from __future__ import annotations

import math
from random import Random

import cv2
import numpy as np
from numpy.typing import NDArray

Picture = NDArray[np.uint8]
SCALE = 0.5
"""Meters for each pixel."""
WHITE = (255, 255, 255)
CLOSEST = math.radians(28.0)
"""Angle between two arms, at least."""


def star(draw: Random, width: float) -> Picture:
    """Three to six arms at random angles."""
    picture = _empty(260.0)
    headings = _headings(draw, draw.randint(3, 6))
    for heading in headings:
        _road(picture, _polar(0.0, heading), _polar(draw.uniform(80.0, 120.0), heading), width)
    return picture


def roundabout(draw: Random, width: float) -> Picture:
    """Three to five arms that meet at a ring."""
    picture = _empty(280.0)
    radius = draw.uniform(16.0 + 0.5 * width, 34.0)
    count = draw.randint(3, 5)
    turn = draw.uniform(0.0, 2.0 * math.pi)
    for number in range(count):
        heading = turn + (number + draw.uniform(-0.15, 0.15)) * 2.0 * math.pi / count
        _road(picture, _polar(radius, heading), _polar(draw.uniform(90.0, 125.0), heading), width)
    cv2.circle(picture, (280, 280), round(radius / SCALE), WHITE, round(width / SCALE))
    return picture


def ramp(draw: Random, width: float) -> Picture:
    """A road that joins another at a small angle."""
    picture = _empty(280.0)
    main = draw.uniform(0.0, math.pi)
    for side in (main, main + math.pi):
        _road(picture, (0.0, 0.0), _polar(130.0, side), width)
    heading = main + math.radians(draw.uniform(32.0, 45.0)) * draw.choice((-1.0, 1.0))
    _road(picture, (0.0, 0.0), _polar(draw.uniform(80.0, 125.0), heading), width)
    return picture


def close_pair(draw: Random, width: float) -> Picture:
    """Two junctions, 10 to 60 m apart."""
    picture = _empty(300.0)
    half = 0.5 * draw.uniform(10.0, 60.0)
    for side in (-1.0, 1.0):
        _road(picture, (0.0, 0.0), (side * 140.0, draw.uniform(-30.0, 30.0)), width)
        for up in draw.choice(((1.0,), (-1.0,), (1.0, -1.0))):
            end = side * half + draw.uniform(-30.0, 30.0), up * draw.uniform(80.0, 120.0)
            _road(picture, (side * half, 0.0), end, width)
    return picture


def winding(draw: Random, width: float) -> Picture:
    """Two roads that wind and cross."""
    picture = _empty(300.0)
    for across in (False, True):
        swing, wave = draw.uniform(5.0, 16.0), draw.uniform(80.0, 160.0)
        phase = draw.uniform(0.0, 6.0)
        s = np.arange(-140.0, 141.0, 2.0)
        left = swing * np.sin(2.0 * math.pi * s / wave + phase)
        x, y = (left, s) if across else (s, left)
        points = np.stack([x / SCALE + 300.0, 300.0 - y / SCALE], axis=1).round().astype(np.int32)
        cv2.polylines(picture, [points], False, WHITE, round(width / SCALE))
    return picture


DRAWINGS = {one.__name__: one for one in (star, roundabout, ramp, close_pair, winding)}


def _headings(draw: Random, count: int) -> list[float]:
    """Of arms, none too close to the next."""
    while True:
        found = sorted(draw.uniform(0.0, 2.0 * math.pi) for _ in range(count))
        gaps = [b - a for a, b in zip(found, [*found[1:], found[0] + 2.0 * math.pi], strict=True)]
        if min(gaps) > CLOSEST:
            return found


def _empty(size: float) -> Picture:
    """A square of so many meters; its middle is (0, 0)."""
    return np.zeros((round(size / SCALE), round(size / SCALE), 3), np.uint8)


def _polar(distance: float, heading: float) -> tuple[float, float]:
    return distance * math.cos(heading), distance * math.sin(heading)


def _road(
    picture: Picture, start: tuple[float, float], end: tuple[float, float], width: float
) -> None:
    middle = picture.shape[0] / 2.0
    ends = [(round(x / SCALE + middle), round(middle - y / SCALE)) for x, y in (start, end)]
    cv2.line(picture, ends[0], ends[1], WHITE, round(width / SCALE))
