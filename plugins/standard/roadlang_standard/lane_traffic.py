"""Who is in a lane, and whether there is room for one more: what several maneuvers share."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from roadlang.api import Neighbors, ObservationBatch
    from roadlang.geometry import Booleans, Floats

SIDE = 0.4
"""Meters between the sides of two vehicles that pass each other, at least."""
DRIFT_TIME = 1.0
"""Seconds for which others go on sideways as they do now, to foresee who comes into a lane."""
STANDSTILL_GAP = 1.5
"""Meters that remain between two vehicles, at least."""
REACTION = 0.3
"""Seconds of the speed of the one behind that are added to the gap."""
UNSEEN = 1.5
"""Seconds from when an agent begins to change lanes until it is in the way of who is behind there.
"""
BRAKING = 4.0
"""m/s^2 with which the one behind adapts its speed to the one ahead."""
SETTLING_TIME = 2.0
"""Seconds after a lane change for which who changes still steers along its line."""
MEETING = 2.0
"""Seconds that remain until one meets oncoming traffic, at least."""


@dataclass(frozen=True)
class LaneTraffic:
    """Who is in the lanes of N agents, (N, K): whether, and the gap from bumper to bumper, negative
    where they are beside each other."""

    there: Booleans
    ahead: Booleans
    """whether its center is ahead"""
    gap: Floats
    pace: Floats
    length: Floats

    def nearest_ahead(self) -> tuple[Floats, Floats]:
        """(N,) gap to the next one ahead, infinite for none, and its pace."""
        return self._nearest(self.there & self.ahead)

    def nearest_behind(self) -> tuple[Floats, Floats]:
        """(N,) gap to the next one behind, infinite for none, and its pace."""
        return self._nearest(self.there & ~self.ahead)

    def _nearest(self, counts: Booleans) -> tuple[Floats, Floats]:
        import numpy as np

        gap = np.where(counts, self.gap, np.inf)
        if not gap.shape[1]:
            return np.full(len(gap), np.inf), np.zeros(len(gap))
        each, first = np.arange(len(gap)), gap.argmin(axis=1)
        least, pace = gap[each, first], self.pace[each, first]
        return least, np.where(np.isfinite(least), pace, 0.0)


def lane_traffic(
    seen: ObservationBatch, middle: Floats, near: Neighbors, side: float = SIDE
) -> LaneTraffic:
    """Who is, or will be within a second, in a lane whose middle is `middle` meters left of
    the reference line, or nearer than `side` meters to who drives there."""
    import numpy as np

    now = seen.road_offset[:, None] + near.left
    soon = now + near.drift * DRIFT_TIME
    half = 0.5 * (seen.width[:, None] + near.width) + side
    away, later = now - middle[:, None], soon - middle[:, None]
    inside = np.minimum(np.abs(away), np.abs(later)) < half
    inside |= (away < 0.0) != (later < 0.0)  # it crosses the lane
    gap = np.abs(near.ahead) - 0.5 * (seen.length[:, None] + near.length)
    there = near.there & inside
    return LaneTraffic(there, near.ahead >= 0.0, gap, near.pace, near.length)


def has_room(
    seen: ObservationBatch,
    lane: LaneTraffic,
    time: Floats,
    share: float = 1.0,
    braking: Floats | None = None,
) -> Booleans:
    """(N,) whether an agent can be in a lane within `time` seconds without forcing anybody to brake
    harder than `BRAKING`: the gap that the one behind needs is
    `STANDSTILL_GAP + max(REACTION v, UNSEEN d) + d^2 / (2 BRAKING)` with the difference in speed
    `d`, times `share`; oncoming traffic must be farther away than both go until then and `MEETING`
    seconds more. Who brakes, by `braking` (N,) m/s^2, does so for half of the time, and lets those
    behind come closer."""
    import numpy as np

    speed = seen.speed[:, None]
    slowing = (np.zeros(len(time)) if braking is None else braking)[:, None]
    half = np.minimum(0.5 * time[:, None], speed / np.maximum(slowing, 1e-6))
    later, lost = speed - slowing * half, 0.5 * slowing * half * half
    behind = np.where(lane.ahead, speed, lane.pace)
    closing = np.maximum(np.where(lane.ahead, speed - lane.pace, lane.pace - later), 0.0)
    slack = REACTION * np.maximum(behind, 0.0)
    slack = np.maximum(slack, np.where(lane.ahead, 0.0, UNSEEN * closing))
    needed = STANDSTILL_GAP + slack + np.where(lane.ahead, 0.0, lost)
    needed = needed + closing * closing / (2.0 * BRAKING)
    oncoming = lane.ahead & (lane.pace < -1.0)
    meeting = STANDSTILL_GAP + closing * (time[:, None] + MEETING)
    needed = np.where(oncoming, meeting, needed)
    return np.asarray((~lane.there | (lane.gap > needed * share)).all(axis=1))


def members(near: Neighbors, name: str) -> Booleans:
    """(N, K) which are the agent or object of that name, or of that group."""
    import numpy as np

    if not near.there.shape[1]:
        return near.there
    names = near.name.astype(str)
    return np.asarray(near.there & ((names == name) | np.char.startswith(names, f"{name}[")))


def target_among(near: Neighbors, name: str) -> tuple[Booleans, Floats, Floats, Floats, Floats]:
    """(N,) of the agent called `name`, or the nearest member of that group: whether it is near, how
    far ahead it is from center to center, how far to the left, its pace and its length."""
    import numpy as np

    count, width = near.there.shape
    if not width:
        nothing = np.zeros(count)
        return nothing > 0.0, nothing, nothing, nothing, nothing
    mine = members(near, name)
    away = np.where(mine, np.abs(near.ahead), np.inf)
    nearest = np.arange(count), away.argmin(axis=1)
    return (
        np.asarray(mine.any(axis=1)),
        near.ahead[nearest],
        near.left[nearest],
        near.pace[nearest],
        near.length[nearest],
    )
