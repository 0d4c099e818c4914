"""Roads drawn on paper and photographed: ink on a light sheet that is unevenly lit, maybe ruled."""

from __future__ import annotations

from dataclasses import dataclass, replace

import cv2
import numpy as np

from roadlang.geometry import Booleans

from ..colors.counted_colors import color_codes, counted_colors
from ..colors.fast_median import median
from ..colors.overexposed import WHITE, is_overexposed
from ..colors.tones import Image, Layer, thinned
from ..drawings.drawing import between_lines
from ..drawings.surface_roads import roads_of_surface
from ..masks.hysteresis import hysteresis
from ..masks.mask_parts import where_parts
from ..networks.found_network import FoundNetwork
from .cast_shadows import without_cast_shadows
from .even_ground import has_even_ground
from .grain import without_grain
from .pale_spots import pale_spots
from .pencil import smoothed, stroke_lengths, unbroken
from .ruling import without_ruling
from .sheet_outline import sheet_outline

_SMALL, _BROADEST = 300, 12
"""The light is estimated in a copy of at most `_SMALL` pixels a side; ink is thinner than one
`_BROADEST`th of its shorter side."""
_BROADER, _SHADED = 3, 0.5
"""Crossing or thick strokes may be `_BROADER` times as broad if they are darker than `_SHADED` of
the sheet around them; no shadow is that dark."""
_DARKEST, _COLORED = 60, 0.35
"""A sheet is lighter than the gray `_DARKEST`, and its channels differ by at most `_COLORED` of its
brightness."""
_BLUEST = 0.28
"""Its blue exceeds its red by at most this share of its brightness, also in the light of the sky:
what is bluer is the sky itself, or water."""
_TINT, _ONE = 0.12, 0.75
"""At least `_ONE` of a sheet has one color in any light: its channels, divided by their mean, are
within `_TINT`. A beach is as light as paper, but the sea beside it is not."""
_PLAIN, _EVEN = 0.06, 0.6
"""At least `_EVEN` of a sheet is within `_PLAIN` of its own brightness."""
_ROUGHEST = 0.045
"""Ground with more noise than this share of the light is no sheet: none of 22 drawings on paper has
half as much."""
_SAME, _EXACT = 2, 0.5
"""A drawing made on a screen has one color, within `_SAME` gray levels, on more than `_EXACT` of
it."""
_SCREEN = 0.85
"""If one color fills more than this share of a picture, no sheet on a desk is searched in it."""
_NOISE, _FAINTEST = 6.0, 0.1
"""Ink absorbs at least `_NOISE` times the noise, and at least `_FAINTEST` of the light."""
_PRINTED = 0.7
"""Ruled lines are sought down to `_PRINTED` of the faintest ink: long as they are, they stand out
from noise."""
_MOST_INK = 0.2
"""Maximum share of the sheet that ink covers."""
_TOP, _STRONG, _WEAK, _FAINT = 0.02, 0.7, 0.45, 0.35
"""The darkest strokes are the `_TOP` quantile. Ink is at least `_STRONG` as dark, and continues
down to `_WEAK`: ruled lines are lighter. Where the ink is smoothed, a pencil's lines go on down to
`_FAINT`."""
_SNOW, _FEW_SPOTS, _DOUBTED = 20, 12, 0.5
"""More than `_SNOW` pale spots are trees and houses in snow; so are more than `_FEW_SPOTS` if the
roads have a confidence below `_DOUBTED`."""
_SHORTEST, _LITTLE, _OF_LONGEST = 0.12, 0.3, 0.08
"""In shorter sides of the sheet: strokes shorter than `_SHORTEST` are letters; a total length below
`_LITTLE` is no road. Strokes shorter than `_OF_LONGEST` of the longest are houses and trees."""


@dataclass(frozen=True)
class Sheet:
    """A photographed sheet: how much light (h, w) ink takes away, 0..1, and the noise of that."""

    ink: Layer
    noise: float


