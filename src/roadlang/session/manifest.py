"""The manifest of a compilation."""

from __future__ import annotations

import contextlib
import hashlib
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from ..evaluate.kind_instance import KindInstance
from ..files.reading import UnreadableFile, read_file
from ..ir.manifest import Manifest, OutputFile, RequirementRecord
from ..ir.recorded_names import recorded_name
from ..ir.scenario import Scenario
from ..version import __version__

if TYPE_CHECKING:
    from ..scenes.sampling import SamplingResult
    from .loading import LoadedScenario


def manifest_of(
    loaded: LoadedScenario,
    result: SamplingResult,
    seed: int,
    written: Sequence[OutputFile],
    backends: Sequence[KindInstance],
) -> Manifest:
    """What was written, from what, and how the requirements fared."""
    scenario = loaded.scenario
    sampled = result.scenes[0].provenance
    inputs = {**loaded.inputs, **scene_file_digests(scenario), **sampled.inputs}
    emitting = {b.entry.origin.distribution: b.entry.origin.version for b in backends}
    return Manifest(
        name=scenario.header.name,
        title=scenario.header.title,
        roadlang=__version__,
        source=recorded_name(loaded.path),
        seed=seed,
        scenes=result.accepted,
        requested=result.wanted,
        candidates=result.candidates,
        diversity=_rounded(result.diversity),
        expected_diversity=_rounded(result.expected_diversity),
        inputs=dict(sorted(inputs.items())),
        plugins=dict(sorted({**sampled.plugins, **emitting}.items())),
        overrides=dict(sorted(loaded.params.items())),
        requirements=tuple(
            RequirementRecord(row.name, row.text, row.tried, row.rejected, row.best)
            for row in sorted(result.table, key=lambda row: (row.line or 0, row.name))
        ),
        files=tuple(sorted(written, key=lambda file: file.path)),
    )


def _rounded(value: float | None) -> float | None:
    """To what every machine computes alike."""
    return None if value is None else float(f"{value:.6g}")


def scene_file_digests(scenario: Scenario) -> dict[str, str]:
    """sha256 of the scene file and its includes; of what cannot be read again, nothing."""
    digests = {}
    for source in scenario.inputs:
        path = Path(source.path)
        if source.sha256:
            digests[recorded_name(source.path)] = source.sha256
        else:
            with contextlib.suppress(UnreadableFile):
                digests[recorded_name(source.path)] = hashlib.sha256(read_file(path)).hexdigest()
    return digests
