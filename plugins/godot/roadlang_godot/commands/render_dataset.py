"""`roadlang render FILE --dataset DIR`: labeled pictures of the drives of a scene."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

from roadlang.commands import ProgressBar, python_controllers, report

if TYPE_CHECKING:
    from roadlang.api import Dataset
    from roadlang_godot.rendering.labeled_frames import Moment, Sampling


def write_labeled(
    loaded: Any,
    folder: Path,
    sampling: Sampling,
    count: int,
    scenes: int,
    seed: int,
    clips: bool,
) -> tuple[int, int]:
    """Write `count` moments to a folder, at least from so many scenes; returns the numbers of
    moments and pictures. Scenes whose drives end early are followed by more."""
    from roadlang_godot.rendering.dataset_files import write_dataset
    from roadlang_godot.rendering.labeled_frames import labeled_moments

    pictures = 0

    def counted(moments: Iterator[Moment]) -> Iterator[Moment]:
        nonlocal pictures
        with ProgressBar("moments") as progress:
            for number, moment in enumerate(moments, start=1):
                pictures += len(moment)
                progress(number, count)
                yield moment

    drawn = _driven_scenes(loaded, scenes, seed, most=max(scenes, count))
    moments = labeled_moments(drawn, sampling, count, -(-count // scenes))
    index = _index(loaded, seed, sampling.interval)
    written = write_dataset(folder, counted(moments), index, clips)
    return written, pictures


def _driven_scenes(loaded: Any, first: int, seed: int, most: int) -> Iterator[tuple[Any, Any]]:
    """Scenes with their controllers: as many as are needed, `first` of them at once."""
    made = 0
    while made < most:
        scenes = loaded.sample(min(most, max(first, 2 * made)), seed=seed)
        if not made:
            report(scenes.diagnostics)
        if len(scenes) <= made:
            return
        for scene in scenes[made:]:
            yield scene.record, python_controllers(scene.record, loaded.registry, loaded.places)
        made = len(scenes)


def _index(loaded: Any, seed: int, interval: float) -> Dataset:
    from roadlang import __version__
    from roadlang.api import Dataset

    scene = loaded.sample(1, seed=seed)[0].record
    digest = hashlib.sha256(loaded.text.encode()).hexdigest()
    return Dataset(
        name=scene.name,
        title=scene.title,
        roadlang=__version__,
        engine="",
        source=str(loaded.path),
        seed=seed,
        interval=interval,
        classes={},
        frames=(),
        params=dict(sorted(loaded.params.items())),
        inputs={str(loaded.path): digest, **loaded.inputs, **scene.provenance.inputs},
        plugins=dict(scene.provenance.plugins),
    )
