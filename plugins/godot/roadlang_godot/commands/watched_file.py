"""The scene file that `roadlang watch` looks at."""

from __future__ import annotations

from typing import TYPE_CHECKING

from roadlang.commands import report

if TYPE_CHECKING:
    from roadlang.commands import DiagnosticError

_PATIENCE = 1.0
"""Seconds for which a file may be unreadable: editors that save by renaming leave a moment without
one."""


class WatchedFile:
    """Its text, as long as it can be read; what is wrong with it is printed once."""

    def __init__(self, path: str) -> None:
        self._path = path
        self._unreadable_since: float | None = None
        self._told = ""

    def read(self, now: float) -> str | None:
        """The text; None where there is none to be read. `now`: seconds of a clock."""
        from roadlang.commands import DiagnosticError, read_scene_file

        try:
            text = read_scene_file(self._path)
        except DiagnosticError as error:
            self._tell(error, now)
            return None
        self._unreadable_since, self._told = None, ""
        return text

    def _tell(self, error: DiagnosticError, now: float) -> None:
        if self._unreadable_since is None:
            self._unreadable_since = now
        if now - self._unreadable_since >= _PATIENCE and str(error) != self._told:
            self._told = str(error)
            report(error.diagnostics)
