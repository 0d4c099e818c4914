"""Line art: a face, a diagram, cracks. Its lines end on one another, or vary in width; roads cross,
keep their width, and a network of many roads goes on beyond the picture."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from roadlang.geometry import Booleans

from ..networks.found_network import NO_ROAD, FoundRoad

_FEW, _MANY = 14.0, 22.0
"""Where nothing leaves the picture: with at most `_FEW` lines that end on another line the lines
are roads, with `_MANY` or more they are line art. Few people draw larger towns within margins."""
_STUB = 3.0
"""Dead ends shorter than this many widths are barbs, ticks and whiskers."""
_RIM = 3.0
"""Distance from the border, in pixels, within which a road leaves the picture."""
_ROADS, _EVEN, _UNEVEN = 10, 0.1, 0.2
"""Where there are at least `_ROADS` lines: if the standard deviation of their widths is at most
`_EVEN` of the width, they are roads; from `_UNEVEN` on they are cracks or veins. Fewer may be
strokes of a pen."""
_BROAD, _UNEVEN_IF_BROAD = 0.02, (0.075, 0.1)
"""No pen is as broad as `_BROAD` of the picture's shorter side: then the same between these two, as
of branches, rolls of paper and birds. Of 130 drawings of roads, those that broad have at most .065,
but for one that other rules doubt."""


def sure_by_junctions(roads: Sequence[FoundRoad], shape: tuple[int, ...]) -> float:
    """How sure all roads of a picture (h, w) are by how they meet and leave it.

    A town that goes on beyond the picture leaves it at least as many times as the square root of
    the number of its junctions: a grid of n by n streets has 4 n such ends.
    """
    nodes = np.array([(road.start, road.end) for road in roads], np.intp).reshape(-1, 2)
    degree = np.bincount(nodes.ravel())
    joins, crossings = np.count_nonzero(degree == 3), np.count_nonzero(degree > 3)
    if 2 * joins - crossings <= _FEW:
        return 1.0
    free = degree[nodes] == 1
    rim = np.array([ends_at_rim(road, shape) for road in roads])
    short = np.array([road.length < _STUB * road.usual_width for road in roads])
    stubs = np.count_nonzero((free & ~rim).any(axis=1) & short)
    leaving = np.count_nonzero(free & rim) / np.sqrt(joins + crossings)
    art = (joins + min(stubs, joins) - crossings) * max(0.0, 1.0 - float(leaving))
    return float(np.interp(art, (_FEW, _MANY), (1.0, NO_ROAD)))


def sure_by_widths(roads: Sequence[FoundRoad], side: float) -> float:
    """How sure all roads of a drawing of this shorter side are by how evenly wide each is."""
    if not roads:
        return 1.0
    lengths = np.array([road.length for road in roads])
    uneven = np.array(
        [np.std(road.widths) / max(float(np.mean(road.widths)), 1.0) for road in roads]
    )
    total = max(float(lengths.sum()), 1e-9)
    mean = float(lengths @ uneven) / total
    sure = 1.0
    if len(roads) >= _ROADS:
        sure = float(np.interp(mean, (_EVEN, _UNEVEN), (1.0, 0.0)))
    if float(lengths @ np.array([road.usual_width for road in roads])) >= _BROAD * side * total:
        sure = min(sure, float(np.interp(mean, _UNEVEN_IF_BROAD, (1.0, NO_ROAD))))
    return sure


def ends_at_rim(road: FoundRoad, shape: tuple[int, ...]) -> Booleans:
    """Whether the start and the end (2,) of a road, less half its width, are at the border of the
    picture (h, w)."""
    near = _RIM + 0.5 * road.usual_width
    ends = road.points[[0, -1]]
    far = np.array(shape[::-1]) - 1 - near
    return np.asarray(((ends <= near) | (ends >= far)).any(axis=1))
