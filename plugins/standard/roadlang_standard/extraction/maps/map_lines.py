"""Thin lines of a map that may be streets: their colors, and which parts of a color are lines."""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans

from ..colors.mixed_pixels import Labels
from ..colors.tones import Image
from ..masks.mask_parts import opened_by_square, parts_and_boxes, parts_touching, where_parts
from .map_tones import EXACT, MapTone, frequent_colors, map_tone

_STEP = 6
"""A line differs from both of its sides by more than this many gray levels, and varies by at most
as many along itself."""
_REACH = 2
"""Distance of its sides in pixels: lines of up to three pixels have no even part."""
THIN = 4.5
"""Colors of lines with a smaller usual width, in pixels, may also be those of houses."""
_EXTENT, _LONG = 40, 5.0
"""A line has an extent of at least `_EXTENT` pixels and `_LONG` widths; outlines of houses are
smaller."""
_STEADY = 0.45
"""Least share of streets that keeps its width: rows of houses do not."""
_SHORT, _BENT = 16, 1.4
"""A short street has an extent of at least `_SHORT` pixels, and a surface of less than `_BENT`
times its width times its extent; the outline of a house returns to its start and has more."""
_BARB = 2
"""In a JPEG, what is thinner than so many pixels at the rim of a street is noise."""
_SIDE = 2
"""Distance in pixels from the edges of a line at which its sides are compared."""


def with_line_colors(image: Image, colors: list[NDArray[np.float64]]) -> list[NDArray[np.float64]]:
    """The `colors` (3,) BGR of a map (h, w, 3), and those of its thin lines, which are nowhere
    even."""
    known = [*colors]
    for color in frequent_colors(image, _ridges(image)):
        if all(np.abs(color - one).max() > EXACT.near for one in known):
            known.append(color)
    return known


def _ridges(image: Image) -> Booleans:
    """Where (h, w) a map is brighter or darker than at both sides, and as before and after."""
    gray = cv2.cvtColor(image, cv2.COLOR_BGR2GRAY)
    around = cv2.copyMakeBorder(gray, *(_REACH,) * 4, cv2.BORDER_REPLICATE)
    found = np.zeros(gray.shape, bool)
    for across, along in (((0, 1), (1, 0)), ((1, 0), (0, 1)), ((1, 1), (1, -1)), ((1, -1), (1, 1))):
        one, other = (_moved(around, across, _REACH * sign) for sign in (1, -1))
        before, after = (cv2.absdiff(_moved(around, along, sign), gray) for sign in (1, -1))
        higher = cv2.subtract(gray, cv2.max(one, other))  # 0 where it is lower
        ridge = cv2.max(higher, cv2.subtract(cv2.min(one, other), gray)) > _STEP
        found |= ridge & (cv2.max(before, after) <= _STEP)
    return found


def _moved(around: Image, step: tuple[int, int], times: int) -> Image:
    """The inner part of a picture with a rim of `_REACH` pixels, moved by some steps."""
    rows, columns = (
        slice(_REACH + side * times, size - _REACH + side * times)
        for side, size in zip(step, around.shape, strict=True)
    )
    return np.ascontiguousarray(around[rows, columns])


def without_outlines(tones: list[MapTone]) -> list[MapTone]:
    """The tones of a map; of those that are mostly thin lines, only what may be streets.

    A street is long, and has the same color on both sides; an outline of a house or of a park, and
    the casing of a road, has one inside and another one outside.
    """
    labels = np.full(tones[0].mask.shape, -1, np.int16)
    for index, tone in enumerate(tones):
        labels[tone.mask] = index
    land = max(tones, key=lambda tone: np.count_nonzero(tone.mask))
    return [
        _streets(tone, labels) if tone is not land and 0 < tone.width < THIN else tone
        for tone in tones
    ]


