"""What a controller written in Python sees, once a step: of one agent, or of many."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, fields
from typing import TYPE_CHECKING, Any

from ..diagnostics.renamed_names import OldName
from .read_only import Frozen
from .readings import Reading, Readings, batch_of_one
from .surroundings import (
    LaneChoice,
    LanePlace,
    LanePlaces,
    LanesBeside,
    Neighbor,
    Neighbors,
    curvatures_ahead,
    nearest_of,
    points_ahead,
)

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from ..geometry.arrays import Booleans, Floats, Integers

_FREE = (math.inf, math.inf, 0.0)
_NO_JUNCTION = (math.inf, 0.0, math.inf)


@dataclass(frozen=True, slots=True)
class Observation(Frozen):
    """The state of one agent, in SI units and radians. The line is the path that it should follow.

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
    """all agents by name, including this one; their own `others` are empty"""
    road_offset: float = 0.0
    """distance from the center line of the road, left positive"""
    road_width: float = math.inf
    speed_for_bends: Callable[[float, float, float], float] = lambda lateral, braking, on: math.inf
    """`speed_for_bends(a, b, d)`: the greatest speed, `d` meters on, from which the bends of the
    line ahead can be driven with a lateral acceleration of at most `a`, braking before them with
    `b`"""
    vehicle_ahead: Callable[[], tuple[float, float]] = lambda: (math.inf, 0.0)
    """`vehicle_ahead()`: gap to the next agent ahead in the lane, and its speed along it"""
    acceleration_ahead: Callable[[], float] = lambda: 0.0
    """acceleration of the vehicle ahead, along the lane"""
    obstacle_ahead: Callable[[], float] = lambda: math.inf
    """`obstacle_ahead()`: gap to the next object in the way"""
    lane_end: Callable[[], float] = lambda: math.inf
    """`lane_end()`: how far ahead of the center its lane becomes too narrow to drive in"""
    length: float = 4.5
    width: float = 1.8
    max_steering: float = 0.61
    """as far as the front wheels turn to either side"""
    yaw_rate: float = 0.0
    acceleration: float = 0.0
    """along the body"""
    contacts: float = 0.0
    """number of contacts so far"""
    traveled: float = 0.0
    """meters along the line since the start of the drive"""
    lane_place: Callable[[], LanePlace] = LanePlace
    """its place among the lanes: `lane`, `lane_offset`, `lane_width` and `speed_limit`"""
    offset_of_lane: Callable[[LaneChoice], float] = lambda lane: math.nan
    """`offset_of_lane(-2)`, `offset_of_lane("left")`: how far left of its reference line
    (see `LanePlace`) the middle of a lane is here; NaN where there is none"""
    direction_of_lane: Callable[[LaneChoice], float] = lambda lane: math.nan
    """of its traffic: 1 as the agent goes, -1 against it, 0 for both or none; NaN for no lane"""
    speed_limit_ahead: Callable[[float, float], float] = lambda braking, on: math.inf
    """`speed_limit_ahead(b, d)`: the greatest speed, `d` meters on, from which the speed limits
    ahead can be obeyed by braking with `b`"""
    stop_ahead: Callable[[], float] = lambda: math.inf
    """`stop_ahead()`: distance from the front to where it has to stop, infinite for nowhere; an
    agent that calls it obeys"""
    right_of_way: Callable[[float, float], tuple[float, float, float]] = lambda polite, bold: _FREE
    """`right_of_way(p, a)`: what `stop_ahead` says, and where lanes merge the gap to who goes first
    there, infinite for nobody, and its speed; politeness and aggression are from 0 to 1"""
    junction_ahead: Callable[[], tuple[float, float, float]] = lambda: _NO_JUNCTION
    """`junction_ahead()`: how far ahead of its front its next junction begins, negative inside,
    infinite for none; the length of its path inside; and the seconds until the signal turns red,
    infinite for never"""
    nearby: Callable[[float], tuple[Neighbor, ...]] = lambda range: ()
    """`nearby(r)`: the agents and objects within `r` meters, from center to center"""
    sensors: Mapping[str, Reading] = field(default_factory=dict)
    """the readings of the sensors of the agent, by name: `sensors["front"].rgb`"""

    @property
    def lane(self) -> int:
        """Id of the lane of the agent, 0 for none."""
        return self.lane_place().lane

    @property
    def lane_offset(self) -> float:
        """Offset of the middle of that lane to the left of the reference line."""
        return self.lane_place().offset

    @property
    def lane_width(self) -> float:
        """Of that lane."""
        return self.lane_place().width

    @property
    def speed_limit(self) -> float:
        """Speed limit of that lane, infinite without one."""
        return self.lane_place().speed_limit


