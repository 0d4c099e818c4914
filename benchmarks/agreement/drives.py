"""Drives scenes in both engines."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from roadlang.api import EngineSettings, Scene, Trace, simulate_scenes
from roadlang.drive.controllers import python_controllers
from roadlang.plugins.discovery import load_registry
from roadlang_godot.drive.simulate import Settings, drive_scenes
from roadlang_standard.engine_tables import BODIES

DURATION = 30.0


def in_godot(scenes: Sequence[Scene]) -> list[Trace]:
    """The drives in one Godot engine."""
    registry = load_registry()
    controllers = [python_controllers(scene, registry) for scene in scenes]
    return list(drive_scenes(scenes, Settings(DURATION, 0.05), controllers))


def in_embedded(scenes: Sequence[Scene], grip: float = 1.0) -> list[Trace]:
    """The drives in the embedded engine, with the friction of the scenes times `grip`."""
    registry = load_registry()
    slick = [
        replace(scene, world={**scene.world, "friction": grip * scene.world["friction"]})
        for scene in scenes
    ]
    controllers = [python_controllers(scene, registry) for scene in slick]
    settings = EngineSettings(duration=DURATION, step=0.05, bodies=BODIES)
    return list(simulate_scenes(slick, controllers, settings))
