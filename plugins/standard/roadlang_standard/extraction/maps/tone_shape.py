"""The shapes that a flat color of a map has: how long and how even its strips are."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans

from ..colors.tones import Layer
from ..masks.mask_parts import window_around, without_specks
from ..masks.skeleton import skeleton
from .map_ribbons import ribbons_along

THINNEST = 2.0
"""Ribbons are wider than this, in pixels, unless they are very long; casings and footpaths are
thinner."""
_THIN_LONG = 80.0
"""Thin lines longer than this, in pixels, are connected like streets; outlines of buildings are
shorter."""
_LONG = 5.0
"""Least length of a ribbon in widths."""
SPECK = 8
"""Parts and holes of fewer pixels are ignored."""


@dataclass(frozen=True)
class ToneShape:
    """How much a surface looks like roads."""

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


@dataclass(frozen=True)
class Steadiness:
    """How much of a surface keeps its width along its length."""

    share: float
    """of the surface"""
    length: float
    """of that, pixels"""
    wide: float = 0.0
    """width of its widest twentieth, pixels"""


@dataclass(frozen=True)
class _Ridge:
    """The center lines of a surface (h, w): the picture's `size`, their pixels (n,) as indices of
    the flat picture, and the width there (n,)."""

    size: tuple[int, int]
    at: NDArray[np.intp]
    widths: Layer

    @property
    def steadiness(self) -> Steadiness:
        if not len(self.at):
            return Steadiness(0.0, 0.0)
        steady = ribbons_along(self.size, self.at, self.widths)
        return Steadiness(steady.share, steady.length, steady.wide)


NO_SHAPE = ToneShape(0.0, 0.0, 0.0, 1.0, 0.0, 0.0)
"""Of nothing."""


class HasShape(Protocol):
    """What has a shape."""

    @property
    def shape(self) -> ToneShape:
        """Its shape."""
        ...

    @property
    def steadiness(self) -> Steadiness:
        """How much of it keeps its width."""
        ...


@dataclass(frozen=True)
class ToneSurface:
    """A surface (h, w). To measure it takes longer than all else: that is done when first asked,
    and nobody asks what shape the land of a map has."""

    mask: Booleans

    @property
    def shape(self) -> ToneShape:
        """Its shape."""
        return self._measured[0]

    @cached_property
    def steadiness(self) -> Steadiness:
        """How much of it keeps its width: asked where colors alone do not tell what is a road."""
        return self._measured[1].steadiness

    @cached_property
    def _measured(self) -> tuple[ToneShape, _Ridge]:
        return _shape(self.mask)


def _shape(mask: Booleans) -> tuple[ToneShape, _Ridge]:
    window = window_around(mask, SPECK)
    clean = without_specks(np.ascontiguousarray(mask[window]), SPECK)
    inner = cv2.distanceTransform(clean.view(np.uint8), cv2.DIST_L2, 5)
    thin = skeleton(clean)
    at = np.flatnonzero(thin)
    ridge = _Ridge((clean.shape[0], clean.shape[1]), at, 2 * inner.ravel()[at] - 1)
    parts = _parts(clean, ridge)
    if not len(parts.lengths):
        return NO_SHAPE, ridge
    wide = (parts.usual > THINNEST) | (parts.lengths > _THIN_LONG)
    ribbon = (parts.lengths > _LONG * np.maximum(parts.usual, 1)) & wide
    weights = np.where(ribbon, parts.lengths, 0) if ribbon.any() else parts.lengths
    weights = weights / max(float(weights.sum()), 1.0)
    usual = float(weights @ parts.usual)
    shape = ToneShape(
        float(parts.lengths.sum()),
        float((parts.lengths * parts.usual)[ribbon].sum() / (parts.lengths @ parts.usual)),
        usual,
        float(weights @ parts.wide) / max(usual, 1.0),
        float(weights @ parts.even),
        2 * float(inner.max()) - 1,
    )
    return shape, ridge


@dataclass(frozen=True)
class _Parts:
    """The connected parts (n,) of a mask: length of the center lines, usual width, that of the wide
    tenth, and the share of the length that is about as wide as usual."""

    lengths: NDArray[np.float64]
    usual: NDArray[np.float64]
    wide: NDArray[np.float64]
    even: NDArray[np.float64]


def _parts(mask: Booleans, ridge: _Ridge) -> _Parts:
    _, labels = cv2.connectedComponents(mask.view(np.uint8), connectivity=8)
    part, width = labels.ravel()[ridge.at], ridge.widths.astype(np.float64)
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
