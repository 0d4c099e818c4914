"""Road surfaces: asphalt and gravel, shoulders, patches, markings, and the cars on them."""

from __future__ import annotations

import cv2
import numpy as np

from training.rendering.frame import Floats, Image, Layer, PlannedRoad, ribbon
from training.rendering.noise import blend, fractal
from training.rendering.setting import Setting


def offset(points: Floats, distance: float) -> Floats:
    """The line moved sideways by `distance`."""
    tangent = np.gradient(points, axis=0)
    tangent /= np.maximum(np.hypot(*tangent.T), 1e-9)[:, None]
    return points + np.c_[-tangent[:, 1], tangent[:, 0]] * distance


def pave(rng: np.random.Generator, setting: Setting, image: Layer, plan: list[PlannedRoad]) -> None:
    """Lay shoulders, surfaces and markings into the picture, in place."""
    frame = setting.frame
    grain = 0.03 * fractal(rng, frame, 15) + 0.02 * fractal(rng, frame, 1.5, 2)
    shoulder = rng.uniform(0.5, 3.0) if rng.random() < 0.6 else 0.0
    curb = np.clip(np.array([0.62, 0.65, 0.67]) * rng.uniform(0.7, 1.25), 0, 1)
    above = rng.random() < 0.5
    ordered = sorted(plan, key=lambda road: ((road.manner == "motorway") == above, road.width))
    if shoulder:
        for road in ordered:
            _lay(
                setting, image, road.points, road.width + 2 * shoulder, curb, rng.uniform(0.15, 0.8)
            )
    for road in ordered:
        _surface(rng, setting, image, road, grain)
    if rng.random() < 0.75:
        for road in ordered:
            if road.manner in ("street", "motorway") and road.width > 5.5:
                _markings(rng, setting, image, road)


def _lay(
    setting: Setting, image: Layer, points: Floats, width: float, color: Floats, cover: float
) -> None:
    frame = setting.frame
    window, alpha = ribbon(frame.pixels(points), frame.length(width), frame.shape)
    blend(image[window], tuple(color), alpha * cover)


def _surface(
    rng: np.random.Generator, setting: Setting, image: Layer, road: PlannedRoad, grain: Layer
) -> None:
    frame = setting.frame
    gray = np.clip(setting.asphalt + rng.normal(0, setting.asphalt_spread), 0.13, 0.85)
    color = gray * rng.normal(1, 0.02, 3)
    if road.width < 5.5 and rng.random() < 0.4:
        color = np.array(setting.palette["soil"]) * rng.uniform(0.8, 1.2)
    window, alpha = ribbon(frame.pixels(road.points), frame.length(road.width), frame.shape)
    texture = (1 + grain[window] / max(0.3, float(gray)))[..., None] * color
    blend(image[window], texture, alpha)
    count = len(road.points)
    for _ in range(rng.poisson(count / 300)):
        start = int(rng.integers(0, max(1, count - 12)))
        part = road.points[start : start + int(rng.integers(6, 90))]
        if len(part) > 2:
            side = rng.choice([0.0, 0.25, -0.25]) * road.width
            width = road.width * (1.0 if side == 0 else 0.5)
            _lay(
                setting,
                image,
                offset(part, side),
                width,
                color * rng.uniform(0.7, 1.2),
                rng.uniform(0.3, 0.9),
            )
    for side in (-0.25, 0.25):
        wear = color * rng.normal(1, 0.06)
        _lay(setting, image, offset(road.points, side * road.width), 1.6, wear, 0.5)


def _markings(rng: np.random.Generator, setting: Setting, image: Layer, road: PlannedRoad) -> None:
    white, yellow = np.array([0.9, 0.92, 0.92]), np.array([0.25, 0.75, 0.9])
    paint = rng.uniform(0.35, 0.95)
    lanes = max(1, round(road.width / 3.6))
    two_way = road.manner == "street"
    if road.width > 7 and rng.random() < 0.6:
        for side in (-1, 1):
            line = offset(road.points, side * (road.width / 2 - 0.4))
            _lay(setting, image, line, 0.25, white, paint)
    if two_way and rng.random() < 0.75:
        center = yellow if rng.random() < 0.6 else white
        _lay(setting, image, road.points, 0.35, center, paint)
    for lane in range(1, lanes):
        side = (lane / lanes - 0.5) * road.width
        if two_way and abs(side) < 0.5:
            continue
        line = offset(road.points, side)
        for start in range(0, len(line) - 2, 6):
            _lay(setting, image, line[start : start + 3], 0.25, white, paint)


def park(rng: np.random.Generator, setting: Setting, image: Image, plan: list[PlannedRoad]) -> None:
    """Put cars on the roads and at the curbs, in place."""
    for road in plan:
        if road.manner == "apron" or len(road.points) < 6:
            continue
        length = 2.0 * len(road.points)
        for _ in range(rng.poisson(setting.cars * length / 100)):
            index = int(rng.integers(1, len(road.points) - 2))
            ahead = road.points[index + 1] - road.points[index - 1]
            side = rng.choice([-1, 1]) * road.width * rng.choice([0.22, 0.4])
            across = np.array([-ahead[1], ahead[0]]) / max(1e-9, float(np.hypot(*ahead)))
            car(
                rng,
                setting,
                image,
                road.points[index] + side * across,
                float(np.arctan2(ahead[1], ahead[0])),
            )


def car(
    rng: np.random.Generator, setting: Setting, image: Image, center: Floats, heading: float
) -> None:
    """One car, with its shadow; lorries now and then."""
    half = np.array([rng.uniform(1.9, 2.5), 0.9]) * (
        rng.uniform(1.4, 3) if rng.random() < 0.06 else 1
    )
    half[1] = min(half[1], 1.3)
    light = rng.choice([0.08, 0.2, 0.5, 0.75, 0.95])
    color = np.clip(
        light * np.array([1, 1, 1]) + (rng.random() < 0.25) * rng.normal(0, 0.2, 3), 0.03, 1
    )
    fall = 1.2 * setting.slant * np.array([np.cos(setting.sun), np.sin(setting.sun)])
    quad(setting, image, center + fall, half, heading, np.array([0.12, 0.12, 0.11]))
    quad(setting, image, center, half, heading, color)
    quad(setting, image, center, half * (0.45, 0.8), heading, color * 0.6)


def quad(
    setting: Setting, image: Image, center: Floats, half: Floats, heading: float, color: Floats
) -> None:
    """A filled, turned rectangle (meters) on the picture, in place."""
    spin = np.array([[np.cos(heading), -np.sin(heading)], [np.sin(heading), np.cos(heading)]])
    corners = center + (np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * half) @ spin.T
    shade = tuple(float(v) for v in np.clip(color, 0, 1) * 255)
    at = np.round(setting.frame.pixels(corners) * 16).astype(np.int32)
    cv2.fillConvexPoly(image, at, shade, cv2.LINE_AA, 4)
