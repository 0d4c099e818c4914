"""Rivers and lakes that have the color of the roads, as on maps in black and white."""

from __future__ import annotations

from dataclasses import dataclass, replace

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans

from ..colors.fast_median import median, quantile
from ..colors.tones import Layer
from ..masks.mask_parts import areas_of, parts_of, where_parts, window_around
from ..masks.skeleton import skeleton
from .map_ribbons import ribbons
from .map_tones import MapTone, is_gray, map_tone

_WIDE, _UNEVEN_WIDE, _BEYOND = 1.9, 1.4, 1.3
"""Water is more than `_WIDE` times as wide as wide roads; `_UNEVEN_WIDE` times if its width varies,
and `_BEYOND` times if it also continues other water beyond a bridge."""
_WIDER = 1.15
"""Usual width of water over that of the roads, at least: a wide road may have narrow ones on it."""
_UNEVEN = 1.07
"""A width varies if that of the widest tenth exceeds the usual width by this factor."""
_BRIDGE = 0.8
"""Maximum width of a bridge over that of wide roads."""
_BROAD, _WIDER_BY, _LARGE, _CONSTANT, _MOSTLY = 2.2, 4.0, 2.0, 0.1, 0.5
"""Parts more than `_BROAD` times as wide as usual streets, and at least `_WIDER_BY` pixels wider,
that cover at least `_LARGE` squares of this width, are water or houses, even if connected to
streets; unless the width varies by at most `_CONSTANT` along at least `_MOSTLY` of their length."""
_REST = 0.5
"""What is left of a color is a rest if it is less than this share of it."""
_LINE, _WITHIN, _HALVED = 5, 0.3, 0.7
"""A line less than `_LINE` pixels wide that covers at least `_WITHIN` pixels for each of the center
lines of a color parts it in two if these lines have less than `_HALVED` of their length with it.
"""
_SHORT = 12
"""Parts with center lines of fewer pixels are ignored."""


@dataclass(frozen=True)
class _Width:
    """Of a connected part, pixels: its usual width, and that of its wide tenth."""

    usual: float
    wide: float

    @property
    def uneven(self) -> bool:
        return self.wide > _UNEVEN * self.usual

    def exceeds(self, road: _Width, times: float) -> bool:
        """Whether it is usually wider than a road, and its wide tenth so many times as wide."""
        return self.usual > _WIDER * road.usual and self.wide > times * road.wide


class KnownWater:
    """The water of masks, which is sought once in each."""

    def __init__(self) -> None:
        self._found: list[tuple[Booleans, Booleans | None]] = []

    def of(self, mask: Booleans) -> Booleans | None:
        """What of a mask (h, w) is water among roads of its color; None if nothing."""
        for known, water in self._found:
            if known is mask:
                return water
        self._found.append((mask, _water(mask)))
        return self._found[-1][1]


def without_water(tones: list[MapTone], known: KnownWater | None = None) -> list[MapTone]:
    """The tones of a map, without water as in `masks_without_water`; rivers with a line in their
    middle are rests."""
    masks = [tone.mask for tone in tones]
    dry = masks_without_water([tone.color for tone in tones], masks, known)
    found = []
    for tone, mask in zip(tones, dry, strict=True):
        kept = tone if mask is tone.mask else map_tone(tone.color, mask)
        is_little = np.count_nonzero(mask) < _REST * np.count_nonzero(tone.mask)
        is_rest = is_little or _has_middle_line(kept, tones)
        found.append(replace(kept, rest=True) if is_rest else kept)
    return found


def _has_middle_line(tone: MapTone, tones: list[MapTone]) -> bool:
    """Whether a gray tone is a surface that a line of a darker gray parts along its middle, as maps
    draw the course of a river; casings are beside roads."""
    light = float(tone.color.mean())
    lines = [one for one in tones if one.is_gray and one.color.mean() < light]
    if not (tone.is_gray and lines):
        return False
    land = max(tones, key=lambda one: np.count_nonzero(one.mask))
    if light >= land.color.mean():
        return False
    mask = tone.mask.astype(np.uint8)
    closed = cv2.morphologyEx(mask, cv2.MORPH_CLOSE, np.ones((_LINE, _LINE), np.uint8)) > 0
    parting = [closed & line.mask for line in lines]
    return any(
        np.count_nonzero(within) >= _WITHIN * tone.length
        and map_tone(tone.color, tone.mask | within).length < _HALVED * tone.length
        for within in parting
    )


def masks_without_water(
    colors: list[NDArray[np.float64]], masks: list[Booleans], known: KnownWater | None = None
) -> list[Booleans]:
    """Where (h, w) the colors of a map are, the grays darker than its land without what looks like
    water among roads.

    Water is nowhere lighter than the land. A colored tone is kept whole: without its wide part,
    the remnants of a park between streets would look like roads.
    """
    land = colors[int(np.argmax([np.count_nonzero(mask) for mask in masks]))]
    dry, known = [], known or KnownWater()
    for color, mask in zip(colors, masks, strict=True):
        dark = is_gray(color) and color.mean() < land.mean()
        water = known.of(mask) if dark else None
        dry.append(mask if water is None else np.asarray(mask & ~water))
    return dry


