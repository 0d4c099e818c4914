"""Poses on lines, arcs and clothoids at any stations, however far these are apart."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang.geometry import Clothoid, chain, poses_along


@pytest.mark.parametrize("curvatures", [(0.0, 0.0), (0.05, 0.05), (-0.02, 0.3), (0.4, -0.4)])
@pytest.mark.parametrize("count", [2, 3, 80])
def test_poses_are_those_of_the_chain_of_pieces(
    curvatures: tuple[float, float], count: int
) -> None:
    start, length = np.array([3.0, -2.0, 2.5]), 40.0
    exact = chain([Clothoid(length, *curvatures)], start[:2], 2.5, spacing=0.05)
    stations = np.linspace(0.0, length, count)
    found = poses_along(start, curvatures, stations)
    np.testing.assert_allclose(found[0], start, atol=1e-12)
    np.testing.assert_allclose(found[-1, :2], exact.points[-1], atol=1e-9)
    np.testing.assert_allclose(found[:, 2], np.interp(stations, exact.stations, exact.heading),
                               atol=1e-4)  # fmt: skip


def test_one_circle_comes_back_to_its_start() -> None:
    around = np.array([0.0, 2.0 * np.pi * 7.0])
    found = poses_along(np.zeros(3), (1 / 7, 1 / 7), around)
    np.testing.assert_allclose(found[-1], (0.0, 0.0, 2.0 * np.pi), atol=1e-9)
