"""A set of scenes to files in a folder, with their manifest.

A facade: a set of scenes writes itself, and what writes it takes the set.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from ..diagnostics import Code, DiagnosticError, diagnose, did_you_mean
from ..files.writing import write_set
from ..scenes.emitting import backends_of, outputs, send
from .manifest import files_named_in, manifest_of

if TYPE_CHECKING:
    from ..ir.manifest import Manifest
    from .loading import LoadedScenario
    from .scene_set import SceneSet

MANIFEST = "manifest.json"


def kinds_to_emit(loaded: LoadedScenario, kinds: Sequence[str] | None) -> Sequence[str] | None:
    """The backends to use instead of the file's; None where the file's are meant.

    Raises `DiagnosticError` RL930 for kinds that are not there, RL928 where there are none.
    """
    scenario, registry = loaded.scenario, loaded.registry
    if kinds is None and not scenario.emits:
        return [entry.qualified for entry in registry.defaults("emit")]
    faults = []
    for name in kinds or ():
        if not registry.has("emit", name):
            known = registry.names("emit")
            hints = did_you_mean(name, known) or (f"there are {', '.join(known)}",)
            faults.append(diagnose(Code.UNKNOWN_CHOICE, what="backend", name=name, help=hints))
    if kinds is not None and not kinds:
        faults.append(diagnose(Code.NOTHING_TO_EMIT, help="for instance `--emit json,svg`"))
    if faults:
        raise DiagnosticError(*faults)
    return kinds


def emit(
    scenes: SceneSet,
    folder: Path,
    kinds: Sequence[str] | None,
    progress: Callable[[int, int], None] | None,
) -> Manifest:
    """Write everything, then deliver to the backends that speak to an engine."""
    from ..ir.encoding import to_json

    folder = folder.absolute()  # before a plugin can change the current folder
    loaded = scenes.loaded
    backends = backends_of(loaded.scenario, loaded.registry, kinds_to_emit(loaded, kinds))
    records = [scene.record for scene in scenes]
    written = outputs(backends, records, progress)
    manifest = manifest_of(
        loaded.scenario,
        scenes.result,
        written,
        str(loaded.path),
        scenes.seed,
        loaded.params,
        backends,
    )
    contents = {output.path: output.content for output in written}
    contents[MANIFEST] = to_json(manifest).encode()
    write_set(folder, contents, MANIFEST, files_named_in)
    send(backends, records)
    return manifest
