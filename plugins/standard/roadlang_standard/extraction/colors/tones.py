"""The few flat tones of a drawing: which they are, which is the paper, how flat the picture is."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from .counted_colors import color_codes, counted_colors

Image = NDArray[np.uint8]
Layer = NDArray[np.float32]

_BINS = 5
_STRANGE = 50.0
"""Gray levels by which a color is off all mixtures of two tones that are no tone of its own."""


@dataclass(frozen=True)
class Tones:
    """Dominant colors (k, 3) BGR, most frequent first, and the share of pixels near each (k,)."""

    colors: NDArray[np.float64]
    shares: NDArray[np.float64]
    paper: int
    """Index of the background: the tone that holds most of the picture's rim."""

    @property
    def covered(self) -> float:
        """Share of all pixels that lie near one of the tones."""
        return float(self.shares.sum())


def tones(image: Image, most: int = 8, least: float = 0.004, near: float = 40.0) -> Tones:
    """The dominant colors of a picture (h, w, 3), found in a coarse color histogram."""
    sample = counted_colors(color_codes(thinned(image, 120_000)))
    total = int(sample.counts.sum())
    blue, green, red = (sample.colors >> _BINS).astype(np.int32).T
    cell = (blue << 6) | (green << 3) | red
    left = np.ones(len(cell), bool)
    colors: list[NDArray[np.float64]] = []
    shares: list[float] = []
    for peak in np.argsort(sample.binned(cell, 512))[::-1][: 3 * most]:
        members = left & (cell == peak)
        if sample.number(members) / total < least or len(colors) == most:
            continue
        color = sample.median(members)
        close = left & sample.near(color, near - 0.5)  # medians are whole numbers or halves
        colors.append(color)
        shares.append(sample.number(close) / total)
        left &= ~close
    if not colors:
        colors, shares = [sample.median(left)], [1.0]
    stacked = np.array(colors)
    rim = np.concatenate([image[0], image[-1], image[:, 0], image[:, -1]]).astype(float)
    nearest = np.abs(rim[:, None] - stacked[None]).max(axis=2).argmin(axis=1)
    votes = np.bincount(nearest, minlength=len(stacked)) / len(rim) + 0.5 * np.array(shares)
    return Tones(stacked, np.array(shares), int(np.argmax(votes)))


def away_from(image: Image, color: NDArray[np.float64]) -> Image:
    """How far each pixel (h, w) is from a color, in its worst channel, 0..255."""
    return next(away_from_each(image, [color]))


def away_from_each(image: Image, colors: Sequence[NDArray[np.float64]]) -> Iterator[Image]:
    """How far each pixel (h, w) is from one color after the other, as `away_from`."""
    channels = cv2.split(image)
    for color in colors:
        flat = np.clip(color, 0, 255).round().tolist()
        blue, green, red = (cv2.absdiff(*each) for each in zip(channels, flat, strict=True))
        yield np.asarray(cv2.max(cv2.max(blue, green), red))


def thinned(image: Image, most: int) -> Image:
    """Every k-th pixel, so that at most about `most` are left."""
    step = max(1, int(np.ceil(np.sqrt(image.shape[0] * image.shape[1] / most))))
    return image if step == 1 else image[::step, ::step]


def flatness(image: Image, within: NDArray[np.bool_] | None = None) -> float:
    """Share of pixels, of those `within` (h, w), whose 3x3 neighborhood hardly varies.

    Hardly is a fifth of the picture's own deviation and at most 10 gray levels, so that a photo
    dimmed or washed out stays as it is.
    """
    height, width = image.shape[:2]
    top, left = max(0, height - 700) // 2, max(0, width - 700) // 2
    window = (slice(top, top + 700), slice(left, left + 700))
    patch = image[window]
    gray = cv2.cvtColor(patch, cv2.COLOR_BGR2GRAY)
    kernel = np.ones((3, 3), np.uint8)
    varied = cv2.split(cv2.subtract(cv2.dilate(patch, kernel), cv2.erode(patch, kernel)))
    spreads = cv2.max(cv2.max(varied[0], varied[1]), varied[2])
    if within is not None:
        gray, spreads = gray[within[window]], spreads[within[window]]
    if not gray.size:
        return 1.0
    spread = min(10.0, 0.2 * float(cv2.meanStdDev(gray)[1][0, 0]))
    return float((spreads <= spread).mean())


def layers(
    image: Image, colors: Sequence[NDArray[np.float64]], paper: NDArray[np.float64]
) -> list[Layer]:
    """How much of each pixel (h, w) is of each of the `colors` rather than of the nearest of the
    others and of the `paper`, 0..1.

    On an anti-aliased edge between two tones this is the covered share of the pixel. Most pixels
    have exactly the color of the paper: one of them tells for all.
    """
    plain = np.clip(paper, 0, 255).round().astype(np.float32)
    drawn = np.flatnonzero(away_from(image, paper))
    pixels = np.vstack([image.reshape(-1, 3).take(drawn, axis=0), plain]).astype(np.float32)
    found = []
    for index, color in enumerate(colors):
        others = [paper, *(other for i, other in enumerate(colors) if i != index)]
        share = _shares(pixels, color, others)
        result = np.full(image.shape[:2], share[-1], np.float32)
        result.ravel()[drawn] = share[:-1]
        found.append(result)
    return found


def _shares(
    pixels: Layer, color: NDArray[np.float64], others: Sequence[NDArray[np.float64]]
) -> Layer:
    """Of pixels (n, 3), as in `layers` (n,)."""
    result = np.ones(len(pixels), np.float32)
    for other in others:
        axis = (color - other).astype(np.float32)
        along = ((pixels - other.astype(np.float32)) @ axis) / max(float(axis @ axis), 1e-6)
        np.minimum(result, np.clip(along, 0, 1), out=result)
    return result


def without_other_colors(
    surface: Layer, image: Image, color: NDArray[np.float64], others: NDArray[np.float64]
) -> Layer:
    """The surface (h, w), 0..1, without what is of `color` by its lightness alone, such as an arrow
    whose color is too rare for a tone: no mixture of `color` with one of the `others` (k, 3)."""
    there = np.flatnonzero(surface >= 0.5)
    pixels = image.reshape(-1, 3)[there].astype(np.float32)
    off = np.full(len(there), np.inf, np.float32)
    for other in others:
        axis = (color - other).astype(np.float32)
        along = (pixels - other.astype(np.float32)) @ axis / max(float(axis @ axis), 1e-6)
        mixed = other.astype(np.float32) + np.clip(along, 0, 1)[:, None] * axis
        off = np.minimum(off, np.abs(pixels - mixed).max(axis=1))
    strange = there[off > _STRANGE]
    if not len(strange):
        return surface
    result = surface.copy()
    result.ravel()[strange] = 0
    return result
