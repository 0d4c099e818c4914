"""`drive with traffic`: drive as traffic does, by limits, signals and right of way."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import STANDING_GAP, Controller, Duration, Flag, InitialSpeed, Speed, option

from .going_around import COLUMNS, going_around
from .steering import SPEED_GAIN, along_line, bend_speed, pursuit

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from roadlang.api import ControlBatch, ObservationBatch
    from roadlang.geometry import Floats

HARDEST = 8.0
"""m/s^2: deceleration in an emergency."""
LATE = 0.7
"""Share of the comfortable deceleration from which on cars brake evenly for a stop."""
MERGING = 1.5
"""Times the comfortable deceleration, with which cars make room for who goes first."""
LOOKAHEAD = 0.8
"""Seconds of its speed to the point that a very fast car steers to: far enough that it does not
weave, although a decision holds for `interval`."""
FAST, FASTEST = 40.0, 45.0
"""m/s: up to the first, cars keep to the line exactly; from the second on they steer to a point."""
NEAREST, FARTHEST = 0.1, 1e6
"""Meters: gaps count as no smaller and no larger."""
COOLNESS = 0.99
"""How far drivers trust that the vehicle ahead keeps its acceleration (1: wholly)."""
CAR_BASE = 3.5
"""Meters between the axles, from which on a vehicle takes bends the slower, and accelerates the
less, the longer it is."""
LEAST = 1.2
"""m/s^2: what others who cross or merge count on, of long vehicles too."""
FORESIGHT = 2.0
"""Seconds ahead at which a lower speed limit is obeyed, so that it holds where it begins."""


@dataclass(frozen=True)
class Traffic(Controller):
    """Drive like traffic: along its route, obeying speed limits, signals, stop lines and right
    of way, and keeping its distance to the vehicle ahead (enhanced intelligent driver model,
    Kesting, Treiber and Helbing 2010)."""

    name: ClassVar[str] = "traffic"
    also_called: ClassVar[tuple[str, ...]] = ("autopilot", "DriveAvoidingCollisions", "autonomous")
    interval: ClassVar[float] = 0.1
    keeps_distance: ClassVar[bool] = True
    for_vehicles: ClassVar[bool] = True
    speed: Speed | None = option(
        None, above=0, maximum=120, help="target speed; by default the speed limit"
    )
    speed_factor: float = option(
        1.0, above=0, maximum=2, help="target speed as a multiple of the limit", example="0.9..1.1"
    )
    headway: Duration = option(1.0, above=0, maximum=30, help="time gap to the vehicle ahead")
    politeness: float = option(
        0.5, minimum=0, maximum=1, help="how hard it brakes to let others merge"
    )
    aggression: float = option(
        0.5, minimum=0, maximum=1,
        help="how hard it accelerates, brakes and corners, and how small a gap it accepts",
    )  # fmt: skip

    go_around: Flag = option(
        True, help="go around objects in its lane, on the lane beside it where that is free"
    )

    def start(self, count: int) -> NDArray[np.float64]:
        """(count, 6) what agents do about objects in their lanes."""
        import numpy as np

        return np.zeros((count, len(COLUMNS)))

    def initial_speed(self) -> InitialSpeed:
        return InitialSpeed(self.speed, stops_at_junctions=True, limit_factor=self.speed_factor)

    def controls(self, observations: ObservationBatch, state: NDArray[np.float64]) -> ControlBatch:
        import numpy as np

        from roadlang.api import ControlBatch

        seen = observations
        boldness = np.asarray(self.aggression, dtype=np.float64)
        if boldness.shape != seen.speed.shape:
            boldness = np.full(seen.speed.shape, boldness)
        length = np.minimum(1.0, CAR_BASE / seen.wheelbase)
        most, braking = np.maximum((1.6 + 2.0 * boldness) * length, LEAST), 2.0 + 2.0 * boldness
        target = self._target(seen, braking)
        gap, pace, leading = self._next_ahead(seen)
        around = going_around(seen, state, target) if self.go_around else None
        target = target if around is None else np.minimum(target, around.speed)
        follow = Following(seen.speed, target, most, braking, self.headway)
        stop, merging, speed = seen.right_of_way(
            self.politeness, self.aggression, around and around.passing
        )
        stop = stop if around is None else np.minimum(stop, around.stop)
        # `np.array` takes a seventh of the time of `np.stack`.
        gaps = np.array((gap, merging, stop + STANDING_GAP))
        others = np.array((pace, speed, np.zeros(len(stop))))
        ahead, merges, gentle = follow.behind(gaps, others)
        ahead = follow.calmly(ahead, gap, pace, leading)
        ahead = np.minimum(ahead, np.maximum(merges, -MERGING * braking))
        ahead = np.minimum(ahead, follow.to_stop(stop, gentle))
        bends = bend_speed(seen, target, (2.0 + 3.0 * boldness) * length, braking)
        slower = np.maximum(SPEED_GAIN * (bends - seen.speed), -braking)
        acceleration = np.minimum(ahead, np.where(bends < target, slower, most))
        steering = _steering(seen)
        if around is None:
            return ControlBatch(steering, np.maximum(acceleration, -HARDEST))
        acceleration = np.minimum(acceleration, around.most)
        steering = np.where(around.creeps, around.steering, steering)
        return ControlBatch(
            steering, np.maximum(acceleration, -HARDEST),
            line_offset=around.line, line_time=around.time,
        )  # fmt: skip

    def _next_ahead(self, seen: ObservationBatch) -> tuple[Floats, Floats, Floats]:
        """(N,) gap, speed and acceleration of the next vehicle. Who is stranded is an object for
        those that go around."""
        if self.go_around:
            return seen.moving_ahead()
        return (*seen.vehicle_ahead(), seen.acceleration_ahead())

    def _target(self, seen: ObservationBatch, braking: Floats) -> Floats:
        """(N,) target speeds: as said, or by the limits from here on."""
        import numpy as np

        if self.speed is not None:
            return np.broadcast_to(np.asarray(self.speed, dtype=np.float64), seen.speed.shape)
        limit = seen.speed_limit_ahead(0.5 * braking, 0.0)
        # The speed comes after its target by about a second.
        soon = seen.speed_limit_ahead(0.5 * braking, FORESIGHT * seen.speed)
        limit = np.minimum(limit, soon)
        if np.count_nonzero(np.isfinite(limit)) < len(limit):
            limit = np.where(np.isfinite(limit), limit, seen.lane_place().default_speed)
        return np.asarray(limit * self.speed_factor)


def _steering(seen: ObservationBatch) -> Floats:
    """(N,) exact up to the speeds of motorways, calm beyond."""
    import numpy as np

    exact = along_line(seen)
    share = np.minimum(np.maximum((seen.speed - FAST) / (FASTEST - FAST), 0.0), 1.0)
    if not np.count_nonzero(share):
        return exact
    calm = pursuit(seen, LOOKAHEAD * np.maximum(seen.speed, FAST))
    return np.asarray((1.0 - share) * exact + share * calm)


@dataclass(frozen=True)
class Following:
    """The improved intelligent driver model: (N,) accelerations of agents."""

    speed: Floats
    target: Floats
    most: Floats
    """m/s^2"""
    braking: Floats
    """comfortable, m/s^2"""
    headway: Floats | float

    @cached_property
    def free(self) -> Floats:
        """With nobody ahead: toward the target speed."""
        import numpy as np

        speed = np.maximum(self.speed, NEAREST)
        share = speed / self.target
        square = share * share
        rises = self.most * (1.0 - square * square)
        power = 4.0 * self.most / self.braking
        falls = -self.braking * (1.0 - np.exp(-power * np.log(np.maximum(share, 1.0))))
        return np.where(share <= 1.0, rises, falls)

    def behind(self, gap: Floats, ahead: Floats) -> Floats:
        """(..., N) with somebody at a gap ahead (infinite: nobody), at that speed."""
        import numpy as np

        closing = self.speed * (self.speed - ahead)
        closing = closing / (2.0 * np.sqrt(self.most * self.braking))
        wanted = STANDING_GAP + np.maximum(0.0, self.speed * self.headway + closing)
        need = wanted / np.maximum(gap, NEAREST)
        free = self.free
        close = self.most * (1.0 - need * need)
        rises = np.maximum(free, 1e-3)
        power = 2.0 * self.most / rises
        log = np.log(np.maximum(np.minimum(need, 1.0), 1e-9))
        far = np.where(free > 0.0, rises * (1.0 - np.exp(power * log)), free)
        over = self.speed > self.target
        return np.where(need >= 1.0, np.where(over, free + close, close), far)

    def calmly(self, braking: Floats, gap: Floats, ahead: Floats, leading: Floats) -> Floats:
        """(N,) what `behind` gives for somebody at a speed and acceleration, but where that is less
        than is needed if both keep their accelerations (constant-acceleration heuristic), little
        less than that: after somebody has changed into the lane, the gap may stay small for a while
        (Kesting, Treiber and Helbing 2010, equations 2.5 and 2.8)."""
        import numpy as np

        leading = np.where(np.isfinite(gap), np.minimum(leading, self.most), 0.0)
        gap = np.minimum(np.maximum(gap, NEAREST), FARTHEST)
        ahead = np.maximum(ahead, 0.0)
        closing = self.speed - ahead
        stops = ahead * closing < -2.0 * gap * leading  # the other stands before they would meet
        way = np.where(stops, ahead * ahead - 2.0 * gap * leading, 1.0)
        both = self.speed * self.speed * leading / way
        needed = leading - np.maximum(closing, 0.0) * closing / (2.0 * gap)
        needed = np.where(stops, both, needed)
        lack = self.braking * np.tanh((braking - needed) / self.braking)
        calm = (1.0 - COOLNESS) * braking + COOLNESS * (needed + lack)
        # Who is too fast for the road brakes as it would alone.
        return np.where(braking >= needed, braking, np.minimum(calm, self.free))

    def to_stop(self, distance: Floats, gentle: Floats) -> Floats:
        """With a place ahead at which to stand, at a distance (infinite: none). `gentle`: with
        somebody who stands there."""
        import numpy as np

        even = 0.5 * self.speed * self.speed / np.maximum(distance, 0.05)
        late = (even > LATE * self.braking) | (distance < 0.0)
        return np.where(late, np.minimum(gentle, -even), gentle)
