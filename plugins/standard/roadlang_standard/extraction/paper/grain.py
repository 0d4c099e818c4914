"""Strokes of crayon and chalk: the grain of the paper shows through them, as many small holes and
as gaps in their edges, and cuts them into pieces."""

from __future__ import annotations

import cv2
import numpy as np

from roadlang.geometry import Booleans

from ..masks.ellipses import closed_by, grown_by, opened_by
from ..masks.mask_parts import parts_and_boxes, where_parts, without_holes
from ..masks.skeleton import skeleton, widths_across

_REACH = 4
"""Grain is found by closing the strokes by this many pixels to each side."""
_SMOOTH = 0.25
"""Grain is closed, and burrs are removed, up to this share of the width to each side."""
_MANY, _OFTEN, _FILLED = 12, 600, 0.3
"""A stroke has grain if it has at least `_MANY` holes and gaps, at least one in `_OFTEN` pixels,
and these are at most `_FILLED` of its surface."""
_THICK, _LONG = 2.0 * _REACH, 0.6
"""Only strokes at least `_THICK` pixels thick and `_LONG` shorter sides of the picture long have
grain: most words are smaller."""
_BROAD, _UNEVEN = 0.9, 1.33
"""With grain the ink has all widths: its `_BROAD` quantile exceeds the usual width by the factor
`_UNEVEN`. Letters are written with an even pen."""


def without_grain(marked: Booleans) -> Booleans:
    """The strokes (h, w), with the holes, gaps and burrs of those that have grain closed; itself if
    none has."""
    grainy = _grainy(marked, closed_by(marked, 2 * _REACH + 1))
    if grainy is None:
        return marked
    width = _width(grainy)
    reach = round(_SMOOTH * width)
    solid = without_holes(closed_by(grainy, 2 * max(_REACH, reach) + 1), width**2)
    smooth = opened_by(solid, 2 * reach + 1)
    # Where the stroke is thinner than that, it stays.
    thin = solid & ~grown_by(smooth, 2 * reach + 1)
    return (marked & ~grainy) | smooth | thin


def _grainy(marked: Booleans, closed: Booleans) -> Booleans | None:
    """Those of the strokes, closed (h, w), that have grain, None without any."""
    gaps = closed & ~marked
    holes, parts = cv2.connectedComponents(gaps.view(np.uint8), connectivity=4)
    if holes <= _MANY:
        return None
    number, labels, stats = parts_and_boxes(closed)
    pixels = np.flatnonzero(gaps)
    first = pixels[np.unique(parts.ravel()[pixels], return_index=True)[1]]  # one of each gap
    found = np.bincount(labels.ravel()[first], minlength=number)
    areas = stats[:, cv2.CC_STAT_AREA]
    filled = np.bincount(labels[gaps], minlength=number)
    grainy = (found >= _MANY) & (found * _OFTEN >= areas) & (filled <= _FILLED * areas)
    grainy[0] = False
    for index in np.flatnonzero(grainy):
        part = labels == index
        grainy[index] = _is_stroke(part, min(marked.shape)) and _is_uneven(marked & part)
    return where_parts(grainy, labels) if grainy.any() else None


def _is_stroke(part: Booleans, side: int) -> bool:
    """Whether a part (h, w) is a thick, long stroke in a picture of this shorter side."""
    width = _width(part)
    return width >= _THICK and int(np.count_nonzero(part)) >= _LONG * side * width


def _is_uneven(ink: Booleans) -> bool:
    """Whether ink (h, w) is of all widths."""
    broad, usual = _widths(ink, (_BROAD, 0.5))
    return broad + 1 >= _UNEVEN * (usual + 1)


def _width(part: Booleans) -> float:
    """The usual width of strokes (h, w), pixels."""
    return _widths(part, (0.5,))[0]


def _widths(part: Booleans, shares: tuple[float, ...]) -> list[float]:
    """The widths that such shares of strokes (h, w) are thinner than, pixels."""
    inner = cv2.distanceTransform(part.view(np.uint8), cv2.DIST_L2, 5)
    return widths_across(inner[skeleton(part)], shares)
