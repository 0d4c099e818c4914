"""The connected parts of a mask."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans, Floats

Labels = NDArray[np.int32]

_SAMPLED, _MANY = 101, 0.1
"""Large parts are found by looking at one pixel in `_SAMPLED`. A list of more than `_MANY` of all
pixels takes more time and memory than counting all of them."""
_ROWS, _NOISY = 8, 0.03
"""A mask with more than `_NOISY` changes per pixel, along every `_ROWS`th row, has many parts."""
_RUNS = 0.05
"""Where more than this share of all pixels begins a run of one label, as in noise, to look at the
pixels takes less time than to look at the runs."""


def parts_of(mask: Booleans, connectivity: int = 4) -> tuple[int, Labels]:
    """How many labels there are, and the label (h, w) of each pixel, 0 where the mask is not set.

    Without diagonals OpenCV's usual algorithm takes twice as long as this one (Bolelli et al.
    2019), which numbers the parts alike.
    """
    seen = mask.view(np.uint8)
    if connectivity == 8:
        count, labels = cv2.connectedComponents(seen, connectivity=8)
    else:
        count, labels = cv2.connectedComponentsWithAlgorithm(seen, 4, cv2.CV_32S, cv2.CCL_BOLELLI)
    return count, np.asarray(labels, np.int32)


def parts_and_boxes(mask: Booleans, connectivity: int = 8) -> tuple[int, Labels, NDArray[np.int32]]:
    """How many labels there are, the label (h, w) of each pixel, and for each label (n, 5) the
    first column and row, the width, the height and the area, in OpenCV's order.

    What OpenCV gives, in a third of the time. The box of pixels that are not set means nothing.
    """
    count, labels = parts_of(mask, connectivity)
    boxes = boxes_of(labels, count)
    if boxes is not None:
        return count, labels, boxes
    count, found, stats, _ = cv2.connectedComponentsWithStatsWithAlgorithm(
        mask.view(np.uint8), connectivity, cv2.CV_32S, cv2.CCL_BOLELLI
    )
    return count, np.asarray(found, np.int32), np.asarray(stats, np.int32)


def boxes_of(labels: Labels, count: int) -> NDArray[np.int32] | None:
    """The boxes and areas (count, 5) of the parts with these labels (h, w), as `parts_and_boxes`;
    None where the labels have so many runs that this takes longer than what OpenCV does."""
    width = labels.shape[1]
    flat = labels.ravel()
    begins = np.ones(flat.size, bool)
    np.not_equal(flat[1:], flat[:-1], out=begins[1:])
    begins[::width] = True  # no run goes on from row to row
    starts = np.flatnonzero(begins)
    if len(starts) > _RUNS * flat.size:
        return None
    owner, lengths = flat[starts], np.diff(starts, append=flat.size)
    row, column = np.divmod(starts, width)
    boxes = np.zeros((count, 5), np.int32)
    for index, (first, last) in enumerate(((column, column + lengths), (row, row + 1))):
        low, high = np.full(count, flat.size, np.intp), np.zeros(count, np.intp)
        np.minimum.at(low, owner, first)
        np.maximum.at(high, owner, last)
        boxes[:, index], boxes[:, index + 2] = low, high - low
    boxes[:, cv2.CC_STAT_AREA] = np.bincount(owner, weights=lengths, minlength=count)
    return boxes


def areas_of(labels: Labels, count: int) -> NDArray[np.intp]:
    """How many pixels each of `count` labels (h, w) has (count,): as `numpy.bincount`, by runs."""
    values, lengths = _runs(labels)
    return np.bincount(values, weights=lengths, minlength=count).astype(np.intp)


def where_parts(chosen: Booleans, labels: Labels) -> Booleans:
    """Where (h, w) labels (h, w) are among the `chosen` (n,): as `chosen[labels]`, by runs."""
    values, lengths = _runs(labels)
    if len(values) > _RUNS * labels.size:
        return np.asarray(chosen.take(labels))
    return np.repeat(chosen[values], lengths).reshape(labels.shape)


def _runs(labels: Labels) -> tuple[Labels, NDArray[np.intp]]:
    """The label (m,) and the length (m,) of each run of one label in labels (h, w), row by row."""
    flat = labels.ravel()
    starts = np.flatnonzero(flat[1:] != flat[:-1]) + 1
    if flat.size:
        starts = np.append(0, starts)
    return flat[starts], np.diff(starts, append=flat.size)


def small_parts(mask: Booleans, most: float, connectivity: int = 4) -> Booleans | None:
    """The parts (h, w) of a mask of fewer than `most` pixels; None if there are none.

    A few pixels tell which parts are large for sure: those of the others alone are counted.
    """
    if not _may_have_small_parts(mask, most, connectivity):
        return None
    count, labels = parts_of(mask, connectivity)
    flat = labels.ravel()
    doubtful = np.bincount(flat[::_SAMPLED], minlength=count) < most
    doubtful[0] = False
    if not doubtful.any():
        return None
    found = where_parts(doubtful, labels)
    if np.count_nonzero(found) > _MANY * found.size:
        doubtful &= areas_of(labels, count) < most
        return where_parts(doubtful, labels) if doubtful.any() else None
    pixels = np.flatnonzero(found)
    owner = flat[pixels]
    large = np.bincount(owner, minlength=count)[owner] >= most
    if large.all():
        return None
    found.ravel()[pixels[large]] = False
    return found


def _may_have_small_parts(mask: Booleans, most: float, connectivity: int) -> bool:
    """Whether any part of a mask (h, w) may have fewer than `most` pixels, by the outlines of all:
    what extends farther has more. Most drawings have few outlines, found in a tenth of the time."""
    rows = mask[::_ROWS]
    if np.count_nonzero(rows[:, 1:] != rows[:, :-1]) > _NOISY * rows.size:
        return True
    are_holes = connectivity == 4  # OpenCV's parts are joined by corners, and its holes are not
    if are_holes:
        drawn = cv2.copyMakeBorder((~mask).view(np.uint8), *(1,) * 4, cv2.BORDER_CONSTANT, value=1)
    else:
        drawn = mask.view(np.uint8)
    outlines, tree = cv2.findContours(drawn, cv2.RETR_CCOMP, cv2.CHAIN_APPROX_SIMPLE)
    for outline, (_, _, _, outer) in zip(outlines, tree[0] if outlines else (), strict=True):
        if (outer >= 0) == are_holes and max(cv2.boundingRect(outline)[2:]) < most + 2 * are_holes:
            return True  # an outline of a hole is a pixel beyond it on each side
    return False


def opened_by_square(mask: Booleans, size: int) -> Booleans:
    """A mask (h, w) without what holds no square of so many pixels a side."""
    kernel = np.ones((size, size), np.uint8)
    inner = cv2.erode(mask.view(np.uint8), kernel)
    # OpenCV moves what is opened by a square of an even side by one pixel.
    at = size - 1 - size // 2
    return np.asarray(cv2.dilate(inner, kernel, anchor=(at, at)) > 0)


def window_around(mask: Booleans | NDArray[np.uint8], margin: int) -> tuple[slice, slice]:
    """The rows and columns of a picture that hold a mask (h, w) and so many pixels around it.

    They begin at even numbers: OpenCV numbers parts by squares of 2 x 2 pixels, here as in all of
    the picture.
    """
    x, y, width, height = cv2.boundingRect(mask.view(np.uint8))
    rows = slice(max(0, y - margin) & ~1, y + height + margin)
    return rows, slice(max(0, x - margin) & ~1, x + width + margin)


def parts_touching(mask: Booleans, reach: Booleans) -> Booleans:
    """The connected parts of a mask (h, w) that meet another one (h, w)."""
    count, parts = parts_of(mask, 8)
    met = np.bincount(parts[reach], minlength=count) > 0
    met[0] = False
    return where_parts(met, parts)


def is_inside(mask: Booleans, place: Floats) -> bool:
    """Whether a place (2,) is on a mask (h, w)."""
    x, y = np.round(place).astype(int)
    return bool(0 <= x < mask.shape[1] and 0 <= y < mask.shape[0] and mask[y, x])


def without_specks(mask: Booleans, least: float) -> Booleans:
    """The mask without parts and without holes of fewer than `least` pixels."""
    return without_holes(~without_holes(~mask, least, 8), least)


def without_holes(mask: Booleans, least: float, connectivity: int = 4) -> Booleans:
    """The mask with holes of fewer than `least` pixels filled; itself if there are none."""
    holes = small_parts(~mask, least, connectivity)
    return mask if holes is None else mask | holes
