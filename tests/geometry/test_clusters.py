"""Clusters are those of single linkage, cut where ways are far longer than usual."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.cluster.hierarchy import fcluster, linkage

from roadlang.geometry.numbers.clusters import GAP, USUAL, clusters


@pytest.mark.parametrize("seed", range(30))
def test_clusters_are_those_of_single_linkage(seed: int) -> None:
    rng = np.random.default_rng(seed)
    groups, dimensions = 1 + seed % 4, 1 + seed % 6
    centers = rng.uniform(0, 9, (groups, dimensions))
    points = np.concatenate([c + rng.normal(0, 0.02, (20 + seed, dimensions)) for c in centers])
    points = rng.permutation(np.round(points, 2 if seed % 3 == 0 else 9))

    found = clusters(points, fewest=1)

    tree = linkage(points, "single")
    limit = GAP * np.quantile(tree[:, 2], USUAL)
    expected = fcluster(tree, limit + 1e-9, "distance")
    assert len(set(zip(found, expected, strict=True))) == len(set(found)) == len(set(expected))
    assert sorted(set(found)) == list(range(found.max() + 1))


def test_points_alone_join_the_nearest_cluster() -> None:
    line = np.linspace(0, 0.1, 11)
    points = np.concatenate([line, line + 5, [4.0]])[:, None]
    assert clusters(points).tolist() == [0] * 11 + [1] * 12
    assert clusters(points[:1]).tolist() == [0]
