"""What a controller written in Python gets and gives, once a step: for one agent, or for many."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from .read_only import Frozen

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from ..geometry.arrays import Floats


@dataclass(frozen=True, slots=True)
class Observation(Frozen):
    """The state of one agent, SI units and radians; the line is the one that it should follow.

    `line_ahead(d)` gives x, y, heading and curvature of that line `d` meters on.
    """

    time: float
    step: float
    agent: str
    x: float
    y: float
    heading: float
    speed: float
    steering: float
    cross_track_error: float
    """distance from the line, left positive"""
    heading_error: float
    """own heading minus that of the line"""
    station: float
    wheelbase: float
    line_ahead: Callable[[float], tuple[float, float, float, float]]
    others: Mapping[str, Observation] = field(default_factory=dict)
    """all agents by name, this one too; theirs have no `others`"""
    road_offset: float = 0.0
    """distance from the center line of the road, left positive"""
    road_width: float = math.inf
    speed_for_bends: Callable[[float, float, float], float] = lambda lateral, braking, on: math.inf
    """`speed_for_bends(a, b, d)`: the greatest speed, `d` meters on, from which the bends of the
    line ahead can be driven with a lateral acceleration of at most `a`, braking before them with
    `b`"""
    vehicle_ahead: Callable[[], tuple[float, float]] = lambda: (math.inf, 0.0)
    """`vehicle_ahead()`: gap to the next agent ahead in the lane, and its speed along it"""


@dataclass(frozen=True, slots=True)
class Control:
    """Steering angle of the front wheels (left positive), acceleration (braking negative).

    What walks turns to `heading` at once, where that is a number.
    """

    steering: float
    acceleration: float
    heading: float = math.nan


@dataclass(frozen=True, slots=True)
class ObservationBatch:
    """The states of N agents: columns (N,) of what `Observation` says of one."""

    time: Floats
    step: float
    agent: NDArray[np.object_]
    """their names"""
    x: Floats
    y: Floats
    heading: Floats
    speed: Floats
    steering: Floats
    cross_track_error: Floats
    heading_error: Floats
    station: Floats
    wheelbase: Floats
    road_offset: Floats
    road_width: Floats
    line_ahead: Callable[[Floats | float], tuple[Floats, Floats, Floats, Floats]]
    """of each agent, a distance ahead: a number, or (N,)"""
    speed_for_bends: Callable[[Floats | float, Floats | float, Floats | float], Floats]
    vehicle_ahead: Callable[[], tuple[Floats, Floats]]

    @classmethod
    def of_one(cls, seen: Observation) -> ObservationBatch:
        """A batch of one agent."""
        import numpy as np

        def column(value: float) -> Floats:
            return np.array([value], dtype=np.float64)

        def first(value: Floats | float) -> float:
            return float(np.ravel(value)[0])

        def line_ahead(distance: Floats | float) -> tuple[Floats, Floats, Floats, Floats]:
            x, y, heading, curvature = seen.line_ahead(first(distance))
            return column(x), column(y), column(heading), column(curvature)

        def vehicle_ahead() -> tuple[Floats, Floats]:
            gap, speed = seen.vehicle_ahead()
            return column(gap), column(speed)

        return cls(
            time=column(seen.time),
            step=seen.step,
            agent=np.array([seen.agent], dtype=object),
            x=column(seen.x),
            y=column(seen.y),
            heading=column(seen.heading),
            speed=column(seen.speed),
            steering=column(seen.steering),
            cross_track_error=column(seen.cross_track_error),
            heading_error=column(seen.heading_error),
            station=column(seen.station),
            wheelbase=column(seen.wheelbase),
            road_offset=column(seen.road_offset),
            road_width=column(seen.road_width),
            line_ahead=line_ahead,
            speed_for_bends=lambda lateral, braking, on: column(
                seen.speed_for_bends(first(lateral), first(braking), first(on))
            ),
            vehicle_ahead=vehicle_ahead,
        )


@dataclass(frozen=True, slots=True)
class ControlBatch:
    """Columns (N,) of what `Control` says of one agent.

    Where `steering` is NaN, the last controller before this one that steers does. `heading` is for
    what walks: it turns there at once where that is not NaN.
    """

    steering: Floats
    acceleration: Floats
    heading: Floats | None = None
