"""Lines painted on a drawn road, such as dashes along its middle: they are road as well."""

from __future__ import annotations

from dataclasses import dataclass, replace

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans

from ..colors.counted_colors import color_codes, counted_colors
from ..colors.tones import Image, Layer, away_from
from ..masks.mask_parts import parts_and_boxes, where_parts

_THIN = 5.0
"""Around a marking, the road is more than this many times as wide as the marking is thick, ..."""
_SHORT = 2.5
"""and the marking is shorter than this many widths of the road: a longer one is a median, ..."""
_LINE = 6.0
"""unless the road is more than this many times as wide as it is thick."""
_DASH, _REPEATED, _ALIKE = 3.0, 8, 1.6
"""The first factor where there are dashes: at least `_REPEATED` short gaps whose areas are at most
`_ALIKE` times larger or smaller than usual. Dashes that cross are one larger gap."""
_COLORED = 3.0
"""The same factor for markings with a color that neither road nor ground has."""
_ENCLOSED = 0.6
"""Least share of the surroundings of such a marking that is road."""
_LARGEST = 0.02
"""Maximum share of the picture that a marking covers."""
_BESIDE, _BESIDE_COLORED = 1.5, 0.75
"""On one of its sides, the road is at least this many times as wide as a marking is thick."""
_PAINTED = 60
"""Least difference in gray levels between a painted color and road, ground, and all mixtures of
these, which occur at edges."""
_FEWEST, _MOST_COLORED = 20, 0.05
"""Paint covers at least `_FEWEST` pixels, and at most `_MOST_COLORED` of the picture."""
_SAMPLED = 3
"""The colors of road and ground are estimated from every third row and column."""


def with_markings_filled(surface: Layer, image: Image | None = None) -> Layer:
    """The surface (h, w), 0..1, with thin gaps within its roads filled; itself if there are none.

    `image`: (h, w, 3), where lines may have a color of their own, as of a yellow center line.
    """
    mask = (surface >= 0.5).view(np.uint8)
    depth = cv2.distanceTransform(mask, cv2.DIST_L2, 5)
    filled = _plain_gaps(mask, depth)
    colored = None if image is None else _colored(image, mask)
    if colored is not None:
        filled = filled | _colored_gaps(mask, depth, colored)
    if not filled.any():
        return surface
    road = cv2.distanceTransform(mask | filled.view(np.uint8), cv2.DIST_L2, 5)
    around = cv2.dilate(filled.view(np.uint8), np.ones((5, 5), np.uint8)) > 0
    return np.asarray(np.where(around, np.maximum(surface, road > 2), surface), np.float32)


def _colored(image: Image, mask: NDArray[np.uint8]) -> Booleans | None:
    """(h, w) the pixels of neither road's nor ground's color, if few have one of their own."""
    seen, road = image[::_SAMPLED, ::_SAMPLED], mask[::_SAMPLED, ::_SAMPLED] > 0
    if road.all() or not road.any():
        return None
    codes = color_codes(seen)
    ground, drawn = (counted_colors(codes[part]).usual for part in (~road, road))
    axis = drawn - ground
    found = (mask == 0) & (away_from(image, ground) > _PAINTED)
    differs = image[found] - ground
    share = np.clip(differs @ axis / max(float(axis @ axis), 1.0), 0, 1)
    found[found] = np.abs(differs - share[:, None] * axis).max(axis=1, initial=0) > _PAINTED
    count = int(np.count_nonzero(found))
    if not _FEWEST <= count <= _MOST_COLORED * found.size:
        return None
    # The pixels between paint and road are mixtures of both.
    near = cv2.dilate(found.view(np.uint8), np.ones((3, 3), np.uint8)) > 0
    return np.asarray(near & (mask == 0))


def _plain_gaps(mask: NDArray[np.uint8], depth: Layer) -> Booleans:
    """(h, w) thin parts that are no road, and are short or as thin as lines."""
    gaps = _gaps((mask, depth), mask == 0, _BESIDE, _LARGEST)
    length = gaps.areas[gaps.keys] / gaps.thickness
    short = length < _SHORT * gaps.width
    is_marking = (gaps.thinner > _THIN) & short | (gaps.thinner > _LINE)
    dashes = (gaps.thinner > _DASH) & short
    if _are_alike(gaps.areas[gaps.keys[dashes]]):
        is_marking |= dashes
    return gaps.union(gaps.keys[is_marking])


def _are_alike(areas: NDArray[np.int32]) -> bool:
    """Whether many of these areas (n,) are about the same, as those of the dashes of a line."""
    if len(areas) < _REPEATED:
        return False
    times = areas / np.median(areas)
    return int(np.count_nonzero((times < _ALIKE) & (times * _ALIKE > 1))) >= _REPEATED


def _colored_gaps(mask: NDArray[np.uint8], depth: Layer, colored: Booleans) -> Booleans:
    """(h, w) thin parts within roads that have a color, however long."""
    gaps = _gaps((mask, depth), colored, _BESIDE_COLORED, _MOST_COLORED)
    if not len(gaps.keys):
        return np.zeros(mask.shape, bool)
    # The greater label where two meet: there are few such pixels.
    rim = cv2.dilate(gaps.labels.astype(np.float32), np.ones((3, 3), np.uint8))
    beside = np.flatnonzero((rim > 0) & (gaps.labels == 0))
    owner = rim.ravel()[beside].astype(np.intp)
    around = np.bincount(owner, minlength=len(gaps.boxes))[gaps.keys]
    on_road = owner[mask.ravel()[beside] > 0]
    road = np.bincount(on_road, minlength=len(gaps.boxes))[gaps.keys] / np.maximum(around, 1)
    return gaps.union(gaps.keys[(gaps.thinner > _COLORED) & (road > _ENCLOSED)])


