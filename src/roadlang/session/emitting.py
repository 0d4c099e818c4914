"""A set of scenes to files in a folder, with their manifest.

A facade: a set of scenes writes itself, and what writes it takes the set.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from ..files.writing import write_set
from ..ir.manifest import MANIFEST_FILE
from ..ir.values import NO_OPTIONS, PassCall
from ..plugins.finding import entry_of
from ..scenes.emitting import backends_of, outputs_of, send
from .manifest import files_named_in, manifest_of

if TYPE_CHECKING:
    from ..ir.manifest import Manifest
    from ..plugins.registry import Registry
    from .scene_set import SceneSet


DEFAULT_EMITS = ("json", "svg")
"""What a file without an `emit` is taken to mean."""


def _default_emits(registry: Registry) -> list[PassCall]:
    entries = [entry_of(registry, "emit", name) for name in DEFAULT_EMITS]
    return [
        PassCall("emit", entry.qualified, NO_OPTIONS, f"emit {entry.name}") for entry in entries
    ]


def emit(
    scenes: SceneSet,
    folder: Path,
    outputs: Sequence[str] | None,
    progress: Callable[[int, int], None] | None,
) -> Manifest:
    """Write everything, then deliver to the backends that speak to an engine."""
    from ..ir.encoding import to_json

    folder = folder.absolute()  # before a plugin can change the current folder
    loaded = scenes.loaded if outputs is None else scenes.loaded.with_outputs(outputs)
    scenario, registry = loaded.scenario, loaded.registry
    backends = backends_of(scenario, registry, scenario.emits or _default_emits(registry))
    records = [scene.record for scene in scenes]
    written = outputs_of(backends, records, progress)
    manifest = manifest_of(loaded, scenes.result, scenes.seed, written, backends)
    contents = {output.path: output.content for output in written}
    contents[MANIFEST_FILE] = to_json(manifest).encode()
    write_set(folder, contents, MANIFEST_FILE, files_named_in)
    send(backends, records)
    return manifest
