"""The report on a folder of results, written."""

from __future__ import annotations

from pathlib import Path

from ..files.writing import write_file
from ..plugins.registry import Registry
from ..report.report import report
from .scene import installed

REPORT = "report.html"


def write_report(
    folder: str | Path, file: str | Path | None = None, registry: Registry | None = None
) -> Path:
    """Make the page of what `roadlang run` or `roadlang falsify` wrote into `folder`, and write it,
    into `folder/report.html` where no `file` is named.

    Raises `DiagnosticError` RL720 for a folder without results, RL721 for results that cannot be
    read, RL460 where the page cannot be written.
    """
    source = Path(folder).absolute()
    text = report(Path(folder), installed() if registry is None else registry)
    return write_file(source / REPORT if file is None else Path(file).absolute(), text)
