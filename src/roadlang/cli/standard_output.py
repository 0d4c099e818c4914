"""Standard streams: there are always three, and output belongs to the results of a command."""

from __future__ import annotations

import io
import os
import sys

_OUT, _ERR = 1, 2


def open_closed_streams() -> None:
    """Give a process that was started without some of them (`>&-`, a daemon) empty ones.

    From the first to the last, so that each gets its own descriptor and no file that is written
    later is taken for standard output by a library.
    """
    for name, mode in (("stdin", "r"), ("stdout", "w"), ("stderr", "w")):
        if getattr(sys, name) is None:
            descriptor = os.open(os.devnull, os.O_RDWR)
            setattr(sys, name, os.fdopen(descriptor, mode, encoding="utf-8"))


def claim_standard_output() -> None:
    """Keep standard output for `sys.stdout`; what is written to file descriptor 1 goes to stderr.

    Libraries written in C, which OpenCV, simulators and plugins load, print to the descriptor
    itself, some of it only when the process ends.
    """
    before = sys.stdout
    if not isinstance(before, io.TextIOWrapper):
        return
    try:
        ours = os.dup(_OUT)
        os.dup2(_ERR, _OUT)
    except OSError:  # closed from the start
        return
    raw = io.FileIO(ours, "w")
    sys.stdout = io.TextIOWrapper(
        raw if before.write_through else io.BufferedWriter(raw),
        encoding=before.encoding,
        errors=before.errors,
        newline=None if os.name == "nt" else "\n",
        line_buffering=before.line_buffering,
        write_through=before.write_through,
    )
