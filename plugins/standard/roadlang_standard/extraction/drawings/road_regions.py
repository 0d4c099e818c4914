"""Parts of a drawing's paper that look like roads: long, and of even width."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import find_objects

from roadlang.geometry import Booleans

from ..colors.fast_median import quantile
from ..masks.mask_parts import areas_of, boxes_of, parts_of

_LEAST = 40
"""Least area of a region, in square pixels."""
_UNEVEN = 2.8
"""Maximum width of a road over its usual width. At crossings it is 1.4, where two roads become one
it is 2; a block between filled roads has more."""
_LEAVING = 4.0
"""Maximum length of the picture's rim that a road covers, in widths; the ground around a circuit
covers more."""
_LONG, _PIECE = 12.0, 1.2
"""Least length over width of a road, and of a piece of one."""
_ALIKE = (0.6, 1.6)
"""Widths of the pieces, in widths of the main road."""
_WIDEST, _LONGEST = 0.2, 1.5
"""A region wider than `_WIDEST` of the picture's shorter side and longer than `_LONGEST` times the
sum of both sides is not a road; even a ring as large as the picture is shorter."""
_FEW, _SMALL, _AROUND = 40, 0.25, 3
"""At most `_FEW` parts, which cover at most `_SMALL` of the picture, are measured one by one, each
with `_AROUND` pixels around it."""
_USUAL = 0.9
"""Half the usual width is this quantile of the distances from the middle to the edge."""


@dataclass(frozen=True)
class RoadRegion:
    """A road-like region: its mask in a window, its usual width in pixels, length over width."""

    window: tuple[slice, slice]
    part: Booleans
    width: float
    elongation: float


@dataclass(frozen=True)
class _Region:
    """A part of the paper: its label, area in square pixels, how many pixels of it are on the
    picture's rim; and how far pixels in its middle are from its edge (n,), ascending."""

    key: int
    area: int
    rim: int
    half_widths: NDArray[np.float32]

    def width_between(self) -> tuple[float, float]:
        """Bounds of the usual width, which takes longer to work out."""
        last = len(self.half_widths) - 1
        place = int(_USUAL * last)
        low, high = max(0, place - 1), min(last, place + 2)
        return 2 * float(self.half_widths[low]), 2 * float(self.half_widths[high])

    def width(self) -> float:
        """The usual width, pixels."""
        return 2 * quantile(self.half_widths, _USUAL)

    def is_even(self, width: float) -> bool:
        """Whether it looks like a road that is usually so wide."""
        widest = 2 * float(self.half_widths[-1])
        return self.rim <= _LEAVING * width and widest <= _UNEVEN * width

    def fills(self, shape: tuple[int, ...]) -> bool:
        """Whether it would be too wide for its length in a picture (h, w): it is all of the paper
        within a frame."""
        widest, longest = _WIDEST * min(shape), _LONGEST * sum(shape)
        if self.area < widest * longest:
            return False
        width = self.width()
        return width > widest and self.area > longest * width

    def elongation(self, width: float) -> float:
        """Length over width, if it is usually so wide."""
        return float(self.area) / max(width, 1.0) ** 2


@dataclass(frozen=True)
class PaperParts:
    """The connected parts of the paper about the ink: their labels (h, w), 0 for ink, and how many
    labels there are."""

    labels: NDArray[np.int32]
    count: int

    @staticmethod
    def about(ink: Booleans) -> PaperParts:
        """Those about the ink (h, w)."""
        count, labels = parts_of(~ink)
        return PaperParts(labels, count)

    def divides_as(self, before: PaperParts) -> bool:
        """Whether more ink has left the parts the same, each a little smaller."""
        if self.count != before.count:
            return False
        origin = np.zeros(self.count, np.int32)
        origin[self.labels.ravel()] = before.labels.ravel()
        return len(np.unique(origin[1:])) == self.count - 1


