"""`control with signals`: lights that change with time."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Duration, JunctionControl, RightOfWay, SignalPhase, option
from roadlang.geometry import signal_phases

if TYPE_CHECKING:
    from roadlang.geometry import Junction


@dataclass(frozen=True)
class Signals(JunctionControl):
    """Traffic signals: opposite roads have green together, every other road alone."""

    name: ClassVar[str] = "signals"
    also_called: ClassVar[tuple[str, ...]] = ("traffic_lights", "traffic_light", "lights")
    green: Duration = option(20.0, above=0, maximum=600, help="green time of each phase")
    yellow: Duration = option(3.0, minimum=0, maximum=60, help="yellow time after each green")
    all_red: Duration = option(
        2.0, minimum=0, maximum=60, help="time after yellow during which all signals are red"
    )
    offset: Duration = option(
        0.0,
        minimum=0,
        help="time into the cycle at which the drive starts",
        example="0s..40s",
    )

    def right_of_way(self, junction: Junction) -> RightOfWay:
        """Phases of equal length."""
        phases = tuple(
            SignalPhase(group, self.green, self.yellow, self.all_red)
            for group in signal_phases(junction)
        )
        return RightOfWay("signals", (), phases, self.offset)
