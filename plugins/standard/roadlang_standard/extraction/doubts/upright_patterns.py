"""Patterns in photos that are no streets: courses of bricks, slabs, rows of parking spaces."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..networks.found_network import FoundRoad
from .box_lines import upright_share

_UPRIGHT, _JOINS, _CROSSINGS = 0.9, 8, 0.1
"""At least `_UPRIGHT` of the length is level or upright, at least `_JOINS` lines end on others, and
crossings are at most `_CROSSINGS` times as many. Of 58 photos with roads, those with so many joins
have at most .15 upright."""


def is_upright_pattern(roads: Sequence[FoundRoad]) -> bool:
    """Whether all roads of a photo are a pattern of level and upright lines that end on each other:
    streets that are as straight cross."""
    if not roads:
        return False
    nodes = np.array([(road.start, road.end) for road in roads], np.intp)
    degree = np.bincount(nodes.ravel())
    joins, crossings = np.count_nonzero(degree == 3), np.count_nonzero(degree > 3)
    if joins < _JOINS or crossings > _CROSSINGS * joins:
        return False
    return upright_share(roads) >= _UPRIGHT
