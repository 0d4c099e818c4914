"""The world of an engine: many scenes side by side, moved on in time by what agents are to do."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from ...geometry.arrays import Booleans, Floats, Integers
from ...ir.scene import Scene, SceneActor
from ..bends.sweeps import Sweeps
from ..junctions.stop_lines import StopLines
from ..lines.followed_lines import FollowedLines
from ..lines.route_table import RoadPosition, RouteTable
from ..shallow_copies import shallow
from ..vehicles.bodies import Bodies
from ..vehicles.motion import Advance, Motion, Track, advance
from ..vehicles.placing import Placing
from ..vehicles.poses import Poses, poses_of
from ..vehicles.verges import Verges
from . import along_lines
from .along_routes import stations
from .arrivals import ARRIVED, all_arrived
from .held_controls import held_controls
from .line_heights import LineHeights
from .settling import can_settle, settle
from .step_times import seconds_at


@dataclass
class World:
    """S scenes with at most A agents each, in columns (N,) with N = S A, scene by scene.

    Slots that a scene has no agent for are not `filled`. Who has arrived at the end of its line is
    no longer `present`: nobody sees or touches it, and all that is known of it stays as it was
    then. `reset` puts all agents where their scenes have them, `step` moves them on.
    """

    scenes: tuple[Scene, ...]
    slots: int
    dt: float
    """seconds for one step of the vehicles"""
    filled: Booleans
    present: Booleans
    actors: tuple[SceneActor | None, ...]
    names: NDArray[np.object_]
    bodies: Bodies
    verges: Verges
    track: Track
    table: RouteTable
    """what the lines lead over"""
    sweeps: Sweeps
    has_road: Booleans
    has_route: Booleans
    backward: Booleans
    """without a route, against the direction of the road"""
    road: Integers
    """the road of each agent at the start, within its scene, -1 for none"""
    followed: FollowedLines
    """the lines to follow, left of the reference lines"""
    end: Floats
    """arc length of the line at which the agent arrives"""
    start: Motion
    motion: Motion
    halted: Booleans
    """agents that had a crash: they stand"""
    contacts: Floats
    collision: Floats
    """m/s, the fastest impact so far"""
    red_lights: Floats
    """how many stop lines were crossed at red"""
    traveled: Floats
    """arc length since the start"""
    pace: tuple[Floats, Floats]
    """along and to the left of the lines, in the last step"""
    began: Integers
    """the tick at which the drive of each agent began"""
    stop_lines: StopLines
    """those with signals"""
    heights: LineHeights | None = None
    tick: int = 0
    placing: Placing | None = None
    """agents that go by recordings, in the last step"""
    placed_at: int = 0
    """the tick at which that began"""
    advance: Advance = advance
    """the equations of motion"""
    arrived: tuple[Floats, Floats, Booleans] | None = None  # arc lengths, and who is at its end
    any_left: bool = False
    """whether anybody has"""

    @property
    def time(self) -> float:
        """Seconds since the start."""
        return seconds_at(self.tick, self.dt)

    @property
    def age(self) -> Floats:
        """(N,) seconds since the drive of each agent began."""
        return np.asarray((self.tick - self.began) * self.dt, dtype=np.float64)

    @property
    def poses(self) -> Poses:
        """Where all agents are."""
        if self.placing is None:
            return poses_of(self.motion, self.track)
        steps = self.tick - self.placed_at
        stays = self.halted | ~self.present if self.any_left else self.halted
        return self.placing.poses(self.motion, self.track, steps, stays)

    def reset(self) -> None:
        """All agents back to the start."""
        every = np.arange(len(self.filled))
        self.motion, self.placing, self.tick = self.start.take(every), None, 0
        self.restart(every)

    def restart(self, agents: Integers) -> None:
        """Some agents back to the start, now; all of a scene."""
        self.motion.put(agents, self.start)
        self.present[agents] = self.filled[agents]
        self.halted[agents] = ~self.filled[agents]
        for column in (self.contacts, self.collision, self.red_lights, self.traveled, *self.pace):
            column[agents] = 0.0
        self.followed.restart(agents)
        self.began[agents] = self.tick

    def step(
        self, steering: Floats, acceleration: Floats, heading: Floats | None,
        steps: int, stops: Sequence[int] = (), pose: tuple[Floats, int] | None = None,
    ) -> list[World]:  # fmt: skip
        """Move on by `steps` steps of `dt` seconds, in which agents hold what they are to do.

        `pose`: (N, 4) x, y, heading and speed of those who are there after a number of steps, NaN
        for the others.
        Returns the world as it is after each number of steps in `stops`, ascending and below
        `steps`. Stops change nothing of the motion, not even in the last bit.
        """
        bodies, motion = self.bodies, self.motion
        if heading is not None:
            motion.face(bodies.walks & np.isfinite(heading) & ~self.halted, heading)
        held, below = held_controls(self, steering, acceleration)
        self.placing = pose and Placing.of(self.poses, motion, pose[0], ~self.halted, pose[1])
        self.placed_at = self.tick
        before, passed = motion.copied(), []
        for begin, end in pairwise((0, *stops, steps)):
            self.advance(motion, below, self.track, held, end - begin, self.dt)
            if end < steps:
                between = shallow(self)
                between.motion, between.followed = motion.copied(), self.followed.copied()
                between.contacts, between.collision = self.contacts.copy(), self.collision.copy()
                between._arrive(before, end)
                passed.append(between)
        self._arrive(before, steps)
        return passed

    def follow(self, pose: Floats, steering: Floats, poses: Poses, *, passed: bool) -> None:
        """Another engine has moved the agents: (N, 4) x, y, heading and speed. `poses`: those so
        far; `passed`: whether a step has passed."""
        before = self.motion.copied()
        self.placing = Placing.of(poses, self.motion, pose, self.filled, 1)
        self.placed_at = self.tick - (0 if passed else 1)
        if passed:
            self._arrive(before, 1)
        elif self.placing is not None:
            self.placing.put(self.motion, self.track, 1, self.dt)
            self.track.wrap(self.motion)
            self._leave()
        self.motion.tangent = np.where(self.present, np.tan(steering), self.motion.tangent)

    def _arrive(self, before: Motion, steps: int) -> None:
        """The motion is `steps` steps on; `before`: what it was then."""
        if can_settle(self):
            settle(self, before, steps)
            return
        seconds = steps * self.dt
        if self.placing is not None:
            self.placing.put(self.motion, self.track, steps, seconds)
        speed = self.motion.speed
        if self.any_left:  # they stay as they were when they left, but for who comes back
            gone = self.filled & ~self.present & self.at_end
            self.motion.put(gone, before)
            speed = np.where(gone, 0.0, speed)
        moved, left = self.motion.along - before.along, self.motion.offset - before.offset
        self.pace = moved / seconds, left / seconds
        self.traveled = self.traveled + moved
        self.followed.advance(speed, seconds)
        if not self.stop_lines.is_empty:
            self.count_red_lights(before.along, moved, seconds)
        self.track.wrap(self.motion)
        self.tick += steps
        self._leave()

    def _leave(self) -> None:
        """Who has arrived is no longer there, unless it began where it would arrive."""
        if self.any_left or np.count_nonzero(self.at_end):
            arrived = self.at_end & ~self.closed & (self.traveled > ARRIVED)
            self.any_left = bool(np.count_nonzero(arrived))
            self.present = self.filled & ~arrived

    def count_red_lights(self, before: Floats, moved: Floats, seconds: float) -> None:
        """Agents have `moved` from arc lengths `before`."""
        front = before + 0.5 * self.bodies.length
        if self.track.has_closed or self.stop_lines.may_cross(front, moved):
            lap, rows = np.where(self.closed, self.length, math.inf), np.arange(len(front))
            crossed = self.stop_lines.crossed_at_red(rows, front, moved, lap, (self.age, seconds))
            self.red_lights = self.red_lights + crossed

    @property
    def line_offset(self) -> Floats:
        """(N,) of the line to follow, left of the reference line, beside each agent."""
        return self.followed.offset(slice(None), self.motion.along)

    @property
    def closed(self) -> Booleans:
        """(N,) whose line ends where it begins."""
        return self.track.closed

    @property
    def length(self) -> Floats:
        """(N,) of the lines, meters."""
        return self.track.length

    @property
    def at_end(self) -> Booleans:
        """(N,) who has arrived at the end of its line, or has gone all around."""
        along, traveled, known = self.motion.along, self.traveled, self.arrived
        if known is None or known[0] is not along or known[1] is not traveled:
            laps = self.closed if self.track.has_closed else None
            arrived = along_lines.at_end(
                along, traveled, self.end, self.has_road, laps, self.length
            )
            known = self.arrived = along, traveled, arrived
        return known[2]

    @property
    def finished(self) -> Booleans:
        """(S,) scenes in which every agent with a road has arrived."""
        return all_arrived(self.at_end, self.has_road, self.filled, self.slots)

    @property
    def station(self) -> Floats:
        """(N,) arc length along the road, within its ends."""
        station = along_lines.station(self.motion.along, self.length, self.backward)
        if len(rows := self.has_route.nonzero()[0]):  # traced columns have no rows
            along = np.minimum(np.maximum(self.motion.along[rows], 0.0), self.length[rows])
            station[rows] = stations(self.table, rows, along)
        return station

    @property
    def place(self) -> RoadPosition:
        """Where on roads and junctions all agents are."""
        return self.table.place(slice(None), self.motion.along)

    @property
    def progress(self) -> Floats:
        """(N,) share of the line: of an open one up to here, of a closed one since the start."""
        return along_lines.progress(
            self.motion.along, self.traveled, self.length, self.has_road, self.closed, self.at_end
        )

    @property
    def cross_track_error(self) -> Floats:
        """(N,) left of the line to follow."""
        return self.motion.offset - self.line_offset

    def halt(self, agent: int, seconds: float) -> None:
        """An agent stands, from where it was some seconds ago."""
        motion, self.arrived = self.motion, None
        motion.along[agent] -= self.pace[0][agent] * seconds
        motion.offset[agent] -= self.pace[1][agent] * seconds
        self.traveled[agent] -= self.pace[0][agent] * seconds
        self.halted[agent] = True
        motion.halt(agent)

    def take(self, rows: Integers) -> World:
        """A world of some of its scenes, as they are now."""
        agents = (rows[:, None] * self.slots + np.arange(self.slots)).ravel()
        return replace(
            self, scenes=tuple(self.scenes[row] for row in rows),
            actors=tuple(self.actors[agent] for agent in agents),
            track=self.track.of_rows(agents), placing=None,
            pace=(self.pace[0][agents], self.pace[1][agents]),
            **{name: getattr(self, name).take(agents) for name in _PARTS},
            **{name: getattr(self, name)[agents] for name in _COLUMNS},
        )  # fmt: skip


_PARTS = ("bodies", "verges", "table", "sweeps", "stop_lines", "start", "motion", "followed")
_COLUMNS = (
    "filled", "present", "end", "names", "has_road", "has_route", "backward", "road", "halted",
    "contacts", "collision", "red_lights", "traveled", "began")  # fmt: skip
