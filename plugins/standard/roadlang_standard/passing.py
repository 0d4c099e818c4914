"""What passing an agent or object takes: time and distance, by hand."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from roadlang.api import Neighbors
    from roadlang.geometry import Booleans, Floats

    from .lane_traffic import LaneTraffic

STANDSTILL = 1.0
"""m/s: what is slower stands still."""
REACHED = 0.8
"""Share of the acceleration that is planned with: drag and the engine take the rest."""


@dataclass(frozen=True)
class PassingView:
    """What agents (N,) who may pass another see of it."""

    found: Booleans
    """whether the target is near"""
    ahead: Floats
    """of the target, from center to center"""
    left: Floats
    pace: Floats
    length: Floats
    origin: Floats
    """offset of the lane that the agent comes from"""
    middle: Floats
    """offset of the lane in which it passes"""
    fast: Floats
    """speed while passing"""
    lane: LaneTraffic
    """in which it passes"""
    home: LaneTraffic
    """from which it comes"""
    row: Booleans
    """(N, K) who stands still and is of the target, or follows it too closely for a place between:
    passed all together"""
    row_length: Floats
    """from the middle of the target to that of the farthest in its row"""
    has_another: Booleans
    """whether a member of the group is still ahead"""

    def gap(self, length: Floats) -> Floats:
        """(N,) from bumper to bumper, to the target ahead; `length`: of the agents."""
        return self.ahead - 0.5 * (length + self.length)


def passing_time(
    speed: Floats, pace: Floats, fast: Floats, acceleration: Floats | float, gain: Floats
) -> Floats:
    """(N,) seconds until an agent has gained `gain` meters on one that goes at `pace`, if it
    accelerates from `speed` to `fast`: `d t + a t^2 / 2 = gain` with `d = speed - pace` as long as
    it accelerates, and then at a constant difference."""
    import numpy as np

    rate = REACHED * acceleration
    rising = np.maximum(fast - speed, 0.0) / rate
    off = speed - pace
    gained = off * rising + 0.5 * rate * rising * rising
    root = np.sqrt(np.maximum(off * off + 2.0 * rate * gain, 0.0))
    early = (root - off) / rate
    late = rising + (gain - gained) / np.maximum(fast - pace, 0.1)
    return np.asarray(np.where(gained >= gain, early, late))


def passing_distance(
    speed: Floats, fast: Floats, acceleration: Floats | float, time: Floats
) -> Floats:
    """(N,) meters that an agent goes in a time, if it accelerates from `speed` to `fast`."""
    import numpy as np

    rising = np.maximum(fast - speed, 0.0) / acceleration
    part = np.minimum(rising, time)
    there = np.minimum(speed + acceleration * part, np.maximum(fast, speed))
    return np.asarray((speed + 0.5 * acceleration * part) * part + there * (time - part))


def standing_row(near: Neighbors, target: Booleans, home: LaneTraffic, least: Floats) -> Booleans:
    """(N, K) members of the target (N, K) that stand still, and what stands before them in the
    lane `home` with less than `least` (N,) meters between, so that nobody can pull in there."""
    import numpy as np

    still = np.abs(near.pace) < STANDSTILL
    row = target & still
    if not row.any():
        return row
    half = 0.5 * near.length
    for _ in range(row.shape[1]):
        front = np.where(row, near.ahead + half, -np.inf).max(axis=1, keepdims=True)
        room = near.ahead - half - front
        joins = still & home.there & ~row & (near.ahead > front) & (room < least[:, None])
        if not joins.any():
            break
        row = row | joins
    return row
