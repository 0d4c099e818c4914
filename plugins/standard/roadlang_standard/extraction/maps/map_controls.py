"""What a web page draws over its map: boxes with buttons or texts, scale bars, and the strip along
the bottom that says whose data it is."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans

from ..colors.counted_colors import color_codes
from ..colors.fast_median import median
from ..colors.local_spread import local_spread
from ..colors.tones import Image, away_from
from ..masks.mask_parts import parts_and_boxes
from .map_tones import Tolerance, flat_colors

_Box = tuple[int, int, int, int]
"""First column and row, width and height, pixels."""
_LEAST, _MOST, _EVEN = 20, 0.3, 0.3
"""The ground of a box is at least so many pixels high and wide, and even on at least `_EVEN` of it;
a box covers at most `_MOST` of the picture."""
_WHITE, _BLACK, _COLORLESS = 235, 60, 12
"""Boxes are white or black, with at most so many gray levels between their channels."""
_GLYPH, _MARKED, _ROUND, _SKEW = 30, 0.004, 2.0, 4
"""Marks on a box are at most so many pixels wide or high and cover at least `_MARKED` of it; at its
four round corners at most `_ROUND` squares of their radius are missing. The radii of two corners
differ by at most `_SKEW` pixels: buttons in a row have round corners at one end."""
_FRAMED, _STRAIGHT, _HOLLOW = (32, 160), 0.7, 0.4
"""A frame around a picture is so many pixels wide and high; each of its sides is straight along
`_STRAIGHT` of its length, and it covers less than `_HOLLOW` of its box."""
_RIM = 3
"""A border and a shadow this wide belong to a box."""
_NEAR_BORDER, _SHORTEST, _LONGEST = 90, 40, 260
"""Scale bars are within so many pixels of the top or the bottom of the picture, and so long."""
_BAR, _TICK, _TALLEST, _TEXT = 3, 4, 26, 16
"""Greatest thickness of a scale bar, least and greatest height of the ticks at its ends, and the
height of the text at them, pixels."""
_CLEAR = 30
"""Least difference in gray levels between a scale bar and what is beside it."""
_STRIP, _STRIP_LONG, _STROKES = (12, 40), 60, (0.05, 0.6)
"""Least and greatest height of a strip along the bottom, its least length, pixels, and the least
and greatest share of it that is strokes of a text."""
_VEILED, _UNEVEN, _STEP, _CLEARLY, _OPAQUE = 0.85, 0.15, 10.0, 0.2, 0.9
"""A strip lets the map shine through: across its upper side, colors come nearer to white, or to
black, by the same share from `_CLEARLY` to `_OPAQUE`, within `_UNEVEN`, on more than `_VEILED` of
its length. Colors less than `_STEP` gray levels from white, or from black, say nothing."""


def without_controls(image: Image, tolerance: Tolerance) -> Image:
    """The map (h, w, 3) with its land in place of what is drawn over it; itself if that is nothing.

    A road beneath it ends at its border.
    """
    colors = flat_colors(image, tolerance)
    if not colors:
        return image
    boxes = _panels(image, colors[0], tolerance)
    boxes += [*_frames(image, boxes), *_scale_bars(image), *_strips(image)]
    if not boxes:
        return image
    plain = image.copy()
    for left, top, width, height in boxes:
        rows = slice(max(0, top - _RIM), top + height + _RIM)
        plain[rows, max(0, left - _RIM) : left + width + _RIM] = np.round(colors[0])
    return plain


def _panels(image: Image, land: NDArray[np.float64], tolerance: Tolerance) -> list[_Box]:
    """Boxes of one color, other than the land's, with straight upright sides and marks on them."""
    channels = cv2.split(image)
    least, most = (np.minimum.reduce(channels), np.maximum.reduce(channels))
    extreme = ((least >= _WHITE) | (most <= _BLACK)) & (most - least <= _COLORLESS)
    even = (local_spread(image) <= tolerance.flat) & (away_from(image, land) > tolerance.near)
    even &= extreme
    _, labels, stats = parts_and_boxes(even, 4)
    boxes = []
    for label in range(1, len(stats)):
        left, top, width, height, area = stats[label].tolist()
        box = width * height
        if min(width, height) < _LEAST or box > _MOST * even.size or area < _EVEN * box:
            continue
        ground = labels[top : top + height, left : left + width] == label
        if _is_panel(ground):
            boxes.append((left - 1, top - 1, width + 2, height + 2))
    return boxes


