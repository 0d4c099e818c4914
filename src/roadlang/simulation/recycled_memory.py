"""Memory of large arrays, which is used again once nobody holds them any more: the system clears
new memory before it hands it out, which takes longer than to write the numbers."""

from __future__ import annotations

import math
import weakref

import numpy as np

from ..geometry.arrays import Floats

LARGE = 2**22
"""Bytes of an array from which on its memory is used again; numpy has it in large pages then."""
KEPT = 5 * 2**26
"""Bytes of unused memory that are kept, at most."""
_SPARE = 1.125
"""How much more new memory is than it has to be: tables of other roads are a little larger."""
_LINE = 64
"""Bytes that a processor fetches at once: a cell of the table of lines is that long."""


class MemoryPool:
    """Memory that was given back, for arrays of at least `LARGE` bytes. It may be used by several
    threads."""

    def __init__(self, kept: int = KEPT) -> None:
        """`kept`: bytes of unused memory, at most."""
        self._kept = kept
        self._unused: dict[int, Floats] = {}
        """by identity, the longest unused first"""

    def empty(self, *shape: int) -> Floats:
        """An array with whatever numbers are in its memory, which begins where a processor fetches
        it. The memory is its own for as long as it or any view of it is held."""
        count = math.prod(shape)
        if 8 * count < LARGE:
            return np.empty(shape)
        memory = self._taken(count + _LINE // 8)
        # Its base is no array, so that views of it are based on it, and it outlives them.
        owner: Floats = np.frombuffer(memory.data)
        weakref.finalize(owner, self._give_back, memory).atexit = False
        begin = (-memory.ctypes.data % _LINE) // 8
        return owner[begin : begin + count].reshape(shape)

    def _taken(self, count: int) -> Floats:
        """Memory for this many numbers: some that is unused and not much too large, if there is
        any."""
        fitting = [one for one in list(self._unused.values()) if count <= len(one) <= 2 * count]
        for memory in sorted(fitting, key=len):
            if self._unused.pop(id(memory), None) is not None:  # no other thread has taken it
                return memory
        return np.empty(int(_SPARE * count))

    def _give_back(self, memory: Floats) -> None:
        self._unused[id(memory)] = memory
        kept = 0
        for key, one in reversed(list(self._unused.items())):
            kept += one.nbytes
            if kept > self._kept:
                self._unused.pop(key, None)


RECYCLED = MemoryPool()
"""That of the process."""
