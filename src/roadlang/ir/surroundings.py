"""What a controller sees around its agents: the lanes of their roads, and who else is near."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar, Protocol

from ..diagnostics.renamed_names import OldName

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from ..geometry.arrays import Booleans, Floats, Integers

DEFAULT_SPEED = 50 / 3.6
"""m/s: what agents drive where neither a scene nor a speed limit says how fast."""
LaneChoice = str | int
"""A lane as seen by an agent: its id, `left`, `right` (next to the agent's), `inner` (toward the
middle of the road and over it), `outer`, or a kind of lane: the nearest of that kind"""


@dataclass(frozen=True, slots=True)
class LanePlace:
    """The lane of an agent; lengths in meters. Offsets are to the left of its reference line, as
    `Observation.road_offset` is: the middle of its road or, on a route, of its lane."""

    default_speed: ClassVar[float] = DEFAULT_SPEED
    usual_speed = OldName("default_speed")
    """deprecated: now `default_speed`"""

    lane: int = 0
    """its id; 0: in none"""
    offset: float = math.nan
    """of its middle"""
    width: float = math.nan
    speed_limit: float = math.inf
    """m/s"""
    direction: float = math.nan
    """of its traffic: 1 as the agent goes, -1 against it, 0 for both or none"""
    road_direction: float = 1.0
    """of the agent: 1 along its road, -1 against it"""


@dataclass(frozen=True, slots=True)
class LanePlaces:
    """Columns (N,) of what `LanePlace` says of one agent."""

    default_speed: ClassVar[float] = DEFAULT_SPEED
    usual_speed = OldName("default_speed")
    """deprecated: now `default_speed`"""

    lane: Integers
    offset: Floats
    width: Floats
    speed_limit: Floats
    direction: Floats
    road_direction: Floats

    of_one = OldName("of_single")
    """deprecated: now `of_single`"""

    @classmethod
    def of_single(cls, place: LanePlace) -> LanePlaces:
        """Of one agent."""
        import numpy as np

        return cls(
            np.array([place.lane], dtype=np.int64),
            *(np.array([getattr(place, name)], dtype=np.float64) for name in _NUMBERS),
        )

    def single(self, row: int) -> LanePlace:
        """That of one agent."""
        return LanePlace(
            int(self.lane[row]), *(float(getattr(self, name)[row]) for name in _NUMBERS)
        )


@dataclass(frozen=True, slots=True)
class LanesBeside:
    """Columns (N,) of a lane and its neighboring lanes for motor vehicles: middles in meters to the
    left of the reference lines, and directions (1: that of the agent); NaN for no lane."""

    middle: Floats
    width: Floats
    left: Floats
    left_direction: Floats
    right: Floats
    right_direction: Floats


_NUMBERS = ("offset", "width", "speed_limit", "direction", "road_direction")


@dataclass(frozen=True, slots=True)
class Neighbor:
    """An agent or object near an agent. SI units and radians."""

    name: str
    kind: str
    """`car`, `tree`, ..."""
    x: float
    y: float
    heading: float
    speed: float
    length: float
    width: float
    ahead: float
    """from center to center, along the line of the agent, round bends too"""
    left: float
    """of the center of the agent, across that line"""
    pace: float
    """its speed along that line; negative for who comes toward the agent"""
    drift: float
    """its speed across that line, to the left"""
    walks: bool = False
    """whether it is on foot: a pedestrian or an animal"""


@dataclass(frozen=True, slots=True)
class Neighbors:
    """Columns (N, K) of what `Neighbor` says of one; `there` is False where there is none."""

    there: Booleans
    name: NDArray[np.object_]
    kind: NDArray[np.object_]
    x: Floats
    y: Floats
    heading: Floats
    speed: Floats
    length: Floats
    width: Floats
    ahead: Floats
    left: Floats
    pace: Floats
    drift: Floats
    walks: Booleans

    of_one = OldName("of_single")
    """deprecated: now `of_single`"""

    @classmethod
    def of_single(cls, seen: tuple[Neighbor, ...]) -> Neighbors:
        """Those of one agent, (1, K)."""
        import numpy as np

        types: dict[str, Any] = {"name": object, "kind": object, "walks": bool}
        columns = {
            name: np.array(
                [[getattr(neighbor, name) for neighbor in seen]],
                dtype=types.get(name, np.float64),
            ).reshape(1, len(seen))
            for name in _MEMBERS
        }
        return cls(np.ones((1, len(seen)), dtype=bool), **columns)

    def single(self, row: int) -> tuple[Neighbor, ...]:
        """Those of one agent."""
        import numpy as np

        def of(i: int) -> Neighbor:
            numbers = {name: float(getattr(self, name)[row, i]) for name in _MEMBERS[2:-1]}
            name, kind, walks = (getattr(self, word)[row, i] for word in ("name", "kind", "walks"))
            return Neighbor(name=str(name), kind=str(kind), walks=bool(walks), **numbers)

        return tuple(of(i) for i in np.flatnonzero(self.there[row]).tolist())


_MEMBERS = (
    "name", "kind", "x", "y", "heading", "speed", "length", "width", "ahead", "left", "pace",
    "drift", "walks",
)  # fmt: skip


def points_ahead(
    line_ahead: Callable[[float], tuple[float, float, float, float]], distances: Floats
) -> tuple[Floats, Floats]:
    """(K, 1) x and y of the line of one agent, `distances` (K,) ahead."""
    import numpy as np

    points = np.array([line_ahead(float(distance))[:2] for distance in distances])
    return points[:, :1], points[:, 1:]


def curvatures_ahead(
    line_ahead: Callable[[float], tuple[float, float, float, float]], distances: Floats
) -> Floats:
    """(K, 1) curvatures of the line of one agent, `distances` (K, 1) ahead."""
    import numpy as np

    return np.array([[line_ahead(float(distance))[3]] for distance in distances[:, 0]])


class _Placed(Protocol):
    """Where an agent is: an `Observation`."""

    @property
    def agent(self) -> str: ...
    @property
    def x(self) -> float: ...
    @property
    def y(self) -> float: ...
    @property
    def heading(self) -> float: ...
    @property
    def speed(self) -> float: ...


def nearest_of(
    seen: _Placed, everyone: Mapping[str, _Placed], count: int
) -> tuple[Floats, Floats, Floats, Floats]:
    """(1, count) x, y, heading and speed of those others that are nearest to an agent; NaN where
    there are no more."""
    import numpy as np

    others = [other for name, other in everyone.items() if name != seen.agent]
    others.sort(key=lambda other: (other.x - seen.x) ** 2 + (other.y - seen.y) ** 2)
    out = np.full((4, 1, count), math.nan)
    for number, other in enumerate(others[:count]):
        out[:, 0, number] = other.x, other.y, other.heading, other.speed
    return out[0], out[1], out[2], out[3]
