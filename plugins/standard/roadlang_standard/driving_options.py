"""What several controllers have in common: options with one meaning, default and limits, and how
fast they drive by them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from roadlang.api import Controller, InitialSpeed, option

from .steering import bend_speed

if TYPE_CHECKING:
    from roadlang.api import ObservationBatch
    from roadlang.geometry import Floats


def target_speed_option() -> Any:
    """`speed`: None where nothing is stated, so that the speed limit counts."""
    return option(
        None,
        minimum=0,
        maximum=120,
        help="target speed; by default the speed limit, or 50 km/h without one",
        example="40km/h",
        if_negative="`facing: back` in the block of the agent drives the other way, "
        "`drive with reverse` backs up",
    )


def lateral_acceleration_option() -> Any:
    """`lateral_acceleration`: how fast bends are taken."""
    return option(
        4.5, above=0, maximum=100, help="maximum lateral acceleration; it slows down before bends"
    )


class SlowsForBends(Controller):
    """A controller that drives at `speed`, and no faster than bends allow."""

    speed: float | None
    deceleration: float
    lateral_acceleration: float

    def initial_speed(self) -> InitialSpeed:
        return InitialSpeed(self.speed, self.lateral_acceleration, self.deceleration)

    def target_speed(self, seen: ObservationBatch) -> Floats:
        """(N,) m/s, as `bend_speed` has it."""
        return bend_speed(seen, self.speed, self.lateral_acceleration, self.deceleration)
