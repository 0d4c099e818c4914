"""Drawings with exact truth: circuits as two edge lines, filled roads, masks."""

from __future__ import annotations

import cv2
import numpy as np

from .frame import Floats, Frame, Image, Rendering, TrueRoad, Truth, ribbon
from .layouts.curves import spline
from .layouts.plans import PLANS
from .pavement import offset


def circuit(rng: np.random.Generator, size: int) -> TrueRoad:
    """A closed track that fits a square picture, center line in pixels."""
    count = int(rng.integers(9, 15))
    angles = np.sort(rng.uniform(0, 2 * np.pi, count))
    angles = 0.5 * angles + 0.5 * np.arange(count) * 2 * np.pi / count
    radius = size * rng.uniform(0.22, 0.44, count)
    points = spline(size / 2 + radius[:, None] * np.c_[np.cos(angles), np.sin(angles)], closed=True)
    return TrueRoad(points, size * rng.uniform(0.012, 0.02), True)


def draw_circuit(seed: int, size: int = 800, pen: float = 1.5) -> Rendering:
    """Two thin dark edge lines on white, as circuit plans have them."""
    rng = np.random.default_rng([seed, 101])
    road = circuit(rng, size)
    image = np.full((size, size, 3), 255, np.uint8)
    for side in (-1, 1):
        line = offset(road.points, side * road.width / 2)
        _ink(image, line, pen)
    return Rendering(image, _truth(size, (road,)))


def draw_filled(
    plan: str,
    seed: int,
    size: int = 600,
    ground: tuple[int, int, int] = (255, 255, 255),
    road: tuple[int, int, int] = (60, 60, 60),
) -> Rendering:
    """Roads of a plan (see `PLANS`) filled with one color on another, edges anti-aliased."""
    rng = np.random.default_rng([seed, 102])
    frame = Frame(size, 1.0)
    image = np.full((size, size, 3), ground, np.float32)
    roads = []
    for planned in PLANS[plan](rng, frame.extent):
        points = frame.pixels(planned.points)
        window, cover = ribbon(points, planned.width, frame.shape)
        image[window] += cover[..., None] * (np.array(road, np.float32) - image[window])
        if planned.manner != "apron":
            roads.append(TrueRoad(points, planned.width, planned.closed))
    return Rendering((image + 0.5).astype(np.uint8), _truth(size, tuple(roads)))


def _ink(image: Image, line: Floats, pen: float) -> None:
    window, cover = ribbon(np.vstack([line, line[1:2]]), pen, image.shape[:2])
    patch = image[window].astype(np.float32)
    image[window] = (patch * (1 - cover[..., None]) + 0.5).astype(np.uint8)


def _truth(size: int, roads: tuple[TrueRoad, ...]) -> Truth:
    return Truth((size, size), roads, np.zeros((size, size), bool))


def as_jpeg(image: Image, quality: int) -> Image:
    """The picture after JPEG compression."""
    _, code = cv2.imencode(".jpg", image, [cv2.IMWRITE_JPEG_QUALITY, quality])
    return np.asarray(cv2.imdecode(code, cv2.IMREAD_COLOR), np.uint8)
