"""What was recorded while a scene was driven: one time axis, a pose and more for each agent."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, fields
from typing import TYPE_CHECKING, Any

from ..diagnostics.renamed_names import OldName
from .controller_failure import ControllerFailure, controller_failures
from .read_only import Frozen

if TYPE_CHECKING:
    from ..geometry.arrays import Booleans, Floats
    from .scene import SceneActor


def _unknown() -> Floats:
    import numpy as np

    return np.array(np.nan)


@dataclass(frozen=True)
class AgentTrace(Frozen):
    """One agent (or object) over the T steps of a drive; arrays are (T,), SI units, radians.

    `station` is arc length along the agent's own road, `cross_track_error` the signed distance from
    the line it should follow (left positive), `progress` the share of the road driven (0 to 1),
    `contacts` the number of bodies touched, not counting the ground.

    `road` is the number of the road in the scene (-1 inside a junction), `lane` the id of the lane
    of its center, `lane_offset` the distance from the middle of that lane (left positive, as the
    agent travels), `route_progress` meters driven along its route, `speed_limit` that of the lane
    (infinite for none), `off_road` how far the footprint sticks out of the drivable area (negative
    within), `red_light` the number of stop lines crossed at red so far, `collision` the speed of
    the hardest impact so far, 0 before the first, `present` 1 and, once it has left at the end of
    its road or route, 0, `elevation` meters of the ground below it, where roads of the scene have
    heights. What an engine does not report is NaN throughout, and a signal of it is
    refused with a diagnostic.
    """

    name: str
    time: Floats
    x: Floats
    y: Floats
    heading: Floats
    speed: Floats
    acceleration: Floats
    steering: Floats
    station: Floats
    cross_track_error: Floats
    progress: Floats
    contacts: Floats
    length: float = 4.5
    width: float = 1.8
    road: Floats = field(default_factory=_unknown)
    lane: Floats = field(default_factory=_unknown)
    lane_offset: Floats = field(default_factory=_unknown)
    route_progress: Floats = field(default_factory=_unknown)
    speed_limit: Floats = field(default_factory=_unknown)
    off_road: Floats = field(default_factory=_unknown)
    red_light: Floats = field(default_factory=_unknown)
    collision: Floats = field(default_factory=_unknown)
    present: Floats = field(default_factory=_unknown)
    elevation: Floats = field(default_factory=_unknown)

    def __post_init__(self) -> None:
        for name in _OPTIONAL:
            value = getattr(self, name)
            if getattr(value, "ndim", 0) == 0:
                import numpy as np

                object.__setattr__(self, name, np.broadcast_to(value, self.time.shape))
        Frozen.__post_init__(self)

    def __repr__(self) -> str:
        return f"<trace of {self.name}: {len(self.time)} samples>"

    @classmethod
    def recorded(
        cls, actor: SceneActor | AgentTrace, time: Floats, column: Callable[[str], Floats]
    ) -> AgentTrace:
        """Of an agent whose `column`s, by the names of the members, are read when they are first
        needed; they are read-only."""
        trace: AgentTrace = object.__new__(cls)
        trace.__dict__.update(
            name=actor.name, time=time, length=actor.length, width=actor.width, _column=column
        )
        return trace

    if not TYPE_CHECKING:  # where it would hide what is no member

        def __getattr__(self, name: str) -> Floats:
            column = self.__dict__.get("_column")
            if column is None or name not in self.__dataclass_fields__:
                raise AttributeError(f"an agent's trace has no member `{name}`")
            values = self.__dict__[name] = column(name)
            return values

    def __getstate__(self) -> dict[str, Any]:
        return {field_.name: getattr(self, field_.name) for field_ in fields(self)}

    still = OldName("standing")
    """deprecated: now `standing`"""

    @classmethod
    def standing(cls, actor: SceneActor, time: Floats, elevation: float = math.nan) -> AgentTrace:
        """An agent that does not move, at its place in the scene at all times (T,), `elevation`
        meters high."""
        import numpy as np

        zero = np.zeros(len(time))
        return cls(
            name=actor.name,
            time=time,
            x=zero + actor.x,
            y=zero + actor.y,
            heading=zero + actor.heading,
            speed=zero,
            acceleration=zero,
            steering=zero,
            station=zero + (actor.start or 0.0),
            cross_track_error=zero + (actor.offset or 0.0),
            progress=zero,
            contacts=zero,
            route_progress=zero,
            red_light=zero,
            collision=zero,
            present=zero + 1.0,
            elevation=zero + elevation,
            length=actor.length,
            width=actor.width,
        )

    @property
    def has_left(self) -> Booleans:
        """(T,) whether it has left; always False if the engine does not report it."""
        gone: Booleans = self.present == 0.0
        return gone

    @property
    def samples_there(self) -> int:
        """Number of samples before it leaves."""
        left = self.has_left
        return int(left.argmax()) if left.any() else len(self.time)


_OPTIONAL = tuple(
    field_.name for field_ in fields(AgentTrace) if field_.default_factory is _unknown
)


@dataclass(frozen=True)
class Trace(Frozen):
    """A whole drive. `time` is (T,) seconds from 0; a group's copies are `name[i]`. `inputs`: of
    agents that a human drove (n, 3) time, steering angle and acceleration that were wanted."""

    time: Floats
    agents: Mapping[str, AgentTrace]
    engine: str = ""
    events: tuple[Mapping[str, Any], ...] = field(default_factory=tuple)
    inputs: Mapping[str, Floats] = field(default_factory=dict)

    def __repr__(self) -> str:
        seconds = float(self.time[-1]) if len(self.time) else 0.0
        return f"<trace of {', '.join(self.agents) or 'no agent'}: {seconds:.6g} s>"

    @property
    def controller_failures(self) -> tuple[ControllerFailure, ...]:
        """The controllers that failed while the drive went on, in the order of their times."""
        return controller_failures(self.events)

    def named(self, name: str) -> tuple[AgentTrace, ...]:
        """The agents that a name stands for: itself, or all copies `name[i]`."""
        if name in self.agents:
            return (self.agents[name],)
        return tuple(agent for key, agent in self.agents.items() if key.startswith(f"{name}["))
