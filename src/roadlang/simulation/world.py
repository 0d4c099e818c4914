"""The world of an engine: many scenes side by side, moved on in time by what agents are to do."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..geometry.arrays import Booleans, Floats, Integers
from ..ir.scene import Scene, SceneActor
from .bodies import Bodies, Body
from .lines import Lines, LineSource, road_line, straight_line
from .motion import Advance, Motion, Track, advance
from .poses import Poses, poses_of
from .starting import LineOffsets, start_of

USUAL_FRICTION = 0.9
ARRIVED = 0.5
"""Meters before the end of a line from which on an agent has arrived."""
END_BRAKING = 4.0
"""m/s^2, at the end of a road."""
FASTEST = 120.0
"""m/s: lines go on beyond their ends for as far as this takes an agent in one step."""


@dataclass
class World:
    """S scenes with at most A agents each, in columns (N,) with N = S A, scene by scene.

    Slots that a scene has no agent for are not `present`. `reset` puts all agents where their
    scenes have them, `step` moves them on.
    """

    scenes: tuple[Scene, ...]
    slots: int
    """A"""
    dt: float
    """seconds for one step of the vehicles"""
    present: Booleans
    actors: tuple[SceneActor | None, ...]
    names: NDArray[np.object_]
    """of the agents"""
    bodies: Bodies
    track: Track
    has_road: Booleans
    backward: Booleans
    """against the direction of the road"""
    road: Integers
    """the road of each agent within its scene, -1 for none"""
    line_offset: Floats
    """of the line to follow, left of the tabled line"""
    start: Motion
    motion: Motion
    halted: Booleans
    """agents that had a crash: they stand"""
    contacts: Floats
    traveled: Floats
    """arc length since the start"""
    pace: tuple[Floats, Floats]
    """along and to the left of the lines, in the last step"""
    tick: int = 0
    advance: Advance = advance
    """the equations of motion"""

    @property
    def time(self) -> float:
        """Seconds since the start."""
        return self.tick * self.dt

    @property
    def poses(self) -> Poses:
        """Where all agents are."""
        return poses_of(self.motion, self.track)

    def reset(self) -> None:
        """All agents back to the start."""
        self.motion = self.start.take(np.arange(len(self.present)))
        self.halted = ~self.present
        self.contacts = np.zeros(len(self.present))
        self.traveled = np.zeros(len(self.present))
        zero = np.zeros(len(self.present))
        self.pace = (zero, zero)
        self.tick = 0

    def step(
        self, steering: Floats, acceleration: Floats, heading: Floats | None,
        steps: int, stops: Sequence[int] = (),
    ) -> list[World]:  # fmt: skip
        """Move on by `steps` steps of `dt` seconds, in which agents hold what they are to do.

        Returns the world as it is after each number of steps in `stops`, ascending and below
        `steps`. Stops change nothing of the motion, not even in the last bit.
        """
        bodies, motion = self.bodies, self.motion
        limit = bodies.max_steering
        angle = np.minimum(np.maximum(steering, -limit), limit)
        braking = np.where(self.at_end & ~self.closed, -END_BRAKING, math.inf)
        acceleration = np.where(self.halted, -END_BRAKING, np.minimum(acceleration, braking))
        if heading is not None:
            self._face(heading)
        held = (np.tan(angle), acceleration)
        before = (motion.along, motion.offset)
        passed = []
        for begin, end in pairwise((0, *stops, steps)):
            self.advance(motion, bodies, self.track, held, end - begin, self.dt)
            if end < steps:
                between = replace(self, motion=replace(motion), contacts=self.contacts.copy())
                between._arrive(before, end)
                passed.append(between)
        self._arrive(before, steps)
        return passed

    def _arrive(self, before: tuple[Floats, Floats], steps: int) -> None:
        """The motion is `steps` steps on; `before`: along and offset then."""
        moved = self.motion.along - before[0]
        seconds = steps * self.dt
        self.pace = (moved / seconds, (self.motion.offset - before[1]) / seconds)
        self.traveled = self.traveled + moved
        self._wrap()
        self.tick += steps

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
        arrived = self.length - self.motion.along < ARRIVED
        if self.track.has_closed:
            arrived = np.where(self.closed, self.traveled >= self.length, arrived)
        return np.asarray(self.has_road & arrived)

    @property
    def finished(self) -> Booleans:
        """(S,) scenes in which every agent with a road has arrived."""
        arrived = self.at_end | ~self.has_road
        rows = (arrived | ~self.present).reshape(-1, self.slots)
        return np.asarray(rows.all(axis=1))

    @property
    def station(self) -> Floats:
        """(N,) arc length along the road, within its ends."""
        along = np.minimum(np.maximum(self.motion.along, 0.0), self.length)
        return np.where(self.backward, self.length - along, along)

    @property
    def progress(self) -> Floats:
        """(N,) share of the line: of an open one up to here, of a closed one since the start."""
        along = np.where(self.closed, self.traveled, np.maximum(self.motion.along, 0.0))
        share = np.where(self.at_end, 1.0, along / self.length)
        return np.where(self.has_road, share, 0.0)

    @property
    def cross_track_error(self) -> Floats:
        """(N,) left of the line to follow."""
        return self.motion.offset - self.line_offset

    def halt(self, agent: int, seconds: float) -> None:
        """An agent stands, from where it was some seconds ago."""
        motion = self.motion
        motion.along[agent] -= self.pace[0][agent] * seconds
        motion.offset[agent] -= self.pace[1][agent] * seconds
        self.traveled[agent] -= self.pace[0][agent] * seconds
        self.halted[agent] = True
        motion.halt(agent)

    def take(self, rows: Integers) -> World:
        """A world of some of its scenes, as they are now."""
        agents = (rows[:, None] * self.slots + np.arange(self.slots)).ravel()
        return replace(
            self,
            scenes=tuple(self.scenes[row] for row in rows),
            actors=tuple(self.actors[agent] for agent in agents),
            bodies=self.bodies.take(agents),
            track=self.track.of_rows(agents),
            start=self.start.take(agents),
            motion=self.motion.take(agents),
            pace=(self.pace[0][agents], self.pace[1][agents]),
            **{name: getattr(self, name)[agents] for name in _COLUMNS},
        )

    def _face(self, heading: Floats) -> None:
        """What walks turns to a heading."""
        rows = np.flatnonzero(self.bodies.walks & np.isfinite(heading) & ~self.halted)
        if len(rows):
            error = heading[rows] - self.motion.line_heading[rows]
            self.motion.cosine[rows], self.motion.sine[rows] = np.cos(error), np.sin(error)
            self.motion.tangent[rows] = 0.0

    def _wrap(self) -> None:
        """On closed lines, arc length begins anew after a lap."""
        if self.track.has_closed:
            over = np.floor(self.motion.along / self.length) * self.closed
            self.motion.along = self.motion.along - over * self.length
            turn = self.track.lines.turn[self.track.row]
            self.motion.line_heading = self.motion.line_heading - over * turn


_COLUMNS = (
    "present", "names", "has_road", "backward", "road", "line_offset", "halted", "contacts",
    "traveled",
)  # fmt: skip


def world_of(scenes: Sequence[Scene], kinds: Mapping[str, Body], dt: float, margin: float) -> World:
    """The world of some scenes at the start. `margin`: seconds of the longest step."""
    slots = max(1, *(len(scene.agents) for scene in scenes))
    sources: list[LineSource] = []
    found: list[_Slot] = []
    for scene in scenes:
        names = {road.name: number for number, road in enumerate(scene.roads)}
        rows: dict[Any, int] = {}
        for place in range(slots):
            actor = scene.agents[place] if place < len(scene.agents) else None
            found.append(_slot(actor, scene, names, rows, sources))
    lines = Lines.of(sources, FASTEST * margin)
    return _started(tuple(scenes), slots, found, lines, kinds, dt)


@dataclass(frozen=True)
class _Slot:
    actor: SceneActor | None
    line: int
    road: int
    friction: float


_NOBODY = SceneActor("", "", "", 0.0, 0.0, 0.0, 1.0, 1.0, 1.0)


def _slot(
    actor: SceneActor | None,
    scene: Scene,
    roads: Mapping[str, int],
    rows: dict[Any, int],
    sources: list[LineSource],
) -> _Slot:
    """An agent with its line, which those of one road and direction share."""
    who = actor or _NOBODY
    number = roads.get(who.road or "", -1)
    key = (number, who.facing == "back") if number >= 0 else (who.x, who.y, who.heading)
    if key not in rows:
        rows[key] = len(sources)
        on_road = number >= 0
        sources.append(
            road_line(scene.roads[number], who.facing == "back")
            if on_road
            else straight_line(who.x, who.y, who.heading)
        )
    friction = scene.world.get("friction", USUAL_FRICTION)
    return _Slot(actor, rows[key], number, float(friction))


def _started(
    scenes: tuple[Scene, ...],
    slots: int,
    found: Sequence[_Slot],
    lines: Lines,
    kinds: Mapping[str, Body],
    dt: float,
) -> World:
    actors = [slot.actor or _NOBODY for slot in found]
    present = np.array([slot.actor is not None for slot in found], dtype=bool)
    row = np.array([slot.line for slot in found], dtype=np.int64)
    road_numbers = [slot.road for slot in found]
    road = np.array(road_numbers, dtype=np.int64)
    track = Track.of(lines, row)
    backward = np.array([actor.facing == "back" for actor in actors], dtype=bool)
    has_road = road >= 0
    start = start_of(actors, track, backward, has_road)
    bodies = Bodies.of(actors, [slot.friction for slot in found], kinds, dt)
    widths = track.lines.width[track.cell(start.along)[0]].tolist()
    known = LineOffsets()
    offsets = [
        known.of(actor, scenes[i // slots].roads[road] if road >= 0 else None, widths[i])
        for i, (actor, road) in enumerate(zip(actors, road_numbers, strict=True))
    ]
    count = len(found)
    world = World(
        scenes, slots, dt, present, tuple(slot.actor for slot in found),
        np.array([actor.name for actor in actors], dtype=object), bodies, track, has_road,
        backward, road, np.where(backward, -1.0, 1.0) * np.array(offsets), start, start,
        ~present, np.zeros(count), np.zeros(count), (np.zeros(count), np.zeros(count)),
    )  # fmt: skip
    world.reset()
    return world