def _no_row(line: Floats, space: float) -> tuple[Floats, Floats, Floats]:
    nothing = line * math.nan
    return nothing, nothing, nothing


def _nothing_ahead(first: Floats | Booleans, second: Floats | Booleans) -> Floats:
    import numpy as np

    return np.full(len(first), math.inf)


def _nobody_ahead() -> tuple[Floats, Floats, Floats]:
    import numpy as np

    return np.array([math.inf]), np.zeros(1), np.zeros(1)


def _no_lanes(ahead: Floats, line: Floats) -> LanesBeside:
    nothing = line * math.nan
    return LanesBeside(*[nothing] * 6)


@dataclass(frozen=True, slots=True)
class ObservationBatch:
    """The states of N agents: columns (N,) of what `Observation` says of one, during the call."""

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
    acceleration_ahead: Callable[[], Floats]
    obstacle_ahead: Callable[..., Floats]
    """`obstacle_ahead(l)`: also in the way of lines `l` (N,) left of the reference lines"""
    lane_end: Callable[[], Floats]
    length: Floats
    width: Floats
    max_steering: Floats
    yaw_rate: Floats
    acceleration: Floats
    contacts: Floats
    traveled: Floats
    lane_place: Callable[[], LanePlaces]
    offset_of_lane: Callable[[LaneChoice | Floats], Floats]
    """of each agent; ids may be a column (N,)"""
    direction_of_lane: Callable[[LaneChoice | Floats], Floats]
    speed_limit_ahead: Callable[[Floats | float, Floats | float], Floats]
    stop_ahead: Callable[[], Floats]
    right_of_way: Callable[..., tuple[Floats, Floats, Floats]]
    """`right_of_way(p, a, passing)`: who is `passing` objects (N,) does not stop for them"""
    junction_ahead: Callable[[], tuple[Floats, Floats, Floats]]
    nearby: Callable[[float], Neighbors]
    path_ahead: Callable[[Floats], tuple[Floats, Floats]]
    """`path_ahead(d)`: (K, N) x and y of those lines, at distances (K,)"""
    curvatures_ahead: Callable[[Floats], Floats]
    """`curvatures_ahead(d)`: (K, N) curvatures of those lines, at distances (K, N)"""
    nearest: Callable[[int], tuple[Floats, Floats, Floats, Floats]]
    """`nearest(n)`: (N, n) x, y, heading and speed of the nearest others; NaN: no more of them"""
    row_ahead: Callable[[Floats, float], tuple[Floats, Floats, Floats]] = _no_row
    """`row_ahead(l, s)`: of the next object in the way of lines `l` (N,) left of the reference
    line, and of those behind it with no room for the agent and `s` meters between: how far from the
    front they end, and how far left of the reference line their sides are; NaN for none"""
    moving_ahead: Callable[[], tuple[Floats, Floats, Floats]] = _nobody_ahead
    """`moving_ahead()`: gap to the next agent ahead in the lane that is not stranded, its speed and
    its acceleration along the lane. Those that stand there and wait for nothing, and those that had
    a crash, count as objects from then on"""
    touches_ahead: Callable[[Booleans, Booleans], Floats] = _nothing_ahead
    """`touches_ahead(l, c)`: meters until those that leave their lines (N,) would touch an object,
    infinite for none; who creeps (N,) goes on as it steers now"""
    comes_toward: Callable[[Floats, Floats], Floats] = _nothing_ahead
    """`comes_toward(l, d)`: seconds until another vehicle may come the other way on the line `l`
    (N,) left of the reference line, `d` (N,) meters ahead or less; infinite for nobody"""
    lanes_beside: Callable[[Floats, Floats], LanesBeside] = _no_lanes
    """`lanes_beside(d, l)`: the lanes `d` (N,) meters ahead at lines `l` (N,), and beside"""
    sensors: Mapping[str, Reading] = field(default_factory=dict)
    """the readings of sensors that all N agents have, by name; arrays have a leading axis N"""
    of_one = OldName("of_single")
    """deprecated: now `of_single`"""

    @property
    def lane(self) -> Integers:
        """Ids of the lanes in which the agents are, 0 for none."""
        return self.lane_place().lane

    @property
    def lane_offset(self) -> Floats:
        """Of the middle of those lanes, left of the reference lines."""
        return self.lane_place().offset

    @property
    def lane_width(self) -> Floats:
        """Of those lanes."""
        return self.lane_place().width

    @property
    def speed_limit(self) -> Floats:
        """Of those lanes, infinite where there is none."""
        return self.lane_place().speed_limit

    @classmethod
    def number_columns(cls) -> tuple[str, ...]:
        """The names of its columns of numbers."""
        return tuple(field_.name for field_ in fields(cls) if field_.type == "Floats")

    @classmethod
    def of_single(cls, seen: Observation) -> ObservationBatch:
        """A batch of one agent."""
        import numpy as np

        def column(value: float) -> Floats:
            return np.array([value], dtype=np.float64)

        def first(value: Floats | float) -> float:
            return float(np.ravel(value)[0])

        def columns(values: tuple[float, ...]) -> Any:
            return tuple(column(value) for value in values)

        def lane(which: LaneChoice | Floats) -> LaneChoice:
            return which if isinstance(which, str | int) else round(first(which))

        return cls(
            **{name: column(getattr(seen, name)) for name in cls.number_columns()},
            step=seen.step,
            agent=np.array([seen.agent], dtype=object),
            line_ahead=lambda distance: columns(seen.line_ahead(first(distance))),
            speed_for_bends=lambda *limits: column(seen.speed_for_bends(*map(first, limits))),
            vehicle_ahead=lambda: columns(seen.vehicle_ahead()),
            acceleration_ahead=lambda: column(seen.acceleration_ahead()),
            obstacle_ahead=lambda line=None: column(seen.obstacle_ahead()),
            lane_end=lambda: column(seen.lane_end()),
            lane_place=lambda: LanePlaces.of_single(seen.lane_place()),
            offset_of_lane=lambda which: column(seen.offset_of_lane(lane(which))),
            direction_of_lane=lambda which: column(seen.direction_of_lane(lane(which))),
            speed_limit_ahead=lambda *at: column(seen.speed_limit_ahead(*map(first, at))),
            stop_ahead=lambda: column(seen.stop_ahead()),
            right_of_way=lambda *temper: columns(seen.right_of_way(*map(first, temper[:2]))),
            junction_ahead=lambda: columns(seen.junction_ahead()),
            nearby=lambda range: Neighbors.of_single(seen.nearby(range)),
            path_ahead=lambda distances: points_ahead(seen.line_ahead, distances),
            curvatures_ahead=lambda distances: curvatures_ahead(seen.line_ahead, distances),
            nearest=lambda count: nearest_of(seen, seen.others, count),
            row_ahead=_no_row,
            moving_ahead=lambda: columns((*seen.vehicle_ahead(), seen.acceleration_ahead())),
            touches_ahead=_nothing_ahead,
            comes_toward=_nothing_ahead,
            lanes_beside=_no_lanes,
            sensors=Readings({name: batch_of_one(one) for name, one in seen.sensors.items()}),
        )
