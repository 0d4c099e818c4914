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
    green: Duration = option(20.0, above=0, maximum=600, help="time of green in each phase")
    yellow: Duration = option(3.0, minimum=0, maximum=60, help="time of yellow after it")
    all_red: Duration = option(
        2.0, minimum=0, maximum=60, help="time until the next phase in which all have red"
    )
    offset: Duration = option(
        0.0,
        minimum=0,
        help="time of the first phase that has passed when the drive begins",
        example="0s..40s",
    )

    def right_of_way(self, junction: Junction) -> RightOfWay:
        """Phases of equal length."""
        phases = tuple(
            SignalPhase(group, self.green, self.yellow, self.all_red)
            for group in signal_phases(junction)
        )
        return RightOfWay("signals", (), phases, self.offset)
