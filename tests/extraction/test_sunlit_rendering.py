"""Scenes under one sun: trees throw their shadows one way, and the truth is the plan."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from training.rendering.aerial import true_roads
from training.rendering.frame import Floats, Frame, Layer
from training.rendering.layouts.plans import PLANS
from training.rendering.noise import smooth
from training.rendering.sunlit.scene import render_sunlit
from training.rendering.sunlit.sprites import (
    Sprite,
    View,
    bare_tree,
    leafy_tree,
    needle_tree,
)
from training.rendering.sunlit.stand import Stand, grow, spots

_GREEN = np.array([0.2, 0.4, 0.2])
_EAST = View(sun=np.array([1.0, 0.0]), lean=np.array([0.0, -0.3]), pixels=2.0)


@pytest.mark.parametrize("plan", ["suburb", "rural", "city"])
def test_a_scene_repeats_and_its_truth_is_the_plan(plan: str) -> None:
    first, again = (render_sunlit(plan, 3, 128, 1.5) for _ in range(2))
    assert (first.image == again.image).all()
    assert first.image.shape == (128, 128, 3)
    assert (render_sunlit(plan, 4, 128, 1.5).image != first.image).any()
    rng = np.random.default_rng([3, list(PLANS).index(plan), 2])
    planned = true_roads(Frame(128, 1.5), PLANS[plan](rng, 128 * 1.5))
    assert [road.width for road in first.truth.roads] == [road.width for road in planned]
    assert all(
        (one.points == other.points).all()
        for one, other in zip(first.truth.roads, planned, strict=True)
    )


def _middle(layer: Layer) -> Floats:
    """The center of what a layer covers, in pixels from the foot of the tree."""
    rows, columns = np.indices(layer.shape) - layer.shape[0] // 2
    return np.array([float((axis * layer).sum() / layer.sum()) for axis in (columns, rows)])


@pytest.mark.parametrize("grown", [bare_tree, needle_tree, leafy_tree])
def test_a_shadow_falls_away_from_the_sun_and_a_tree_leans_from_the_camera(
    grown: Callable[[np.random.Generator, View, float, Floats], Sprite],
) -> None:
    tree = grown(np.random.default_rng(1), _EAST, 12.0, _GREEN)
    x, y = _middle(tree.shade)
    assert 3 < x < 24
    assert abs(y) < 4
    x, y = _middle(tree.cover)
    assert abs(x) < 4
    assert -9 < y < -1


def test_a_tall_tree_has_a_longer_shadow_than_a_low_one() -> None:
    low, tall = (
        needle_tree(np.random.default_rng(1), _EAST, height, _GREEN).shade for height in (6.0, 18.0)
    )
    assert tall.sum() > 4 * low.sum()


def test_trees_stand_only_where_the_density_lets_them() -> None:
    frame = Frame(100, 1.0)
    density = np.zeros(frame.shape, np.float32)
    density[:, 50:] = 1
    at = spots(np.random.default_rng(1), frame, density, 5.0)
    assert len(at) == pytest.approx(200, abs=25)
    assert at[:, 0].min() > 49.4


def test_trees_at_the_border_take_light_and_leave_the_rest_alone() -> None:
    frame = Frame(100, 0.5)
    tree = needle_tree(np.random.default_rng(1), _EAST, 10.0, _GREEN)
    stand = Stand.empty(frame)
    grow(np.random.default_rng(1), frame, stand, [tree], np.array([[0.0, 25.0], [80.0, 80.0]]))
    assert stand.cover.max() > 0.9
    assert stand.light.min() < 0.1
    assert stand.light[:, 60:].min() == 1
    assert (stand.light[50, 2:14] < 0.5).any()


def test_long_waves_have_no_steps() -> None:
    waves = smooth(np.random.default_rng(1), Frame(400, 0.5), 400.0)
    assert (np.diff(waves, axis=1) == 0).mean() < 0.01
