"""A progress bar on the terminal's stderr; none where stderr is not a terminal."""

from __future__ import annotations

import sys
import time
from types import TracebackType

_PATIENCE = 0.6
_INTERVAL = 0.1
_WIDTH = 30


class ProgressBar:
    """Called with what is done and what there is; shown once the work takes longer than a blink."""

    def __init__(self, what: str) -> None:
        self._what = what
        self._watched = sys.stderr.isatty()
        self._next = time.monotonic() + _PATIENCE
        self._shown = False

    def __enter__(self) -> ProgressBar:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        if self._shown:
            sys.stderr.write("\r\x1b[K")
            sys.stderr.flush()

    def __call__(self, done: int, total: int) -> None:
        """Show that `done` of `total` are done."""
        now = time.monotonic()
        if not self._watched or now < self._next or total <= 0:
            return
        self._next, self._shown = now + _INTERVAL, True
        filled = int(_WIDTH * min(done / total, 1.0))
        bar = "#" * filled + "." * (_WIDTH - filled)
        sys.stderr.write(f"\r\x1b[K{self._what} [{bar}] {done}/{total}")
        sys.stderr.flush()