def sheet_of(image: Image, within: Booleans | None = None, textured: bool = False) -> Sheet | None:
    """The ink of a picture (h, w, 3), freed from how it is lit; None if it shows no light sheet.

    Where a sheet lies on a desk, it is `within` (h, w) these pixels. What is `textured` was not
    drawn on a screen, even if most of it has nearly one color: a scan.
    """
    seen = np.ones(image.shape[:2], bool) if within is None else within
    if not textured and _is_flat(image, seen):
        return None
    light, on_strokes = _light(image, within)
    # What else is broad and dark may be hair: then it tells that this is no sheet.
    if not _has_one_light_color(light):
        return None
    ink = cv2.GaussianBlur(1 - _brightness(image, on_strokes), (0, 0), 0.7)
    on_sheet = ink.ravel() if within is None else ink[seen]
    middle = median(on_sheet)
    off = np.abs(on_sheet - middle)
    noise = 1.4826 * median(off)
    if noise > _ROUGHEST or np.count_nonzero(off < _PLAIN) < _EVEN * off.size:
        return None
    marked = np.clip(ink - middle, 0, 1)
    return Sheet(marked if within is None else np.where(seen, marked, np.float32(0)), noise)


def _brightness(image: Image, light: Layer) -> Layer:
    """The share (h, w) of the light that a picture (h, w, 3) has in its darkest channel, given the
    light in a small copy (h, w, 3)."""
    least: Layer | None = None
    for channel, small in zip(cv2.split(image), cv2.split(light), strict=True):
        share = cv2.resize(small, image.shape[1::-1], interpolation=cv2.INTER_LINEAR)
        np.divide(channel, np.maximum(share, 1, out=share), out=share)
        least = share if least is None else cv2.min(least, share)
    assert least is not None
    return least


def _has_one_light_color(light: Layer) -> bool:
    """Whether the light (h, w, 3) of a picture is that of a sheet."""
    colors = light.reshape(-1, 3)
    color = np.median(colors, axis=0)
    if color.mean() < _DARKEST or np.ptp(color) > _COLORED * color.max():
        return False
    if color[0] - color[2] > _BLUEST * color.max():
        return False
    tint = colors / np.maximum(colors.mean(axis=1, keepdims=True), 1)
    return bool((np.abs(tint - color / color.mean()) < _TINT).all(axis=1).mean() >= _ONE)


def _is_flat(image: Image, seen: Booleans, least: float = _EXACT) -> bool:
    """Whether most of what is seen has exactly one color: it was drawn on a screen."""
    chosen = thinned(seen.astype(np.uint8), 100_000) > 0
    sample = counted_colors(color_codes(thinned(image, 100_000))[chosen])
    same = sample.near(sample.usual, _SAME)
    if sample.number(same) <= least * sample.counts.sum():
        return False
    return bool(sample.usual.min() < WHITE) or not is_overexposed(image)


def roads_on_paper(
    image: Image, width: float | None = None, textured: bool = False
) -> FoundNetwork | None:
    """The roads (pixels) drawn on a photographed sheet (h, w, 3); None if it shows no sheet.

    The sheet fills the picture or lies on a darker desk. A line is a road; two lines side by side
    are the edges of one. There may be none. `textured` is as for `sheet_of`.
    """
    everywhere = np.ones(image.shape[:2], bool)
    if not has_even_ground(image) or (not textured and _is_flat(image, everywhere, _SCREEN)):
        return None
    outline = sheet_outline(image)
    sheet = None if outline is None else sheet_of(image, outline, textured)
    sheet = sheet or sheet_of(image, textured=textured)
    if sheet is None:
        return None
    least = max(_NOISE * sheet.noise, _FAINTEST)
    ink = without_ruling(sheet.ink, _PRINTED * least)
    spots = pale_spots(ink, least, sheet.noise, was_ruled=ink is not sheet.ink)
    if spots > _SNOW:
        return None
    found = _roads_of_ink(ink, least, width)
    if found is None or (spots > _FEW_SPOTS and found.confidence < _DOUBTED):
        return None
    printed = ink != sheet.ink
    return replace(found, printed=printed) if printed.any() else found


