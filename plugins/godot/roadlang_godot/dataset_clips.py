"""The color pictures of a data set as clips, one for each camera of each scene."""

from __future__ import annotations

import tempfile
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path

from roadlang.api import Code, DatasetFrame

from .faults import fault


def clips_of(
    frames: Iterable[DatasetFrame], paths: Mapping[str, Path], rate: float
) -> Iterator[tuple[str, bytes]]:
    """Names and contents of clips (motion JPEG in AVI) with `rate` pictures a second.

    `paths`: where the pictures are, by the names that the frames give. Raises `EngineError` RL515.
    """
    pictures: dict[str, list[Path]] = {}
    for frame in frames:
        # What follows the number of the moment, without the output: `ego.front`.
        camera = frame.files["rgb"].partition(".")[2].removesuffix(".rgb.png")
        pictures.setdefault(f"scene-{frame.scene:04d}.{camera}.avi", []).append(
            paths[frame.files["rgb"]]
        )
    for name, of_clip in pictures.items():
        yield name, _clip(of_clip, rate, name)


def _clip(pictures: list[Path], rate: float, name: str) -> bytes:
    import cv2

    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "clip.avi"
        height, width = cv2.imread(str(pictures[0])).shape[:2]
        code = cv2.VideoWriter.fourcc(*"MJPG")
        out = cv2.VideoWriter(str(path), code, rate, (width, height))
        if not out.isOpened():
            raise fault(Code.CLIP_NOT_WRITTEN, path=name)
        for picture in pictures:
            out.write(cv2.imread(str(picture)))
        out.release()
        return path.read_bytes()
