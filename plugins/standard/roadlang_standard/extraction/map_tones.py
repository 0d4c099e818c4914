"""The flat colors of a rendered map, and the shapes that each of them has."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans

from .counted_colors import color_codes, counted_colors
from .map_ribbons import ribbons
from .masks import without_specks
from .mixed_pixels import with_thin_lines
from .skeleton import skeleton
from .tones import Image, Layer, away_from

_LEAST, _MOST = 0.001, 32
"""Least share of the picture that a tone covers, and how many tones are looked at."""
_BITS = 2
_LEVELS = 256 >> _BITS

_BLOCK, _NOISY = 9, 0.26
"""Within a block of an edge, JPEG leaves noise on more than this share of what is even; farther
from edges it may leave none."""
_SAME_TONE, _MARKED, _FAINT, _CLEAR, _MOST_STRETCH = 3, 0.9, 20, 60, 3.0
"""A map is faint where what differs from its land by more than the first, in gray levels, does so
by no more than the third in the share of the second; that share is to differ by the fourth, but
contrast is not raised by more than the last factor."""
_GRAY = 0.02
"""Channels that differ by less, of 1, have no hue."""
THINNEST = 2.0
"""Ribbons are wider than this, in pixels, unless they are very long: casings and footpaths are
not."""
_THIN_LONG = 80.0
"""Thin lines longer than this, in pixels, hang together as streets do; outlines of buildings do
not."""
_LONG = 5.0
"""A ribbon is longer than so many widths."""
_SHAPED, _GRAIN = 0.2, 4.0
"""Noise of a color is in ribbons to a smaller share than this, and no wider than so many pixels."""
_MIXED = 1.5
"""Wide and thin roads of one color are on average wider than usual by more than this factor."""
_SPECK = 8
"""Parts and holes of fewer pixels are not looked at."""


@dataclass(frozen=True)
class Tolerance:
    """How exact the colors of a map are, in gray levels."""

    flat: int
    """Within it a neighborhood of 3 x 3 pixels is of one tone."""
    same: int
    """Colors that differ by no more are one tone."""
    near: int
    """A pixel of a tone may be off it by this."""


EXACT, LOSSY = Tolerance(6, 6, 8), Tolerance(12, 8, 16)
"""For lossless files, and for JPEG, whose blue is off most at the edges of roads."""


@dataclass(frozen=True)
class MapTone:
    """One flat color of a map: where it is, and how much it looks like roads."""

    color: NDArray[np.float64]
    """(3,) BGR"""
    mask: Booleans
    length: float
    """of its center lines, pixels"""
    ribbons: float
    """share of the surface that lies in parts much longer than wide"""
    width: float
    """usual width, pixels"""
    spread: float
    """the width of its wide parts over the usual one"""
    even: float
    """share of the length whose width is near that of its part"""
    widest: float
    """width of its widest place, pixels"""
    steady: float
    """share of the surface that keeps its width along its length"""
    steady_length: float
    """length of that, pixels"""
    steady_wide: float = 0.0
    """width of its widest twentieth, pixels"""
    shared: bool = False
    """whether houses or water have the color, too, which are not in the mask"""

    @property
    def is_gray(self) -> bool:
        """Whether it is black, gray or white."""
        return is_gray(self.color)

    @property
    def typical_width(self) -> float:
        """Of most of its length or, where much of that is thin lines, of most of its surface;
        pixels."""
        mean = float(self.mask.sum()) / max(1.0, self.length)
        return mean if mean > _MIXED * self.width else self.width


def is_gray(color: NDArray[np.float64]) -> bool:
    """Whether a color (3,) is black, gray or white."""
    return float(np.ptp(color)) < _GRAY * 255


def tolerance_of(image: Image) -> Tolerance:
    """How exact the colors of a map (h, w, 3) are: JPEG leaves noise at edges."""
    spread = local_spread(image)
    edges = (spread > EXACT.flat).astype(np.uint8)
    near = (cv2.dilate(edges, np.ones((_BLOCK, _BLOCK), np.uint8)) > edges) & (spread <= EXACT.flat)
    return LOSSY if near.any() and (spread[near] > 0).mean() > _NOISY else EXACT


def without_jpeg_noise(image: Image) -> Image:
    """A map (h, w, 3) with its chroma smoothed: JPEG has it at half the resolution, quantized
    coarsely."""
    light, red, blue = cv2.split(cv2.cvtColor(image, cv2.COLOR_BGR2YCrCb))
    even = cv2.merge([light, cv2.medianBlur(red, 5), cv2.medianBlur(blue, 5)])
    return np.asarray(cv2.cvtColor(even, cv2.COLOR_YCrCb2BGR))


def with_contrast(image: Image) -> Image:
    """A lossless map (h, w, 3), with more contrast about its land where it has little: lines that
    differ from it by ten gray levels have no edges of a mixed color else."""
    land = flat_colors(image)[:1]
    if not land:
        return image
    away = away_from(image, land[0])
    seen = away[away > _SAME_TONE]
    differs = float(np.quantile(seen, _MARKED)) if seen.size else 255.0
    if differs > _FAINT:
        return image
    stretch = min(_MOST_STRETCH, _CLEAR / differs)
    return np.clip(land[0] + (image - land[0]) * stretch, 0, 255).round().astype(np.uint8)


def flat_colors(image: Image, tolerance: Tolerance = EXACT) -> list[NDArray[np.float64]]:
    """The colors (3,) BGR of the even parts of a picture (h, w, 3), most frequent first."""
    return frequent_colors(image, local_spread(image) <= tolerance.flat, tolerance)


def frequent_colors(
    image: Image, within: Booleans, tolerance: Tolerance = EXACT
) -> list[NDArray[np.float64]]:
    """The colors (3,) BGR that many of some pixels (h, w) of a picture (h, w, 3) have, most
    frequent first."""
    flat = counted_colors(color_codes(image)[within])
    blue, green, red = (flat.colors >> _BITS).astype(np.int32).T
    cell = (blue * _LEVELS + green) * _LEVELS + red
    counts = flat.binned(cell, _LEVELS**3)
    least = 0.5 * _LEAST * image.shape[0] * image.shape[1]
    frequent = np.flatnonzero(counts >= least)
    left = np.ones(len(cell), bool)
    colors: list[NDArray[np.float64]] = []
    for peak in frequent[np.argsort(counts[frequent], kind="stable")][::-1][: 8 * _MOST]:
        if len(colors) == _MOST:
            break
        members = left & (cell == peak)
        if flat.number(members) < least:
            continue
        color = flat.median(members)
        left &= ~flat.near(color, tolerance.same)
        colors.append(color)
    return colors


def local_spread(image: Image) -> Image:
    """How much the 3 x 3 pixels around each (h, w) vary, in their worst channel."""
    kernel = np.ones((3, 3), np.uint8)
    blue, green, red = cv2.split(cv2.subtract(cv2.dilate(image, kernel), cv2.erode(image, kernel)))
    return np.asarray(cv2.max(cv2.max(blue, green), red))


def map_tones(
    image: Image,
    colors: list[NDArray[np.float64]],
    tolerance: Tolerance = EXACT,
    smooth: bool = False,
) -> list[MapTone]:
    """Where the `colors` of a rendered map (h, w, 3) are, and what shapes they have.

    In a JPEG, a color that forms no shape is noise: its pixels go to the nearest color in reach.
    With `smooth`, thin lines have the pixels that a renderer smoothed.
    """
    tones = _tones_of(image, colors, tolerance.near, smooth)
    shaped = [tone.color for tone in tones if tone.ribbons >= _SHAPED or tone.width > _GRAIN]
    if tolerance is LOSSY and 0 < len(shaped) < len(tones):
        return _tones_of(image, shaped, tolerance.near)
    return tones


def _tones_of(
    image: Image, colors: list[NDArray[np.float64]], near: int, smooth: bool = False
) -> list[MapTone]:
    masks = color_masks(image, colors, near, smooth)
    return [map_tone(color, mask) for color, mask in zip(colors, masks, strict=True)]


def color_masks(
    image: Image, colors: list[NDArray[np.float64]], near: int, smooth: bool = False
) -> list[Booleans]:
    """Where (h, w) each of the `colors` of a map (h, w, 3) is, `near` as in `Tolerance`."""
    label = np.full(image.shape[:2], -1, np.int16)
    best = np.full(image.shape[:2], near + 1, np.int16)
    for index, color in enumerate(colors):
        away = away_from(image, color).astype(np.int16)
        closer = away < best
        best[closer], label[closer] = away[closer], index
    if smooth:
        label = with_thin_lines(image, label, colors)
    return [label == index for index in range(len(colors))]


def map_tone(color: NDArray[np.float64], mask: Booleans) -> MapTone:
    """What shapes a color has where it is (h, w)."""
    clean = without_specks(mask, _SPECK)
    inner = cv2.distanceTransform(clean.astype(np.uint8), cv2.DIST_L2, 5)
    thin = skeleton(clean)
    parts = _parts(clean, inner, thin)
    if not len(parts.lengths):
        return MapTone(color, mask, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0)
    wide = (parts.usual > THINNEST) | (parts.lengths > _THIN_LONG)
    ribbon = (parts.lengths > _LONG * np.maximum(parts.usual, 1)) & wide
    weights = np.where(ribbon, parts.lengths, 0) if ribbon.any() else parts.lengths
    weights = weights / max(float(weights.sum()), 1.0)
    usual = float(weights @ parts.usual)
    steady = ribbons(thin, inner)
    return MapTone(
        color,
        mask,
        float(parts.lengths.sum()),
        float((parts.lengths * parts.usual)[ribbon].sum() / (parts.lengths @ parts.usual)),
        usual,
        float(weights @ parts.wide) / max(usual, 1.0),
        float(weights @ parts.even),
        2 * float(inner.max()) - 1,
        steady.share,
        steady.length,
        steady.wide,
    )


@dataclass(frozen=True)
class _Parts:
    """The connected parts (n,) of a mask: length of the center lines, usual width, that of the wide
    tenth, and the share of the length that is about as wide as usual."""

    lengths: NDArray[np.float64]
    usual: NDArray[np.float64]
    wide: NDArray[np.float64]
    even: NDArray[np.float64]


def _parts(mask: Booleans, inner: Layer, thin: Booleans) -> _Parts:
    _, labels = cv2.connectedComponents(mask.astype(np.uint8), connectivity=8)
    part, width = labels[thin], (2 * inner[thin] - 1).astype(np.float64)
    order = np.lexsort((width, part))
    part, width = part[order], width[order]
    starts = np.flatnonzero(np.r_[True, np.diff(part) > 0]) if len(part) else np.zeros(0, np.intp)
    counts = np.diff(np.r_[starts, len(part)])
    usual = _quantiles(width, starts, counts, 0.5)
    middle = np.repeat(usual, counts)
    near = (width > 0.6 * middle) & (width < 1.6 * middle)
    even = np.add.reduceat(near.astype(np.float64), starts) if len(starts) else np.zeros(0)
    wide = _quantiles(width, starts, counts, 0.9)
    return _Parts(counts.astype(np.float64), usual, wide, even / np.maximum(counts, 1))


def _quantiles(
    values: NDArray[np.float64],
    starts: NDArray[np.intp],
    counts: NDArray[np.intp],
    share: float,
) -> NDArray[np.float64]:
    """The quantile (n,) of each of n runs of ascending values, between two of them by lines."""
    place = starts + share * (counts - 1)
    low = np.floor(place).astype(np.intp)
    high = np.minimum(low + 1, starts + counts - 1)
    return np.asarray(values[low] + (place - low) * (values[high] - values[low]))
