"""`roadlang view FILE`: a map or scene as a picture."""

from __future__ import annotations

from typing import TYPE_CHECKING

import click

from roadlang.commands import FormatFile, WholeNumber, echo, note

if TYPE_CHECKING:
    from pathlib import Path


@click.command("view")
@click.argument("file")
@click.option(
    "-o",
    "--output",
    type=FormatFile("SVG", ".svg"),
    metavar="FILE",
    help="Output file; by default FILE with the extension .svg.",
)
@click.option(
    "--size",
    type=WholeNumber(120, 8192),
    default=1024,
    show_default=True,
    help="Width in pixels.",
)
def command(file: str, output: str | None, size: int) -> None:
    """Draw a map (.xodr, .osm, ...), a scene (.json) or a scene file (.rl) as SVG.

    Also draws, seen from above, networks of SUMO (.net.xml), Lanelet2 maps (.osm), CommonRoad
    scenarios and MuJoCo models (.xml), binary glTF (.glb), and the map of an OpenSCENARIO file
    (.xosc) or a Scenic program (.scenic).
    """
    from pathlib import Path

    path = Path(output) if output is not None else Path(file).with_suffix(".svg")
    picture = _drawn(Path(file), float(size))
    from roadlang.commands import write_file

    write_file(path.absolute(), picture)
    echo(f"{path}")


def _drawn(path: Path, size: float) -> str:
    """The SVG of a file."""
    from ..plans.drawing import drawn
    from ..plans.views import map_named_in, shapes_of
    from .opening import opened

    shapes = shapes_of(path)
    if shapes is not None:
        return drawn(shapes, path.name, size)
    roads = map_named_in(path)
    if roads is not None:
        note(f"{path.name} is drawn as its road map, {roads.name}")
    return opened(str(roads or path)).svg(size=size)
