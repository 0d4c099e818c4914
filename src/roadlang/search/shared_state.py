"""What worker processes share: written once, and read by each of them when it starts."""

from __future__ import annotations

import pickle  # noqa: TID251 - what processes do with every argument
import shutil
from multiprocessing.shared_memory import SharedMemory
from typing import Any, TypeAlias, cast

Reference: TypeAlias = "tuple[str, int] | bytes"
"""The name of shared memory and how much of it counts, or the content itself."""

_FOLDER = "/dev/shm"
"""Where Linux has shared memory. It is often small in containers, and whoever writes beyond it is
killed."""


class SharedState:
    """A value in shared memory, until it is `withdrawn`.

    Not in the arguments of a process: they go through a pipe, and whoever writes more than that
    holds waits forever for a process that was killed before it read them. Where there is no room
    for it, the arguments have it all the same.
    """

    def __init__(self, value: Any) -> None:
        content = pickle.dumps(value)
        self._memory = _memory(len(content))
        self.reference: Reference = content
        """what `read` is called with by the other processes"""
        if self._memory is not None:
            cast(memoryview, self._memory.buf)[: len(content)] = content
            self.reference = self._memory.name, len(content)

    def withdraw(self) -> None:
        """No process will start to read it any more."""
        if self._memory is not None:
            self._memory.close()
            self._memory.unlink()
            self._memory = None


def read(reference: Reference) -> Any:
    """The value of a `SharedState`."""
    if isinstance(reference, bytes):
        return pickle.loads(reference)
    name, size = reference
    memory = SharedMemory(name)
    try:
        return pickle.loads(bytes(cast(memoryview, memory.buf)[:size]))
    finally:
        memory.close()


def _memory(size: int) -> SharedMemory | None:
    """Shared memory of that many bytes, where there is room for it."""
    try:
        free = shutil.disk_usage(_FOLDER).free
    except OSError:  # another system
        free = size
    try:
        return SharedMemory(create=True, size=size) if size <= free else None
    except OSError:
        return None
