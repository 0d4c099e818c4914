"""Traces of drives, read again."""

from __future__ import annotations

from pathlib import Path

from ..diagnostics import arguments
from ..drive.trace_files import from_json
from ..ir.trace import Trace
from ..report.reading import parsed


def read_drive(file: str | Path) -> Trace:
    """The trace in a `.trace.json` that `roadlang run` or `falsify` wrote.

    Raises `DiagnosticError` RL721 for any other file.
    """
    return parsed(arguments.path("file", file), from_json)
