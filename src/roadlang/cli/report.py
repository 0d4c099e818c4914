"""`roadlang report DIR`: one page on the results of a run or a search."""

from __future__ import annotations

from pathlib import Path

import click

from .console import echo, shown


@click.command("report")
@click.argument("folder", metavar="DIR")
@click.option(
    "-o", "--output", "file", metavar="FILE", help="The page; by default DIR/report.html."
)
def command(folder: str, file: str | None) -> None:
    """Make one HTML page of what `roadlang run` or `roadlang falsify` wrote into DIR.

    The page needs nothing else and no network. It has the summary, the failing and the safe roads,
    the drives to step through, robustness over time and along the road, what was covered, a table
    of all drives, and what they were made from. What `roadlang shrink` and `roadlang explain` found
    is in it.
    """
    from ..session.reports import write_report

    written = write_report(folder, file)
    size = written.stat().st_size / 1e6
    echo(f"{shown(Path(written))} ({size:.1f} MB)")
