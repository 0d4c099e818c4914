"""A set of labeled pictures as files of one folder, with its index."""

from __future__ import annotations

import json
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

from roadlang.api import Dataset, DatasetFrame, to_json
from roadlang.commands import staged_set
from roadlang_standard.semantic_classes import class_table

from .clips import clips_of
from .labeled_frames import LabeledFrame, Moment

INDEX = "dataset.json"


def write_dataset(
    folder: Path, moments: Iterable[Moment], index: Dataset, clips: bool = False
) -> int:
    """Write all moments and the index, or nothing; returns the number of moments. With `clips` the
    color pictures of each camera are a clip too.

    Files of a set that was there before go. Raises `DiagnosticError` RL460, and whatever making
    the moments raises.
    """
    count = 0
    frames = []
    with staged_set(folder, INDEX, _files_of) as files:
        for moment in moments:
            for frame in moment:
                names = _names(count, frame)
                for output, content in frame.contents.items():
                    files.add(names[output], content)
                frames.append(_entry(count, frame, names))
                index = replace(index, engine=frame.engine)
            count += 1
        names_of_clips = []
        for name, content in clips_of(frames, files.paths(), 1 / index.interval) if clips else ():
            files.add(name, content)
            names_of_clips.append(name)
        whole = replace(
            index, classes=class_table(), frames=tuple(frames), clips=tuple(names_of_clips)
        )
        files.add(INDEX, to_json(whole).encode())
    return count


def _names(moment: int, frame: LabeledFrame) -> dict[str, str]:
    """Of copies of an agent, `oncoming[2]` is `oncoming-2`: brackets are wildcards in shells."""
    agent = frame.camera.agent.replace("[", "-").replace("]", "")
    return {
        output: f"{moment:06d}.{agent}.{frame.camera.name}.{output}"
        + (".json" if output == "labels" else ".png")
        for output in frame.contents
    }


def _entry(moment: int, frame: LabeledFrame, names: dict[str, str]) -> DatasetFrame:
    camera = frame.camera
    return DatasetFrame(moment, frame.scene, frame.time, camera.agent, camera.name, names)


def _files_of(index: Path) -> list[str]:
    """The files of an earlier set; none where its index cannot be read."""
    try:
        known = json.loads(index.read_text(encoding="utf-8"))
        pictures = [name for frame in known["frames"] for name in frame["files"].values()]
        return pictures + list(known["clips"])
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        return []
