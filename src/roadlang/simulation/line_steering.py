"""The steering that keeps a vehicle on its line: what `lane_follow` does, and what the engine does
where no controller steers."""

from __future__ import annotations

import numpy as np

from ..geometry.arrays import Floats, wrapped
from ..ir.control import ObservationBatch

PREVIEW_TIME = 0.12
"""Seconds by which the curvature is looked up ahead."""
YAW_DAMPING = 0.1
"""Seconds: steering angle for each rad/s of a yaw rate that is not that of the line."""
SLOWEST = 3.0
"""m/s: below it, a cross-track error is corrected as at this speed."""


def line_steering(seen: ObservationBatch) -> Floats:
    """(N,) steering angle that keeps to the line: its curvature, looked up ahead, and a correction
    of the errors in place and heading and, as the faster a car goes the more it swings, of the yaw
    rate."""
    _, _, _, curvature = seen.line_ahead(PREVIEW_TIME * seen.speed)
    # A car on a circle points along the circle at its rear axle.
    _, _, rear_heading, _ = seen.line_ahead(-0.5 * seen.wheelbase)
    correction = np.arctan(2.0 * seen.cross_track_error / np.maximum(seen.speed, SLOWEST))
    bend = np.arctan(seen.wheelbase * curvature)
    damping = YAW_DAMPING * (seen.yaw_rate - seen.speed * curvature)
    return np.asarray(bend + wrapped(rear_heading - seen.heading) - correction - damping)
