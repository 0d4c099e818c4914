"""The diagnostic of an output that cannot be written: it names the file that stands in the way."""

from __future__ import annotations

import os
from pathlib import Path

from ..diagnostics import Code, DiagnosticError, diagnose


def not_written(path: Path, error: OSError) -> DiagnosticError:
    """RL460 of a file, or of a folder."""
    reason, file = error.strerror or str(error), str(path)
    help_: tuple[str, ...] = ()
    if isinstance(error, FileExistsError | NotADirectoryError):
        obstacle = next((each for each in (path, *path.parents) if os.path.lexists(each)), path)
        if not obstacle.is_dir():
            what = "a file, not a folder" if obstacle.is_file() else "not a folder"
            reason = f"`{obstacle.name}` is {what}"
            help_ = ("choose another folder, or move the file away",)
    return DiagnosticError(
        diagnose(Code.OUTPUT_NOT_WRITTEN, path=file, file=file, reason=reason, help=help_)
    )
