"""`drive with crossing`: walk straight across the road."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Controller, InitialSpeed, Length, Speed, Word, option

from .gaps_on_foot import blocked_by_vehicle, has_gap

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from roadlang.api import ControlBatch, ObservationBatch

WITHOUT_ROAD = 10.0
"""Meters to walk where there is no road to cross."""


@dataclass(frozen=True)
class Crossing(Controller):
    """Cross the road at a right angle and stop on the other side. Once it walks, it does not
    yield, but does not walk into the side of a vehicle either, and goes around one that stands."""

    name: ClassVar[str] = "crossing"
    also_called: ClassVar[tuple[str, ...]] = ("cross", "CrossingBehavior")
    speed: Speed = option(1.4, above=0, maximum=20, help="walking speed")
    beyond: Length = option(1.0, minimum=0, help="distance to walk past the opposite edge")
    wait_for: Word = option(
        "nothing",
        words=("gap", "nothing"),
        help="whether it first waits for a gap in traffic",
    )

    def initial_speed(self) -> InitialSpeed:
        return InitialSpeed(0.0 if self.wait_for == "gap" else self.speed)

    def start(self, count: int) -> NDArray[np.float64]:
        """Of each agent: distance walked, distance to walk, heading (NaN before the start)."""
        import numpy as np

        return np.tile([0.0, 0.0, np.nan], (count, 1))

    def controls(self, observations: ObservationBatch, state: NDArray[np.float64]) -> ControlBatch:
        import numpy as np

        from roadlang.api import ControlBatch

        seen = observations
        new = np.isnan(state[:, 2])
        if new.any():
            _, _, along, _ = seen.line_ahead(0.0)
            left = seen.road_offset
            on_road = np.isfinite(seen.road_width)
            across = np.abs(left) + 0.5 * seen.road_width + self.beyond
            toward = along + np.where(left < 0.0, 0.5 * np.pi, -0.5 * np.pi)
            state[:, 1] = np.where(new, np.where(on_road, across, WITHOUT_ROAD), state[:, 1])
            state[:, 2] = np.where(new, np.where(on_road, toward, seen.heading), state[:, 2])
        blocked, aside = blocked_by_vehicle(seen, state[:, 2])
        walks = (state[:, 0] < state[:, 1]) & ~blocked
        speed = np.broadcast_to(np.asarray(self.speed, dtype=np.float64), walks.shape)
        begins = walks & (state[:, 0] == 0.0)
        if self.wait_for == "gap" and begins.any():
            walks &= ~begins | has_gap(seen, state[:, 2], state[:, 1], speed)
        pace = np.where(walks, self.speed, 0.0)
        state[:, 0] += pace * seen.step
        around = blocked & np.isfinite(aside) & (state[:, 0] > 0.0) & (state[:, 0] < state[:, 1])
        pace = np.where(around, self.speed, pace)
        heading = np.where(around, aside, state[:, 2])
        acceleration = (pace - seen.speed) / seen.step
        return ControlBatch(np.zeros(len(pace)), acceleration, heading)
