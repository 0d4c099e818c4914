"""Drives whole scenes: builds them, lets the engine or Python drive, and gives back traces."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from roadlang.api import Code

from . import driving, engine
from .drives import decided_in_python
from .faults import EngineError, fault
from .followed_scene import FollowedScene
from .layout import layout_of
from .session import Session
from .telemetry import of_agent

if TYPE_CHECKING:
    from roadlang.api import Controller, Scene, Trace

MOST_LOSSES = 3
"""Engines that one scene may lose before it counts as their cause."""
_LOST = frozenset({Code.GODOT_DISCONNECTED, Code.GODOT_NOT_ANSWERING})
LEAST_RATE = 60.0
"""Ticks a second below which wheeled bodies are not stable in Godot."""


@dataclass(frozen=True, slots=True)
class Settings:
    """How to drive: seconds at most, seconds between records, with a window or without."""

    duration: float = 60.0
    step: float = 0.02
    headless: bool = True
    road: str = "mesh"

    @property
    def every(self) -> int:
        """Physics ticks between two records."""
        return max(1, math.ceil(LEAST_RATE * self.step - 1e-9))

    @property
    def rate(self) -> int:
        """Physics ticks a second."""
        return max(1, round(self.every / self.step))

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

    An engine that is lost is started again, and drives the same scene from its start: the trace is
    the same. Raises RL505 with the name of a scene with which `MOST_LOSSES` engines were lost.
    """
    engines = RestartedEngine(settings)
    try:
        for scene, of_scene in zip(scenes, controllers, strict=True):
            yield engines.drive(scene, of_scene)
    finally:
        engines.stop()


class RestartedEngine:
    """An engine with a session, started when it is needed, and again when it is lost."""

    def __init__(self, settings: Settings) -> None:
        self._settings = settings
        self._engine: engine.Engine | None = None
        self._session: Session | None = None

    def drive(self, scene: Scene, controllers: Controllers) -> Trace:
        """Drive a scene, again where the engine is lost on the way."""
        for attempt in range(MOST_LOSSES):
            try:
                return drive_in(self._connected(scene), scene, self._settings, controllers)
            except EngineError as error:
                lost = {found.code for found in error.diagnostics} & _LOST
                if not lost:
                    raise
                self.stop()
                if attempt + 1 == MOST_LOSSES:
                    raise _lost_with(scene, error) from error
        raise AssertionError("unreachable")

    def stop(self) -> None:
        """End the session and the engine."""
        session, running = self._session, self._engine
        self._session = self._engine = None
        if session is not None:
            session.close()
        if running is not None:
            running.stop()

    def _connected(self, scene: Scene) -> Session:
        if self._session is None:
            fixed = self._settings.rate if self._settings.headless else None
            self._engine = engine.start(fixed_fps=fixed, window=not self._settings.headless)
            self._session = self._engine.connect(scene.name)
        return self._session


def _lost_with(scene: Scene, error: EngineError) -> EngineError:
    reason = f"{MOST_LOSSES} engines were lost in scene {scene.index} of `{scene.name}`"
    last = [found.message for found in error.diagnostics]
    return fault(Code.GODOT_DISCONNECTED, [f"the last one: {text}" for text in last], reason=reason)


def drive_in(session: Session, scene: Scene, settings: Settings, controllers: Controllers) -> Trace:
    """Build and drive a scene in a session.

    The engine drives alone where it has copies of all controllers, else Python decides for all
    agents that `controllers` has. Raises `EngineError` RL700 where nothing drives, RL510 where a
    controller is missing.
    """
    decided = decided_in_python(scene, controllers)
    layout = layout_of(scene, settings.road, python_driven=decided)
    if not layout.agents:
        raise fault(Code.NO_AGENTS, scene=scene.name)
    for name in layout.undriven:
        kind = next(actor.drive[-1].kind for actor in scene.agents if actor.name == name)
        raise fault(Code.UNSUPPORTED_CONTROLLER, kind=kind, engine="Godot's project")
    session.begin(layout.settings(settings.rate), clear=True)
    session.update(layout.parts)
    session.prove()
    followed = FollowedScene(
        scene, layout, settings.every / settings.rate, settings.rate, decided
    )  # fmt: skip
    if decided:
        _step_by_step(session, followed, settings)
    else:
        drive = driving.run(session, settings.ticks, every=settings.every, stop_at_end=True)
        _record(drive, followed, len(layout.agents))
    return followed.trace(_name(session))


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
        traces.append(followed.trace(_name(session)))
    return traces


def _step_by_step(session: Session, followed: FollowedScene, settings: Settings) -> None:
    """Drive in lock-step: at every step Python sees all agents, and decides for them."""
    with driving.LockStep(session) as lock:
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


def _name(session: Session) -> str:
    welcome: Mapping[str, Any] = session.welcome
    return f"Godot {welcome.get('godot')} with {welcome.get('physics')}"


__all__ = ["Controllers", "Settings", "drive_batch", "drive_in", "drive_scenes", "of_agent"]
