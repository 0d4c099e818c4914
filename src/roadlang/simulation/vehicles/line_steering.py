"""The steering that keeps a vehicle on its line: what `lane_follow` does, and what the engine does
where no controller steers."""

from __future__ import annotations

import numpy as np

from ...geometry.arrays import Floats, wrapped
from ...ir.observation import ObservationBatch
from .vehicle_dynamics import FRONT_STIFFNESS, GRAVITY

PREVIEW_TIME = 0.12
"""Seconds by which the curvature is looked up ahead."""
YAW_DAMPING = 0.1
"""Seconds: steering angle for each rad/s of a yaw rate that is not that of the line."""
SLIP = 1.0 / (FRONT_STIFFNESS * GRAVITY)
"""Radians for each m/s^2 to the side by which a car steers more, as its tires slip: its body points
inward by the slip of the rear tires, and the front tires slip more than the rear ones (R. Rajamani,
Vehicle Dynamics and Control, ch. 3)."""
SLOWEST = 3.0
"""m/s: below it, a cross-track error is corrected as at this speed."""


def line_steering(seen: ObservationBatch) -> Floats:
    """(N,) steering angle that keeps to the line: its curvature, looked up ahead, and a correction
    of the errors in place and heading and, as the faster a car goes the more it swings, of the yaw
    rate. No tire slips by more than what the greatest grip takes."""
    (curvature,) = seen.curvatures_ahead((PREVIEW_TIME * seen.speed)[None])
    # A car on a circle points along the circle at its rear axle.
    _, _, rear_heading, _ = seen.line_ahead(-0.5 * seen.wheelbase)
    correction = np.arctan(2.0 * seen.cross_track_error / np.maximum(seen.speed, SLOWEST))
    bend = np.arctan(seen.wheelbase * curvature)
    turning = seen.speed * curvature
    slip = SLIP * np.minimum(np.maximum(seen.speed * turning, -GRAVITY), GRAVITY)
    damping = YAW_DAMPING * (seen.yaw_rate - turning)
    angle: Floats = bend + slip + wrapped(rear_heading - seen.heading) - correction - damping
    return angle
