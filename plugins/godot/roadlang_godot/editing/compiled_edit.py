"""What an edit of a text makes of its scene, for the window that shows it."""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from roadlang import LoadedScenario
    from roadlang.api import Controller, Scene
    from roadlang.commands import Handle


@dataclass(frozen=True)
class CompiledEdit:
    """What an edit of the text makes of the scene, with what drives its agents."""

    loaded: LoadedScenario
    scene: Scene
    controllers: Mapping[str, Controller]
    handles: Sequence[Handle]
    seconds: float
    """that compiling took"""


def compiled(loaded: LoadedScenario, seed: int) -> CompiledEdit:
    """The scene of a text."""
    from roadlang.commands import handles_of, python_controllers

    began = time.monotonic()
    (scene,) = loaded.sample(1, seed=seed)
    controllers = python_controllers(scene.record, loaded.registry, loaded.places)
    handles = handles_of(loaded.text, scene.record)
    return CompiledEdit(loaded, scene.record, controllers, handles, time.monotonic() - began)
