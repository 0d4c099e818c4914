"""What a controller written in Python decides, once a step: for one agent, or for many."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ..geometry.arrays import Floats


@dataclass(frozen=True, slots=True)
class Control:
    """Steering angle of the front wheels (left positive), acceleration (braking negative).

    Pedestrians turn to `heading` at once if it is a number. `line_offset` and `line_time` move the
    line to follow, `pose` puts the agent at a place: see `ControlBatch`.
    """

    steering: float
    acceleration: float
    heading: float = math.nan
    line_offset: float = math.nan
    line_time: float = 0.0
    pose: tuple[float, float, float, float] | None = None
    failure: str = ""
    """why the controller fails from this step on, if the drive goes on without it"""

    @property
    def is_open(self) -> bool:
        """Whether steering or acceleration is left to an earlier controller."""
        return math.isnan(self.steering) or math.isnan(self.acceleration)

    def filled(self, earlier: Control) -> Control:
        """With what `earlier` decides where this one is open."""
        pairs = ((self.steering, earlier.steering), (self.acceleration, earlier.acceleration))
        steering, acceleration = (then if math.isnan(now) else now for now, then in pairs)
        failure = self.failure or earlier.failure
        return replace(self, steering=steering, acceleration=acceleration, failure=failure)


@dataclass(frozen=True, slots=True)
class ControlBatch:
    """Columns (N,) of what `Control` says of one agent. If `steering` or `acceleration` is NaN, the
    last controller before it that gives a number decides; without one it is 0. `heading` is for
    pedestrians, who turn at once if it is not NaN."""

    steering: Floats
    acceleration: Floats
    heading: Floats | None = None
    line_offset: Floats | None = None
    """moves the path of the agent to this many meters left of its reference line, for all later
    controllers; where widths change, the path keeps its place relative to the nearest lane; NaN: no
    change"""
    line_time: Floats | None = None
    """duration of this move in seconds; None or 0: at once"""
    pose: Floats | None = None
    """(N, 4) x, y, heading and speed one step later; NaN: left to the equations of motion"""
    acceleration_limit: Floats | None = None
    """(N,) m/s^2: upper limit of the acceleration that earlier controllers decide, if
    `acceleration` is NaN"""
    failures: Mapping[int, str] | None = None
    """by place in the batch: why the controller of that agent fails from this step on, if the drive
    goes on without it. Traces have it as an event `controller_failed`, tables as columns"""

    @classmethod
    def of(cls, controls: Sequence[Control]) -> ControlBatch:
        """A batch of single decisions."""
        import numpy as np

        names = ("steering", "acceleration", "heading", "line_offset", "line_time")
        numbers = np.array([[getattr(c, name) for c in controls] for name in names], np.float64)
        steering, acceleration, heading, line_offset, line_time = numbers
        pose = None
        if any(c.pose is not None for c in controls):
            pose = np.array([c.pose or (math.nan,) * 4 for c in controls], dtype=np.float64)
        failures = {place: c.failure for place, c in enumerate(controls) if c.failure}
        if all(math.isnan(c.line_offset) for c in controls):
            return cls(steering, acceleration, heading, pose=pose, failures=failures)
        return cls(steering, acceleration, heading, line_offset, line_time, pose, failures=failures)
