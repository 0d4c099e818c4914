"""The junctions of a scene: their surfaces, and how lanes are connected through them."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

ControlRule = Literal["right_first", "yield", "stop", "all_way_stop", "signals"]
Light = Literal["green", "yellow", "red"]


@dataclass(frozen=True, slots=True)
class SceneArm:
    """One end of a road that enters a junction."""

    road: str
    """name of the road"""
    end: Literal["start", "end"]
    """which end of the road"""
    trim: float
    """how far from its node the road begins, meters of its `reference_stations`: the same in all
    variants; `SceneRoad.trim` has the place in the road's own stations"""
    left: int
    """index in the area of the left corner of the face where the road begins, seen from inside"""
    right: int
    """index in the area of the right corner"""


@dataclass(frozen=True, slots=True)
class SceneLaneEnd:
    """A lane at one end of its road."""

    road: str
    """name of the road"""
    end: Literal["start", "end"]
    """which end of the road"""
    lane: int
    """its id"""


@dataclass(frozen=True, slots=True)
class SceneConnection:
    """The curve from the middle of one lane to the middle of another: lines and arcs."""

    id: int
    """unique in the junction"""
    source: SceneLaneEnd
    """the lane that it leaves"""
    target: SceneLaneEnd
    """the lane that it enters"""
    turn: Literal["left", "straight", "right", "u"]
    """where it leads"""
    start: tuple[float, float, float]
    """x, y (meters) and heading (radians) of its first point"""
    pieces: tuple[tuple[float, float], ...]
    """length (meters) and curvature (1/m, positive to the left) of each line and arc, in order"""
    length: float
    """of all pieces, meters"""
    widths: tuple[float, float]
    """of the lanes that it leaves and enters, meters; linear between"""
    stop_line: tuple[tuple[float, float], tuple[float, float]]
    """across the source lane, from its left to its right border: x and y, meters"""


@dataclass(frozen=True, slots=True)
class SceneConflict:
    """Two connections on which vehicles can meet."""

    a: int
    """id of a connection"""
    b: int
    """id of the other"""
    kind: Literal["cross", "merge", "diverge"]
    """`diverge`: out of one lane, where the vehicle behind follows the one ahead"""
    interval_a: tuple[float, float]
    """where they are close: arc length along `a`, meters"""
    interval_b: tuple[float, float]
    """where they are close: arc length along `b`, meters"""


@dataclass(frozen=True, slots=True)
class SceneRefusal:
    """A turn that is allowed, but that no vehicle can drive."""

    source: SceneLaneEnd
    """the lane that it would leave"""
    target: SceneLaneEnd
    """the lane that it would enter"""
    turn: Literal["left", "straight", "right", "u"]
    """where it would lead"""
    reason: str
    """why there is no connection"""


@dataclass(frozen=True, slots=True)
class SignalPhase:
    """A phase of the signals: who has green, and for how long. Others have red."""

    connections: tuple[int, ...]
    """ids of the connections with green; left turns among them yield to oncoming traffic"""
    green: float
    """seconds"""
    yellow: float
    """seconds, after green"""
    all_red: float
    """seconds, after yellow"""


@dataclass(frozen=True, slots=True)
class SceneControl:
    """Who goes first at a junction."""

    kind: ControlRule = "right_first"
    """`yield` and `stop`: traffic of the minor roads; `all_way_stop`: in order of arrival"""
    minor: tuple[str, ...] = ()
    """names of the roads that yield or stop"""
    phases: tuple[SignalPhase, ...] = ()
    """of signals, in order and again from the first"""
    offset: float = 0.0
    """seconds of the first phase that have passed when the drive begins"""

    @property
    def cycle(self) -> float:
        """Seconds of all phases."""
        return self.changes[-1][3] if self.phases else 0.0

    @property
    def changes(self) -> tuple[tuple[float, float, float, float], ...]:
        """When in a cycle each phase turns green, yellow and red, and when it ends, seconds."""
        found, begin = [], 0.0
        for phase in self.phases:
            yellow = begin + phase.green
            red = yellow + phase.yellow
            found.append((begin, yellow, red, red + phase.all_red))
            begin = red + phase.all_red
        return tuple(found)

    def light(self, connection: int, time: float) -> Light:
        """What the signals show a connection, `time` seconds into the drive."""
        if self.cycle <= 0.0:
            return "red"
        now = (time + self.offset) % self.cycle
        for phase, (begin, yellow, red, _) in zip(self.phases, self.changes, strict=True):
            if connection in phase.connections and begin <= now < red:
                return "green" if now < yellow else "yellow"
        return "red"


@dataclass(frozen=True, slots=True)
class SceneJunction:
    """A place where roads of a network meet. Roads end at its area (`SceneRoad.trim`)."""

    id: int
    """unique in the network: the least number of its nodes"""
    nodes: tuple[int, ...]
    """numbers of the nodes in the network"""
    kind: Literal["junction", "roundabout", "joint"]
    """`joint`: two roads that go on in one another; `roundabout`: one node of its ring"""
    area: tuple[tuple[float, float], ...] = field(repr=False)
    """its surface, a ring counter-clockwise: x and y, meters"""
    arms: tuple[SceneArm, ...]
    """counter-clockwise"""
    connections: tuple[SceneConnection, ...] = field(repr=False)
    """of lanes"""
    conflicts: tuple[SceneConflict, ...] = field(repr=False, default=())
    """of connections"""
    yields: tuple[tuple[int, int], ...] = field(repr=False, default=())
    """pairs of connections: the first yields to the second"""
    refused: tuple[SceneRefusal, ...] = ()
    """turns without connection"""
    inside: tuple[str, ...] = ()
    """names of the roads that lie wholly in its area"""
    control: SceneControl = field(default_factory=SceneControl)
    """who goes first"""