def _frames(image: Image, panels: Sequence[_Box]) -> Iterator[_Box]:
    """Frames around pictures, in the colors of the panels: a view of another map on a button."""
    colors = {tuple(image[top + height // 2, left + 2].tolist()) for left, top, _, height in panels}
    for color in sorted(colors):
        framing = cv2.inRange(image, color, color) > 0
        _, labels, stats = parts_and_boxes(framing, 8)
        low, high = _FRAMED
        size = stats[:, [cv2.CC_STAT_WIDTH, cv2.CC_STAT_HEIGHT]]
        fits = np.asarray(((size >= low) & (size <= high)).all(axis=1))
        fits[0] = False
        for label in np.flatnonzero(fits).tolist():
            left, top, width, height, area = stats[label].tolist()
            frame = labels[top : top + height, left : left + width] == label
            sides = (frame[0], frame[-1], frame[:, 0], frame[:, -1])
            straight = all(np.count_nonzero(side) >= _STRAIGHT * len(side) for side in sides)
            if straight and area < _HOLLOW * width * height:
                yield left, top, width, height


def _is_panel(ground: Booleans) -> bool:
    """Whether an even ground that fills its box (h, w) is that of a box with marks on it."""
    marks = _holes(ground)
    if np.count_nonzero(marks) < _MARKED * ground.size:
        return False
    whole = ground | marks
    cut = max(_cut(side) for side in (whole[0], whole[-1], whole[:, 0], whole[:, -1]))
    missing = whole.size - np.count_nonzero(whole)
    return cut <= 0.5 * min(whole.shape) + 1 and bool(missing <= _ROUND * (cut + 1) ** 2)


def _cut(side: Booleans) -> float:
    """How much of a side (n,) is cut off at its ends, as by round corners; infinite where it is far
    more at one end, as where the side is not upright."""
    first, last = np.argmax(side), len(side) - 1 - np.argmax(side[::-1])
    if abs(int(first) - (len(side) - 1 - int(last))) > _SKEW:
        return np.inf
    return float(first) if side[first : last + 1].all() else np.inf


def _holes(ground: Booleans) -> Booleans:
    """The marks on a ground (h, w): its holes, none of them large."""
    _, labels, stats = parts_and_boxes(~ground)
    rim = np.unique(np.concatenate([labels[0], labels[-1], labels[:, 0], labels[:, -1]]))
    small = (stats[:, cv2.CC_STAT_WIDTH] <= _GLYPH) | (stats[:, cv2.CC_STAT_HEIGHT] <= _GLYPH)
    small[0] = False
    small[rim] = False
    return np.asarray(small[labels])


def _scale_bars(image: Image) -> Iterator[_Box]:
    """Level lines of one color with a tick at each end, and the text at them."""
    near = min(_NEAR_BORDER, image.shape[0] // 2)
    for first, last in ((0, near), (image.shape[0] - near, image.shape[0])):
        part = image[first:last]
        for row, start, end in _level_lines(part):
            ticks = _ticks(part, row, (start, end))
            if ticks is None or _is_closed(part, row, (start, end), ticks):
                continue
            up, down = ticks
            up, down = max(up, _TEXT), max(down, _TEXT if up < down else 0)
            yield start, first + row - up, end - start, up + down + _BAR


def _level_lines(image: Image) -> list[tuple[int, int, int]]:
    """Row, first and last column of each level run of one color (h, w, 3) that is as long as a
    scale bar and differs from what is above and below it."""
    code = color_codes(image)
    height, width = code.shape
    gray = cv2.cvtColor(image, cv2.COLOR_BGR2GRAY).astype(np.int16)
    begins = np.ones(code.shape, bool)
    np.not_equal(code[:, 1:], code[:, :-1], out=begins[:, 1:])
    runs = np.flatnonzero(begins)
    lengths = np.diff(runs, append=code.size)
    rows, starts = np.divmod(runs, width)
    ends = starts + lengths
    long = (lengths >= _SHORTEST) & (lengths <= _LONGEST) & (rows > 0) & (rows < height - 1)
    long &= (starts < _NEAR_BORDER) | (ends > width - _NEAR_BORDER)
    lines = []
    for row, start, end in np.column_stack([rows, starts, ends])[long].tolist():
        above, below = max(0, row - _BAR), min(len(code) - 1, row + _BAR)
        level = gray[row, start]
        inner = slice(start + _BAR, end - _BAR)
        apart = [np.abs(gray[other, inner] - level) for other in (above, below)]
        if min(median(one) for one in apart) >= _CLEAR:
            lines.append((row, start, end))
    return lines


def _ticks(image: Image, row: int, ends: Sequence[int]) -> tuple[int, int] | None:
    """How far the ticks at both ends of a line rise above its row, and how far they reach below
    it, pixels; None if there are none, or no even ones."""
    reach = []
    for column in (ends[0], ends[1] - 1):
        same = (image[:, column] == image[row, column]).all(axis=1)
        up = int(np.argmin(np.append(same[row::-1], False))) - 1
        down = int(np.argmin(np.append(same[row:], False))) - 1
        reach.append((up, down))
    least, most = np.min(reach, axis=0), np.max(reach, axis=0)
    if not least.max() >= _TICK or most.max() > _TALLEST:
        return None
    return int(most[0]), int(most[1])


def _is_closed(image: Image, row: int, ends: Sequence[int], ticks: Sequence[int]) -> bool:
    """Whether there is such a line at the other ends of the ticks as well: it is an outline."""
    start, end = ends
    color = image[row, start]
    others = [row - ticks[0], row + ticks[1]]
    far = image[[other for other in others if abs(other - row) > _BAR], start:end]
    return bool(far.size and (far == color).all(axis=2).mean(axis=1).max() > 0.5)


def _strips(image: Image) -> Iterator[_Box]:
    """The strip at the right or the left end of the bottom of a picture, or all along it."""
    height, width = image.shape[:2]
    low, high = _STRIP
    best: tuple[int, _Box] | None = None
    first = max(1, height - high)
    bottom = image[first - 1 : height - low + 1]
    changes = (bottom[1:] != bottom[:-1]).any(axis=2).sum(axis=1)
    # Where a veil begins, colors change.
    for top in (first + np.flatnonzero(changes >= _STRIP_LONG // 2)).tolist():
        for shown in (image, image[:, ::-1]):
            long = _veiled(shown[top - 1], shown[top])
            if long >= _STRIP_LONG and (best is None or long > best[0]):
                left = width - long if shown is image else 0
                best = long, (left, top, long, height - top)
    if best is not None and _is_written(image, best[1]):
        yield best[1]


def _is_written(image: Image, box: _Box) -> bool:
    """Whether there is a text in a box: strokes on some of it."""
    left, top, width, height = box
    low, high = _STROKES
    strokes = local_spread(image[top : top + height, left : left + width]) > 2 * _CLEAR
    return bool(low < strokes.mean() < high)


def _veiled(above: Image, below: Image) -> int:
    """On how many pixels up to the end of a row (w, 3) a veil begins below it."""
    before, step = above.astype(float), below.astype(float) - above
    longest = 0
    for veil in (255.0, 0.0):
        room = veil - before
        size = np.abs(room).max(axis=1)
        moved = (step * room).sum(axis=1) / np.maximum((room * room).sum(axis=1), 1.0)
        told = size >= _STEP
        steps = told & (moved > _CLEARLY)
        if np.count_nonzero(steps) < _STRIP_LONG // 2:
            continue
        share = float(np.median(moved[steps]))
        if share > _OPAQUE:
            continue
        right = told & (np.abs(moved - share) < _UNEVEN)
        wrong = told & ~right
        score = np.cumsum((right - _VEILED / (1 - _VEILED) * wrong)[::-1])
        if score.max() > 0:
            longest = max(longest, int(np.argmax(score)) + 1)
    return longest
