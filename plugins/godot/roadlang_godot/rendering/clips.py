"""Clips of pictures that are files."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from roadlang.api import DatasetFrame
from roadlang_standard.camera_pictures import clip_of

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


def clips_of(
    frames: Iterable[DatasetFrame], paths: Mapping[str, Path], rate: float
) -> Iterator[tuple[str, bytes]]:
    """Names and contents of clips (motion JPEG in AVI) with `rate` pictures a second.

    `paths`: where the pictures are, by the names that the frames give. Raises `DiagnosticError`
    RL515.
    """
    pictures: dict[str, list[Path]] = {}
    for frame in frames:
        # What follows the number of the moment, without the output: `ego.front`.
        camera = frame.files["rgb"].partition(".")[2].removesuffix(".rgb.png")
        pictures.setdefault(f"scene-{frame.scene:04d}.{camera}.avi", []).append(
            paths[frame.files["rgb"]]
        )
    for name, of_clip in pictures.items():
        yield name, clip_of((decoded(path.read_bytes()) for path in of_clip), rate, name)


def decoded(picture: bytes) -> NDArray[np.uint8]:
    """The colors (height, width, 3) of a PNG or JPEG picture."""
    import cv2
    import numpy as np

    pixels = cv2.imdecode(np.frombuffer(picture, np.uint8), cv2.IMREAD_COLOR)
    return np.asarray(pixels, np.uint8)[..., ::-1]
