"""Folders in which a search keeps its results: no run may write its own over them."""

from __future__ import annotations

import json
from contextlib import suppress
from pathlib import Path

from ..diagnostics import Code, DiagnosticError, diagnose
from ..files.journal import JOURNAL_FILE, UNUSABLE, unchanged


def refuse_folder_of_search(folder: Path) -> None:
    """Raises `DiagnosticError` RL460 where `falsify` has evaluated scenes in a folder: the journal
    of a run there would replace that of the search, which could not be resumed."""
    path = folder / JOURNAL_FILE
    if _is_of_search(path):
        file, reason = str(path), "it is the journal of a search for failures"
        other = "choose another folder with `-o`"
        code = Code.OUTPUT_NOT_WRITTEN
        raise DiagnosticError(diagnose(code, path=file, file=file, reason=reason, help=other))


def _is_of_search(path: Path) -> bool:
    """By its first outcome; the whole may have millions."""
    with suppress(OSError, *UNUSABLE), path.open("rb") as file:
        file.readline()  # the header
        return "point" in json.loads(unchanged(file.readline().rstrip(b"\n")))
    return False
