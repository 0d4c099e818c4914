"""Map styles whose colors are known: what is land in them, and what is a road."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import cv2
import numpy as np
from numpy.typing import NDArray

from ..colors.colors import bgr
from ..colors.tones import Image, away_from
from ..masks.mask_parts import parts_and_boxes, where_parts
from .map_contrast import Stretch
from .map_tones import EXACT, MapTone, Tolerance, map_tone

_EXACTLY, _NEARLY = 0.5, 2.5
_ROAD, _ROAD_LOSSY = 1.0, 4.0
"""The color of a land is off that of the style by at most `_EXACTLY` gray levels in a lossless
file, and by at most `_NEARLY` in a JPEG; that of roads, which are narrow, by `_ROAD` and by
`_ROAD_LOSSY`."""
_LIGHTNESS = np.array([0.114, 0.587, 0.299])
"""Of blue, green and red."""
_BETWEEN = 2.0
"""In a JPEG, the color of a road is at least this many times as far off all land as off the color
that the style has for it."""
_KNOWN, _KNOWN_LOSSY, _WINDOW = 0.6, 0.45, 640
"""At least `_KNOWN` of a map, in a window of `_WINDOW` pixels a side, has the colors of its style,
of a JPEG at least `_KNOWN_LOSSY`: names, icons and edges are the rest."""
_FREQUENT, _MOST, _GRAYS = 12, 6, 4
"""Of a map's `_FREQUENT` most frequent colors, the first `_MOST` include the land of its style. The
first `_GRAYS` of a gray map are all of its style."""
_SHARED, _SHARED_LOSSY, _TINTED = 2, 3, 6
_LAND, _ALMOST, _WHITE, _HUED = 0.3, 1.0, 250, 2
"""Least number of colors that a map, or one stored as JPEG, shares with its style. All of them but
one have channels that differ by at least `_TINTED`, as snow and paper have any gray. If at least
`_LAND` of a map has one color within `_ALMOST` gray levels of a land, `_SHARED` colors of any tint
are enough if the channels of one differ by `_HUED`. White, with no channel below `_WHITE`, does not
count: most maps have it."""
_LONG, _DASH = 16, 10
"""Roads are at least `_LONG` pixels long; parts shorter than `_DASH` pixels are dashes."""


@dataclass(frozen=True)
class MapStyle:
    """The colors (n, 3) BGR of a style: of its land, parks, water and houses, and of its roads."""

    ground: NDArray[np.float64]
    roads: NDArray[np.float64]
    contrast: float = 1.0
    """How many times the contrast of the style a map has."""

    @staticmethod
    def of(ground: str, roads: str) -> MapStyle:
        """That of color codes such as "#f2efe9", separated by spaces."""
        land, streets = (
            np.array([bgr(code) for code in codes.split()], np.float64) for codes in (ground, roads)
        )
        return MapStyle(land, streets)

    def is_ground(self, color: NDArray[np.float64], tolerance: Tolerance) -> bool:
        """Whether a color (3,) is one of its land, parks, water or houses."""
        most = _NEARLY if tolerance.is_lossy else _EXACTLY
        return _is_near(color, self.ground, most * self.contrast)

    def is_road(self, color: NDArray[np.float64], tolerance: Tolerance) -> bool:
        """Whether a color (3,) is one of its roads."""
        most = _ROAD_LOSSY if tolerance.is_lossy else _ROAD
        away = np.abs(self.roads - color).max(axis=1)
        near = away <= most * self.contrast
        return bool(near.any()) and not (tolerance.is_lossy and self._is_noise(color, away))

    def _is_noise(self, color: NDArray[np.float64], away: NDArray[np.float64]) -> bool:
        """Whether a color (3,) of a JPEG, so far `away` (n,) from those of roads, is rather noise
        at an edge. Narrow roads are mixed with land, but no lighter or darker than in the style."""
        road = self.roads[away.argmin()]
        from_ground = np.abs(self.ground - color).max(axis=1).min()
        beyond = (color - road) @ _LIGHTNESS * np.sign((road - self.ground[0]) @ _LIGHTNESS)
        return bool(from_ground < _BETWEEN * away.min() or beyond > EXACT.flat)

    def stretched(self, stretch: Stretch) -> MapStyle:
        """The style with more contrast."""
        return MapStyle(stretch.of(self.ground), stretch.of(self.roads), stretch.times)

    def with_its_own(
        self, colors: Sequence[NDArray[np.float64]], tolerance: Tolerance
    ) -> list[NDArray[np.float64]]:
        """The colors (3,) of a map in this style, and those of its roads. In a JPEG, where two
        similar colors look like one, they are all of the style's, and those of the map that the
        style lacks."""
        if not tolerance.is_lossy:
            return [*colors, *_apart(self.roads, colors, tolerance)]
        own = [*self.ground, *self.roads]
        return [*own, *_apart(colors, own, tolerance)]

    def roads_among(self, tones: Sequence[MapTone], tolerance: Tolerance) -> list[MapTone]:
        """The tones of a map of this style that are roads, the longest first, without dashes: those
        of footpaths and railways may have their color. A few pixels are not a road."""
        roads = [_without_dashes(tone) for tone in tones if self.is_road(tone.color, tolerance)]
        long = [tone for tone in roads if tone.length >= _LONG]
        return sorted(long, key=lambda tone: -tone.length)


STYLES = (
    # openstreetmap-carto; tunnels and areas for walking are paler than its roads.
    MapStyle.of(
        "#f2efe9 #e0dfdf #d9d0c9 #add19e #cdebb0 #c8facc #ebdbe8 #f2dad9 #c7c7b4 #aad3df #aae0cb "
        "#eef0d5 #dfddce #c8d7ab #ffd6d1 #eeeeee #dddde8 #f5dcba #dffce2 #ffffe5",
        "#ffffff #f7fabf #fcd6a4 #f9b29c #e892a2",
    ),
    # OSM Bright, VersaTiles Colorful
    MapStyle.of(
        "#f8f4f0 #f5f1ed #f2eae2 #e9eddf #d8e8c8 #dfdbd7 #f7eae7 #e0e4dd #e0dcd8 #faf4e0 #bfd9f2 "
        "#cbe5b8 #d1e5c3 #f8eeef #e3e7cd #cdd9a9",
        "#ffffff #ffeeaa #ffcc88",
    ),
    # OSM Liberty
    MapStyle.of(
        "#efefef #e5e3e1 #dcecd3 #dce7d6 #d8e0bd #dee3cd #eae9e8 #9ebdff",
        "#ffffff #ffeeaa #ffcc88",
    ),
    # MapTiler Basic
    MapStyle.of(
        "#e8e5d8 #e2e0d7 #ded3be #c8dba4 #d6dfbb #94c1e1 #d3ddba",
        "#ffffff #f7f7f7",
    ),
    # Positron of OpenMapTiles
    MapStyle.of("#f2f3f0 #eaeae5 #dce0dc #c2c8ca #ebebeb", "#ffffff #e2e2e2"),
    # VersaTiles Neutrino
    MapStyle.of(
        "#f4f0ee #f0eeec #eeeae6 #f2eded #e1dfdd #dbe5d4 #d7e4ce #e3e5e1 #e5e6da #d6dcc5 #f3f0e7 "
        "#d0dde9",
        "#f9f9f9 #f5ecc4",
    ),
    # VersaTiles Eclipse
    MapStyle.of(
        "#282725 #2b2826 #312c27 #2e2829 #2c3923 #2b3b1d #31332f #393734 #303322 #383f1f #0c1c2a",
        "#525252 #695d2b #575757",
    ),
)

GRAY_STYLES = (
    # Dark Matter of OpenMapTiles
    MapStyle.of("#0c0c0c #000000 #1b1b1d #232323 #3b3b3b", "#171717 #121212"),
    # VersaTiles Graybeard
    MapStyle.of(
        "#f5f5f5 #f2f2f2 #ebebeb #e9e9e9 #ededed #eeeeee #f0f0f0 #dfdfdf #d7d7d7 #999999",
        "#fafafa #e3e3e3",
    ),
)
"""Styles of grays alone, each with its land first. Many pictures have a gray or two of these: only
what is a map otherwise, and stored as JPEG, is taken for one of them."""


def gray_style_of(image: Image, colors: Sequence[NDArray[np.float64]]) -> MapStyle | None:
    """The gray style of a map (h, w, 3) with these `colors` (3,), most frequent first; None if it
    is none or not known."""
    if not colors or (away_from(image, colors[0]) == 0).mean() < _LAND:
        return None
    for style in GRAY_STYLES:
        own = np.vstack([style.ground, style.roads])
        known = all(_is_near(color, own, _ALMOST) for color in colors[:_GRAYS])
        if known and len(colors) >= _SHARED and _is_near(colors[0], style.ground, _EXACTLY):
            return style
    return None


def style_of(
    image: Image, colors: Sequence[NDArray[np.float64]], tolerance: Tolerance
) -> MapStyle | None:
    """The style of a map (h, w, 3) with these `colors` (3,), most frequent first, if it is known.

    Two styles may share a color, but hardly the colors of most of a map.
    """
    top, left = (max(0, size - _WINDOW) // 2 for size in image.shape[:2])
    part = np.ascontiguousarray(image[top : top + _WINDOW, left : left + _WINDOW])
    least = _KNOWN_LOSSY if tolerance.is_lossy else _KNOWN
    shares = {}
    for index, style in enumerate(STYLES):
        known = _shared(part, colors[:_FREQUENT], style, tolerance)
        seen = np.zeros(part.shape[:2], bool)
        for color in known:
            seen |= away_from(part, color) <= tolerance.flat
        shares[index] = float(seen.mean())
    best = max(shares, key=lambda index: shares[index])
    return STYLES[best] if shares[best] >= least else None


def _shared(
    part: Image, colors: Sequence[NDArray[np.float64]], style: MapStyle, tolerance: Tolerance
) -> list[NDArray[np.float64]]:
    """The colors (3,) that a map (h, w, 3) shares with a style; none if they are too few."""
    land = [color for color in colors[:_MOST] if style.is_ground(color, tolerance)]
    known = [
        color
        for color in colors
        if style.is_ground(color, tolerance) or style.is_road(color, tolerance)
    ]
    if not land or len(known) < _SHARED:
        return []
    exact = [color for color in land if _is_near(color, style.ground, _ALMOST)]
    own = [color for color in known if color.min() < _WHITE]
    is_gray = all(np.ptp(color) < _HUED for color in own)
    if (
        len(own) >= _SHARED
        and not is_gray
        and any((away_from(part, color) == 0).mean() >= _LAND for color in exact)
    ):
        return known
    shared = _SHARED_LOSSY if tolerance.is_lossy else _SHARED
    tinted = sum(np.ptp(color) >= _TINTED for color in known)
    if len(known) < shared or tinted < shared - 1:
        return []
    return known


def _apart(
    some: Iterable[NDArray[np.float64]],
    others: Sequence[NDArray[np.float64]],
    tolerance: Tolerance,
) -> list[NDArray[np.float64]]:
    """Those of some colors (3,) that look like none of the others."""
    return [
        color
        for color in some
        if all(np.abs(color - other).max() > tolerance.same for other in others)
    ]


def _is_near(color: NDArray[np.float64], colors: NDArray[np.float64], most: float) -> bool:
    return bool((np.abs(colors - color).max(axis=1) <= most).any())


def _without_dashes(tone: MapTone) -> MapTone:
    """A tone without parts that are nowhere `_DASH` pixels long."""
    _, parts, boxes = parts_and_boxes(tone.mask)
    long = boxes[:, [cv2.CC_STAT_WIDTH, cv2.CC_STAT_HEIGHT]].max(axis=1) >= _DASH
    long[0] = False
    return replace(map_tone(tone.color, where_parts(long, parts)), shared=True)
