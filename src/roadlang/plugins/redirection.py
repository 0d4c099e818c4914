"""Standard output while code of plugins runs: what that prints goes to standard error.

Several threads may run code of plugins at once. `sys.stdout` is redirected from the first one that
begins until the last one that ends; a thread that runs none prints to `standard_output()`.
"""

from __future__ import annotations

import sys
import threading
from typing import TextIO

_lock = threading.Lock()
_depths: dict[int, int] = {}
"""how many calls of plugins are nested in each thread that runs any"""
_output: TextIO = sys.stdout
"""what `sys.stdout` was before the first of them"""


def standard_output() -> TextIO:
    """Where this thread prints, whatever code other threads run."""
    with _lock:
        only_others = bool(_depths) and threading.get_ident() not in _depths
        return _output if only_others else sys.stdout


def begin_redirection() -> None:
    """From now on this thread runs code of a plugin. May be nested."""
    global _output
    thread = threading.get_ident()
    if thread in _depths:  # as at every step of a drive; no other thread changes this entry
        _depths[thread] += 1
        sys.stdout = sys.stderr
        return
    with _lock:
        if not _depths:
            _output = sys.stdout
        _depths[thread] = 1
        sys.stdout = sys.stderr


def end_redirection() -> None:
    """The innermost code of a plugin that this thread runs has ended."""
    thread = threading.get_ident()
    if _depths[thread] > 1:
        _depths[thread] -= 1
        return
    with _lock:
        del _depths[thread]
        if not _depths:
            sys.stdout = _output
