"""Colors by how many pixels have them: drawings have few, so that these tell as much as pixels."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans

Codes = NDArray[np.int32]
"""Colors as blue + 256 green + 65536 red."""
_BITS = 39
"""Bits for the length of a run of one color, beside the 24 of that."""


@dataclass(frozen=True)
class CountedColors:
    """Distinct colors (n, 3) BGR, in the order of their codes, and the pixels (n,) of each."""

    colors: NDArray[np.uint8]
    counts: NDArray[np.int64]

    def number(self, chosen: Booleans) -> int:
        """How many pixels have one of the `chosen` (n,) colors."""
        return int(self.counts[chosen].sum())

    def binned(self, bins: NDArray[np.integer[Any]], size: int) -> NDArray[np.int64]:
        """How many pixels (size,) there are in each bin, given the bin (n,) of each color."""
        return np.bincount(bins, weights=self.counts, minlength=size).astype(np.int64)

    def median(self, chosen: Booleans) -> NDArray[np.float64]:
        """The median (3,) of the pixels that have one of the `chosen` (n,) colors, by channel."""
        counts = self.counts[chosen]
        total = int(counts.sum())
        middle = [(total - 1) // 2, total // 2]
        below = [
            np.cumsum(np.bincount(channel, weights=counts, minlength=256))
            for channel in self.colors[chosen].T
        ]
        return np.array([np.searchsorted(sums, middle, side="right").mean() for sums in below])

    @property
    def usual(self) -> NDArray[np.float64]:
        """The median (3,) of all pixels, by channel."""
        return self.median(np.ones(len(self.counts), bool))

    def near(self, color: NDArray[np.float64], most: float) -> Booleans:
        """Which colors (n,) are off a color by at most so much in each channel."""
        low = np.clip(np.ceil(color - most), 0, 255).astype(np.uint8)
        high = np.clip(np.floor(color + most), 0, 255).astype(np.uint8)
        return np.asarray(((self.colors >= low) & (self.colors <= high)).all(axis=1))


def color_codes(image: NDArray[np.uint8]) -> Codes:
    """The code of the color of each pixel (h, w) of a picture (h, w, 3)."""
    padded = cv2.cvtColor(np.ascontiguousarray(image), cv2.COLOR_BGR2BGRA)
    codes = padded.view("<i4")[..., 0]
    codes &= 0xFFFFFF
    return np.asarray(codes, np.int32)


def counted(codes: Codes) -> tuple[Codes, NDArray[np.int64]]:
    """As `numpy.unique` with counts, by runs of one color: drawings have few of these."""
    flat = codes.ravel()
    starts = np.append(0, np.flatnonzero(flat[1:] != flat[:-1]) + 1) if len(flat) else flat[:0]
    lengths = np.diff(starts, append=len(flat))
    packed = flat[starts].astype(np.int64) << _BITS | lengths
    packed.sort()  # in a fifth of the time that the order of the values takes
    values, lengths = (packed >> _BITS).astype(np.int32), packed & ((1 << _BITS) - 1)
    first = np.flatnonzero(np.append(True, values[1:] != values[:-1])[: len(values)])
    sums = np.append(0, np.cumsum(lengths))
    return values[first], np.diff(sums[np.append(first, len(values))])


def counted_colors(codes: Codes) -> CountedColors:
    """The distinct colors of pixels, given by their codes in an array of any shape."""
    values, counts = counted(codes)
    colors = np.column_stack([values & 255, values >> 8 & 255, values >> 16]).astype(np.uint8)
    return CountedColors(colors, counts)
