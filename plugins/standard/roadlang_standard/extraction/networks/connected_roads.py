"""Which roads hang together."""

from __future__ import annotations

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from .found_network import FoundRoad


def connected_parts(roads: tuple[FoundRoad, ...]) -> list[list[FoundRoad]]:
    """The roads by the connected part of the network that they belong to."""
    starts, ends = ([getattr(road, end) for road in roads] for end in ("start", "end"))
    count = 1 + max([*starts, *ends], default=0)
    links = coo_array((np.ones(len(roads)), (starts, ends)), shape=(count, count))
    number, part = connected_components(links, directed=False)
    found: list[list[FoundRoad]] = [[] for _ in range(number)]
    for road in roads:
        found[part[road.start]].append(road)
    return [members for members in found if members]
