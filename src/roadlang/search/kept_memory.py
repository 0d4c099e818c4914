"""Memory that a worker process keeps for its next job."""

from __future__ import annotations

import ctypes
import sys

_TRIM_THRESHOLD, _MMAP_THRESHOLD = -1, -3
"""The parameters of `mallopt` in glibc: how much free memory at the end of the heap is given back,
and from which size on memory is not taken from the heap."""
_KEPT, _FROM_HEAP = 1 << 30, 1 << 25
"""bytes; the second is the most that glibc takes"""


def keep_memory() -> None:
    """From now on freed memory is used again instead of being given back to the system, where that
    can be set: each job needs about as much as the one before, and every page that the system hands
    out anew costs a fault, which takes longer than to write it."""
    if sys.platform != "linux":
        return
    mallopt = getattr(ctypes.CDLL(None), "mallopt", None)
    if mallopt is not None:
        mallopt(_TRIM_THRESHOLD, _KEPT)
        mallopt(_MMAP_THRESHOLD, _FROM_HEAP)
