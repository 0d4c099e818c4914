"""Drives whole scenes: builds them, lets the engine or Python drive, and gives back traces."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from roadlang.api import Code

from . import driving, engine
from .drives import EMBEDDED_ONLY, plain_name
from .faults import fault
from .layout import Layout, layout_of
from .python_drive import PythonDriver
from .session import Session
from .telemetry import Records, of_agent
from .traces import trace_of

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
    """Drive scenes one after the other in one engine, each in a fresh world."""
    fixed = settings.rate if settings.headless else None
    with (
        engine.start(fixed_fps=fixed, window=not settings.headless) as running,
        running.connect(scenes[0].name) as session,
    ):
        for scene, of_scene in zip(scenes, controllers, strict=True):
            yield drive_in(session, scene, settings, of_scene)


def drive_in(session: Session, scene: Scene, settings: Settings, controllers: Controllers) -> Trace:
    """Build and drive a scene in a session.

    Raises `EngineError` RL700 where nothing drives, RL510 where a controller is missing.
    """
    layout = layout_of(scene, settings.road)
    if not layout.agents:
        raise fault(Code.NO_AGENTS, scene=scene.name)
    _check_controllers(scene, layout, controllers)
    controllers = {name: controllers[name] for name in layout.python_driven}
    session.begin(layout.settings(settings.rate), clear=True)
    session.update(layout.things)
    session.prove()
    if controllers:
        records = _step_by_step(session, scene, layout, settings, controllers)
    else:
        drive = driving.run(session, settings.ticks, every=settings.every, stop_at_end=True)
        records = drive.trace
    return trace_of(records, layout, scene, 1.0 / settings.rate, _name(session))


def drive_batch(session: Session, scenes: Sequence[Scene], settings: Settings) -> list[Trace]:
    """Drive many scenes at once, each in a world of its own within one engine."""
    layouts = [layout_of(scene, settings.road) for scene in scenes]
    for world, layout in enumerate(layouts):
        session.begin(layout.settings(settings.rate), world, clear=world == 0)
        session.update(layout.things, world)
        session.prove(world)
    drive = driving.run(session, settings.ticks, every=settings.every, stop_at_end=True)
    traces = []
    for world, (layout, scene) in enumerate(zip(layouts, scenes, strict=True)):
        rows = drive.trace[drive.trace["world"] == world].copy()
        rows["world"] = 0
        traces.append(trace_of(rows, layout, scene, 1.0 / settings.rate, _name(session)))
    return traces


def _step_by_step(
    session: Session,
    scene: Scene,
    layout: Layout,
    settings: Settings,
    controllers: Controllers,
) -> Records:
    """Drive in lock-step: at every step the controllers see all agents, and decide."""
    driver = PythonDriver(scene, layout, settings.every / settings.rate, controllers)
    parts = []
    with driving.LockStep(session) as lock:
        state = lock.state
        for _ in range(settings.ticks // settings.every):
            parts.append(state)
            controls = driver.controls(state)
            state = lock.step(controls, settings.every)
            if lock.at_end:
                break
        parts.append(state)
    return np.concatenate(parts)


def _check_controllers(scene: Scene, layout: Layout, controllers: Controllers) -> None:
    project = "Godot's project"
    for actor in scene.agents:
        needs = [EMBEDDED_ONLY.get(plain_name(call.kind)) for call in actor.drive]
        needs.append(None if actor.route is None else "routes")
        for what in filter(None, needs):
            raise fault(Code.EMBEDDED_ENGINE_ONLY, agent=actor.name, engine=project, what=what)
        if actor.name in layout.python_driven and actor.name not in controllers:
            kind = actor.drive[-1].kind
            raise fault(Code.UNSUPPORTED_CONTROLLER, kind=kind, engine=project)


def _name(session: Session) -> str:
    welcome: Mapping[str, Any] = session.welcome
    return f"Godot {welcome.get('godot')} with {welcome.get('physics')}"


__all__ = ["Controllers", "Settings", "drive_batch", "drive_in", "drive_scenes", "of_agent"]
