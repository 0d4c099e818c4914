"""`roadlang extract IMAGE`: the roads of a picture as JSON, and a picture of them to judge."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from ..diagnostics import Code
from . import exit_codes
from .console import echo, note, report
from .finite_range import FiniteRange
from .output_files import FormatFile, OutputPath, keep_inputs
from .quantities import pixel_size, pixels

if TYPE_CHECKING:
    from ..images.image_file import OpenedImage
    from ..ir.picture import Extraction


class _Numbers(click.ParamType):  # type: ignore[type-arg, unused-ignore]
    """Numbers with commas between them: `120,80`."""

    def __init__(self, count: int, name: str) -> None:
        self.count, self.name = count, name

    def convert(self, value: Any, parameter: Any, context: Any) -> tuple[float, ...]:
        try:
            numbers = tuple(float(part) for part in str(value).split(","))
        except ValueError:
            numbers = ()
        if len(numbers) != self.count or not all(map(math.isfinite, numbers)):
            self.fail(f"{value!r} is not {self.name}", parameter, context)
        return numbers


class _Place(_Numbers):
    """Degrees of a place on Earth: `48.137,11.575`."""

    def convert(self, value: Any, parameter: Any, context: Any) -> tuple[float, ...]:
        latitude, longitude = super().convert(value, parameter, context)
        if not (abs(latitude) <= 90.0 and abs(longitude) <= 180.0):
            self.fail(f"{value!r} is not a latitude and longitude", parameter, context)
        return latitude, longitude


_ROADS = FormatFile(
    "JSON or GeoJSON",
    *(".json", ".geojson", ""),
    hint=" A picture of the roads: `--overlay FILE.svg` or `--mask FILE.png`.",
)
_SAY_MORE = (
    "`--overlay` shows what was found; use `--with contour` for a drawing, `--with aerial` for a "
    "photo"
)


@click.command("extract")
@click.argument(
    "images", metavar="IMAGE...", nargs=-1, required=True, type=click.Path(dir_okay=False)
)
@click.option(
    "-o",
    "--output",
    type=_ROADS,
    help="File to write the roads to: JSON in pixels or, if the name ends in .geojson, GeoJSON.",
)
@click.option(
    "--overlay",
    type=FormatFile("SVG", ".svg"),
    help="SVG file that shows the roads over the image.",
)
@click.option("--mask", type=FormatFile("PNG", ".png"), help="PNG file for the road mask.")
@click.option(
    "--with", "kind", default="auto", metavar="KIND", help="Extractor: a kind of `extract`."
)
@click.option("--scale", type=pixel_size(min=1e-4, max=1e4), help="Ground resolution: 0.5m/px.")
@click.option(
    "--origin",
    type=_Place(2, "LATITUDE,LONGITUDE"),
    metavar="LAT,LON",
    help="Latitude and longitude of the lower left corner, for GeoJSON; by default from the file.",
)
@click.option(
    "--threshold",
    type=FiniteRange(0, 1, min_open=True, max_open=True),
    help="Threshold of the extractor.",
)
@click.option("--width", type=pixels(min=0, min_open=True), metavar="PIXELS", help="Road width.")
@click.option(
    "--through",
    type=_Numbers(2, "X,Y"),
    multiple=True,
    metavar="X,Y",
    help="Pixel that a road passes through; repeat it in order along the road.",
)
@click.option(
    "--only-through", is_flag=True, help="Keep only the road through the --through points."
)
@click.option(
    "--leave-out",
    type=_Numbers(4, "X,Y,X,Y"),
    multiple=True,
    metavar="X,Y,X,Y",
    help="Box without roads, given by two opposite corners; repeatable.",
)
@click.option("--model", type=click.Path(dir_okay=False), help="Model file for `--with onnx`.")
@click.option(
    "--edit",
    type=OutputPath(dir_okay=False),
    metavar="SCENE",
    help="Correct the roads on a page in the browser and save them in this scene file.",
)
@click.option("--no-browser", is_flag=True, help="With --edit: print the address, do not open it.")
def command(
    images: tuple[str, ...],
    output: str | None,
    overlay: str | None,
    mask: str | None,
    origin: tuple[float, float] | None,
    edit: str | None,
    no_browser: bool,
    **settings: Any,
) -> None:
    """Extract the roads of IMAGE.

    Several images are tiles of one picture; each must be georeferenced (GeoTIFF or world file).
    Polylines, nodes and widths are in pixels of IMAGE: (0, 0) is the center of the top-left pixel,
    y points down. Without `-o`, or with `-o -`, the JSON goes to standard output.
    """
    if edit is not None:
        _edit(images, edit, settings["scale"], not no_browser)
        return
    output = None if output == "-" else output
    read = [*images, *([] if settings["model"] is None else [settings["model"]])]
    keep_inputs([name for name in (output, overlay, mask) if name is not None], read)

    from ..world.sources.pictures import picture_of
    from .chosen_extractor import extracted
    from .extraction_files import as_json, as_mask, as_overlay
    from .extraction_geojson import as_geojson

    opened = _opened(images)
    scale = settings["scale"] if settings["scale"] is not None else opened.scale
    picture = picture_of(opened.shown, scale or 1.0, images[0])
    on_earth = output is not None and Path(output).suffix.lower() == ".geojson"
    place = _place(opened, origin, scale) if on_earth else None
    found, seconds = extracted(picture, scale, settings)
    if place is None:
        beside = _beside(mask, output)
        document = as_json(picture, found, scale is not None, seconds, beside, images)
    else:
        document = as_geojson(picture, found, place)
    shown = None if overlay is None else as_overlay(picture, found)
    covered = None if mask is None else as_mask(picture, found)
    _write({output: document, overlay: shown, mask: covered})
    if output is None:
        click.echo(document)
    _report(found, output is not None)


def _write(files: dict[str | None, str | bytes | None]) -> None:
    """Those of the files that have a name, after all have their content."""
    from ..files.writing import write_file

    for name, content in files.items():
        if name is not None and content is not None:
            write_file(Path(name), content)


def _edit(images: tuple[str, ...], scene: str, scale: float | None, opens_browser: bool) -> None:
    from .extract_edit import edit_roads

    _refuse_with_edit()
    if len(images) > 1:
        raise click.UsageError(
            "`--edit` takes one image: name tiles in the scene file, as in "
            '`image photo from "tiles/*.tif"`.'
        )
    edit_roads(images[0], scene, scale, opens_browser)


def _refuse_with_edit() -> None:
    """Only the scale of a new scene goes with `--edit`: all else is in the scene file."""
    context = click.get_current_context()
    for parameter in context.command.params:
        source = context.get_parameter_source(parameter.name or "")
        given = source is click.core.ParameterSource.COMMANDLINE
        if given and parameter.name not in ("images", "edit", "no_browser", "scale"):
            raise click.UsageError(
                f"`{parameter.opts[0]}` cannot be used with `--edit`: write options of the "
                "extractor in the scene file."
            )


def _beside(mask: str | None, output: str | None) -> str | None:
    """The mask's path as seen from the JSON."""
    import os

    if mask is None:
        return None
    return os.path.relpath(mask, Path(output).parent if output else ".").replace(os.sep, "/")


