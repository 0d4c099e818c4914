"""Metrics of drives for Python: `from roadlang_standard import metrics`.

    drive = roadlang.load("traffic.rl").sample()[0].run()
    ego, lead = drive.trace.agents["ego"], drive.trace.agents["lead"]
    metrics.time_to_collision(ego, lead).min()

Functions take agents of a trace, `drive.trace.agents["ego"]`, or plain arrays. What formulas say of
a drive (`time_to_collision(ego, lead)`) has its one definition in the kinds of drive signals. SI
units and radians; arrays are (T,) over the times of the trace.

All raise `TypeError` for what is no agent, array of numbers or number, and `ValueError` for agents
of different drives, arrays of different lengths, times out of order and a threshold that is NaN.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from . import metric_arguments as given
from .drive_signal_jerk import JerkSignal
from .drive_signal_lateral_acceleration import LateralAcceleration
from .drive_signals_conflict import TimeHeadway, TimeToCollision

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from roadlang.api import AgentTrace
    from roadlang.geometry import Floats

GRAVITY = 9.80665
"""m/s2"""
COMFORTABLE_ACCELERATION = 0.15 * GRAVITY
"""Longitudinal acceleration up to which most passengers find a ride acceptable (Hoberock 1977)."""
COMFORTABLE_JERK = 0.30 * GRAVITY
"""The same of its rate of change."""


def time_to_collision(first: AgentTrace, second: AgentTrace) -> Floats:
    """(T,) seconds until the rectangles of two touch if both keep their velocity; infinite if they
    would not (Hayward 1972)."""
    one, other = given.pair(first, second)
    return TimeToCollision(first=one, second=other).values()


def time_headway(first: AgentTrace, second: AgentTrace) -> Floats:
    """(T,) seconds in which the front of the first will be where the front of the second is now,
    along its lane; infinite where the second is not ahead there, or the first stands."""
    one, other = given.pair(first, second)
    return TimeHeadway(first=one, second=other).values()


def time_exposed(values: ArrayLike, time: ArrayLike, threshold: float) -> float:
    """Seconds in which a measure (T,) such as time to collision is below a threshold: TET of
    Minderhoud and Bovy (2001). Linear between samples is not assumed: each stands until the next.
    NaN where a value is."""
    measure, times = given.samples(values, time)
    is_below = measure < given.threshold(threshold)
    return float("nan") if np.isnan(measure).any() else float(_steps(times)[is_below].sum())


def time_integrated(values: ArrayLike, time: ArrayLike, threshold: float) -> float:
    """How far and how long a measure (T,) is below the threshold, in seconds squared for a time to
    collision: TIT of Minderhoud and Bovy (2001). Each sample stands until the next, the last for
    no time. NaN where a value is."""
    measure, times = given.samples(values, time)
    depths, steps = np.maximum(given.threshold(threshold) - measure, 0.0), _steps(times)
    lasting = (steps > 0.0) | np.isnan(depths)
    return float((depths[lasting] * steps[lasting]).sum())


def _steps(time: Floats) -> Floats:
    """(T,) seconds for which each sample stands."""
    return np.diff(time, append=time[-1:])


def rms(values: ArrayLike, time: ArrayLike) -> float:
    """Root of the mean square of (T,) values over time, trapezoidal between samples; that of a
    single sample is its size. NaN without samples, and where a value is."""
    signal, times = given.samples(values, time)
    square = signal**2
    if len(square) < 2 or times[-1] <= times[0]:
        return float(np.sqrt(square.mean())) if len(square) else float("nan")
    areas = (square[1:] + square[:-1]) / 2.0 * np.diff(times)
    return float(np.sqrt(areas.sum() / (times[-1] - times[0])))


def cross_track_rms(agent: AgentTrace) -> float:
    """Meters from the line that the agent follows, root of the mean square over time. NaN where
    the simulator did not record it."""
    given.agent("agent", agent)
    return rms(agent.cross_track_error, agent.time)


def max_lateral_acceleration(agent: AgentTrace) -> float:
    """m/s2, the greatest size of speed times yaw rate; 0 without samples."""
    return _greatest(LateralAcceleration(agent=given.agent("agent", agent)).values())


@dataclass(frozen=True)
class Comfort:
    """How a ride feels. m/s2, and m/s3 for jerk."""

    rms: float
    """total acceleration in the plane, root of the mean square over time: a_v of ISO 2631-1,
    without its weighting by frequency. Up to 0.315 is not uncomfortable there,
    above 0.8 uncomfortable"""
    longitudinal: float
    """the greatest size of the acceleration along the heading"""
    lateral: float
    """the greatest size of the lateral acceleration"""
    jerk: float
    """the greatest size of the rate of change of the acceleration along the heading"""
    uncomfortable: float
    """the share of the time in which acceleration or jerk along the heading is beyond what most
    passengers find acceptable (Hoberock 1977: 0.15 g and 0.30 g/s)"""


def comfort(agent: AgentTrace) -> Comfort:
    """How the ride of an agent feels."""
    given.agent("agent", agent)
    time, along = agent.time, agent.acceleration
    across = LateralAcceleration(agent=agent).values()
    jerk = JerkSignal(agent=agent).values()
    is_beyond = (np.abs(along) > COMFORTABLE_ACCELERATION) | (np.abs(jerk) > COMFORTABLE_JERK)
    steps = _steps(time)
    duration = float(steps.sum())
    return Comfort(
        rms(np.hypot(along, across), time),
        _greatest(along),
        _greatest(across),
        _greatest(jerk),
        float(steps[is_beyond].sum()) / duration if duration > 0.0 else 0.0,
    )


def _greatest(values: Floats) -> float:
    return float(np.abs(values).max(initial=0.0))
