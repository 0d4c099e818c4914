"""Scenes that are written to a folder as they are found."""

from __future__ import annotations

import contextlib
from pathlib import Path
from typing import TYPE_CHECKING

from ..scenes.emitted import Emission, EmittedScene, held
from ..scenes.emitting import send
from ..scenes.spool import SceneSpool
from .emitting import SetWriting
from .scene_set import SceneSet, sampled

if TYPE_CHECKING:
    from ..ir.manifest import Manifest
    from ..scenes.sampling import SceneObserver
    from ..search.worker_pool import Workers
    from .loading import LoadedScenario


def compiled(
    loaded: LoadedScenario,
    folder: Path,
    n: int | None,
    seed: int,
    workers: Workers,
    after_pass: SceneObserver | None = None,
) -> tuple[SceneSet, Manifest]:
    """As `sample` and `emit`, but that scenes are written as they are found, so that memory does
    not grow with their number: those of the set are outlines, without roads and things."""
    folder = folder.absolute()
    with contextlib.closing(SceneSpool()) as spool:
        with SetWriting(loaded, folder) as writing:

            def take(scene: EmittedScene) -> None:
                for file in scene.files:
                    writing.take(file.record, file.content)
                if scene.whole is not None:
                    spool.add(scene.whole)

            # What processes write themselves need not be sent: memory for that is slow to come by.
            stage = writing.staging_folder().stage if workers.write_here else held
            emission = Emission(writing.backends, take, stage)
            scenes = sampled(loaded, n, seed, workers, after_pass, emission)
            manifest = writing.finish(scenes.result, seed, spool)
        send(writing.backends, spool)
    return scenes, manifest
