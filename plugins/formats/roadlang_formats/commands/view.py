"""`roadlang view FILE`: a map or scene as a picture."""

from __future__ import annotations

from pathlib import Path

import click

from roadlang.commands import echo

from .opening import opened


@click.command("view")
@click.argument("file")
@click.option(
    "-o", "--output", metavar="FILE", help="Output file; by default FILE with the extension .svg."
)
@click.option(
    "--size",
    type=click.IntRange(120, 8192),
    default=1024,
    show_default=True,
    help="Width in pixels.",
)
def command(file: str, output: str | None, size: int) -> None:
    """Draw a map (.xodr, .osm, ...), a scene (.json) or a scene file (.rl) as SVG."""
    path = Path(output) if output is not None else Path(file).with_suffix(".svg")
    scene = opened(file)
    picture = scene.svg(size=float(size))
    from roadlang.commands import write_file

    write_file(path.absolute(), picture)
    echo(f"{path}")
