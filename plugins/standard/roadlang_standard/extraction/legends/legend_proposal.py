"""A legend for a drawing that has none: its colored spots are proposed as objects."""

from __future__ import annotations

import colorsys
from collections.abc import Iterator

import cv2
import numpy as np
from numpy.typing import NDArray

from ..colors.counted_colors import color_codes, counted
from ..colors.tones import Image

Mask = NDArray[np.bool_]

_MOST_COLORS = 12
_COVERED = 0.97
"""Share of a drawing that has its few colors; the signs and names of a map have many."""
_LEAST_PIXELS = 12
"""Least number of pixels of a color, and of a spot without its rim, which may be a mixture of
colors."""
_LARGEST = 0.125
"""Maximum side of a spot, as a share of the longer side of the picture."""
_MOST_SPOTS = 200
_FILLED = 0.5
"""Share of the box around a spot that it fills; lines and letters fill less."""


def legend_proposal(image: Image, roads: Mask) -> str | None:
    """What to write to make objects of the spots of one color; None where there are none.

    `roads`: the pixels that were taken for road.
    """
    codes = color_codes(image)
    road = _commonest(codes[roads]) if roads.any() else None
    if road is None:
        return None
    spots = dict(_spots(codes, roads, road))
    if not spots:
        return None
    entries = [f'"{_name(road)}": road', *(f'"{_name(c)}": {_kind(c)}' for c in spots)]
    said = ", ".join(f"{count} of {_name(color)}" for color, count in spots.items())
    return (
        f"there are spots of other colors ({said}): to make objects of them, give the image "
        f"`legend: {{ {', '.join(entries)} }}`, with these or other kinds"
    )


def road_color(image: Image) -> str | None:
    """The color of what looks most like roads in a drawing, as a legend names it; None where
    nothing does."""
    from ..drawings.drawing import roads_of_drawing

    roads = roads_of_drawing(image).mask
    return _name(_commonest(color_codes(image)[roads])) if roads.any() else None


def _commonest(codes: NDArray[np.int32]) -> int:
    values, counts = counted(codes)
    return int(values[counts.argmax()])


def _spots(codes: NDArray[np.int32], roads: Mask, road: int) -> Iterator[tuple[int, int]]:
    """Colors, the most frequent first, and how many spots each has."""
    values, counts = counted(codes)
    order = np.argsort(-counts, kind="stable")[:_MOST_COLORS]
    if counts[order].sum() < _COVERED * codes.size:
        return
    paper = int(values[order[0]])
    for color, count in zip(values[order].tolist(), counts[order].tolist(), strict=True):
        if color in (paper, road) or count < _LEAST_PIXELS:
            continue
        here = codes == color
        if np.count_nonzero(here & roads) > 0.5 * count:
            continue
        found = _count(here)
        if found:
            yield color, found


def _count(here: Mask) -> int:
    """How many spots there are of a color; none where any of it is no spot."""
    inner = cv2.erode(here.view(np.uint8), np.ones((3, 3), np.uint8))
    x, y, width, height = cv2.boundingRect(inner)
    if not width:
        return 0
    around = inner[y : y + height, x : x + width]
    _, _, stats, _ = cv2.connectedComponentsWithStats(around, connectivity=8)
    areas = stats[1:, cv2.CC_STAT_AREA]
    sides = stats[1:, [cv2.CC_STAT_WIDTH, cv2.CC_STAT_HEIGHT]]
    large = areas >= _LEAST_PIXELS
    if not large.any() or large.sum() > _MOST_SPOTS:
        return 0
    filled = areas[large] >= _FILLED * sides[large].prod(axis=1)
    short = sides[large].max(axis=1) <= _LARGEST * max(here.shape)
    return int(large.sum()) if (filled & short).all() else 0


def _name(code: int) -> str:
    return f"#{code >> 16 & 255:02x}{code >> 8 & 255:02x}{code & 255:02x}"


def _kind(code: int) -> str:
    """The kind of object that is usually drawn in such a color."""
    red, green, blue = (code >> shift & 255 for shift in (16, 8, 0))
    hue, saturation, _ = colorsys.rgb_to_hsv(red / 255, green / 255, blue / 255)
    if saturation > 0.25 and 0.2 < hue < 0.45:
        return "tree"
    return "cone" if saturation > 0.5 and (hue < 0.17 or hue > 0.95) else "building"
