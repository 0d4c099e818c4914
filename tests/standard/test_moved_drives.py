"""What is measured on a drive does not depend on where the scene lies and which way it points."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from numpy.typing import ArrayLike

from roadlang.ir.trace import AgentTrace
from roadlang_standard import metrics
from roadlang_standard.drive_signal_distance import DistanceSignal
from roadlang_standard.drive_signal_gap import GapSignal
from roadlang_standard.drive_signal_lateral_acceleration import LateralAcceleration
from roadlang_standard.drive_signal_yaw_rate import YawRate
from roadlang_standard.drive_signals_conflict import (
    PostEncroachmentTime,
    TimeHeadway,
    TimeToCollision,
)

TIME = np.linspace(0.0, 8.0, 81)
Signal = Callable[[AgentTrace, AgentTrace], ArrayLike]
SIGNALS: dict[str, Signal] = {
    "distance": lambda a, b: DistanceSignal(a, b).values(),
    "gap": lambda a, b: GapSignal(a, b).values(),
    "time_headway": lambda a, b: TimeHeadway(a, b).values(),
    "time_to_collision": lambda a, b: TimeToCollision(a, b).values(),
    "post_encroachment_time": lambda a, b: PostEncroachmentTime(a, b).values(),
    "lateral_acceleration": lambda a, _: LateralAcceleration(a).values(),
    "yaw_rate": lambda a, _: YawRate(a).values(),
    "max_lateral_acceleration": lambda a, _: metrics.max_lateral_acceleration(a),
}


def driven(name: str, at: float, left: float, speed: float, bend: float) -> AgentTrace:
    """An agent on a circle, or straight on; beside the others, and nowhere on a road."""
    heading = bend * speed * TIME
    step = np.diff(TIME, prepend=TIME[0])
    x = at + np.cumsum(speed * np.cos(heading) * step)
    y = left + np.cumsum(speed * np.sin(heading) * step)
    zero = np.zeros(len(TIME))
    nowhere = zero - 1.0
    trace = AgentTrace(
        name, TIME, x, y, heading, zero + speed, zero, zero, zero, zero, zero, zero, 4.0, 2.0
    )
    return replace(trace, road=nowhere, lane=zero)


def moved(trace: AgentTrace, angle: float, east: float, north: float) -> AgentTrace:
    """The same drive, turned around the origin and then moved."""
    cosine, sine = math.cos(angle), math.sin(angle)
    return replace(
        trace,
        x=east + cosine * trace.x - sine * trace.y,
        y=north + sine * trace.x + cosine * trace.y,
        heading=trace.heading + angle,
    )


def mirrored(trace: AgentTrace) -> AgentTrace:
    """The same drive, left and right exchanged."""
    return replace(trace, y=-trace.y, heading=-trace.heading, steering=-trace.steering)


def pair(ahead: float, left: float, pace: float, bend: float) -> tuple[AgentTrace, AgentTrace]:
    return driven("ego", 0.0, 0.0, 9.0, bend), driven("lead", ahead, left, pace, bend)


def close(now: ArrayLike, then: ArrayLike) -> bool:
    return bool(np.allclose(now, then, rtol=1e-6, atol=1e-7))


@pytest.mark.parametrize("name", SIGNALS)
@given(
    st.floats(3.0, 40.0),
    st.sampled_from([0.0, 0.4, 3.5, -12.0]),
    st.sampled_from([0.5, 6.0, 9.0, 14.0]),
    st.sampled_from([0.0, 0.01, -0.02]),
    st.sampled_from([0.0, 0.7, math.pi / 2, -2.5, math.pi]),
    st.floats(-500.0, 500.0),
)
def test_a_drive_that_is_moved_measures_the_same(
    name: str, ahead: float, left: float, pace: float, bend: float, angle: float, east: float
) -> None:
    one, other = pair(ahead, left, pace, bend)
    apart = np.abs(DistanceSignal(one, other).values())
    assume(apart.min() > 1e-6)  # whether two that just touch have met is a matter of rounding
    expected = SIGNALS[name](one, other)
    again = SIGNALS[name](moved(one, angle, east, 40.0), moved(other, angle, east, 40.0))
    assert close(again, expected)


@pytest.mark.parametrize("name", SIGNALS)
@pytest.mark.parametrize("bend", [0.0, 0.01, -0.02])
@pytest.mark.parametrize("left", [0.0, 0.4, 3.5, -12.0])
def test_left_and_right_measure_the_same(name: str, left: float, bend: float) -> None:
    one, other = pair(20.0, left, 6.0, bend)
    sign = -1.0 if name in ("yaw_rate", "lateral_acceleration") else 1.0
    again = SIGNALS[name](mirrored(one), mirrored(other))
    assert close(np.asarray(again) * sign, SIGNALS[name](one, other))
