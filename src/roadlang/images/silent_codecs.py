"""Keeps what libjpeg and libpng print of damaged pictures off standard error."""

from __future__ import annotations

import os
import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress

_STANDARD_ERROR = 2


@contextmanager
def silent_codecs() -> Iterator[None]:
    """Nothing is printed meanwhile; the diagnostic of roadlang says what is wrong.

    These libraries print by themselves, to the file descriptor of the whole process: where another
    thread runs, whose lines would be lost too, and where there is no standard error, nothing is
    redirected.
    """
    opened: list[int] = []
    try:
        if threading.active_count() == 1:
            with suppress(OSError):
                opened.append(os.dup(_STANDARD_ERROR))
                opened.append(os.open(os.devnull, os.O_WRONLY))
                os.dup2(opened[1], _STANDARD_ERROR)
        yield
    finally:
        if opened:
            os.dup2(opened[0], _STANDARD_ERROR)
        for each in opened:
            os.close(each)
