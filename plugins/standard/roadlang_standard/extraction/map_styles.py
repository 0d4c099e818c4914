"""Map styles whose colors are known: what is land in them, and what is a road."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .colors import bgr
from .map_tones import MapTone, Tolerance
from .tones import Image, away_from

_EXACTLY, _NEARLY = 1.0, 4.0
"""A color is one of a style if it is off that by at most `_EXACTLY` gray levels in a lossless file,
and by at most `_NEARLY` in a JPEG."""
_KNOWN, _WINDOW = 0.6, 640
_KNOWN_LOSSY = 0.45
"""At least `_KNOWN` of a map, in a window of `_WINDOW` pixels a side, has the colors of its style,
of a JPEG at least `_KNOWN_LOSSY`: names, icons and edges are the rest."""
_LAND, _MOST = 12, 6
"""The land of a style is among the `_MOST` most frequent colors; `_LAND` are looked at."""
_SHARED, _SHARED_LOSSY, _TINTED = 2, 3, 6
"""Least number of colors that a map, or one stored as JPEG, shares with its style. All of them but
one have channels that differ by at least `_TINTED`: snow and paper have any gray."""
_LONG = 16
"""Roads are at least so many pixels long."""


@dataclass(frozen=True)
class MapStyle:
    """The colors (n, 3) BGR of a style: of its land, parks, water and houses, and of its roads."""

    ground: NDArray[np.float64]
    roads: NDArray[np.float64]

    @staticmethod
    def of(ground: str, roads: str) -> MapStyle:
        """That of color codes such as "#f2efe9", separated by spaces."""
        both = ([bgr(code) for code in codes.split()] for codes in (ground, roads))
        return MapStyle(*(np.array(colors, np.float64) for colors in both))

    def is_ground(self, color: NDArray[np.float64], tolerance: Tolerance) -> bool:
        """Whether a color (3,) is one of its land, parks, water or houses."""
        return _is_one(color, self.ground, tolerance)

    def is_road(self, color: NDArray[np.float64], tolerance: Tolerance) -> bool:
        """Whether a color (3,) is one of its roads."""
        return _is_one(color, self.roads, tolerance)

    def roads_among(self, tones: Sequence[MapTone], tolerance: Tolerance) -> list[MapTone]:
        """The tones of a map of this style that are roads, the longest first. A few pixels are
        none."""
        roads = [
            tone for tone in tones if self.is_road(tone.color, tolerance) and tone.length >= _LONG
        ]
        return sorted(roads, key=lambda tone: -tone.length)


STYLES = (
    # openstreetmap-carto; tunnels and areas for walking are paler than its roads.
    MapStyle.of(
        "#f2efe9 #e0dfdf #d9d0c9 #add19e #cdebb0 #c8facc #ebdbe8 #f2dad9 #c7c7b4 #aad3df #aae0cb "
        "#eef0d5 #dfddce #c8d7ab #ffd6d1 #eeeeee #dddde8 #f5dcba #dffce2 #ffffe5",
        "#ffffff #f7fabf #fcd6a4 #f9b29c #e892a2",
    ),
)


def style_of(
    image: Image, colors: Sequence[NDArray[np.float64]], tolerance: Tolerance
) -> MapStyle | None:
    """The style of a map (h, w, 3) with these `colors` (3,), most frequent first, if it is known.

    Two styles may share a color, but hardly the colors of most of a map.
    """
    top, left = (max(0, size - _WINDOW) // 2 for size in image.shape[:2])
    shared, least = (_SHARED_LOSSY, _KNOWN_LOSSY) if tolerance.is_lossy else (_SHARED, _KNOWN)
    part = np.ascontiguousarray(image[top : top + _WINDOW, left : left + _WINDOW])
    for style in STYLES:
        ground = [style.is_ground(color, tolerance) for color in colors[:_LAND]]
        known = [
            color
            for color, is_ground in zip(colors[:_LAND], ground, strict=True)
            if is_ground or style.is_road(color, tolerance)
        ]
        tinted = sum(np.ptp(color) >= _TINTED for color in known)
        if not any(ground[:_MOST]) or len(known) < shared or tinted < shared - 1:
            continue
        seen = np.zeros(part.shape[:2], bool)
        for color in known:
            seen |= away_from(part, color) <= tolerance.flat
        if seen.mean() >= least:
            return style
    return None


def _is_one(color: NDArray[np.float64], colors: NDArray[np.float64], tolerance: Tolerance) -> bool:
    most = _NEARLY if tolerance.is_lossy else _EXACTLY
    return bool((np.abs(colors - color).max(axis=1) <= most).any())
