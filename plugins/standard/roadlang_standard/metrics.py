"""Metrics of drives for Python: `from roadlang_standard import metrics`.

    drive = roadlang.load("traffic.rl").sample()[0].run()
    ego, lead = drive.trace.agents["ego"], drive.trace.agents["lead"]
    metrics.time_to_collision(ego, lead).min()

Functions take agents of a trace, `drive.trace.agents["ego"]`, or plain arrays. What formulas say of
a drive (`time_to_collision(ego, lead)`) has its one definition in the kinds of drive signals. SI
units and radians; arrays are (T,) over the times of the trace.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .drive_signal_jerk import JerkSignal
from .drive_signal_lateral_acceleration import LateralAcceleration
from .drive_signals_conflict import TimeHeadway, TimeToCollision

if TYPE_CHECKING:
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
    return TimeToCollision(first=first, second=second).values()


def time_headway(first: AgentTrace, second: AgentTrace) -> Floats:
    """(T,) seconds in which the front of the first will be where the front of the second is now,
    along its lane; infinite where the second is not ahead there, or the first stands."""
    return TimeHeadway(first=first, second=second).values()


def time_exposed(values: Floats, time: Floats, threshold: float) -> float:
    """Seconds in which a measure such as time to collision is below a threshold: TET of Minderhoud
    and Bovy (2001). Linear between samples is not assumed: each stands until the next."""
    steps = np.diff(time, append=time[-1:])
    return float(steps[np.asarray(values) < threshold].sum())


def time_integrated(values: Floats, time: Floats, threshold: float) -> float:
    """How far and how long it is below the threshold, in seconds squared for a time to collision:
    TIT of Minderhoud and Bovy (2001)."""
    steps = np.diff(time, append=time[-1:])
    return float((np.maximum(threshold - np.asarray(values), 0.0) * steps).sum())


def rms(values: Floats, time: Floats) -> float:
    """Root of the mean square over time, trapezoidal between samples; that of a single sample is
    its size. NaN without samples."""
    square = np.asarray(values, dtype=float) ** 2
    if len(square) < 2 or time[-1] <= time[0]:
        return float(np.sqrt(square.mean())) if len(square) else float("nan")
    areas = (square[1:] + square[:-1]) / 2.0 * np.diff(time)
    return float(np.sqrt(areas.sum() / (time[-1] - time[0])))


def cross_track_rms(agent: AgentTrace) -> float:
    """Meters from the line that the agent follows, root of the mean square over time."""
    return rms(agent.cross_track_error, agent.time)


def max_lateral_acceleration(agent: AgentTrace) -> float:
    """m/s2, the greatest size of speed times yaw rate; 0 without samples."""
    return _greatest(LateralAcceleration(agent=agent).values())


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
    time, along = agent.time, agent.acceleration
    across = LateralAcceleration(agent=agent).values()
    jerk = JerkSignal(agent=agent).values()
    is_beyond = (np.abs(along) > COMFORTABLE_ACCELERATION) | (np.abs(jerk) > COMFORTABLE_JERK)
    steps = np.diff(time, append=time[-1:])
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
