"""What libjpeg and libpng print of damaged pictures: kept off standard error, and read."""

from __future__ import annotations

import os
import tempfile
import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress

_STANDARD_ERROR = 2
_ONE_AT_A_TIME = threading.Lock()
_DAMAGE = ("Corrupt JPEG data", "Premature end of JPEG file", "Inconsistent progression sequence")
"""What lines of libjpeg begin with (`jerror.h`) where it makes up a part of the picture. libpng
refuses every damaged one."""
_OF_CODECS = (*_DAMAGE, "libpng ", "Invalid SOS ", "Unknown Adobe ", "Warning: ")


class CodecOutput:
    """What was printed, once `codec_output` has ended."""

    def __init__(self) -> None:
        self.lines: list[str] = []

    @property
    def damage(self) -> str | None:
        """What libjpeg says is damaged, in its words; None where it decoded all."""
        return next((line for line in self.lines if line.startswith(_DAMAGE)), None)


@contextmanager
def codec_output() -> Iterator[CodecOutput]:
    """These libraries print to the file descriptor of the whole process. Meanwhile that is a
    temporary file, of whose lines those of other threads are printed at the end."""
    output = CodecOutput()
    with _ONE_AT_A_TIME, tempfile.TemporaryFile() as file:
        before: int | None = None
        with suppress(OSError):  # where there is no standard error
            before = os.dup(_STANDARD_ERROR)
        try:
            os.dup2(file.fileno(), _STANDARD_ERROR)
            yield output
        finally:
            if before is None:
                os.close(_STANDARD_ERROR)
            else:
                os.dup2(before, _STANDARD_ERROR)
                os.close(before)
            file.seek(0)
            printed = file.read()
            output.lines = printed.decode("utf-8", "replace").splitlines()
            if before is not None and threading.active_count() > 1:
                _print_others(printed)


def _print_others(printed: bytes) -> None:
    lines = printed.splitlines(keepends=True)
    words = tuple(word.encode() for word in _OF_CODECS)
    with suppress(OSError):
        os.write(_STANDARD_ERROR, b"".join(each for each in lines if not each.startswith(words)))
