"""Files that plugins read: with the limits and diagnostics of those that a scene names."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from ..diagnostics import Code, DiagnosticError, diagnose
from ..files.reading import LARGEST_INPUT
from ..files.table_text import decoded

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


def read_input(path: Path, limit: int = LARGEST_INPUT) -> bytes:
    """The bytes of a regular file of at most `limit` bytes.

    Raises `DiagnosticError` RL400, RL401; the place in the scene file is added where it is known.
    """
    from .image_file import read_input

    return read_input(path, path.name, None, limit)


def read_text(path: Path) -> str:
    """The text of a file in UTF-8, in UTF-16 with its mark, or in Latin-1.

    Raises `DiagnosticError` RL400, RL401, and RL477 for what is no text.
    """
    try:
        return decoded(read_input(path))
    except UnicodeDecodeError:
        found = diagnose(Code.UNREADABLE_TABLE, file=path.name, reason="it is not text")
        raise DiagnosticError(found) from None


def read_image(path: Path) -> NDArray[np.uint8]:
    """The pixels (height, width, 3) BGR of an image, row 0 at the top.

    Raises `DiagnosticError` RL400 to RL405; RL404 also where a part of the image is damaged, which
    an `image` of a scene warns of (RL446).
    """
    from .image_file import open_image

    opened = open_image(path, path.name, None)
    if opened.damage:
        said = (*(each.message for each in opened.damage), "get the file again from its source")
        name = path.name
        raise DiagnosticError(
            diagnose(Code.DAMAGED_IMAGE, help=said, path=name, file=name, format="JPEG")
        )
    return opened.pixels
