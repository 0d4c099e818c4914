"""Where roads of a network must keep meeting, whatever displaces them."""

from __future__ import annotations

import numpy as np

from ..arrays import Floats
from ..curves.window import fade
from .network import Edge, RoadNetwork

FADE_LENGTH = 15.0
"""Meters from a junction within which a displacement fades out."""


def anchored_nodes(network: RoadNetwork) -> frozenset[int]:
    """The nodes that roads must keep meeting at: all but dead ends and the seams of lone rings.

    Where a map states the junctions, those of their arms.
    """
    if network.junctions is not None:
        arms = (arm for junction in network.junctions for arm in junction.arms)
        met = ((network.edge(id), end) for id, end in arms)
        return frozenset(edge.start if end == "start" else edge.end for edge, end in met)
    free = set()
    for node in network.nodes:
        ends = network.edges_at(node.id)
        lone_ring = len(ends) == 2 and ends[0].curve.closed  # of which both ends are here
        if len(ends) <= 1 or lone_ring:
            free.add(node.id)
    return frozenset(node.id for node in network.nodes) - free


def junction_window(
    network: RoadNetwork,
    edge: Edge,
    stations: Floats,
    taper: float = FADE_LENGTH,
    trims: tuple[float, float] = (0.0, 0.0),
) -> Floats:
    """(S,) zero up to `trims` meters from the ends of the edge at anchored nodes, one beyond
    `taper` meters from there; where less is left between the trims, it stays below one (`fade`).

    Value, slope and second derivative of a displacement in this window vanish there, so that
    positions, headings and curvatures stay what they were: a junction planned for the edge fits
    whatever displaces it.
    """
    anchored = anchored_nodes(network)
    free = edge.length - sum(trims)
    if free <= 0.0:
        return np.zeros_like(stations)
    at = stations - trims[0]
    return fade(at, free, taper, edge.start in anchored, edge.end in anchored)
