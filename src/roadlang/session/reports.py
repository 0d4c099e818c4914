"""The report on a folder of results, written."""

from __future__ import annotations

from pathlib import Path

from ..diagnostics import arguments
from ..files.writing import write_file
from ..ir.result_files import REPORT
from ..plugins.registry import Registry
from ..report.report import report
from .scene import installed


def write_report(
    folder: str | Path, file: str | Path | None = None, registry: Registry | None = None
) -> Path:
    """Make the page of what `roadlang run` or `roadlang falsify` wrote into `folder`, and write it,
    into `folder/report.html` where no `file` is named.

    Raises `DiagnosticError` RL720 for a folder without results, RL721 for results that cannot be
    read, RL460 where the page cannot be written.
    """
    source = arguments.path("folder", folder)
    target = source / REPORT if file is None else arguments.file_to_write("file", file)
    target = target.absolute()  # before a plugin can change the current folder
    return write_file(target, report(source, installed() if registry is None else registry))