def _roads_of_ink(ink: Layer, least: float, width: float | None) -> FoundNetwork | None:
    """The roads of the ink (h, w) of a sheet; None if there is too much of it."""
    marked = _strokes(ink, least)
    if not marked.any():
        remark = "no line on the paper is long enough to be a road"
        return FoundNetwork(np.zeros((0, 2)), (), marked, "paper", (remark,))
    if marked.mean() > _MOST_INK:
        return None
    between = between_lines(marked)
    if between is not None:
        return roads_of_surface(between, "edge lines on paper", width=width)
    surface = cv2.GaussianBlur(marked.astype(np.float32), (0, 0), 0.8)
    return roads_of_surface(surface, "line on paper", width=width)


def _light(image: Image, within: Booleans | None) -> tuple[Layer, Layer]:
    """How bright the sheet is in a small copy (h, w, 3): the picture without its thin dark parts,
    and without broader ones that are darker still: strokes that cross."""
    scale = min(1.0, _SMALL / max(image.shape[:2]))
    size = (max(1, round(image.shape[1] * scale)), max(1, round(image.shape[0] * scale)))
    small = cv2.resize(image, size, interpolation=cv2.INTER_AREA)
    if within is not None:
        small = _carried_on(small, cv2.resize(within.astype(np.float32), size) > 0.99)
    side = 2 * (min(size) // (2 * _BROADEST)) + 1
    kernel = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (side, side))
    closed = cv2.morphologyEx(small, cv2.MORPH_CLOSE, kernel)
    broad = np.ones((_BROADER * side,) * 2, np.uint8)
    around = cv2.morphologyEx(small, cv2.MORPH_CLOSE, broad)
    inked = closed.max(axis=2, keepdims=True) < _SHADED * around.max(axis=2, keepdims=True)
    lights = (closed, np.where(inked, around, closed)) if inked.any() else (closed,)
    smooth = [cv2.GaussianBlur(each.astype(np.float32), (0, 0), side / 4) for each in lights]
    return np.asarray(smooth[0]), np.asarray(smooth[-1])


def _carried_on(image: Image, seen: Booleans) -> Image:
    """The picture (h, w, 3) with the nearest pixel that is `seen` (h, w) in place of all others."""
    if not seen.any():
        return image
    _, nearest = cv2.distanceTransformWithLabels(
        (~seen).astype(np.uint8), cv2.DIST_L2, 5, labelType=cv2.DIST_LABEL_PIXEL
    )
    colors = np.zeros((int(nearest.max()) + 1, 3), np.uint8)
    colors[nearest[seen]] = image[seen]
    return np.asarray(colors[nearest])


def _strokes(ink: Layer, least: float) -> Booleans:
    """Where long strokes of the ink (h, w) are."""
    side = min(ink.shape)
    marked = _dark_ink(ink, least)
    lit = without_cast_shadows(ink, marked)
    if lit is not ink:
        ink, marked = lit, _dark_ink(lit, least)
    marked = unbroken(marked, lambda: _dark_ink(smoothed(ink), least, _FAINT), _SHORTEST * side)
    if not marked.any():
        return marked
    marked = without_grain(marked)
    lengths, parts = stroke_lengths(marked)
    long = lengths >= max(_SHORTEST * side, _OF_LONGEST * lengths.max())
    if lengths[long].sum() < _LITTLE * side:
        return np.zeros(marked.shape, bool)
    return where_parts(long, parts)


def _dark_ink(ink: Layer, least: float, weak: float = _WEAK) -> Booleans:
    """Where ink (h, w) is about as dark as the darkest, and goes on at least `weak` as dark."""
    seen = ink[ink > least]
    if not len(seen):
        return np.zeros(ink.shape, bool)
    dark = float(np.quantile(seen, 1 - _TOP))
    return hysteresis(ink, max(least, _STRONG * dark), max(least, weak * dark))
