"""How near agents come to a collision: `time_to_collision(ego, lead)`, headway, encroachment."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import AgentOrObject, DriveSignal, geometry, option

from .headway import time_headway
from .separation import footprints, nearest

if TYPE_CHECKING:
    from roadlang.api import AgentTrace
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class TimeToCollision(DriveSignal):
    """Time until two agents or objects touch if both keep their velocity (Hayward 1972); infinite
    if they would not. For a group, of the member that touches first."""

    name: ClassVar[str] = "time_to_collision"
    unit: ClassVar[str] = "s"
    looks_back: ClassVar[float] = 0
    member: ClassVar[bool] = False
    first: AgentOrObject = option(help="an agent, an object or a group of them")
    second: AgentOrObject = option(help="another agent, object or group")

    def values(self) -> Floats:
        return nearest(self.first, self.second, _time_to_collision)


@dataclass(frozen=True)
class TimeHeadway(DriveSignal):
    """Time in which the first agent will be where the front of the second is now, along its lane
    (front to front over its own speed); infinite where the second is not ahead in its lane, or the
    first stands. For a group, to the nearest ahead.

    On one road stations and lanes say who is ahead; elsewhere, as across a junction, the arc of a
    circle from the heading of the first to the center of the second, where the second is headed
    along it."""

    name: ClassVar[str] = "time_headway"
    unit: ClassVar[str] = "s"
    looks_back: ClassVar[float] = 1
    member: ClassVar[bool] = False
    first: AgentOrObject = option(help="an agent or a group of them")
    second: AgentOrObject = option(help="another agent, object or group")

    def values(self) -> Floats:
        return nearest(self.first, self.second, time_headway)


@dataclass(frozen=True)
class PostEncroachmentTime(DriveSignal):
    """Time between one agent leaving a place and another reaching it (Allen et al. 1978): the least
    until now, infinite before that, and 0 from a collision on."""

    name: ClassVar[str] = "post_encroachment_time"
    unit: ClassVar[str] = "s"
    member: ClassVar[bool] = False
    first: AgentOrObject = option(help="an agent or a group of them")
    second: AgentOrObject = option(help="another agent or group")

    def values(self) -> Floats:
        import numpy as np

        # Of who has left, what was so far.
        return np.minimum.accumulate(nearest(self.first, self.second, _encroachment), axis=0)


def _time_to_collision(a: AgentTrace, b: AgentTrace) -> Floats:
    return geometry.time_to_contact(footprints(a), footprints(b), _velocity(b) - _velocity(a))


def _encroachment(a: AgentTrace, b: AgentTrace) -> Floats:
    return geometry.encroachment_times(footprints(a), footprints(b), a.time)


def _velocity(agent: AgentTrace) -> Floats:
    """(..., 2) m/s."""
    import numpy as np

    return np.stack(
        [agent.speed * np.cos(agent.heading), agent.speed * np.sin(agent.heading)], axis=-1
    )
