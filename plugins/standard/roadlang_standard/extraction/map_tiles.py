"""Roads of rendered maps: the tones that are ribbons, joined beneath letters and signs."""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans

from .found_network import FoundNetwork
from .map_letters import letters_of_map, without_letters
from .map_tones import LOSSY, flat_colors, map_tones, tolerance_of, without_jpeg_noise
from .map_water import without_water
from .masks import Cover, roads_of_surface, without_holes, without_specks
from .road_tones import MOST_SPREAD, road_tones
from .tones import Image, Layer

_COLORS, _FEW, _LETTERED = 3, 3, 0.003
"""A map has at least so many colors; with so few it has letters on this share of it, or it is a
drawing."""
_THIN, _LONG = 0.5, 5.0
"""Parts that are narrower than this share of the usual width, or shorter than so many widths, are
no roads."""
_WIDE = 2.6
"""What is so many times as wide as the widest roads is a square or a parking lot."""
_GAP, _LETTER_GAP, _HOLE = 0.35, 0.8, 1.5
"""Gaps of the surface are closed up to so many widths to each side, and where letters are; holes
are filled up to so many square widths."""
_ROAD, _LAND, _UNKNOWN = 0.25, 0.002, 0.6
"""How easily a bridge between dead ends crosses road, land, and what covers either: it should not
turn back along its own road."""
_ON_LETTERS = 0.6
"""A tone that lies so much about letters is their outline."""


def roads_of_map(image: Image, width: float | None = None) -> FoundNetwork | None:
    """The roads (pixels) of a rendered map (h, w, 3).

    None if the picture has too few colors for a map, or if none of them looks like roads.
    """
    tolerance = tolerance_of(image)
    if tolerance is LOSSY:
        image = without_jpeg_noise(image)
    # Names on roads leave no even strips of them: the colors of roads are chosen without names.
    plain = image if tolerance is LOSSY else without_letters(image)
    colors = flat_colors(plain, tolerance)
    if len(colors) < _COLORS:
        return None
    tones = without_water(map_tones(plain, colors, tolerance))
    roads = road_tones(tones, min(image.shape[:2]))
    if not roads:
        return None
    lengths = np.array([tone.steady_length for tone in roads])
    usual = float(lengths @ [tone.width for tone in roads] / lengths.sum())
    letters = letters_of_map(image, usual)
    if len(colors) <= _FEW and letters.mean() < _LETTERED:
        return None
    seen = tones if plain is image else without_water(map_tones(image, colors, tolerance))
    taken = [any(tone is road for road in roads) for tone in tones]
    mask = np.logical_or.reduce([one.mask for one, road in zip(seen, taken, strict=True) if road])
    others = [one.mask for one, road in zip(seen, taken, strict=True) if not road]
    widest = max(tone.width * max(1.0, tone.spread / MOST_SPREAD) for tone in roads)
    surface, hidden = _uncovered(mask, others, letters, usual, widest)
    found = roads_of_surface(
        surface.astype(np.float32),
        "map",
        width=width,
        specks=usual**2,
        cover=Cover(letters, hidden, widest),
    )
    return replace(found, mask=surface)


def _uncovered(
    mask: Booleans, others: list[Booleans], letters: Booleans, width: float, widest: float
) -> tuple[Booleans, Layer]:
    """The surface with what letters and casings cover, and how likely roads are hidden, 0..1."""
    area = np.zeros(mask.shape, bool)
    for other in others:
        if (other & letters).sum() < _ON_LETTERS * other.sum():
            area |= _opened(other)
    surface = _without_areas(without_specks(_without_thin(mask, width), 0.5 * width**2), widest)
    near = _closed(surface, _GAP * width) | (_closed(surface, _LETTER_GAP * width) & letters)
    surface = without_holes(surface | (near & ~area), _HOLE * width**2)
    surface = _without_islands(surface, _LONG * width)
    covered = _grown(surface, width) | _opened(~surface & ~area) | letters
    hidden = np.where(surface, _ROAD, np.where(area | ~covered, _LAND, _UNKNOWN))
    return surface, hidden.astype(np.float32)


def _opened(mask: Booleans) -> Booleans:
    """Without what is thinner than 3 pixels: edges and casings."""
    kernel = np.ones((3, 3), np.uint8)
    return np.asarray(cv2.morphologyEx(mask.astype(np.uint8), cv2.MORPH_OPEN, kernel) > 0)


def _grown(mask: Booleans, radius: float) -> Booleans:
    """With what is within so many pixels of it."""
    size = 2 * round(radius) + 1
    kernel = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (size, size))
    return np.asarray(cv2.dilate(mask.astype(np.uint8), kernel) > 0)


def _closed(mask: Booleans, radius: float) -> Booleans:
    size = 2 * max(1, round(radius)) + 1
    kernel = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (size, size))
    return np.asarray(cv2.morphologyEx(mask.astype(np.uint8), cv2.MORPH_CLOSE, kernel) > 0)


def _without_areas(mask: Booleans, widest: float) -> Booleans:
    """Without what is far wider than roads are: squares and parking lots of the same color."""
    inner = cv2.distanceTransform(mask.astype(np.uint8), cv2.DIST_L2, 5)
    core = inner > _WIDE / 2 * widest
    if not core.any():
        return mask
    size = 2 * int(np.ceil(_WIDE / 2 * widest)) + 1
    kernel = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (size, size))
    wide: NDArray[np.uint8] = cv2.dilate(core.astype(np.uint8), kernel)
    return np.asarray(mask & (wide == 0))


def _without_thin(mask: Booleans, width: float) -> Booleans:
    """Without what is not nearly as wide as a road: railways of the same color."""
    size = max(1, int(_THIN * width))
    core = cv2.morphologyEx(mask.astype(np.uint8), cv2.MORPH_OPEN, np.ones((size, size), np.uint8))
    return np.asarray(mask & (cv2.dilate(core, np.ones((3, 3), np.uint8)) > 0))


def _without_islands(mask: Booleans, least: float) -> Booleans:
    """Without parts that are nowhere `least` pixels long: buildings of a road's color."""
    _, parts, stats, _ = cv2.connectedComponentsWithStats(mask.astype(np.uint8), connectivity=8)
    long = stats[:, [cv2.CC_STAT_WIDTH, cv2.CC_STAT_HEIGHT]].max(axis=1) >= least
    long[0] = False
    return np.asarray(long[parts])
