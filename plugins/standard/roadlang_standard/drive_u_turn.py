"""`drive with u_turn`: turn around on the road, and drive back."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Controller, InitialSpeed, Speed, Word, option

from .kinematic_moves import arc_move, lateral_reach, touches
from .steering import difference

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from roadlang.api import ControlBatch, Neighbors, ObservationBatch
    from roadlang.geometry import Floats
    from roadlang.geometry.arrays import Booleans

TURNING, BACKING = 3.0, 1.5
"""m/s: speeds while it turns, forward and backward."""
ACCELERATION, BRAKING = 1.5, 3.0
"""m/s^2"""
STEERING = 0.58
"""Radians of the front wheels while it turns: nearly as far as those of cars go."""
STANDING = 0.05
"""m/s"""
LANES = 3
"""Lanes of the other direction that it may use, counted from the middle."""
LANE_WIDTH = 3.5
"""Meters, where there are no lanes."""
EDGE = 0.2
"""Meters that its corners keep from the edges of the road."""
SHUNT = 0.6
"""Meters of each move at least: on a road that leaves less to a vehicle that stands across it, it
does not turn around."""
STRAIGHTENING = 0.8
"""Radians from the way back at which it steers toward its lane."""
LOOKAHEAD = 6.0
"""Meters on to which it steers then."""
SIGHT, GAP, BESIDE = 80.0, 2.5, 0.4
"""Meters: how far it sees, what it keeps to who is ahead, and to what is beside its way."""
CLEAR_TIME = 8.0
"""Seconds in which nobody may come, if it waits for a gap."""
COMING, FORWARD, BACKWARD, RETURNING, ENDED = 0.0, 1.0, 2.0, 3.0, 4.0
_PHASE, _PACE, _MIDDLE, _RIGHT, _STATION = range(5)


@dataclass(frozen=True)
class UTurn(Controller):
    """Turn around on the road and drive back in a lane of the other direction, or in its own where
    there is none; in several moves where the road is too narrow for one. It waits while something
    stands in its way. Where the lanes are hardly as wide as the vehicle is long, it does not turn:
    the controller before it drives on."""

    name: ClassVar[str] = "u_turn"
    speed: Speed = option(
        None,
        above=0,
        maximum=120,
        help="target speed on the way back; by default the speed limit, or 50 km/h without one",
        example="30km/h",
    )
    wait_for: Word = option(
        "nothing",
        words=("gap", "nothing"),
        help="whether it first waits for a gap in traffic",
    )

    def initial_speed(self) -> InitialSpeed:
        return InitialSpeed(TURNING)

    def start(self, count: int) -> NDArray[np.float64]:
        """Of each agent: phase, its speed, offsets of the middle of the lane in which it goes back
        and of the right edge of the lane from which it comes, and its station one step before."""
        import numpy as np

        return np.zeros((count, 5))

    def controls(self, observations: ObservationBatch, state: NDArray[np.float64]) -> ControlBatch:
        import numpy as np

        from roadlang.api import ControlBatch

        seen = observations
        near = seen.nearby(SIGHT)
        coming = state[:, _PHASE] == COMING
        lane = seen.lane_place()
        width = np.where(np.isfinite(lane.width), lane.width, LANE_WIDTH)
        right = np.where(np.isfinite(lane.offset), lane.offset, seen.road_offset) - 0.5 * width
        drives_on = coming & ~self._has_room(seen, right, width)
        waits = coming & ((seen.speed > TURNING) | self._has_to_wait(seen, near)) & ~drives_on
        begins = coming & ~waits & ~drives_on
        state[begins, _RIGHT] = right[begins]
        state[begins, _PACE], state[begins, _PHASE] = seen.speed[begins], FORWARD
        pose = self._driven(seen, near, state, width)
        pose[waits | drives_on] = np.nan
        acceleration = np.where(drives_on, np.nan, np.where(waits, -BRAKING, 0.0))
        return ControlBatch(np.full(len(waits), np.nan), acceleration, pose=pose)

    def _has_room(self, seen: ObservationBatch, right: Floats, width: Floats) -> Booleans:
        """(N,) whether it can move to and fro standing across the lanes, at worst diagonally.
        `right`: offset of the right edge of the lane from which it comes."""
        import numpy as np

        left = _left_edge(self._lanes_back(seen), right, width)
        needed = np.hypot(seen.length, seen.width) + 2.0 * EDGE + SHUNT
        return np.asarray(left - right >= needed)

    def _has_to_wait(self, seen: ObservationBatch, near: Neighbors) -> Booleans:
        """(N,) whether somebody who comes toward the agent, or from behind beside it, will soon be
        there."""
        import numpy as np

        if self.wait_for != "gap":
            return np.zeros(len(seen.x), dtype=bool)
        reach = np.abs(near.pace) * CLEAR_TIME
        oncoming = (near.pace < -0.5) & (near.ahead > -seen.length[:, None]) & (near.ahead < reach)
        beside = near.left > 0.5 * (seen.width[:, None] + near.width)
        behind = (near.pace > 0.5) & (near.ahead < 0.0) & (-near.ahead < reach) & beside
        return np.asarray((near.there & (oncoming | behind)).any(axis=1))

    def _lanes_back(self, seen: ObservationBatch) -> Floats:
        """(LANES, N) offsets of the middles of the lanes of the other direction, from the middle of
        the road outward; NaN for none."""
        import numpy as np

        out = np.full((LANES, len(seen.x)), np.nan)
        for lane in (*range(-LANES, 0), *range(1, LANES + 1)):
            goes_back = seen.direction_of_lane(lane) < 0.0
            row = abs(lane) - 1
            out[row] = np.where(goes_back, seen.offset_of_lane(lane), out[row])
        return out

    def _driven(
        self, seen: ObservationBatch, near: Neighbors, state: Floats, width: Floats
    ) -> Floats:
        """(N, 4) x, y, heading and speed at the end of the step."""
        import numpy as np

        phase, pace = state[:, _PHASE].copy(), state[:, _PACE].copy()
        returns = (phase == RETURNING) | (phase == ENDED)
        lanes = self._lanes_back(seen)
        error = seen.heading_error % (2.0 * np.pi)
        sharpest = np.tan(STEERING) / seen.wheelbase
        way = np.where(phase == BACKWARD, -1.0, 1.0)
        bend = np.where(returns, self._bend_back(seen, state, error, sharpest), way * sharpest)
        stop = way * (pace * pace / (2.0 * BRAKING) + pace * seen.step + EDGE)
        then = arc_move(seen, stop, bend)
        high, low = lateral_reach(seen, then)
        most = _left_edge(lanes, state[:, _RIGHT], width) - EDGE
        over = ~returns & np.where(way > 0.0, high > most, low < state[:, _RIGHT] + EDGE)
        limit = np.where(phase == BACKWARD, BACKING, TURNING)
        limit = np.where(phase == RETURNING, self._speed_back(seen, near), limit)
        turned = ~returns & (error > np.pi - STRAIGHTENING) & (error < 1.5 * np.pi)
        stops = over | (phase == ENDED) | (turned & (phase == BACKWARD))
        limit = np.where(stops | touches(seen, near, then), 0.0, limit)
        faster = np.minimum(pace + ACCELERATION * seen.step, limit)
        pace = np.maximum(faster, np.maximum(pace - BRAKING * seen.step, 0.0))
        pose = arc_move(seen, way * pace * seen.step, bend)
        pose[:, 3] = way * pace
        done = turned & ((phase == FORWARD) | (pace < STANDING))
        switches = over & (pace < STANDING) & ~turned
        state[switches, _PHASE] = (FORWARD + BACKWARD - phase)[switches]
        state[done, _PHASE] = RETURNING
        state[done, _MIDDLE] = _nearest(lanes, seen.road_offset, state[:, _RIGHT] + 0.5 * width)[
            done
        ]
        stays = np.abs(seen.station - state[:, _STATION]) < 0.1 * pace * seen.step
        state[(phase == RETURNING) & stays & (pace > 1.0), _PHASE] = ENDED
        state[:, _PACE], state[:, _STATION] = pace, seen.station
        return pose

    def _bend_back(
        self, seen: ObservationBatch, state: Floats, error: Floats, sharpest: Floats
    ) -> Floats:
        """(N,) curvature of the arc to a point ahead in the lane in which it goes back."""
        import numpy as np

        aside = seen.road_offset - state[:, _MIDDLE]
        turned = difference(np.full(len(error), np.pi), error)
        bearing = np.arctan2(aside, LOOKAHEAD) - turned
        bend = 2.0 * np.sin(bearing) / np.hypot(LOOKAHEAD, aside)
        return np.minimum(np.maximum(bend, -sharpest), sharpest)

    def _speed_back(self, seen: ObservationBatch, near: Neighbors) -> Floats:
        """(N,) the target speed on the way back: no faster than it can stop behind who is ahead, or
        where a road along which it came begins."""
        import numpy as np

        place = seen.lane_place()
        limit = np.where(np.isfinite(place.speed_limit), place.speed_limit, place.default_speed)
        speed = limit if self.speed is None else np.zeros(len(limit)) + self.speed
        beside = np.abs(near.left) < 0.5 * (seen.width[:, None] + near.width) + BESIDE
        gap = -near.ahead - 0.5 * (seen.length[:, None] + near.length) - GAP
        there = near.there & beside & (near.ahead < 0.0)
        ahead = np.maximum(-near.pace, 0.0)
        safe = np.sqrt(ahead * ahead + BRAKING * np.maximum(gap, 0.0))
        left = np.where(place.road_direction > 0.0, seen.station - seen.length, np.inf)
        speed = np.minimum(speed, np.sqrt(BRAKING * np.maximum(left, 0.0)))
        behind = np.where(there, safe, np.inf).min(axis=1, initial=np.inf)
        return np.asarray(np.minimum(speed, behind))


def _left_edge(lanes: Floats, right: Floats, width: Floats) -> Floats:
    """(N,) offset of the left edge of the lanes that it may use: of those of the other direction,
    whose middles are at the offsets (L, N), or where there are none of its own."""
    import numpy as np

    edge = np.fmax.reduce(lanes, axis=0) + 0.5 * width
    return np.where(np.isfinite(edge), edge, right + width)


def _nearest(lanes: Floats, offset: Floats, other: Floats) -> Floats:
    """(N,) of the offsets (L, N) the one nearest to `offset`; `other` where there is none."""
    import numpy as np

    away = np.where(np.isnan(lanes), np.inf, np.abs(lanes - offset))
    found = np.take_along_axis(lanes, away.argmin(axis=0)[None], axis=0)[0]
    return np.where(np.isnan(found), other, found)
