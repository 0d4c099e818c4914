"""Traces that a command judges: each has samples."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from ..diagnostics import Code, DiagnosticError, diagnose

if TYPE_CHECKING:
    from ..stl.formats.trace_files import Columns


def read_samples(path: str, agent: str | None) -> Columns:
    """The columns of a file. Raises DiagnosticError RL340, RL300 with its name for no sample."""
    from ..stl.formats.trace_files import read_trace

    columns = read_trace(path, agent)
    if not columns[1]:
        help_ = f"{Path(path).name} has no rows below its column names"
        raise DiagnosticError(diagnose(Code.EMPTY_TRACE, path=path, help=help_))
    return columns
