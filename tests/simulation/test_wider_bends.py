"""The lines of long vehicles where lanes bend more than they can drive."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from roadlang.geometry.arrays import Floats
from roadlang.simulation.bends.leaning import leaned_source
from roadlang.simulation.lines.line_sources import LineSource
from roadlang.simulation.lines.smoothing import drivable
from roadlang.simulation.lines.wider_bends import with_wider_bends

LEAST = 9.4
STRAIGHT = 60.0


def corner(radius: float, degrees: float, after: float = STRAIGHT) -> LineSource:
    """A straight, a bend to the left (degrees below 0: to the right), and a straight."""
    turn = math.radians(degrees)
    s = np.arange(0.0, STRAIGHT + radius * abs(turn) + after, 0.5)
    share = np.clip((s - STRAIGHT) / (radius * abs(turn)), 0.0, 1.0)
    heading = turn * share
    middle = 0.5 * (heading[1:] + heading[:-1])
    x, y = (np.concatenate([[0.0], np.cumsum(f(middle) * 0.5)]) for f in (np.cos, np.sin))
    return LineSource(s, x, y, heading, 3.5)


def least_radius(s: Floats, heading: Floats) -> float:
    """Over 2 m of a line."""
    bend = (heading[4:] - heading[:-4]) / (s[4:] - s[:-4])
    return 1.0 / float(np.abs(bend).max())


def distance(x: Floats, y: Floats, line: LineSource) -> float:
    """Of the points from a line, at most."""
    away = np.hypot(x[:, None] - line.x, y[:, None] - line.y)
    return float(away.min(axis=1).max())


@pytest.mark.parametrize("degrees", [45.0, -90.0, 130.0])
@pytest.mark.parametrize("radius", [4.0, 6.0, 8.5])
def test_a_tight_corner_is_cut_as_little_as_an_arc_can(radius: float, degrees: float) -> None:
    line = corner(radius, degrees)
    s, x, y, heading = with_wider_bends((line.s, line.x, line.y, line.heading), LEAST)
    gone = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(x), np.diff(y)))])
    assert least_radius(gone, heading) > 0.97 * LEAST
    half = math.radians(abs(degrees)) / 2.0
    arc = (LEAST - radius) * (1.0 / math.cos(half) - 1.0)
    assert distance(x, y, line) < arc * 1.15 + 0.35
    assert (np.diff(s) > 0.0).all()
    assert (x[-1], y[-1], heading[-1]) == pytest.approx((line.x[-1], line.y[-1], line.heading[-1]))


@pytest.mark.parametrize("radius", [2.0, 3.0])
@pytest.mark.parametrize("degrees", [60.0, -90.0, 130.0])
def test_an_inner_lane_stays_a_lane_where_a_car_cannot_follow_it(
    radius: float, degrees: float
) -> None:
    line = corner(radius, degrees)
    before, x, y, heading = drivable(line.x, line.y)
    gone = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(x), np.diff(y)))])
    assert least_radius(gone, heading) > 3.6
    half = math.radians(abs(degrees)) / 2.0
    assert distance(x, y, line) < (4.0 - radius) * (1.0 / math.cos(half) - 1.0) * 1.15 + 0.45
    assert (np.diff(before) > 0.0).all()
    assert before[-1] == pytest.approx(line.s[-1], abs=0.5)


def test_a_bend_that_can_be_driven_stays() -> None:
    line = corner(12.0, 90.0)
    columns = line.s, line.x, line.y, line.heading
    assert with_wider_bends(columns, LEAST) is columns


def test_what_nothing_can_replace_stays() -> None:
    line = corner(3.0, 90.0, after=1.0)  # the line ends in the bend
    s, x, y, heading = with_wider_bends((line.s, line.x, line.y, line.heading), 30.0)
    assert np.isfinite([s, x, y, heading]).all()


@given(
    radius=st.floats(4.0, 40.0),
    degrees=st.floats(-140.0, 140.0).filter(lambda turn: abs(turn) > 5.0),
    length=st.sampled_from((7.5, 9.0, 12.0, 14.0)),
)
@example(radius=10.2, degrees=90.0, length=12.0)
@example(radius=16.0, degrees=90.0, length=14.0)
def test_no_line_of_a_long_vehicle_has_a_kink(radius: float, degrees: float, length: float) -> None:
    line, base, steering = corner(radius, degrees), 0.29 * length, 0.65
    least = math.hypot(2.0 * base / math.tan(steering), base)
    leans, _, _ = leaned_source(line, length, base, steering)
    assert least_radius(leans.s, np.unwrap(leans.heading)) > least
    course = np.unwrap(np.arctan2(np.diff(leans.y), np.diff(leans.x)))
    middle = 0.5 * (leans.heading[1:] + leans.heading[:-1])
    assert np.abs(course - middle).max() < 0.06