@dataclass(frozen=True)
class _Gaps:
    """Small parts of a mask: the labels (h, w) of all parts, and their boxes and areas (m, 5) as
    OpenCV gives them; the `pixels` (p,) of small ones, as indices of the flat picture; of those
    that may be markings the labels `keys` (n,), how thick they are and how wide the road is with
    them (n,), pixels."""

    labels: NDArray[np.int32]
    boxes: NDArray[np.int32]
    pixels: NDArray[np.intp]
    keys: NDArray[np.intp]
    thickness: NDArray[np.float64]
    width: NDArray[np.float64]

    @property
    def areas(self) -> NDArray[np.int32]:
        """Of all parts (m,)."""
        return np.asarray(self.boxes[:, cv2.CC_STAT_AREA])

    @property
    def thinner(self) -> NDArray[np.float64]:
        """How many times as wide as they are thick the road is (n,)."""
        return self.width / self.thickness

    def union(self, keys: NDArray[np.intp]) -> Booleans:
        """(h, w) where some of the small parts are."""
        chosen, found = np.zeros(len(self.boxes), bool), np.zeros(self.labels.shape, bool)
        chosen[keys] = True
        found.ravel()[self.pixels[chosen.take(self.labels.ravel()[self.pixels])]] = True
        return found

    def thin(self, times: float, most: float, inner: Layer) -> _Gaps:
        """Those of the small parts of which so many times the thickness is nowhere more pixels."""
        owner = self.labels.ravel()[self.pixels]
        thick = np.zeros(len(self.boxes), bool)
        wide = 2 * inner.ravel()[self.pixels].astype(np.float64) - 1
        thick[owner[times * wide > most]] = True
        left = ~thick[owner]
        return replace(self, pixels=self.pixels[left], keys=self.keys[~thick[self.keys]])

    def window(self, key: int, reach: int) -> tuple[slice, slice]:
        """The rows and columns of a part and so many pixels around it."""
        left, top, width, height = self.boxes[key, :4].tolist()
        rows = slice(max(0, top - reach), top + height + reach)
        return rows, slice(max(0, left - reach), left + width + reach)

    def most(self, inner: Layer) -> NDArray[np.float64]:
        """How wide what has its edge so far away (h, w) is at most on the small parts, by labels
        (m,).

        A line one pixel thick is at 1 from what is around it. Where nothing else is in the picture,
        OpenCV's distance is the greatest number there is.
        """
        most = np.zeros(len(self.boxes))
        owner = self.labels.ravel()[self.pixels]
        np.maximum.at(most, owner, inner.ravel()[self.pixels].astype(np.float64))
        return 2 * most - 1


def _gaps(
    within: tuple[NDArray[np.uint8], Layer], gaps: Booleans, least: float, largest: float
) -> _Gaps:
    """The parts of the `gaps` (h, w) of a road that are less than a share of the picture; the road
    is a mask (h, w), and how far it goes on from each pixel (h, w).

    The road is at least so many times as wide beside them as they are thick: else the blocks of a
    town, which are one wide road once all of them are filled, would be lines upon it."""
    mask, beside = within
    found = _small_parts(gaps, largest)
    keys = found.keys
    if not len(keys):
        return found
    inner = cv2.distanceTransform(found.union(keys).view(np.uint8), cv2.DIST_L2, 5)
    found = found.thin(least, 2 * float(beside.max(initial=0.0)) - 1, inner)
    thickness, keys = found.most(inner), found.keys
    wide = [_width_about(beside, found, key, thickness[key]) for key in keys.tolist()]
    keys = keys[np.array(wide, float) >= least * thickness[keys]]
    if not len(keys):
        return replace(found, keys=keys)
    parts = found.union(keys).view(np.uint8)
    road = cv2.distanceTransform(mask | parts, cv2.DIST_L2, 5)
    width, thickness = found.most(road)[keys], thickness[keys]
    for i in np.flatnonzero(width < _LINE * thickness).tolist():
        width[i] = _width_beside(road, found, int(keys[i]), thickness[i])
    return replace(found, keys=keys, thickness=thickness, width=width)


def _width_about(inner: Layer, gaps: _Gaps, key: int, thickness: float) -> float:
    """How wide the road is at most within two thicknesses about a part, pixels."""
    return 2 * float(inner[gaps.window(key, int(2 * thickness) + 2)].max()) - 1


def _width_beside(inner: Layer, gaps: _Gaps, key: int, thickness: float) -> float:
    """How wide the road is at most within a few thicknesses beside a part that has hardly any of it
    on its other side, as a line along its edge."""
    reach = int(_LINE * thickness) + 1
    window = gaps.window(key, reach)
    part = (gaps.labels[window] == key).view(np.uint8)
    near = cv2.dilate(part, np.ones((2 * reach + 1, 2 * reach + 1), np.uint8)) > 0
    return 2 * float(inner[window][near].max()) - 1


def _small_parts(gaps: Booleans, largest: float) -> _Gaps:
    """The parts of a mask (h, w) that are less than this share of the picture."""
    _, labels, boxes = parts_and_boxes(gaps, 4)
    small = boxes[:, cv2.CC_STAT_AREA] < largest * gaps.size
    small[0] = False
    keys, none = np.flatnonzero(small), np.zeros(0)
    pixels = np.flatnonzero(where_parts(small, labels)) if len(keys) else keys
    return _Gaps(labels, boxes, pixels, keys, none, none)
