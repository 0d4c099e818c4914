"""How sure roads of photos are that join no other: a faint line by itself is seldom a road."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from .drawn_confidence import connected_parts
from .found_network import FoundNetwork

_SHORT, _SIDE = 1.15, 512
"""A connected part of the network stands alone if its total length is below this many sides of the
picture; of a larger picture, only this many pixels of its side count."""
_SEEN, _BELIEVED = (0.0, 0.42, 0.68, 0.8, 1.0), (0.0, 0.42, 0.46, 0.8, 1.0)
"""Mean evidence of roads that are alone, and how sure they are: on 51 photos those of .5 to .7 were
right over a quarter of their length, others of as much evidence, which join a network, over
seven tenths."""


def with_doubts_of_lone(found: FoundNetwork) -> FoundNetwork:
    """The same roads, those less sure that are faint and short and join no others."""
    short = _SHORT * min(*found.mask.shape, _SIDE)
    factors: dict[int, float] = {}
    for part in connected_parts(found.roads):
        lengths = np.array([road.length for road in part])
        total = max(float(lengths.sum()), 1e-9)
        mean = float(lengths @ [road.confidence for road in part]) / total
        believed = mean if total >= short else float(np.interp(mean, _SEEN, _BELIEVED))
        factors.update((id(road), believed / max(mean, 1e-9)) for road in part)
    roads = tuple(road.less_sure(factors[id(road)]) for road in found.roads)
    return replace(found, roads=roads)
