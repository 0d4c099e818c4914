"""How the confidence of roads of photos is fitted, and told on photos left out."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from benchmarks.extraction.calibration import (
    Samples,
    by_road,
    by_stretch,
    fitted,
    joined,
    samples_of,
    shrunk,
    stated,
    stated_when_left_out,
)
from benchmarks.extraction.scores import Case
from roadlang_standard.extraction.networks.found_network import FoundNetwork, FoundRoad

TRUE = np.array([0.5, 0.8, -0.6])


def drawn(count: int = 20_000, seed: int = 0) -> Samples:
    """Points of 400 roads in 40 photos of two sources, right as often as `TRUE` says."""
    rng = np.random.default_rng(seed)
    facts = np.column_stack([np.ones(count), rng.normal(0.5, 1.5, count), rng.random(count)])
    chance = 1 / (1 + np.exp(-facts @ TRUE))
    road = np.sort(rng.integers(0, 400, count)).astype(float)
    group = road // 10
    length = rng.uniform(0.5, 2.0, count)
    right = rng.random(count) < chance
    return Samples(facts, np.zeros(count), right, length, road, group, group % 2)


def test_what_is_fitted_is_what_made_the_samples() -> None:
    assert fitted(drawn()) == pytest.approx(TRUE, abs=0.15)


def test_given_log_odds_are_not_fitted_again() -> None:
    plain = drawn()
    given = np.where(plain.group == 3, -2.0, 0.0)
    chance = 1 / (1 + np.exp(-(plain.facts @ TRUE + given)))
    right = np.random.default_rng(1).random(len(chance)) < chance
    moved = Samples(**{**vars(plain), "given": given, "right": right})
    assert fitted(moved) == pytest.approx(TRUE, abs=0.15)
    assert stated(moved, TRUE) == pytest.approx(chance)


def test_photos_that_are_left_out_have_no_say() -> None:
    """All of one photo turned wrong: what is stated there stays, elsewhere it falls."""
    samples = drawn()
    there = samples.group == 7
    worse = Samples(**{**vars(samples), "right": samples.right & ~there})
    before, after = (stated_when_left_out(one, 0) for one in (samples, worse))
    assert (before[there] == after[there]).all()
    assert after[~there].mean() < before[~there].mean()


def test_what_is_fitted_to_few_points_is_drawn_together() -> None:
    few = [drawn(120, seed) for seed in range(8)]
    assert np.mean([shrunk(s)[1] for s in few]) < 0.95 * np.mean([fitted(s)[1] for s in few])
    assert shrunk(drawn()) == pytest.approx(fitted(drawn()), abs=0.05)


def test_bands_weigh_by_length() -> None:
    sure, right = np.array([0.2, 0.6, 0.65, 0.9]), np.array([0.0, 1.0, 0.0, 1.0])
    low, middle, high, top = by_stretch(sure, right, np.array([1.0, 3.0, 1.0, 5.0]))
    assert (low.share, low.stated, low.right) == pytest.approx((0.1, 0.2, 0.0))
    assert (middle.share, middle.stated, middle.right) == pytest.approx((0.4, 0.6125, 0.75))
    assert high.share == pytest.approx(0.0)
    assert (top.share, top.right) == pytest.approx((0.5, 1.0))


def test_a_road_is_in_the_band_of_its_mean() -> None:
    ends = samples_of(*seen(y=20), road=5, group=1, source=0)
    assert set(ends.road) == {5.0}
    _, middle, _, _ = by_road(np.linspace(0.3, 0.9, len(ends.road)), ends)
    assert (middle.share, middle.stated) == pytest.approx((1.0, 0.6))


def seen(y: float) -> tuple[FoundNetwork, Any]:
    """A road 60 pixels long at height y, found where the true one is at 20."""
    line = np.column_stack([np.linspace(0.0, 60.0, 31), np.full(31, y)])
    road = FoundRoad(0, 1, line, np.full(31, 8.0), confidences=np.full(31, 0.7), confidence=0.7)
    truth = Case.of_lines(np.zeros((40, 61, 3), np.uint8), [line + np.array([0.0, 20.0 - y])])
    return FoundNetwork(line[[0, -1]], (road,), np.zeros((40, 61), bool)), truth


def test_right_is_within_three_pixels() -> None:
    near, far = (samples_of(*seen(y), road=0, group=0, source=0) for y in (23.0, 24.0))
    assert near.right.all()
    assert not far.right.any()
    assert near.length.sum() == pytest.approx(60.0)
    assert len(joined([near, far]).right) == 62
    assert len(joined([]).right) == 0
