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

from ...geometry.arrays import Floats
from ...geometry.curves.bend_room import LONG
from ...ir.scene_actor import SceneActor
from ..lines.line_sources import LineSource
from ..lines.route_lines import LineLeg, RouteLine
from ..lines.wider_bends import with_wider_bends
from ..vehicles.bodies import vehicle_parameters

SPACING = 0.5
"""Meters between two points of the line."""
EASED = 2.5
"""Meters to each side over which the line is averaged: wheels take time to turn."""
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


def least_radius(actor: SceneActor) -> float:
    """Meters: of the bends that the middle of a vehicle can follow."""
    car = vehicle_parameters(actor)
    return _tightest_radius(0.5 * car.wheelbase, car.max_steering)


def _tightest_radius(base: float, max_steering: float) -> float:
    return math.hypot(2.0 * base / math.tan(max_steering), base)


def moved_line(line: RouteLine, left: Floats) -> RouteLine:
    """The line with each of its points (n,) so many meters to the left, and as much less of its
    lane beside it."""
    source = line.source
    s, heading = source.s, source.heading
    bend = np.gradient(heading, s)
    x, y = source.x - np.sin(heading) * left, source.y + np.cos(heading) * left
    turned = np.arctan2(np.gradient(left, s), np.maximum(1.0 - bend * left, 0.1))
    gone = _chords(x, y)
    width = np.maximum(source.width - 2.0 * np.abs(left), 0.1)
    moved = LineSource(gone, x, y, heading + turned, width, source.closed)
    return replace(line, source=moved, legs=tuple(_moved(leg, s, gone) for leg in line.legs))


def leaned_source(
    source: LineSource, length: float, base: float, max_steering: float
) -> tuple[LineSource, Floats, Floats]:
    """The line of the middle of a vehicle, and arc lengths of `source` with those of that line at
    the same places. `base`: half of the wheelbase."""
    front = base + 0.5 * length
    least = SPARE * _tightest_radius(base, max_steering)
    gain = max(0.0, 0.25 * front * front - 0.5 * base * base)
    s, gone, x, y, heading = _even(source, least)
    bend = mean_bend(gone, heading, source.closed, length)
    left = _leaning(gain * bend, gone, heading, length, least)
    turned = np.arctan2(np.gradient(left, gone), np.maximum(1.0 - bend * left, 0.1))
    x, y = x - np.sin(heading) * left, y + np.cos(heading) * left
    width = source.width
    if isinstance(width, np.ndarray):
        width = np.interp(s, source.s, width)
    gone = _chords(x, y)
    return LineSource(gone, x, y, heading + turned, width, source.closed), s, gone


def _even(source: LineSource, least: float) -> tuple[Floats, Floats, Floats, Floats, Floats]:
    """Arc lengths of `source`, and those, x, y and heading of the same line with no bends tighter
    than about `least`."""
    s = _evenly(source.length)
    x, y, heading = (np.interp(s, source.s, c) for c in (source.x, source.y, source.heading))
    line = with_wider_bends((s, x, y, heading), least)
    gone = _chords(line[1], line[2])
    even = _evenly(float(gone[-1]))
    s, *rest = (np.interp(even, gone, column) for column in line)
    x, y, heading = (_eased(column, source.closed) for column in rest)
    return s, even, x, y, heading


def _eased(values: Floats, closed: bool) -> Floats:
    """Means over `EASED` meters to each side: no bend begins at once. Open lines go on straight."""
    count = min(round(EASED / SPACING), (len(values) - 1) // 2)
    if count < 1:
        return values
    wide = np.pad(values, count, mode="reflect", reflect_type="odd")
    if closed:
        lap = values[-1] - values[0]
        wide[:count] = values[-count - 1 : -1] - lap
        wide[-count:] = values[1 : count + 1] + lap
    box = np.full(2 * count + 1, 1.0 / (2 * count + 1))
    return np.asarray(np.convolve(wide, box, mode="valid"))


def _evenly(length: float) -> Floats:
    return np.linspace(0.0, length, max(2, math.ceil(length / SPACING)) + 1)


def _chords(x: Floats, y: Floats) -> Floats:
    """Arc lengths of points."""
    return np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(x), np.diff(y)))])


def _leaning(wanted: Floats, s: Floats, heading: Floats, length: float, least: float) -> Floats:
    """Meters to the left that the line is moved: less than `wanted` where the bend is nearly as
    tight as a vehicle can drive, and without steps."""
    around = math.ceil(0.5 * length / (s[1] - s[0]))
    bend = np.abs(np.gradient(heading, s))
    windows = np.lib.stride_tricks.sliding_window_view(np.pad(bend, around), 2 * around + 1)
    spare = np.maximum(1.0 / np.maximum(windows.max(axis=1), 1e-6) - least, 0.0)
    left = wanted * spare / np.maximum(np.abs(wanted) + spare, 1e-9)
    quarter = max(1, around // 2)
    box = np.full(2 * quarter + 1, 1.0 / (2 * quarter + 1))
    for _ in range(2):
        left = np.convolve(np.pad(left, quarter, mode="edge"), box, mode="valid")
    return np.asarray(left)


def mean_bend(s: Floats, heading: Floats, closed: bool, length: float) -> Floats:
    """Curvature, averaged twice over half of a length: over the ground that the vehicle covers."""
    h = 0.25 * length
    last = float(s[-1])
    fine = np.arange(-2.0 * h, last + 2.0 * h + SPACING, SPACING)
    if closed:
        laps = np.floor(fine / last)
        turn = heading[-1] - heading[0]
        wide = np.interp(fine - laps * last, s, heading) + laps * turn
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
