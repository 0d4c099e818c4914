"""The environment of programs that plugins start: that of roadlang, without what it set itself."""

from __future__ import annotations

import os

_OPENCV_THREADS, _SET_HERE = "OPENCV_FOR_THREADS_NUM", "ROADLANG_ONE_THREAD"
"""The second records, also for worker processes, what roadlang set the first to."""


def one_thread_for_opencv() -> None:
    """OpenCV starts threads unless told otherwise before it is imported. A choice of the user's
    stays."""
    if _OPENCV_THREADS not in os.environ:
        os.environ.update({_OPENCV_THREADS: "1", _SET_HERE: "1"})


def program_environment() -> dict[str, str]:
    """The environment for a program that is no part of roadlang: the same with any number of
    worker processes."""
    environment = dict(os.environ)
    ours = environment.pop(_SET_HERE, None)
    if ours is not None and environment.get(_OPENCV_THREADS) == ours:
        del environment[_OPENCV_THREADS]
    return environment
