"""Smooth lines for plans: splines through control points, at even steps."""

from __future__ import annotations

import numpy as np
from scipy.interpolate import CubicSpline

from training.rendering.frame import Floats

STEP = 2.0


def even(points: Floats, step: float = STEP) -> Floats:
    """The same polyline (n, 2) with points every `step` meters."""
    points = np.asarray(points, float)
    lengths = np.hypot(*np.diff(points, axis=0).T)
    station = np.r_[0, np.cumsum(lengths)]
    at = np.linspace(0, station[-1], max(2, round(float(station[-1]) / step) + 1))
    return np.c_[np.interp(at, station, points[:, 0]), np.interp(at, station, points[:, 1])]


def spline(points: Floats, closed: bool = False) -> Floats:
    """A smooth line through control points (n, 2), at even steps."""
    points = np.asarray(points, float)
    if closed:
        points = np.vstack([points, points[:1]])
    chord = np.maximum(np.hypot(*np.diff(points, axis=0).T), 1e-6)
    station = np.r_[0, np.cumsum(chord)]
    curve = CubicSpline(station, points, bc_type="periodic" if closed else "natural")
    return even(curve(np.linspace(0, station[-1], max(8, int(station[-1])))))


def arc(center: Floats, radius: float, start: float, sweep: float) -> Floats:
    """A circular arc (angles in radians)."""
    count = max(8, int(abs(sweep) * radius / STEP) + 1)
    angle = start + np.linspace(0, sweep, count)
    return np.asarray(center) + radius * np.c_[np.cos(angle), np.sin(angle)]


def wander(
    rng: np.random.Generator, start: Floats, heading: float, length: float, bend: float
) -> Floats:
    """A road whose curvature wanders with deviation `bend` (1/m)."""
    count = max(4, int(length / STEP))
    knots = rng.normal(0, bend, int(length / 60) + 3)
    curvature = np.interp(np.arange(count) * STEP, np.arange(len(knots)) * 60, knots)
    headings = heading + np.cumsum(curvature) * STEP
    steps = STEP * np.c_[np.cos(headings), np.sin(headings)]
    return np.vstack([start, np.asarray(start) + np.cumsum(steps, axis=0)])


def crossing(rng: np.random.Generator, extent: float, bend: float, margin: float = 30.0) -> Floats:
    """A wandering road that passes near the middle and leaves the frame at both ends."""
    middle = rng.uniform(0.2, 0.8, 2) * extent
    heading = rng.uniform(0, 2 * np.pi)
    forth = wander(rng, middle, heading, 1.5 * extent, bend)
    back = wander(rng, middle, heading + np.pi, 1.5 * extent, bend)
    return np.vstack(
        [until_outside(back, extent, margin)[::-1][:-1], until_outside(forth, extent, margin)]
    )


def until_outside(points: Floats, extent: float, margin: float) -> Floats:
    """The line up to where it first leaves the frame by `margin` meters."""
    outside = ((points < -margin) | (points > extent + margin)).any(axis=1)
    return points[: int(np.argmax(outside)) + 1] if outside.any() else points
