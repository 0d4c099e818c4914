"""Drives scenes in the embedded engine: in blocks, all scenes of a block side by side."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from ..diagnostics import Code, DiagnosticError, diagnose
from ..geometry.arrays import Integers
from ..ir.paused_collector import collector_paused
from ..ir.scene import Scene
from ..ir.trace import Trace
from ..plugins.kinds import Controller
from .building.world_building import world_of
from .controlling.driving import DriverGroup, signals_of
from .quiet_drives import StepCounts, drive_quietly
from .recording.recording import Recorder
from .recording.violations import ViolationWatch
from .state.world import World
from .surroundings.contacts import Contact, ContactDetector
from .tapes.repeating import Repetition
from .vehicles import compiled, motion
from .vehicles.bodies import Body
from .vehicles.motion import Advance
from .vehicles.poses import Poses

AN_AGENT = "add one, such as `agent ego is car on main at 5m { drive with pure_pursuit }`"
BLOCK_AGENTS = 3072
"""Agents that are driven side by side: their columns fit into the caches of a processor."""
ALONE = 768
"""The same of agents that are alone in their scenes, where their steps are repeated in a compiled
loop: so few that their memory is used again for the next."""
LEFT_OUT = 0.25
"""Share of the scenes of a block that are over when it is made smaller."""


@dataclass(frozen=True)
class EngineSettings:
    """Settings of a drive; times in seconds."""

    duration: float = 60.0
    """at most"""
    step: float = 0.1
    """from one sample of the trace to the next"""
    control_step: float = 0.04
    """for which a decision of the controllers holds"""
    vehicle_step: float = 0.02
    """of the equations of motion"""
    after_violation: float = math.inf
    """time for which a drive continues after all of its expectations are certainly violated"""
    bodies: Mapping[str, Body] = field(default_factory=dict)
    """properties of the kinds of agents, by name"""

    def ticks(self, seconds: float) -> int:
        """Number of vehicle steps in a time, at least one."""
        return max(1, round(seconds / self.vehicle_step))


Controllers = Mapping[str, Controller]
"""By agent."""


def simulate_scenes(
    scenes: Sequence[Scene], controllers: Sequence[Controllers], settings: EngineSettings
) -> Iterator[Trace]:
    """The trace of each scene. A scene gives the same trace alone and with others.

    Raises DiagnosticError RL700 where a scene has no agent, RL510, RL513 and RL47x of controllers.
    """
    for scene in scenes:
        if not scene.agents:
            raise DiagnosticError(diagnose(Code.NO_AGENTS, scene=scene.name, help=AN_AGENT))
    for start, stop in _blocks(scenes):
        agents = sum(len(scene.agents) for scene in scenes[start:stop])
        pays = compiled.pays(settings.ticks(settings.duration), agents)
        advance = compiled.advance if pays else motion.advance
        yield from _drive_block(scenes[start:stop], controllers[start:stop], settings, advance)


def _blocks(scenes: Sequence[Scene]) -> Iterator[tuple[int, int]]:
    start = most = 0
    alone = compiled.is_installed() and all(len(scene.agents) == 1 for scene in scenes)
    agents = min(ALONE, BLOCK_AGENTS) if alone else BLOCK_AGENTS
    for number, scene in enumerate(scenes):
        wider = max(most, len(scene.agents))
        if number > start and (number + 1 - start) * wider > agents:
            yield start, number
            start, wider = number, len(scene.agents)
        most = wider
    yield start, len(scenes)


def _drive_block(
    scenes: Sequence[Scene],
    controllers: Sequence[Controllers],
    settings: EngineSettings,
    advance: Advance,
) -> list[Trace]:
    held, sampled = settings.ticks(settings.control_step), settings.ticks(settings.step)
    last = settings.ticks(settings.duration)
    with collector_paused():  # objects for each scene, all of which live on
        world, drivers, contacts, recorder = _at_start(scenes, controllers, settings)
    world.advance = advance
    poses: Poses | None = world.poses
    recorder.note(world, contacts.watch(world, world.poses, 0.0))
    calm = Repetition.of(world, drivers, contacts, held, sampled)
    is_recorded = False
    while True:
        if not is_recorded and (world.tick % sampled == 0 or world.tick >= last):
            poses = poses or world.poses
            recorder.record(world, poses)
        going_on = recorder.going_on
        if world.tick >= last or not len(going_on):
            with collector_paused():
                return recorder.traces()
        if len(going_on) <= (1.0 - LEFT_OUT) * len(world.scenes):
            agents, count = _columns(going_on, world.slots), len(world.present)
            drivers.take(agents, count)
            contacts.take(agents, count)
            world, poses = world.take(going_on), poses and poses.take(agents)
            recorder.go_on_with(going_on, agents, count)
            if calm:
                calm.take(agents)
        is_recorded = calm is not None and calm.drive(world, recorder, last)
        if is_recorded:
            poses = None
            continue
        poses = _decide_and_move(world, poses, (drivers, contacts, recorder), settings)


def _decide_and_move(
    world: World,
    poses: Poses | None,
    others: tuple[DriverGroup, ContactDetector, Recorder],
    settings: EngineSettings,
) -> Poses | None:
    """Agents move for as long as a decision holds. `poses`: where they are. Returns where they are
    then. None: that was not looked at."""
    drivers, contacts, recorder = others
    held, sampled = settings.ticks(settings.control_step), settings.ticks(settings.step)
    decision = drivers.held(world) or drivers.decide(world, poses or world.poses)
    recorder.note_failures(world, decision.failures)
    left = settings.ticks(settings.duration) - world.tick
    times = drivers.holds(world, held, left // held)
    counts = StepCounts(held, sampled)
    if times and drive_quietly(world, decision, (contacts, recorder), counts, times):
        return None
    steps = min(held, left)
    samples = range(sampled - world.tick % sampled, steps, sampled)
    pose = None if decision.pose is None else (decision.pose, held)
    passed = world.step(
        decision.steering, decision.acceleration, decision.heading, steps, samples, pose
    )
    poses = world.poses
    touched = contacts.watch(world, poses, steps * settings.vehicle_step)
    if touched:
        recorder.note(world, touched)
        poses = world.poses
        contacts.seen(poses)
    for between in passed:
        _halt_touched(between, world, touched)
        recorder.record(between, between.poses)
    return poses


def _at_start(
    scenes: Sequence[Scene], controllers: Sequence[Controllers], settings: EngineSettings
) -> tuple[World, DriverGroup, ContactDetector, Recorder]:
    """Some scenes at the start, and what drives, watches and records them."""
    dt = settings.vehicle_step
    world = world_of(scenes, settings.bodies, dt, settings.control_step)
    drivers = DriverGroup(world, controllers, settings.ticks(settings.control_step) * dt)
    watch = ViolationWatch(world, signals_of(controllers), settings.after_violation)
    return world, drivers, ContactDetector(world), Recorder(world, watch)


def _columns(scenes: Integers, slots: int) -> Integers:
    """Those of all agents of some scenes."""
    return np.asarray((scenes[:, None] * slots + np.arange(slots)).ravel())


def _halt_touched(between: World, world: World, touched: Sequence[Contact]) -> None:
    """Who has touched something before the time of `between` already stands as in `world`, which
    is later."""
    for contact in touched:
        if contact.time <= between.time:
            agent = contact.agent
            between.motion.put(agent, world.motion)
            between.traveled[agent] = world.traveled[agent]
            between.contacts[agent] = world.contacts[agent]
