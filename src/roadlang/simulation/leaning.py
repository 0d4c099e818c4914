"""Long vehicles keep to the inside of bends, so that their fronts do not swing out of their lanes.

A vehicle whose middle follows a circle of curvature `k` covers, with half of its wheelbase `b` and
`f` meters from its rear axle to its front bumper, `(f^2 - b^2) k / 2` more than its width outside
of the circle and `b^2 k / 2` inside, to the first order. Drivers of long vehicles steer so that
the two are equal: their middle is `(f^2 - 2 b^2) k / 4` to the inside of the middle of the lane.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from ..geometry.arrays import Floats
from ..ir.scene_actor import SceneActor
from .bodies import vehicle_parameters
from .lines import LineSource
from .route_lines import LineLeg, RouteLine
from .smoothing import smoothed

LONG = 7.0
"""Meters: shorter vehicles have room enough in their lanes."""
SPACING = 0.5
"""Meters between two points of the line."""
SPARE = 1.2
"""Times its least radius, at least, is that of the bends that a vehicle follows."""


def leaned(line: RouteLine, actor: SceneActor) -> RouteLine:
    """The line that the middle of a vehicle follows where `line` is the middle of its lane. Bends
    that it cannot drive are cut."""
    if actor.length <= LONG:
        return line
    car = vehicle_parameters(actor)
    source, s, gone = leaned_source(
        line.source, actor.length, 0.5 * car.wheelbase, car.max_steering
    )
    return RouteLine(source, tuple(_moved(leg, s, gone) for leg in line.legs))


def leaned_source(
    source: LineSource, length: float, base: float, max_steering: float
) -> tuple[LineSource, Floats, Floats]:
    """The line of the middle of a vehicle, and arc lengths of `source` with those of that line at
    the same places. `base`: half of the wheelbase."""
    front = base + 0.5 * length
    least = SPARE * math.hypot(2.0 * base / math.tan(max_steering), base)
    gain = max(0.0, 0.25 * front * front - 0.5 * base * base)
    s = np.linspace(0.0, source.length, max(2, math.ceil(source.length / SPACING)) + 1)
    x, y, heading = _cut(source, s, least)
    bend = _mean_bend(source, s, heading, length)
    free = np.maximum(1.0 / np.maximum(np.abs(bend), 1e-6) - least, 0.0)
    left = np.sign(bend) * np.minimum(gain * np.abs(bend), free)
    turned = np.arctan2(np.gradient(left, s), np.maximum(1.0 - bend * left, 0.1))
    x, y = x - np.sin(heading) * left, y + np.cos(heading) * left
    width = source.width
    if isinstance(width, np.ndarray):
        width = np.interp(s, source.s, width)
    gone = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(x), np.diff(y)))])
    return LineSource(gone, x, y, heading + turned, width, source.closed), s, gone


def _cut(source: LineSource, s: Floats, least: float) -> tuple[Floats, Floats, Floats]:
    """x, y and heading at arc lengths, with a radius of at least about `least` everywhere."""
    x, y, heading = (np.interp(s, source.s, c) for c in (source.x, source.y, source.heading))
    bend = np.gradient(heading, s)
    tight = s[np.abs(np.convolve(bend, np.full(5, 0.2))[2:-2]) > 1.0 / least]
    if not len(tight):
        return x, y, heading
    reach = math.sqrt(2.0) * least
    even, smooth_x, smooth_y, _ = smoothed(x, y, reach)
    away = np.abs(s[:, None] - tight).min(axis=1)
    share = np.minimum(np.maximum(2.0 - away / reach, 0.0), 1.0)
    share = share * share * (3.0 - 2.0 * share)
    along = even * (s[-1] / even[-1])
    x = x + share * (np.interp(s, along, smooth_x) - x)
    y = y + share * (np.interp(s, along, smooth_y) - y)
    course = np.arctan2(np.gradient(y, s), np.gradient(x, s))
    difference = (course - heading + np.pi) % (2.0 * np.pi) - np.pi
    return x, y, heading + np.where(share > 0.0, difference, 0.0)


def _mean_bend(source: LineSource, s: Floats, heading: Floats, length: float) -> Floats:
    """Curvature, averaged twice over half of a length: over the ground that the vehicle covers."""
    h = 0.25 * length
    fine = np.arange(-2.0 * h, source.length + 2.0 * h + SPACING, SPACING)
    if source.closed:
        laps = np.floor(fine / source.length)
        turn = heading[-1] - heading[0]
        wide = np.interp(fine - laps * source.length, s, heading) + laps * turn
    else:
        wide = np.interp(fine, s, heading)
    area = np.concatenate([[0.0], np.cumsum(0.5 * (wide[1:] + wide[:-1]) * SPACING)])

    def mean(at: Floats) -> Floats:
        return np.asarray((np.interp(at + h, fine, area) - np.interp(at - h, fine, area)) / (2 * h))

    return np.asarray((mean(s + h) - mean(s - h)) / (2.0 * h))


def _moved(leg: LineLeg, s: Floats, gone: Floats) -> LineLeg:
    """A leg by the arc lengths of the new line."""
    begin = float(np.interp(leg.begin, s, gone))
    return replace(leg, begin=begin, along=np.interp(leg.along, s, gone))
