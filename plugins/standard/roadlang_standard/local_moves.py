"""Proposals near known points: separate regions, and moves within them."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from roadlang.geometry.numbers.clusters import clusters, distances

from .unit_cube import BELOW_ONE

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from roadlang.geometry import Floats

FRESH, BOX, CROSS, REDRAW = 0.05, 0.5, 0.7, 0.8
"""Where the shares of the moves end; the rest are differences."""
NEAREST, SHARE = 12, 4
"""A local model is made of so many neighbors at least, or of one in so many of the region."""
SINGLE = 0.02
"""How far from a point that has no neighbors the others are thought to be."""


@dataclass(frozen=True)
class Regions:
    """`cumulated` (r,) shares of the regions, whose points are `members`, each (m, d) in order;
    `order[i]` (m, k) are the nearest of each member, itself first."""

    cumulated: Floats
    members: tuple[Floats, ...]
    order: tuple[NDArray[np.intp], ...]


def moved(known: Floats, uniform: Floats) -> Floats:
    """(V, d) proposals from `known` (n, d) and random numbers (V, 3 d + 6)."""
    known = np.ascontiguousarray(known, dtype=np.float64)
    regions = _regions(known.tobytes(), known.shape)
    lead, spread = uniform[:, :6], uniform[:, 6:]
    chosen = np.searchsorted(regions.cumulated, lead[:, 0], "right")
    proposed = np.empty((len(uniform), known.shape[1]))
    for region, (members, order) in enumerate(zip(regions.members, regions.order, strict=True)):
        rows = np.flatnonzero(chosen == region)
        if rows.size:
            proposed[rows] = _moved_within(members, order, lead[rows, 1:], spread[rows])
    folded: Floats = 1.0 - np.abs(np.mod(proposed, 2.0) - 1.0)
    return np.clip(folded, 0.0, BELOW_ONE)


def _moved_within(members: Floats, order: NDArray[np.intp], lead: Floats, spread: Floats) -> Floats:
    """Of each parent one move: a fresh draw, an even draw from the box of its neighbors, a mixture
    of its coordinates and a neighbor's, some coordinates drawn anew, or the difference of two
    neighbors (differential evolution, Storn and Price 1997)."""
    dimensions = members.shape[1]
    first, second, third = (spread[:, i * dimensions : (i + 1) * dimensions] for i in range(3))
    parents = (lead[:, 0] * len(members)).astype(int)
    near = members[order[parents]]
    rows, count = np.arange(len(parents)), near.shape[1]
    parent = near[:, 0]
    other = near[rows, (lead[:, 3] * count).astype(int)]
    another = near[rows, (lead[:, 4] * count).astype(int)]
    low, high = near.min(axis=1), near.max(axis=1)
    width = (high - low) if count > 1 else np.full_like(low, SINGLE)
    beyond = width / (2 * max(count - 1, 1)) if count > 1 else width / 2
    box = low - beyond + (high - low + 2 * beyond) * first
    crossed = np.where(second < 0.5, parent, other) + beyond * (first + third - 1.0)
    share = (1.0 / dimensions) * (max(0.5 * dimensions, 1.0) ** lead[:, 2:3])
    anew = second < share
    anew[rows, (lead[:, 3] * dimensions).astype(int)] = True
    redrawn = np.where(anew, first, parent)
    difference = parent + 1.2 * lead[:, 2:3] * (other - another)
    difference += 0.5 * beyond * (first + third - 1.0)
    kind = lead[:, 1:2]
    proposed: Floats = np.select(
        [kind < FRESH, kind < BOX, kind < CROSS, kind < REDRAW],
        [first, box, crossed, redrawn],
        difference,
    )
    return proposed


@lru_cache(maxsize=8)
def _regions(content: bytes, shape: tuple[int, int]) -> Regions:
    """The regions of known points. Points that are known twice count once."""
    points = np.unique(np.frombuffer(content).reshape(shape), axis=0)
    labels = clusters(points)
    members = tuple(points[labels == label] for label in range(labels.max() + 1))
    order = tuple(_nearest(part) for part in members)
    weights = np.array([_log_weight(part) for part in members])
    shares = np.exp(weights - weights.max())
    cumulated = np.cumsum(shares / shares.sum())
    cumulated[-1] = 1.0
    return Regions(cumulated, members, order)


def _log_weight(points: Floats) -> float:
    """Small regions are drawn from more often than their size says, so that none is lost: by the
    fourth root of their number of points, which chance has multiplied, times their volume."""
    widths = np.maximum(np.ptp(points, axis=0), 1e-9)
    return float(0.25 * (np.log(len(points)) + np.log(widths).sum()))


def _nearest(points: Floats) -> NDArray[np.intp]:
    count = min(len(points), max(NEAREST, len(points) // SHARE))
    return np.argsort(distances(points), axis=1, kind="stable")[:, :count]
