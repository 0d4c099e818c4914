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

    What walks turns to `heading` at once, where that is a number. `line_offset` and `line_time`
    move the line to follow, `pose` puts the agent at a place: see `ControlBatch`.
    """

    steering: float
    acceleration: float
    heading: float = math.nan
    line_offset: float = math.nan
    line_time: float = 0.0
    pose: tuple[float, float, float, float] | None = None
    failure: str = ""
    """why the controller fails from this step on, where the drive goes on without it"""

    @property
    def is_open(self) -> bool:
        """Whether steering or acceleration is left to a controller before."""
        return math.isnan(self.steering) or math.isnan(self.acceleration)

    def filled(self, earlier: Control) -> Control:
        """With what `earlier` decides where this one is open."""
        pairs = ((self.steering, earlier.steering), (self.acceleration, earlier.acceleration))
        steering, acceleration = (then if math.isnan(now) else now for now, then in pairs)
        failure = self.failure or earlier.failure
        return replace(self, steering=steering, acceleration=acceleration, failure=failure)


@dataclass(frozen=True, slots=True)
class ControlBatch:
    """Columns (N,) of what `Control` says of one agent. Where `steering` or `acceleration` is NaN,
    the last controller before it that gives a number decides, else it is 0. `heading` is for what
    walks: it turns there at once, if not NaN."""

    steering: Floats
    acceleration: Floats
    heading: Floats | None = None
    line_offset: Floats | None = None
    """moves the line that the agent follows so many meters left of its reference line, for all
    later controllers, and where widths change keeps it beside the nearest lane; NaN: as before"""
    line_time: Floats | None = None
    """seconds in which the line moves there, smoothly; None or 0: at once"""
    pose: Floats | None = None
    """(N, 4) x, y, heading and speed one step later; NaN: left to the equations of motion"""
    acceleration_limit: Floats | None = None
    """(N,) m/s^2: upper limit of what controllers before it decide where it leaves that open"""
    failures: Mapping[int, str] | None = None
    """by place in the batch: why the controller of that agent fails from this step on, where the
    drive goes on without it. Traces have it as an event `controller_failed`, tables as columns"""

    @classmethod
    def of(cls, controls: Sequence[Control]) -> ControlBatch:
        """A batch of what is decided one by one."""
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
