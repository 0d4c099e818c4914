"""Drives whole scenes: builds them, lets the engine or Python drive, and gives back traces."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from roadlang.api import Code

from ..build.drives import MANUAL, decided_in_python, drives_by_hand
from ..build.layout import layout_of
from ..build.mounted_camera import cameras_of
from ..engines import engine
from ..engines.one_core import on_one_core
from ..engines.restarted_engine import RestartedEngine
from ..engines.running_engine import RunningEngine
from ..faults import fault
from ..net.session import Session
from ..net.telemetry import of_agent
from ..sensors.eyes import Eyes
from . import driving
from .followed_scene import FollowedScene

if TYPE_CHECKING:
    from roadlang.api import Controller, Scene, Trace

LEAST_RATE = 60.0
"""Ticks a second below which wheeled bodies are not stable in Godot."""


@dataclass(frozen=True, slots=True)
class Settings:
    """How to drive: seconds at most, seconds between records, with a window or without."""

    duration: float = 60.0
    step: float = 0.02
    headless: bool = True
    road: str = "mesh"
    running: RunningEngine | None = None
    """the engine to drive in; None: one is started"""

    @property
    def every(self) -> int:
        """Physics ticks between two records."""
        return max(1, math.ceil(LEAST_RATE * self.step - 1e-9))

    @property
    def rate(self) -> int:
        """Physics ticks a second."""
        return max(1, round(self.every / self.step))

    @property
    def frame_rate(self) -> int:
        """Frames a second of an engine that runs as fast as it can: one for each record."""
        return max(1, round(self.rate / self.every))

    @property
    def ticks(self) -> int:
        """Physics ticks of a whole drive."""
        return round(self.duration * self.rate)


Controllers = Mapping[str, "Controller"]
"""Agent to the controller, written in Python, that drives it."""


def drive_scenes(
    scenes: Sequence[Scene], settings: Settings, controllers: Sequence[Controllers]
) -> Iterator[Trace]:
    """Drive scenes one after the other in one engine, each in a fresh world.

    An engine that was started here and is lost is started again, and drives the same scene from its
    start: the trace is the same. Raises RL505 with the name of a scene in which too many engines
    were lost, or where one is lost that somebody else has started.
    """
    if settings.running is not None:
        with settings.running.connect(scenes[0].name) as session:
            for scene, of_scene in zip(scenes, controllers, strict=True):
                yield drive_in(session, scene, settings, of_scene)
        return
    draw = any(map(cameras_of, scenes))
    fixed = None if not settings.headless else settings.rate if draw else settings.frame_rate
    engines = RestartedEngine(
        lambda: engine.start(fixed_fps=fixed, draw=draw, window=not settings.headless)
    )
    try:
        for scene, of_scene in zip(scenes, controllers, strict=True):
            yield engines.drive(scene, partial(_drive, scene, settings, of_scene))
    finally:
        engines.stop()


def _drive(scene: Scene, settings: Settings, controllers: Controllers, session: Session) -> Trace:
    return drive_in(session, scene, settings, controllers)


def drive_in(session: Session, scene: Scene, settings: Settings, controllers: Controllers) -> Trace:
    """Build and drive a scene in a session.

    The engine drives alone where it has copies of all controllers, else Python decides for all
    agents that `controllers` has. Raises `EngineError` RL700 where nothing drives, RL510 where a
    controller is missing.
    """
    decided = decided_in_python(scene, controllers)
    by_hand = drives_by_hand(scene)
    if by_hand and settings.headless and settings.running is None:
        help_ = "`manual` needs a window: add `--window`, or use `roadlang watch`"
        raise fault(
            Code.UNSUPPORTED_CONTROLLER, help_, kind=MANUAL, engine="Godot without a window"
        )
    layout = layout_of(scene, settings.road, python_driven=decided)
    if not layout.agents:
        raise fault(Code.NO_AGENTS, scene=scene.name)
    for name in layout.undriven:
        kind = next(actor.drive[-1].kind for actor in scene.agents if actor.name == name)
        raise fault(Code.UNSUPPORTED_CONTROLLER, kind=kind, engine="Godot's project")
    session.begin(layout.settings(settings.rate), clear=True)
    session.update(layout.parts)
    session.prove()
    step, eyes = settings.every / settings.rate, Eyes(session, scene, layout)
    followed = FollowedScene(scene, layout, step, settings.rate, decided, eyes)
    if decided or by_hand:
        _step_by_step(session, followed, settings)
    else:
        drive = driving.run(session, settings.ticks, every=settings.every, stop_at_end=True)
        _record(drive, followed, len(layout.agents))
    return followed.trace(name_of(session))


def drive_batch(session: Session, scenes: Sequence[Scene], settings: Settings) -> list[Trace]:
    """Drive many scenes at once, each in a world of its own within one engine."""
    layouts = [layout_of(scene, settings.road) for scene in scenes]
    for world, layout in enumerate(layouts):
        session.begin(layout.settings(settings.rate), world, clear=world == 0)
        session.update(layout.parts, world)
        session.prove(world)
    drive = driving.run(session, settings.ticks, every=settings.every, stop_at_end=True)
    traces = []
    for world, (layout, scene) in enumerate(zip(layouts, scenes, strict=True)):
        followed = FollowedScene(scene, layout, settings.every / settings.rate, settings.rate)
        _record(drive, followed, len(layout.agents), world)
        traces.append(followed.trace(name_of(session)))
    return traces


def _step_by_step(session: Session, followed: FollowedScene, settings: Settings) -> None:
    """Drive in lock-step: at every step Python sees all agents, and decides for them."""
    with on_one_core(session.process), driving.LockStep(session) as lock:
        followed.look(lock.state)
        for _ in range(settings.ticks // settings.every):
            followed.look(lock.step(followed.controls(), settings.every))
            if followed.finished:
                break


def _record(
    drive: driving.GodotDrive, followed: FollowedScene, agents: int, world: int = 0
) -> None:
    """Make samples of the records of a world, a tick after the other."""
    rows = drive.trace[drive.trace["world"] == world].reshape(-1, agents)
    contacts = drive.contacts[drive.contacts["world"] == world]
    ends = np.searchsorted(contacts["tick"], rows["tick"][:, 0], side="right")
    started = 0
    for of_tick, end in zip(rows, ends, strict=True):
        followed.look_at_records(of_tick, contacts[started:end])
        started = end
        if followed.finished:
            break


def name_of(session: Session) -> str:
    """The engine and its physics, as in traces."""
    welcome: Mapping[str, Any] = session.welcome
    return f"Godot {welcome.get('godot')} with {welcome.get('physics')}"


__all__ = [
    "Controllers",
    "Settings",
    "drive_batch",
    "drive_in",
    "drive_scenes",
    "name_of",
    "of_agent",
]
