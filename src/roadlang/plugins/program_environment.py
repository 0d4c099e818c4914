"""The environment of programs that plugins start: that of roadlang, without what it set itself."""

from __future__ import annotations

import os

_OPENCV_THREADS, _SET_HERE = "OPENCV_FOR_THREADS_NUM", "ROADLANG_ONE_THREAD"
"""The second notes, also for worker processes, that the first is not from the user."""


def one_thread_for_opencv() -> None:
    """OpenCV starts threads unless told otherwise before it is imported. A choice of the user's
    stays."""
    if _OPENCV_THREADS not in os.environ:
        os.environ.update({_OPENCV_THREADS: "1", _SET_HERE: "1"})


def program_environment() -> dict[str, str]:
    """The environment for a program that is no part of roadlang: the same with any number of
    worker processes."""
    left_out = (_OPENCV_THREADS, _SET_HERE) if _SET_HERE in os.environ else ()
    return {name: value for name, value in os.environ.items() if name not in left_out}
