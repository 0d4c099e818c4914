"""Clusters: points that lie together, apart from others."""

from __future__ import annotations

import numpy as np

from ..arrays import Floats, Integers

USUAL = 0.9
"""The quantile of the ways in the tree that is taken for the usual one: few lead to elsewhere."""

GAP = 4.0
"""How many times longer than usual a way is that parts two clusters."""
FEWEST = 3
"""Points that make a cluster."""


def distances(points: Floats) -> Floats:
    """(n, n) the distances of points (n, d) to each other."""
    square = (points * points).sum(axis=1)
    gaps = square[:, None] + square[None, :] - 2.0 * points @ points.T
    np.fill_diagonal(gaps, 0.0)
    return np.asarray(np.sqrt(np.maximum(gaps, 0.0)))


def clusters(points: Floats, gap: float = GAP, fewest: int = FEWEST) -> Integers:
    """(n,) the number of the cluster of each of the points (n, d), from 0 on without gaps.

    The shortest spanning tree (Prim 1957) is cut where it is `gap` times longer than usual (single
    linkage); what has fewer than `fewest` points joins the nearest cluster that has more.
    """
    between = distances(points)
    labels = _cut(between, gap)
    sizes = np.bincount(labels)
    large = sizes >= fewest
    if not large.any():
        return np.zeros(len(points), dtype=np.intp)
    belongs = large[labels]
    nearest = np.flatnonzero(belongs)[np.argmin(between[:, belongs], axis=1)]
    labels = np.where(belongs, labels, labels[nearest])
    return np.asarray(np.unique(labels, return_inverse=True)[1].reshape(-1), dtype=np.intp)


def _cut(between: Floats, gap: float) -> Integers:
    count = len(between)
    ways, nearest = between.copy(), 0
    reached, source = ways[0].copy(), np.zeros(count, dtype=np.intp)
    closer = np.empty(count, dtype=bool)
    tree = []
    for _ in range(count - 1):
        # Who is in the tree is no longer reached: minima over all are then those over the others.
        reached[nearest] = ways[:, nearest] = np.inf
        nearest = int(reached.argmin())
        tree.append((float(reached[nearest]), int(source[nearest]), nearest))
        np.less(ways[nearest], reached, out=closer)
        np.copyto(reached, ways[nearest], where=closer)
        source[closer] = nearest
    limit = gap * float(np.quantile([length for length, _, _ in tree], USUAL)) if tree else 0.0
    labels, last = [0] * count, 0
    for length, before, after in tree:
        if length > limit:
            last += 1
        labels[after] = last if length > limit else labels[before]
    return np.array(labels, dtype=np.intp)