def _streets(tone: MapTone, labels: Labels) -> MapTone:
    count, parts, stats = parts_and_boxes(tone.mask)
    extents = stats[:, [cv2.CC_STAT_WIDTH, cv2.CC_STAT_HEIGHT]].max(axis=1)
    long = extents >= max(_EXTENT, _LONG * tone.width)
    long[0] = False
    lines = where_parts(long, parts)
    alike, differ = _sides(lines, labels, _SIDE + int(tone.width / 2))
    votes = [np.bincount(parts[side], minlength=count) for side in (alike, differ)]
    between = votes[1] > votes[0]
    if np.count_nonzero(differ) <= np.count_nonzero(alike):
        # A street between a park and houses is an outline of both, but goes around neither.
        between &= holes(tone.mask, parts, count) > 0
    chosen = where_parts(long & ~between, parts)
    is_all = np.array_equal(chosen, tone.mask)
    one = tone if is_all else replace(map_tone(tone.color, chosen), rest=tone.rest)
    streets = replace(one, shared=False)
    return streets if streets.steady >= _STEADY else map_tone(tone.color, np.zeros_like(lines))


def holes(mask: Booleans, parts: NDArray[np.int32], count: int) -> NDArray[np.int64]:
    """How many holes each of the connected parts (n,) of a mask (h, w) has."""
    contours, tree = cv2.findContours(mask.astype(np.uint8), cv2.RETR_CCOMP, cv2.CHAIN_APPROX_NONE)
    found = np.zeros(count, np.int64)
    for _, _, _, outer in tree[0] if contours else ():
        if outer >= 0:
            x, y = contours[outer][0, 0]
            found[parts[y, x]] += 1
    return found


def _sides(mask: Booleans, labels: Labels, away: int) -> tuple[Booleans, Booleans]:
    """Where (h, w) a thin line ends on two opposite sides, and these have the same color; and where
    they have two."""
    alike, differ = np.zeros(mask.shape, bool), np.zeros(mask.shape, bool)
    rim, at = away + 1, np.flatnonzero(mask)
    inked, colors = (
        cv2.copyMakeBorder(part, rim, rim, rim, rim, cv2.BORDER_REPLICATE).ravel()
        for part in (mask.view(np.uint8), labels)
    )
    stride = mask.shape[1] + 2 * rim
    rows, columns = np.divmod(at, mask.shape[1])
    inner = (rows + rim) * stride + columns + rim
    for down, right in ((0, 1), (1, 0), (1, 1), (1, -1)):
        step = down * stride + right
        ends = (inked.take(inner + away * step) | inked.take(inner - away * step)) == 0
        line = inner[ends]
        # A line of two pixels has its middle between them: one side is a pixel farther away.
        there, back = (
            [colors.take(line + sign * far * step) for far in (away, away + 1)] for sign in (1, -1)
        )
        same = np.logical_or.reduce([(a == b) & (a >= 0) for a in there for b in back])
        known = (np.maximum(*there) >= 0) & (np.maximum(*back) >= 0)
        alike.ravel()[at[ends][same]] = True
        differ.ravel()[at[ends][~same & known]] = True
    return alike, differ & ~alike


def short_parts(tones: list[MapTone], roads: list[MapTone], near: Booleans) -> Booleans:
    """The short lines (h, w) of the colors of roads which are `near` (h, w) others: streets between
    two wide roads, or between two names."""
    found = np.zeros(near.shape, bool)
    for tone in tones:
        if any(np.array_equal(road.color, tone.color) for road in roads):
            _, parts, stats = parts_and_boxes(tone.mask)
            extents = stats[:, [cv2.CC_STAT_WIDTH, cv2.CC_STAT_HEIGHT]].max(axis=1)
            reach = np.hypot(stats[:, cv2.CC_STAT_WIDTH], stats[:, cv2.CC_STAT_HEIGHT])
            straight = stats[:, cv2.CC_STAT_AREA] < _BENT * tone.typical_width * reach
            street = straight & (extents >= _SHORT) & (extents < _EXTENT)
            short = tone.mask & where_parts(street, parts)
            found |= parts_touching(short, near)
    return found


def without_barbs(mask: Booleans) -> Booleans:
    """The narrow streets (h, w) of a JPEG without the noise that stands out from them."""
    return opened_by_square(mask, _BARB)
