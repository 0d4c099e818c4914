"""The flat colors of a rendered map, and the shapes that each of them has."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans

from ..colors.counted_colors import CountedColors, color_codes, counted_colors
from ..colors.local_spread import local_spread
from ..colors.mixed_pixels import with_thin_lines
from ..colors.picture_memo import OncePerPicture
from ..colors.tones import Image, away_from_each
from .tone_shape import HasShape, ToneSurface

_LEAST, _MOST = 0.001, 32
"""Least share of the picture that a tone covers, and the greatest number of tones."""
_BITS = 2
_LEVELS = 256 >> _BITS

_BLOCK, _NOISY = 9, 0.26
"""Within a block of `_BLOCK` pixels around edges, JPEG leaves noise on more than `_NOISY` of the
even pixels; farther away it may leave none."""
_ROUNDS, _NEAR, _NOISE, _REACH = 2, 7, 10.0, 2.0
"""A JPEG is smoothed `_ROUNDS` times by a bilateral filter: windows of `_NEAR` pixels, standard
deviations of `_NOISE` gray levels and `_REACH` pixels. Edges of streets differ by more."""
_GRAY = 0.02
"""A color whose channels differ by less than this, of 1, has no hue."""
_SHAPED, _GRAIN = 0.2, 4.0
"""A color is noise if less than `_SHAPED` of it is in ribbons and it is at most `_GRAIN` pixels
wide."""
_MIXED = 1.5
"""If a color has wide and thin roads, their mean width exceeds the usual width by more than this
factor."""


@dataclass(frozen=True)
class Tolerance:
    """How exact the colors of a map are, in gray levels."""

    flat: int
    """Within it a neighborhood of 3 x 3 pixels is of one tone."""
    same: int
    """Colors that differ by no more are one tone."""
    near: int
    """A pixel of a tone may be off it by this."""
    is_lossy: bool = False
    """Whether JPEG left noise."""


EXACT, LOSSY = Tolerance(6, 6, 8), Tolerance(6, 8, 16, is_lossy=True)
"""For lossless files, and for JPEG, whose blue is off most at the edges of roads."""


@dataclass(frozen=True)
class MapTone:
    """One flat color of a map: where it is, and how much it looks like roads."""

    color: NDArray[np.float64]
    """(3,) BGR"""
    mask: Booleans
    surface: HasShape
    """what its shape is measured of: all of the color, though the mask may be a part of that"""
    shared: bool = False
    """whether houses or water have the color, too, which are not in the mask"""
    rest: bool = False
    """whether it is a river, or what is left where most of the color is water or land: a road only
    where no others are"""

    @property
    def length(self) -> float:
        """Of its center lines, pixels."""
        return self.surface.shape.length

    @property
    def ribbons(self) -> float:
        """Share of the surface that lies in parts much longer than wide."""
        return self.surface.shape.ribbons

    @property
    def width(self) -> float:
        """Usual width, pixels."""
        return self.surface.shape.width

    @property
    def spread(self) -> float:
        """The width of its wide parts over the usual one."""
        return self.surface.shape.spread

    @property
    def even(self) -> float:
        """Share of the length whose width is near that of its part."""
        return self.surface.shape.even

    @property
    def widest(self) -> float:
        """Width of its widest place, pixels."""
        return self.surface.shape.widest

    @property
    def steady(self) -> float:
        """Share of the surface that keeps its width along its length."""
        return self.surface.steadiness.share

    @property
    def steady_length(self) -> float:
        """Length of that, pixels."""
        return self.surface.steadiness.length

    @property
    def steady_wide(self) -> float:
        """Width of its widest twentieth, pixels."""
        return self.surface.steadiness.wide

    @property
    def is_gray(self) -> bool:
        """Whether it is black, gray or white."""
        return is_gray(self.color)

    @property
    def typical_width(self) -> float:
        """Of most of its length or, where much of that is thin lines, of most of its surface;
        pixels."""
        mean = self.mean_width
        return mean if mean > _MIXED * self.width else self.width

    @property
    def mean_width(self) -> float:
        """Of all that is in it, pixels."""
        return float(np.count_nonzero(self.mask)) / max(1.0, self.length)

    def measured_in(self, others: Sequence[MapTone]) -> MapTone:
        """That of the others which has this color at the same pixels, and may have been measured;
        this one if none has."""
        for other in others:
            if np.array_equal(self.color, other.color) and np.array_equal(self.mask, other.mask):
                return other
        return self


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
    """A map (h, w, 3) stored as JPEG, with flat areas again: its chroma is smoothed, which JPEG has
    at half the resolution, quantized coarsely, and then all that differs by no more than noise."""
    light, red, blue = cv2.split(cv2.cvtColor(image, cv2.COLOR_BGR2YCrCb))
    even = cv2.merge([light, cv2.medianBlur(red, 5), cv2.medianBlur(blue, 5)])
    smooth = cv2.cvtColor(even, cv2.COLOR_YCrCb2BGR)
    for _ in range(_ROUNDS):
        smooth = cv2.bilateralFilter(smooth, _NEAR, _NOISE, _REACH)
    return np.asarray(smooth)


def flat_colors(image: Image, tolerance: Tolerance = EXACT) -> list[NDArray[np.float64]]:
    """The colors (3,) BGR of the even parts of a picture (h, w, 3), most frequent first."""
    return _frequent(_flat(image, tolerance.flat), image.shape, tolerance)


@OncePerPicture
def _flat(image: Image, most: int) -> CountedColors:
    """The colors of the pixels of a picture (h, w, 3) around which it varies by at most so much."""
    return counted_colors(color_codes(image)[local_spread(image) <= most])


def frequent_colors(
    image: Image, within: Booleans, tolerance: Tolerance = EXACT
) -> list[NDArray[np.float64]]:
    """The colors (3,) BGR that many of some pixels (h, w) of a picture (h, w, 3) have, most
    frequent first."""
    return _frequent(counted_colors(color_codes(image)[within]), image.shape, tolerance)


def _frequent(
    flat: CountedColors, shape: tuple[int, ...], tolerance: Tolerance
) -> list[NDArray[np.float64]]:
    """Those that many pixels of a picture (h, w, 3) have, most frequent first."""
    blue, green, red = (flat.colors >> _BITS).astype(np.int32).T
    cells, cell = np.unique((blue * _LEVELS + green) * _LEVELS + red, return_inverse=True)
    counts = flat.binned(cell, len(cells))
    least = 0.5 * _LEAST * shape[0] * shape[1]
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
    if not tolerance.is_lossy or smooth:
        return tones
    shaped = [tone.color for tone in tones if tone.ribbons >= _SHAPED or tone.width > _GRAIN]
    if 0 < len(shaped) < len(tones):
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
    best = np.full(image.shape[:2], near + 1, np.uint8)
    for index, away in enumerate(away_from_each(image, colors)):
        np.copyto(label, index, where=away < best)
        best = np.minimum(best, away)
    if smooth:
        label = with_thin_lines(image, label, colors)
    return [label == index for index in range(len(colors))]


def map_tone(color: NDArray[np.float64], mask: Booleans) -> MapTone:
    """A color where it is (h, w), with its shapes there."""
    return MapTone(color, mask, ToneSurface(mask))
