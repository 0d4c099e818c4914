"""The renderer of truth: the same seed gives the same bytes, and the truth is what is painted."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from training.rendering.aerial import render_aerial
from training.rendering.extras import Extras
from training.rendering.frame import ribbon
from training.rendering.layouts.plans import PLANS


@pytest.mark.parametrize("plan", PLANS)
def test_every_plan_renders_and_repeats(plan: Any) -> None:
    first, again = (render_aerial(plan, 3, size=192, meters_per_pixel=1.5) for _ in range(2))
    assert (first.image == again.image).all()
    assert first.image.shape == (192, 192, 3)
    assert first.truth.roads
    assert (render_aerial(plan, 4, size=192, meters_per_pixel=1.5).image != first.image).any()


def test_a_ribbon_covers_its_length_times_its_width() -> None:
    line = np.array([[10.3, 20.0], [80.3, 20.0]])
    _, cover = ribbon(line, 6.4, (40, 100))
    assert cover.sum() == pytest.approx(70 * 6.4, rel=0.03)
    rows = cover.sum(axis=1) @ np.arange(len(cover)) / cover.sum()
    window, _ = ribbon(line, 6.4, (40, 100))
    assert rows + window[0].start == pytest.approx(20.0, abs=0.1)


@pytest.mark.parametrize("share", [0.1, 0.3])
def test_as_much_is_hidden_as_is_asked_for(share: float) -> None:
    scene = render_aerial("bend", 7, size=256, hidden=share)
    assert scene.truth.hidden_share() == pytest.approx(share, abs=0.1)


def test_a_bright_road_is_brighter_where_the_truth_says() -> None:
    scene = render_aerial("curve", 5, size=256, asphalt=0.85)
    road = (scene.truth.mask() > 0) & ~scene.truth.hidden
    gray = scene.image.mean(axis=2)
    assert gray[road].mean() > gray[scene.truth.mask() == 0].mean() + 30


_EXTRAS = Extras(1, 0.4, 0.3, 0.05, tracks=3, clearing=True, built_up=None, wrack=True)


def test_extras_change_the_picture_and_what_is_hidden_but_no_road() -> None:
    bare = render_aerial("suburb", 3, size=256)
    scene, again = (render_aerial("suburb", 3, size=256, extras=_EXTRAS) for _ in range(2))
    assert (scene.image == again.image).all()
    assert (scene.image != bare.image).mean() > 0.5
    assert scene.truth.polylines() == bare.truth.polylines()
    assert scene.truth.hidden_share() > bare.truth.hidden_share() + 0.1


def test_a_boulevard_is_two_roads_side_by_side() -> None:
    first, second, *_ = PLANS["boulevard"](np.random.default_rng(2), 400.0)
    middle = first.points[len(first.points) // 2]
    apart = np.hypot(*(second.points - middle).T).min()
    assert first.width + 1 < apart < first.width + 11
