"""`drive with walk`: along the road, on the sidewalk or at the edge."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Controller, InitialSpeed, Length, Speed, Word, option

from .gaps_on_foot import blocked_by_vehicle, has_gap

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from roadlang.api import ControlBatch, ObservationBatch
    from roadlang.geometry import Floats

LOOKAHEAD = 2.0
"""Meters ahead in which who walks wants to be where it should be."""
CURB, NEAR_CURB = 0.8, 1.0
"""Meters beyond the end of a road at which who walks waits to cross the next, and on which it can
still decide to."""
ANEW = 2.0
"""Meters before a junction at which what was decided at the last one is forgotten."""
ON_ROAD = 0.6
"""Share of the way through a junction after which who walks is off the road."""
ROUND = 0.5
"""Radians: who keeps to the inside of such a turn stays at the corner, and crosses no road."""


@dataclass(frozen=True)
class Walk(Controller):
    """Walk along the road, in the direction that the agent faces: on the nearest sidewalk, or
    beside the edge of the road where there is none. With a `route` it crosses the roads at
    junctions, and does not walk into the side of a vehicle there."""

    name: ClassVar[str] = "walk"
    speed: Speed = option(1.4, above=0, maximum=20, help="walking speed")
    along: Word = option(
        "sidewalk",
        words=("sidewalk", "edge"),
        help="whether to walk on the sidewalk or beside the edge of the lanes for vehicles",
    )
    beyond: Length = option(
        0.5, minimum=-10, maximum=20, help="distance from the edge, where it walks beside that"
    )

    wait_for: Word = option(
        "green",
        words=("green", "gap", "nothing"),
        help="what it waits for before it crosses a road at a junction: a green signal, and where "
        "there is none a gap in traffic; always a gap; or nothing",
    )

    def initial_speed(self) -> InitialSpeed:
        return InitialSpeed(self.speed)

    def start(self, count: int) -> NDArray[np.float64]:
        """Of each agent: how far left of the line it walks, NaN before the start; whether it goes
        on across the junction; and for how long its signal was not red."""
        import numpy as np

        return np.tile([np.nan, 0.0, np.inf], (count, 1))

    def controls(self, observations: ObservationBatch, state: NDArray[np.float64]) -> ControlBatch:
        import numpy as np

        from roadlang.api import ControlBatch

        seen, place = observations, state[:, 0]
        aside = -seen.cross_track_error
        begins = np.isnan(place)
        if begins.any():
            place[:] = np.where(begins, self._place(seen), place)
            aside = np.where(begins, place - seen.road_offset, aside)
        _, _, along, _ = seen.line_ahead(0.0)
        heading = along + np.arctan(aside / LOOKAHEAD)
        waits = self.wait_for != "nothing" and self._waits(seen, along, state)
        pace = np.where(waits, 0.0, self.speed)
        acceleration = (pace - seen.speed) / seen.step
        zero = np.zeros(len(state))
        return ControlBatch(zero, acceleration, heading, line_offset=place.copy())

    def _waits(
        self, seen: ObservationBatch, along: Floats, state: NDArray[np.float64]
    ) -> NDArray[np.bool_]:
        """(N,) who stands at a curb and may not cross yet."""
        import numpy as np

        begins, length, green = seen.junction_ahead()
        place, goes, before = state.T
        goes[begins > ANEW] = 0.0
        at_curb = (begins <= -CURB) & (begins > -CURB - NEAR_CURB)
        deciding = at_curb & (goes == 0.0)
        if deciding.any():
            left = np.where(deciding, begins + length, 0.0)
            _, _, beyond, _ = seen.line_ahead(left)
            turned = np.arctan2(np.sin(beyond - along), np.cos(beyond - along))
            may = turned * np.sign(place) > ROUND
            by_signal = np.isfinite(green) & (self.wait_for == "green")
            speed = np.broadcast_to(np.asarray(self.speed, dtype=np.float64), left.shape)
            just_now = (green > 0.0) & (before == 0.0)
            may |= by_signal & ((green >= ON_ROAD * left / speed) | just_now)
            may |= ~by_signal & has_gap(seen, along, left, speed)
            goes[deciding & may] = 1.0
        before[:] = green
        waits = np.asarray(deciding & (goes == 0.0))
        crossing = (begins <= -CURB) & ~waits
        if crossing.any():
            waits |= crossing & blocked_by_vehicle(seen, along)[0]
        return waits

    def _place(self, seen: ObservationBatch) -> Floats:
        """(N,) how far left of the line to walk."""
        import numpy as np

        side = np.where(seen.road_offset < 0.0, -1.0, 1.0)
        edge = side * (0.5 * seen.road_width + self.beyond)
        place = np.where(np.isfinite(edge), edge, seen.road_offset)
        if self.along == "edge":
            return place
        sidewalk = seen.offset_of_lane("sidewalk")
        return np.where(np.isfinite(sidewalk), sidewalk, place)
