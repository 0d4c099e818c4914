"""Rectangles on the move: when they touch, and how long one is where the other has been."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from roadlang.geometry import Footprints, encroachment_times, separation, time_to_contact

places = st.floats(-40.0, 40.0) | st.sampled_from([0.0, 4.5, 2.0])
headings = st.floats(-3.2, 3.2) | st.sampled_from([0.0, np.pi / 2, np.pi])
speeds = st.floats(-20.0, 20.0) | st.sampled_from([0.0])
sizes = st.sampled_from([0.5, 1.8, 4.5, 12.0])


def car(x: float, y: float, heading: float = 0.0) -> Footprints:
    return rectangle(x, y, heading, 4.5, 1.8)


def rectangle(x: float, y: float, heading: float, length: float, width: float) -> Footprints:
    return Footprints(*(np.array([value]) for value in (x, y, heading, length, width)))


def contact(a: Footprints, b: Footprints, vx: float, vy: float = 0.0) -> float:
    return float(time_to_contact(a, b, np.array([[vx, vy]]))[0])


def test_a_follower_reaches_the_bumper_ahead() -> None:
    assert contact(car(0, 0), car(24.5, 0), -5.0) == pytest.approx(4.0)
    assert contact(car(24.5, 0), car(0, 0), 5.0) == pytest.approx(4.0)


def test_who_falls_behind_never_touches() -> None:
    assert contact(car(0, 0), car(24.5, 0), 5.0) == np.inf
    assert contact(car(0, 0), car(24.5, 0), 0.0) == np.inf


def test_the_next_lane_is_passed() -> None:
    assert contact(car(0, 0), car(60, 3.5, np.pi), -30.0) == np.inf
    assert contact(car(0, 0), car(60, 1.7, np.pi), -30.0) == pytest.approx(55.5 / 30)


def test_crossing_cars_meet_with_their_corners() -> None:
    """One comes from the right; its front reaches our lane when our front is past its side."""
    meets = contact(car(0, 0), car(20, -20, np.pi / 2), -10.0, 10.0)
    assert meets == pytest.approx((20 - 2.25 - 0.9) / 10)
    assert contact(car(0, 0), car(20, -60, np.pi / 2), -10.0, 10.0) == np.inf


def test_what_touches_has_no_time_left() -> None:
    assert contact(car(0, 0), car(3, 0), 10.0) == 0.0
    assert contact(car(0, 0), car(3, 1), 0.0) == 0.0


@given(places, places, headings, headings, speeds, speeds, sizes, sizes)
def test_contact_is_what_small_steps_find(
    x: float, y: float, one: float, other: float, vx: float, vy: float, length: float, width: float
) -> None:
    a, b = car(0, 0, one), rectangle(x, y, other, length, width)
    when = contact(a, b, vx, vy)
    time = np.arange(0.0, 6.0, 0.01)
    moved = Footprints(x + vx * time, y + vy * time, np.full(600, other), b.length, b.width)
    apart = separation(a, moved)
    if np.isfinite(when):
        at = rectangle(x + vx * when, y + vy * when, other, length, width)
        assert separation(a, at)[0] <= 1e-9
        assert (apart[time < when - 1e-9] > -1e-9).all()
    else:
        assert (apart > -1e-9).all()
    assert contact(b, a, -vx, -vy) == pytest.approx(when, abs=1e-9)


def drive(x: np.ndarray, y: np.ndarray, heading: float) -> Footprints:
    size = np.full(len(x), 4.5), np.full(len(x), 1.8)
    return Footprints(x, y, np.full(len(x), heading), *size)


def test_encroachment_is_the_time_between_leaving_and_entering() -> None:
    """At 10 m/s the first car's rear has left the crossing at 4.5 + 1.8 m behind its front's entry;
    the second comes three seconds later than at the same time."""
    time = np.arange(0.0, 12.0, 0.02)
    first = drive(-30 + 10 * time, 0 * time, 0.0)
    second = drive(0 * time, -60 + 10 * time, np.pi / 2)
    found = encroachment_times(first, second, time)
    assert found[0] == np.inf
    assert found[-1] == pytest.approx(3.0 - (4.5 + 1.8) / 10, abs=0.05)
    known = time[np.isfinite(found)][0]
    assert known == pytest.approx((60 - 2.25 - 0.9) / 10, abs=0.05)
    assert (np.diff(found[np.isfinite(found)]) <= 0).all()


def test_encroachment_ends_with_a_collision() -> None:
    time = np.arange(0.0, 6.0, 0.02)
    found = encroachment_times(
        drive(-30 + 10 * time, 0 * time, 0.0), drive(0 * time, -30 + 10 * time, np.pi / 2), time
    )
    assert found[-1] == 0.0


def test_ways_that_do_not_cross_have_no_encroachment() -> None:
    time = np.arange(0.0, 6.0, 0.02)
    found = encroachment_times(
        drive(10 * time, 0 * time, 0.0), drive(10 * time, 0 * time + 3.5, 0.0), time
    )
    assert np.isinf(found).all()


@pytest.mark.parametrize(("gap", "touches"), [(0.0, True), (0.25, False)])
def test_encroachment_counts_what_just_touches(gap: float, touches: bool) -> None:
    """Side by side, 2 m wide each: all lengths are exact in binary."""
    time, zero = np.arange(4.0), np.zeros(4)
    size = np.full(4, 4.0), np.full(4, 2.0)
    first = Footprints(zero, zero, zero, *size)
    second = Footprints(zero, zero + 2.0 + gap, zero, *size)
    assert (encroachment_times(first, second, time) == (0.0 if touches else np.inf)).all()
    assert (
        time_to_contact(first, second, np.zeros((4, 2))).tolist()
        == [0.0 if touches else np.inf] * 4
    )