def _opened(images: tuple[str, ...]) -> OpenedImage:
    from ..images.image_file import open_image, open_tiles

    if len(images) > 1:
        opened = open_tiles([(Path(image), image) for image in images], images[0], None)
    else:
        opened = open_image(Path(images[0]), images[0], None)
    if opened.warnings:
        report(opened.warnings)
    return opened


def _place(
    opened: OpenedImage, stated: tuple[float, float] | None, scale: float | None
) -> tuple[float, float]:
    """Latitude and longitude of the lower left corner. Raises DiagnosticError RL433."""
    from ..diagnostics import DiagnosticError, diagnose

    place = stated if stated is not None else opened.shown.origin
    if place is None:
        missing = "neither the image nor `--origin` gives it"
        help = "give its lower left corner: `--origin 48.137,11.575`, latitude first"
    elif scale is None:
        missing = "the size of its pixels on the ground is not known"
        help = "give it in meters: `--scale 0.5`"
    else:
        return place
    raise DiagnosticError(diagnose(Code.IMAGE_WITHOUT_PLACE, reason=missing, help=(help,)))


def _report(found: Extraction, wrote: bool) -> None:
    from ..diagnostics import diagnose

    if wrote:
        count = len(found.network.edges)
        roads = f"{count} road{'' if count == 1 else 's'}"
        about = f"{found.remarks[0]}, " if found.remarks else ""
        echo(f"{roads} ({about}{found.confidence:.0%} sure)")
        for remark in found.remarks[1:]:
            note(f"note: {remark}")
    if not found.network.edges:
        report([diagnose(Code.NO_ROAD_IN_IMAGE, help=(*found.remarks, _SAY_MORE))])
        click.get_current_context().exit(exit_codes.SCENARIO_HAS_ERRORS)
