"""Scenes in which one agent waits for actions, side by side in the embedded engine."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from ..drive.controllers import python_controllers
from ..drive.simulators import engine_settings
from ..geometry.arrays import Booleans, Floats, Integers
from ..geometry.curves.bend_room import LONG
from ..simulation.building.world_building import world_of
from ..simulation.calling.controllers import UNDRIVEN_BRAKING
from ..simulation.calling.decision import Decision
from ..simulation.controlling.driving import DriverGroup
from ..simulation.observing.observing import View
from ..simulation.observing.surroundings import Surroundings
from ..simulation.signals.samples import Samples
from ..simulation.state.world import World
from ..simulation.surroundings.contacts import ContactDetector
from ..simulation.vehicles import compiled
from ..simulation.vehicles.poses import Poses
from .margins import Margins
from .observed import Observed
from .off_road import OffRoadCheck
from .rewards import Transition, transition_of
from .scene_pool import ScenePool
from .settings import EnvSettings


@dataclass(frozen=True)
class EpisodeEnds:
    """Why episodes end, as columns (N,)."""

    collided: Booleans
    off_road: Booleans
    arrived: Booleans
    violated: Booleans
    late: Booleans
    """the time is over"""

    @property
    def terminated(self) -> Booleans:
        """Over for another reason than time."""
        return self.collided | self.off_road | self.arrived | self.violated

    @property
    def reasons(self) -> dict[str, Booleans]:
        """What `info` says of it."""
        names = ("collided", "off_road", "arrived", "violated")
        return {name: getattr(self, name) for name in names}


class Episodes:
    """The scenes `chosen` of a pool, each driven from its start whenever it is `restart`ed."""

    def __init__(self, pool: ScenePool, chosen: Sequence[int], settings: EnvSettings) -> None:
        self._settings, self._substeps = settings, settings.substeps
        self._limit = settings.limit * self._substeps
        scenes = [pool.scenes[index] for index in chosen]
        engine = engine_settings(pool.registry)
        self._world = world = world_of(scenes, engine.bodies, settings.dt, settings.step)
        driven = [pool.driven[index] for index in chosen]
        self._agents = np.arange(len(scenes)) * world.slots + np.array(driven, dtype=np.int64)
        self._vector = settings.vector
        self._surroundings = Surroundings(world)
        self._drivers = _drivers(world, pool, settings)
        self._contacts = ContactDetector(world)
        poses = world.poses
        self._contacts.watch(world, poses, 0.0)
        self._poses = world.poses
        self._at_start = (world.halted.copy(), world.contacts.copy())
        self._start = world.poses.take(slice(None))
        self._margins = [Margins(name, world, pool.registry) for name in pool.margins]
        self._before = np.zeros((len(scenes), 2))
        depth = max((margin.looks_back for margin in self._margins), default=0)
        self._samples = Samples(depth, settings.step)
        self._samples.add(world, self._poses)
        self._off_road = OffRoadCheck(world)
        world.verges.look_up(world.table, world.motion)

    def restart(self, rows: Integers) -> None:
        """Some scenes begin again."""
        world = self._world
        agents = (rows[:, None] * world.slots + np.arange(world.slots)).ravel()
        world.restart(agents)
        for column, first in zip((world.halted, world.contacts), self._at_start, strict=True):
            column[agents] = first[agents]
        self._poses = self._restarted(agents)
        self._contacts.restart(agents, self._poses)
        if self._drivers is not None:
            self._drivers.restart(agents)
        self._samples.restart(agents, world, self._poses)
        self._before = self._before.copy()
        self._before[rows] = 0.0

    def _restarted(self, agents: Integers) -> Poses:
        """Where all agents are, of whom some are at the start."""
        if self._world.placing is not None:
            return self._world.poses
        return self._poses.put(agents, self._start)

    def observe(self, rows: Integers) -> Observed:
        """(R, F) what the driven agents of some scenes see, and what their sensors read."""
        agents = self._driven(rows)
        if self._drivers is None or self._drivers.sensing is None:
            view = View(self._world, self._poses, self._settings.step, self._surroundings)
            return self._vector.of(view.of(agents))
        self._drivers.sense(self._world, self._poses)
        seen = self._drivers.view(self._world, self._poses).of(agents)
        state = self._vector.of(seen)
        readings = {
            name: {part: array.copy() for part, array in reading.items()}
            for name, reading in seen.sensors.items()
        }
        return {"state": state, "sensors": readings} if readings else state

    @property
    def places(self) -> tuple[Floats, Floats, Floats, Booleans]:
        """x, y, heading of all agents (A,), in the order of the scenes; whether each is there."""
        poses = self._poses
        return poses.x, poses.y, poses.heading, self._world.present

    def step(self, rows: Integers, actions: Floats) -> tuple[Transition, EpisodeEnds]:
        """Drive on, with `actions` (R, 2) in the scenes `rows`; the others go on as they like."""
        world, settings = self._world, self._settings
        decision = self._decided(rows, actions)
        agents = self._selected(rows)
        along = world.traveled[agents]
        if compiled.pays(self._substeps, len(world.present)):
            world.advance = compiled.advance  # the same to the last bit
        world.step(decision.steering, decision.acceleration, decision.heading, self._substeps)
        poses = world.poses
        if self._contacts.watch(world, poses, self._substeps * settings.dt):
            poses = world.poses
            self._contacts.seen(poses)
        self._poses = poses
        progress = world.traveled[agents] - along
        transition = self._transition(rows, actions, progress)
        self._remember(rows, actions)
        return transition, self._ends(rows, transition)

    def _remember(self, rows: Integers, actions: Floats) -> None:
        """What was done, for the next transition; that of the last one keeps its array."""
        if len(rows) == len(self._before):
            self._before = actions
            return
        self._before = self._before.copy()
        self._before[rows] = actions

    def _decided(self, rows: Integers, actions: Floats) -> Decision:
        world, settings = self._world, self._settings
        agents, count = self._selected(rows), len(world.present)
        steering = actions[:, 0] * world.bodies.max_steering[agents]
        scale = np.where(actions[:, 1] < 0.0, settings.deceleration, settings.acceleration)
        acceleration = actions[:, 1] * scale
        if len(rows) == count:
            return Decision(steering, acceleration)
        if self._drivers is None:
            decision = Decision(np.zeros(count), np.full(count, -UNDRIVEN_BRAKING))
        else:
            decision = self._drivers.decide(world, self._poses)
        decision.steering[agents], decision.acceleration[agents] = steering, acceleration
        return decision

    def _transition(self, rows: Integers, actions: Floats, moved: Floats) -> Transition:
        world, poses, agents = self._world, self._poses, self._selected(rows)
        motion, scenes = world.motion, self._scenes(rows)
        self._samples.add(world, poses)
        ticks, tangent = world.tick - world.began[agents], motion.tangent[agents]
        return transition_of(
            {
                "margins": {one.name: one.values(self._samples)[scenes] for one in self._margins},
                "moved": moved,
                "x": poses.x[agents],
                "y": poses.y[agents],
                "heading": poses.heading[agents],
                "speed": motion.speed[agents],
                "acceleration": motion.acceleration[agents],
                "yaw_rate": motion.yaw_rate[agents],
                "cross_track_error": world.cross_track_error[agents],
                "action": actions,
                "previous_action": self._before[scenes],
                "collided": world.contacts[agents] > 0.0,
                "off_road": self._off_road.of(world, self._samples, self._driven(rows)),
                "arrived": world.at_end[agents],
            },
            {
                "time": partial(np.multiply, ticks, world.dt),
                "steering": partial(np.arctan, tangent),
            },
        )

    def _scenes(self, rows: Integers) -> Any:
        """Some scenes, as an index that copies nothing where they are all."""
        return slice(None) if len(rows) == len(self._before) else rows

    def _selected(self, rows: Integers) -> Any:
        """The driven agents of some scenes, as an index that copies nothing where it can."""
        return slice(None) if len(rows) == len(self._world.present) else self._driven(rows)

    def _driven(self, rows: Integers) -> Integers:
        """(R,) the driven agents of some scenes, which are named in their order: of all, the very
        array that names them at every step."""
        return self._agents if len(rows) == len(self._agents) else self._agents[rows]

    def _ends(self, rows: Integers, after: Transition) -> EpisodeEnds:
        settings, world = self._settings, self._world
        none = np.zeros(len(rows), dtype=bool)
        violated = none.copy()
        if settings.violation_ends:
            for margin in after.margins.values():
                violated |= margin < 0.0
        ticks = world.tick - world.began[self._selected(rows)]
        return EpisodeEnds(
            after.collided,
            after.off_road if settings.off_road_ends else none,
            after.arrived,
            violated,
            ticks >= self._limit,
        )


def can_restart(pool: ScenePool) -> bool:
    """Whether scenes can begin again while others go on: where no controller waits for a condition
    and nobody gives way, at a junction or to a long vehicle in a bend."""
    return (
        not any(
            call.when is not None or call.during is not None
            for scene in pool.scenes
            for actor in scene.agents
            for call in actor.drive
        )
        and not any(bool(network.junctions) for scene in pool.scenes for network in scene.networks)
        and not any(actor.length > LONG for scene in pool.scenes for actor in scene.agents)
    )


def _drivers(world: World, pool: ScenePool, settings: EnvSettings) -> DriverGroup | None:
    """What drives the other agents; None where there are none that anything drives, and
    no sensors."""
    agents = [actor for scene in world.scenes for actor in scene.agents]
    if not any(actor.drive or actor.sensors for actor in agents):
        return None
    controllers = [python_controllers(scene, pool.registry, pool.places) for scene in world.scenes]
    return DriverGroup(world, controllers, settings.step)
