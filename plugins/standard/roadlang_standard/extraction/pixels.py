"""What the extract kinds ask of a picture, its pixels or its legend; diagnostics if lacking."""

from __future__ import annotations

from typing import TYPE_CHECKING

from roadlang.api import Code

from .colors.colors import NAMES, bgr
from .colors.tones import Image
from .legends.legend import ROAD, ROADS, LegendObject, read_colors, read_text
from .networks.found_network import FoundNetwork

if TYPE_CHECKING:
    from roadlang.api import Picture


def pixels_of(picture: Picture, kind: str) -> Image:
    """The pixels (h, w, 3). Raises DiagnosticError RL420 for a picture typed as text."""
    from roadlang.api import DiagnosticError, diagnose

    if picture.pixels is None:
        raise DiagnosticError(
            diagnose(
                Code.TEXT_IMAGE_WITHOUT_PIXELS,
                kind=kind,
                help="text images are read by `extract with pixels`",
            )
        )
    return picture.pixels


def read_legend(
    picture: Picture, thickness: float | None
) -> tuple[FoundNetwork, tuple[LegendObject, ...]]:
    """Roads and things of a picture with a legend. Raises DiagnosticError RL421 to RL423."""
    from roadlang.api import DiagnosticError, diagnose

    legend = dict(picture.legend)
    if not legend and picture.characters is not None:
        legend = {"#": ROAD}
    if picture.characters is not None:
        _check_characters(legend)
    else:
        for color in legend:
            _check_color(color)
    if not set(ROADS) & set(legend.values()):
        raise DiagnosticError(diagnose(Code.LEGEND_WITHOUT_ROAD, help=_missing_entry(picture)))
    if picture.characters is not None:
        return read_text(picture.characters, legend, thickness)
    return read_colors(pixels_of(picture, "pixels"), legend, thickness)


def _missing_entry(picture: Picture) -> str:
    """What to add to a legend without a road: an entry for what looks like road."""
    from .legends.legend_proposal import road_color

    if picture.characters is not None:
        return 'add `"#": road` to the legend, with the character that you draw roads with'
    color = None if picture.pixels is None else road_color(picture.pixels)
    if color is None or bgr(color) in map(bgr, picture.legend):
        return 'add an entry such as `"white": road` to the legend'
    return f'add `"{color}": road` to the legend: it is the color of what looks most like a road'


def _check_characters(legend: dict[str, str]) -> None:
    from roadlang.api import DiagnosticError, diagnose

    for key in legend:
        if len(key) != 1:
            raise DiagnosticError(
                diagnose(
                    Code.INVALID_LEGEND_CHARACTER,
                    key=key,
                    help="in a text image each key is one character",
                )
            )


def _check_color(color: str) -> None:
    from roadlang.api import DiagnosticError, diagnose, did_you_mean

    try:
        bgr(color)
    except ValueError:
        hints = did_you_mean(color, NAMES)
        advice = 'write a color as "#2e7d32" or by name, such as "white"'
        raise DiagnosticError(
            diagnose(Code.INVALID_LEGEND_COLOR, color=color, help=(*hints, advice))
        ) from None
