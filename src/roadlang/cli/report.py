"""`roadlang report DIR`: one page on the results of a run or a search."""

from __future__ import annotations

from pathlib import Path

import click

from .console import echo, shown
from .output_files import FormatFile


@click.command("report")
@click.argument("folder", metavar="DIR")
@click.option(
    "-o",
    "--output",
    "file",
    type=FormatFile("HTML", ".html", ".htm"),
    metavar="FILE",
    help="The page; by default DIR/report.html.",
)
def command(folder: str, file: str | None) -> None:
    """Write an HTML page with the results of `roadlang run` or `roadlang falsify` in DIR.

    The page is self-contained and works offline. It shows the summary, the failing and the safe
    roads, the drives step by step, robustness over time and along the road, the coverage, a table
    of all drives, their inputs, and the results of `roadlang shrink` and `roadlang explain`.
    """
    from ..session.reports import write_report

    written = write_report(folder, file)
    size = written.stat().st_size / 1e6
    echo(f"{shown(Path(written))} ({size:.1f} MB)")
