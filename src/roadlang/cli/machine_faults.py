"""What the machine refuses, such as memory or room on a disk: neither bug nor fault of a scene."""

from __future__ import annotations

import errno
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ..diagnostics import Diagnostic

_NO_ROOM = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EIO)


def _is_about_memory(words: str) -> bool:
    """Whether a library could not be loaded for want of memory, as the system's loader says it."""
    return "failed to map segment" in words or "annot allocate memory" in words


def machine_fault(error: BaseException) -> Diagnostic | None:
    """The diagnostic of such an error, None for any other."""
    from ..diagnostics import Code, diagnose

    if isinstance(error, MemoryError) or _is_about_memory(str(error)):
        return diagnose(
            Code.OUT_OF_MEMORY,
            help=(
                "make fewer scenes at once (`-n`), or use fewer processes (`--jobs`) or a smaller"
                " picture"
            ),
        )
    if isinstance(error, OSError) and error.errno in _NO_ROOM:
        path = str(error.filename or "standard output")
        reason = (error.strerror or "no room").lower()
        return diagnose(Code.UNWRITABLE_OUTPUT, path=path, reason=reason)
    # By its name: concurrent.futures is not imported for it.
    if type(error).__name__ == "BrokenProcessPool":
        return diagnose(
            Code.WORKER_ENDED,
            help="if memory is short, use fewer processes (`--jobs`); if a plugin ends the process,"
            " `--jobs 1` shows which",
        )
    return None
