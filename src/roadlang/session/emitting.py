"""A set of scenes to files in a folder, with their manifest."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..files.staging import StagingFolder, staged_set
from ..ir.manifest import MANIFEST_FILE, OutputFile
from ..ir.values import NO_OPTIONS, PassCall
from ..plugins.finding import entry_of
from ..scenes.emitting import (
    Output,
    OutputNames,
    backends_of,
    outputs_of_all,
    outputs_of_scene,
    send,
)
from .manifest import manifest_of
from .manifest_files import files_named_in
from .result_folders import refuse_results_of_others

if TYPE_CHECKING:
    from ..ir.manifest import Manifest
    from ..ir.scene import Scene
    from ..plugins.registry import Registry
    from ..scenes.sampling import SamplingResult
    from .loading import LoadedScenario


DEFAULT_EMITS = ("json", "svg")
"""What a file without an `emit` is taken to mean."""


def _default_emits(registry: Registry) -> list[PassCall]:
    entries = [entry_of(registry, "emit", name) for name in DEFAULT_EMITS]
    return [
        PassCall("emit", entry.qualified, NO_OPTIONS, f"emit {entry.name}") for entry in entries
    ]


def emit(
    loaded: LoadedScenario,
    result: SamplingResult,
    seed: int,
    folder: Path,
    progress: Callable[[int, int], None] | None,
) -> Manifest:
    """Write everything, then deliver to the backends that speak to an engine."""
    records = result.scenes
    with SetWriting(loaded, folder) as writing:
        for number, record in enumerate(records):
            for output in outputs_of_scene(writing.backends, record):
                writing.add(output)
            if progress is not None:
                progress(number, len(records))
        manifest = writing.finish(result, seed, records)
    send(writing.backends, records)
    return manifest


class SetWriting:
    """The files of a scenario, written one after the other; they are in the folder at the end.

    Raises `DiagnosticError` RL460 for a folder with results of another command."""

    def __init__(self, loaded: LoadedScenario, folder: Path) -> None:
        scenario, registry = loaded.scenario, loaded.registry
        refuse_results_of_others(folder, "compile")
        calls = scenario.emits or _default_emits(registry)
        self.backends = backends_of(scenario, registry, calls)
        self._loaded = loaded
        self._staging = staged_set(folder, MANIFEST_FILE, files_named_in)
        self._names = OutputNames(self.backends)
        self._written: list[OutputFile] = []

    def __enter__(self) -> SetWriting:
        self._files = self._staging.__enter__()
        return self

    def __exit__(self, *error: Any) -> bool | None:
        return self._staging.__exit__(*error)

    def add(self, output: Output) -> None:
        """Write a file, unless another has its name."""
        self.take(output.record(), output.content)

    def take(self, record: OutputFile, content: bytes | PathLike[str]) -> None:
        """Write a file of which everything is known, or move it here from the staging folder."""
        self._names.add(record)
        self._files.add(record.path, content)
        self._written.append(record)

    def staging_folder(self) -> StagingFolder:
        """Where other processes of this machine write."""
        return self._files.staging_folder()

    def finish(self, result: SamplingResult, seed: int, scenes: Sequence[Scene]) -> Manifest:
        """Add what is written once for all scenes."""
        from ..ir.encoding import to_json

        for output in outputs_of_all(self.backends, scenes):
            self.add(output)
        manifest = manifest_of(self._loaded, result, seed, self._written, self.backends)
        self._files.add(MANIFEST_FILE, to_json(manifest).encode())
        return manifest