def _water(mask: Booleans) -> Booleans | None:
    """What of a tone (h, w) is wider than roads and apart from the longest network; None if
    nothing.

    Roads join. Where one crosses water of its own color, its casing parts both; a wide road that
    passes over others is apart as well, but even.
    """
    lines = _Lines.of(mask)
    basin = _basin(mask, lines)
    if basin is not None:
        lines = _Lines.of(mask & ~basin)
    labels, widths = lines.labels, lines.widths()
    road = widths.pop(lines.longest(), None)
    if road is None:
        return basin
    found = {
        part
        for part, width in widths.items()
        if width.exceeds(road, _UNEVEN_WIDE if width.uneven else _WIDE)
    }
    also = {part for part, width in widths.items() if width.uneven and width.exceeds(road, _BEYOND)}
    reach = 2 * round(_BRIDGE * road.wide) + 1
    water = _joined(labels, found, also, reach) if found else found
    apart = np.isin(labels, list(water)) if water else None
    if apart is None or basin is None:
        return basin if apart is None else apart
    return np.asarray(apart | basin)


@dataclass(frozen=True)
class _Lines:
    """Of a tone (h, w): the labels (h, w) of its parts, how far pixels are from its edge (h, w),
    its skeleton (h, w), and the pixels of that (n,), as indices of the flat picture."""

    labels: NDArray[np.int32]
    inner: Layer
    thin: Booleans
    at: NDArray[np.intp]

    @staticmethod
    def of(mask: Booleans) -> _Lines:
        seen, thin = mask.view(np.uint8), skeleton(mask)
        _, labels = cv2.connectedComponents(seen, connectivity=4)
        inner = cv2.distanceTransform(seen, cv2.DIST_L2, 5)
        return _Lines(labels, inner, thin, np.flatnonzero(thin))

    def longest(self) -> int:
        """The part with the longest center lines."""
        return int(np.argmax(np.bincount(self.labels.ravel()[self.at], minlength=2)))

    def widths(self) -> dict[int, _Width]:
        """Those of the parts whose center lines are not short, by their labels."""
        if not len(self.at):
            return {}
        owner = self.labels.ravel()[self.at]
        order = np.argsort(owner, kind="stable")
        across = (2 * self.inner.ravel()[self.at] - 1)[order]
        starts = np.flatnonzero(np.diff(owner[order], prepend=-1))
        return {
            int(owner[order[start]]): _Width(median(values), quantile(values, 0.9))
            for start, values in zip(starts, np.split(across, starts[1:]), strict=True)
            if len(values) >= _SHORT
        }


def _basin(mask: Booleans, lines: _Lines) -> Booleans | None:
    """What of a tone (h, w) is water or houses, though streets may lead into it; None if nothing.

    It is far wider than most streets, and so are wide roads; but their width is the same between
    two junctions.
    """
    inner, thin, labels = lines.inner, lines.thin, lines.labels
    even = ribbons(thin, inner).lines
    if not even.any():
        return None
    network = int(np.argmax(np.bincount(labels[even], minlength=2)))
    usual = 2 * float(np.median(inner[even & (labels == network)])) - 1
    broad = max(_BROAD * usual, usual + _WIDER_BY)
    deep = (inner > broad / 2).astype(np.uint8)
    if not deep.any():
        return None
    window = window_around(deep, int(broad / 2) + 3)
    inner, thin = np.ascontiguousarray(inner[window]), np.ascontiguousarray(thin[window])
    away = cv2.distanceTransform(1 - np.ascontiguousarray(deep[window]), cv2.DIST_L2, 5)
    wide = mask[window] & (away < broad / 2)
    count, parts = parts_of(wide, 8)
    core = thin & wide
    # Where lines meet, they end: between junctions a road's width is one.
    near = cv2.filter2D(core.astype(np.uint8), -1, np.ones((3, 3)), borderType=cv2.BORDER_CONSTANT)
    forks = cv2.dilate((core & (near > 3)).astype(np.uint8), np.ones((3, 3), np.uint8)) > 0
    total = np.bincount(parts[core], minlength=count)
    same = np.bincount(parts[_constant(core & ~forks, inner)], minlength=count)
    large = areas_of(parts, count) >= _LARGE * broad**2
    water = large & (same < _MOSTLY * total)
    water[0] = False
    if not water.any():
        return None
    found = np.zeros(mask.shape, bool)
    found[window] = where_parts(water, parts)
    return found


def _constant(lines: Booleans, inner: Layer) -> Booleans:
    """Which of the lines (h, w) are longer than wide and have one width from end to end."""
    if not lines.any():
        return lines
    count, run = parts_of(lines, 8)
    at = np.flatnonzero(lines)
    order = np.argsort(run.ravel()[at], kind="stable")
    across = (2 * inner.ravel()[at] - 1)[order]
    starts = np.flatnonzero(np.r_[True, np.diff(run.ravel()[at][order]) > 0])
    kept = np.zeros(count, bool)
    for values, one in zip(np.split(across, starts[1:]), range(1, count), strict=True):
        low, middle, high = np.quantile(values, (0.1, 0.5, 0.9))
        kept[one] = values.size > middle and high - low <= max(1.0, _CONSTANT * middle)
    return where_parts(kept, run)


def _joined(labels: np.ndarray, found: set[int], also: set[int], reach: int) -> set[int]:
    """The parts `found`, and those of `also` that are near them, one after the other."""
    water = set(found)
    kernel = np.ones((reach, reach), np.uint8)
    while found:
        near = cv2.dilate(np.isin(labels, list(found)).astype(np.uint8), kernel) > 0
        found = ({int(label) for label in np.unique(labels[near])} & also) - water
        water |= found
    return water
