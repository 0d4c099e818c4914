"""An output that a command line names, for a scene without its scene file."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from ..diagnostics import DiagnosticError
from ..scenes.emitting import backends_of, outputs_of_scene
from .outputs import check_outputs

if TYPE_CHECKING:
    from ..evaluate.kind_instance import KindInstance
    from ..ir.scenario import Scenario
    from ..ir.scene import Scene
    from ..plugins.registry import Registry


def scenario_of_outputs(outputs: Sequence[str], registry: Registry) -> Scenario:
    """A scenario of nothing but `emit`s, written as `svg{size: 800px}`.

    Raises RL930, RL928, RL220 and the like for kinds and options.
    """
    from ..semantics import check_text

    check_outputs(outputs, registry)
    scenario, found = check_text("", Path("--emit"), {}, registry, outputs)
    if scenario is None:
        raise DiagnosticError(*found)
    return scenario


def emitted_files(output: str, scene: Scene, registry: Registry) -> dict[str, bytes]:
    """What an output (`geojson`, `svg{size: 800px}`) writes of a scene, by file ending.

    Raises RL930, RL220 and the like for its kind and options, RL470 where the plugin fails, and
    what the kind says of a scene that it cannot write.
    """
    scenario = scenario_of_outputs([output], registry)
    backends: list[KindInstance] = backends_of(scenario, registry, scenario.emits)
    start = len(scene.stem) + 1
    return {file.path[start:]: file.content for file in outputs_of_scene(backends, scene)}
