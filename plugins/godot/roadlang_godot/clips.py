"""Clips of pictures: in memory, so that a file of them is whole or absent."""

from __future__ import annotations

import tempfile
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from roadlang.api import Code, DatasetFrame

from .faults import fault

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


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
        yield name, clip_of((path.read_bytes() for path in of_clip), rate, name)


def clip_of(pictures: Iterable[bytes], rate: float, name: str) -> bytes:
    """A clip of PNG or JPEG pictures of one size, at least one. Raises `EngineError` RL515."""
    import cv2

    with tempfile.TemporaryDirectory() as folder:
        path, out = Path(folder) / "clip.avi", None
        for picture in pictures:
            pixels = _pixels(picture)
            if out is None:
                height, width = pixels.shape[:2]
                code = cv2.VideoWriter.fourcc(*"MJPG")
                out = cv2.VideoWriter(str(path), code, rate, (width, height))
            if not out.isOpened():
                raise fault(Code.CLIP_NOT_WRITTEN, path=name)
            out.write(pixels)
        if out is not None:
            out.release()
        return path.read_bytes()


def _pixels(picture: bytes) -> NDArray[np.uint8]:
    import cv2
    import numpy as np

    decoded = cv2.imdecode(np.frombuffer(picture, np.uint8), cv2.IMREAD_COLOR)
    return np.asarray(decoded, np.uint8)
