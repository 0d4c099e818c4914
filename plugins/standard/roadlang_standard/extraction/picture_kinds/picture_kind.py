"""Tell what sort of picture it is: a photo, a mask, a filled drawing, a drawing of edge lines."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans

from ..colors.nodata import nodata
from ..colors.tones import Image, away_from, flatness, thinned, tones
from ..drawings.drawing import has_edge_lines, has_long_edge_lines
from ..maps.map_tones import flat_colors
from .dark_words import has_dark_words
from .exact_colors import has_exact_colors, has_exact_land, is_shaded

PHOTO, MASK, FILLED, EDGES, MAP = (
    "photo",
    "mask",
    "filled drawing",
    "edge-line drawing",
    "color map",
)

_FLAT = 0.55
"""Maximum share of a photo without texture."""
_LIT, _INDEX = 215, 12
"""A mask has a tone lighter than `_LIT` on black, or only indices below `_INDEX`; dark maps have
neither."""
_SAME, _BRUSH, _BROAD = 8, 15, 0.25
"""Parts that differ by more than `_SAME` gray levels from the most frequent color and contain a
square of `_BRUSH` pixels are broad. If more than `_BROAD` of the picture is broad, that part
decides what the picture is."""


@dataclass(frozen=True)
class PictureKind:
    """What a picture is, and how that was seen."""

    unless_edges: str
    """its name, unless it shows roads between two lines"""
    flat: float
    """Share of pixels without any texture."""
    exact: bool = False
    """Whether it was rendered in several exact colors: it is no photo of a drawing on paper."""
    marked: Booleans | None = None
    """what is drawn in it (h, w), None for a photo"""

    @cached_property
    def name(self) -> str:
        """What it is. To seek edge lines takes as long as all else: it is done when first asked."""
        is_edged = self.marked is not None and has_edge_lines(self.marked)
        return EDGES if is_edged else self.unless_edges

    @property
    def drawn(self) -> bool:
        """Whether it is anything but a photo."""
        return self.unless_edges != PHOTO

    @property
    def is_plan(self) -> bool:
        """Whether it has few colors, and its long lines are edges of roads: a plan with dimensions
        looks like a map in black and white else."""
        if self.unless_edges != FILLED or self.marked is None:
            return False
        return has_long_edge_lines(self.marked)

    def named(self, name: str) -> bool:
        """Whether this is its name; no edge lines are sought where another one is plain."""
        return self.unless_edges == name and self.name == name


def picture_kind(image: Image) -> PictureKind:
    """Photos have texture nearly everywhere, drawings nearly nowhere."""
    flat, exact = flatness(image), has_exact_colors(image)
    if flat < _FLAT and not exact:
        exact = has_exact_land(image)
    if flat < _FLAT and not exact:
        return PictureKind(PHOTO, flat)
    plan = tones(image, most=12)
    few = np.sort(plan.shares)[-6:].sum()
    if few < 0.85 or (not exact and (is_shaded(image) or _is_photo_in_part(image, flat))):
        return PictureKind(PHOTO, flat)
    paper = plan.colors[plan.paper]
    away = away_from(image, paper)
    marked = away > (100 if away.max() > 100 else 30)
    colors = plan.colors[np.argsort(-plan.shares)]
    pure = _unmixed(colors)
    black_and_white = len(pure) <= 2 and all(min(c.max(), 255 - c.min()) < 40 for c in pure)
    lit = any(color.min() > _LIT for color in pure) or image.max() < _INDEX
    # Black maps have names; a mask shows nothing but roads.
    if black_and_white and paper.mean() < 40 and lit and not has_dark_words(image):
        return PictureKind(MASK, flat, exact, marked)
    return PictureKind(MAP if len(pure) > 3 else FILLED, flat, exact, marked)


def _is_photo_in_part(image: Image, flat: float) -> bool:
    """Whether what lies within margins of pure black or white, or beside a lake, has the texture
    and the shades of a photo: blocks at the rim of a map in black and white are pure as well."""
    small = np.ascontiguousarray(thinned(image, 250_000))
    margins = nodata(small)
    if margins is not None and margins.mean() <= 0.75 and _is_photo(small, ~margins):
        return True
    if flat > 1 - _BROAD * (1 - _FLAT):
        return False
    beside = _beside_land(small)
    return bool(beside.mean() > _BROAD) and _is_photo(small, beside)


def _is_photo(image: Image, within: Booleans) -> bool:
    return flatness(image, within) < _FLAT and is_shaded(image, within)


def _beside_land(image: Image) -> Booleans:
    """What is broad (h, w) of a picture (h, w, 3) and not of its most frequent color."""
    land = flat_colors(image)[:1]
    if not land:
        return np.zeros(image.shape[:2], bool)
    other = (away_from(image, land[0]) > _SAME).astype(np.uint8)
    return np.asarray(cv2.morphologyEx(other, cv2.MORPH_OPEN, np.ones((_BRUSH,) * 2, np.uint8)) > 0)


def _unmixed(colors: NDArray[np.float64]) -> list[NDArray[np.float64]]:
    """Those of the colors, most frequent first, that are no mixture of two earlier ones."""
    pure: list[NDArray[np.float64]] = []
    for color in colors:
        pairs = [(a, b) for i, a in enumerate(pure) for b in pure[:i]]
        if not any(_between(color, a, b) < 25 for a, b in pairs):
            pure.append(color)
    return pure


def _between(color: NDArray[np.float64], a: NDArray[np.float64], b: NDArray[np.float64]) -> float:
    """Distance of a color from the mixtures of two others."""
    axis = b - a
    share = float(np.clip((color - a) @ axis / max(float(axis @ axis), 1e-9), 0, 1))
    return float(np.abs(color - a - share * axis).max())