def road_regions(ink: Booleans, parts: PaperParts | None = None) -> list[RoadRegion]:
    """The road-like regions of the paper about the ink (h, w), which may be divided in `parts`
    already: the longest, and pieces as wide."""
    parts = parts or PaperParts.about(ink)
    labels, areas = parts.labels, areas_of(parts.labels, parts.count)
    rim = np.concatenate([labels[0], labels[-1], labels[:, 0], labels[:, -1]])
    rims = np.bincount(rim, minlength=parts.count)
    if not _may_be_long(ink, labels, areas, rims):
        return []
    likely = []
    for region in _regions(ink, labels, areas, rims):
        least, most = region.width_between()
        if (
            region.is_even(most)
            and region.elongation(least) > _PIECE
            and not region.fills(ink.shape)
        ):
            likely.append((region, least))
    if not any(region.elongation(least) > _LONG for region, least in likely):
        return []
    widths = [(region, region.width()) for region, _ in likely]
    windows = find_objects(labels)
    found = []
    for region, width in widths:
        if region.is_even(width):
            window = windows[region.key - 1]
            part = labels[window] == region.key
            found.append(RoadRegion(window, part, width, region.elongation(width)))
    long = [region for region in found if region.elongation > _LONG]
    if not long:
        return []
    main = max(long, key=lambda region: region.elongation * region.width)
    least, most = _ALIKE
    return [r for r in found if r.elongation > _PIECE and least < r.width / main.width < most]


def _may_be_long(
    ink: Booleans, labels: NDArray[np.int32], areas: NDArray[np.intp], rims: NDArray[np.intp]
) -> bool:
    """Whether any part of the paper may be a long road: most drawings have none, and that is seen
    before all of the picture is measured."""
    # What covers so much of the rim is at least so wide, if it is a road.
    long = (areas >= _LEAST) & (areas > _LONG * np.maximum(rims / _LEAVING, 1.0) ** 2)
    long[0] = False
    keys = np.flatnonzero(long)
    if not len(keys) or len(keys) > _FEW:
        return len(keys) > 0
    boxes = boxes_of(labels, len(areas))
    if boxes is None or boxes[keys, 2:4].prod(axis=1).sum() > _SMALL * ink.size:
        return True
    for key in keys.tolist():
        left, top, width, height = boxes[key, :4].tolist()
        # The pixels about a part tell how far those of it are from its edge.
        window = (
            slice(max(0, top - _AROUND), top + height + _AROUND),
            slice(max(0, left - _AROUND), left + width + _AROUND),
        )
        here = (labels[window] == key).astype(np.int32)
        (region,) = _regions(ink[window], here, areas[[0, key]], rims[[0, key]])
        usual = region.width()
        if region.is_even(usual) and region.elongation(usual) > _LONG:
            return True
    return False


def _regions(
    ink: Booleans, labels: NDArray[np.int32], areas: NDArray[np.intp], rims: NDArray[np.intp]
) -> Iterator[_Region]:
    """The parts of the paper, by the order of their labels, that are not tiny."""
    padded = cv2.copyMakeBorder((~ink).view(np.uint8), 1, 1, 1, 1, cv2.BORDER_CONSTANT, value=0)
    inner = cv2.distanceTransform(padded, cv2.DIST_L2, 5)[1:-1, 1:-1]
    ridge = np.flatnonzero((inner >= cv2.dilate(inner, np.ones((3, 3)))) & ~ink)
    keys, depths = labels.ravel()[ridge], inner[np.divmod(ridge, ink.shape[1])]
    order = np.lexsort((depths, keys))
    depths = depths[order]
    ends = np.cumsum(np.bincount(keys, minlength=len(areas)))
    for key in np.flatnonzero(areas >= _LEAST).tolist():
        if key:
            depth = depths[ends[key - 1] : ends[key]]
            yield _Region(key, int(areas[key]), int(rims[key]), depth)
