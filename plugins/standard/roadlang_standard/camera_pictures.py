"""Outputs of cameras as pictures and clips."""

from __future__ import annotations

import tempfile
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from roadlang.api import Code, DiagnosticError, diagnose

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

DEPTH_UNIT = 0.01
"""Meters for 1 in pictures of depth."""
_FARTHEST = 65535
_CODECS = {".avi": "MJPG", ".mp4": "mp4v"}


def png_of(output: str, array: NDArray[Any]) -> bytes:
    """A PNG file of one output of a camera, (height, width[, 3]) from the top left.

    `rgb` has 8 bits a color; `depth` 16 bits in units of `DEPTH_UNIT`, 0 for what is not within
    reach of them; `semantic` 8 bits; `instance` 16 bits.
    """
    import cv2
    import numpy as np

    picture = array[..., ::-1] if output == "rgb" else array
    if output == "depth":
        picture = depth_numbers(array)
    return bytes(cv2.imencode(".png", np.ascontiguousarray(picture))[1])


def depth_numbers(depth: NDArray[np.float32]) -> NDArray[np.uint16]:
    """Depth in meters as 16 bit numbers."""
    import numpy as np

    numbers = np.rint(depth / np.float32(DEPTH_UNIT))
    return np.where(numbers <= _FARTHEST, numbers, 0).astype(np.uint16)


def clip_of(pictures: Iterable[NDArray[np.uint8]], rate: float, name: str) -> bytes:
    """A clip of color pictures (height, width, 3) of one size, at least one, `rate` a second.

    Motion JPEG in AVI or MPEG-4, by the ending of `name`. Raises `DiagnosticError` RL515.
    """
    import cv2
    import numpy as np

    # In memory, so that a file is whole or absent; OpenCV writes to files alone.
    with tempfile.TemporaryDirectory() as folder:
        path, out = Path(folder) / f"clip{Path(name).suffix}", None
        for picture in pictures:
            if out is None:
                height, width = picture.shape[:2]
                code = cv2.VideoWriter.fourcc(*_CODECS[path.suffix])
                out = cv2.VideoWriter(str(path), code, rate, (width, height))
            if not out.isOpened():
                raise DiagnosticError(diagnose(Code.CLIP_NOT_WRITTEN, path=name))
            out.write(np.ascontiguousarray(picture[..., ::-1]))
        if out is not None:
            out.release()
        return path.read_bytes()
