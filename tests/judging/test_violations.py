"""Where a formula is violated: each run of stations, by its first and last."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from roadlang.ir.scene import Verdict
from roadlang.scenes.sampling import SamplingResult
from tests.straight_road import STRAIGHT

Sample = Callable[..., SamplingResult]
BUMP = "road bent from main { perturb with bump { at: 100m, height: 3m, length: 80m } }\n"
LOOP = """
road ring { draw with segments { pieces: [
  straight(50m), arc(20m, 180deg), straight(50m), arc(20m, 180deg)
] }, closed: true }
"""


def violated(sample: Sample, formula: str, text: str = STRAIGHT + BUMP) -> Verdict:
    (scene,) = sample(text + f"expect e: {formula}\n").scenes
    (verdict,) = scene.expectations
    assert verdict.satisfied is False
    return verdict


def ends(verdict: Verdict) -> list[tuple[float, float]]:
    return [(stretch.start, stretch.end) for stretch in verdict.violated]


def test_a_run_begins_and_ends_at_stations_that_violate(sample: Sample) -> None:
    """The bump is higher than 1 m from 78 m to 122 m of a road with a station each meter."""
    verdict = violated(sample, "always (deviation(bent, main) < 1m)")
    ((start, end),) = ends(verdict)
    heights = dict(zip(*(_profile(verdict)), strict=True))
    assert heights[start] < 0 <= heights[start - 1]
    assert heights[end] < 0 <= heights[end + 1]


def _profile(verdict: Verdict) -> tuple[Any, Any]:
    (profile,) = verdict.profiles
    return profile.stations, profile.values


def test_only_what_the_interval_of_always_holds_counts(sample: Sample) -> None:
    verdict = violated(sample, "always[90m, 110m] (deviation(bent, main) < 1m)")
    assert ends(verdict) == [(90.0, 110.0)]


def test_an_interval_on_a_closed_road_goes_over_its_start(sample: Sample) -> None:
    """The ring is 225.7 m long, so that 30 m of the interval lie behind its start."""
    verdict = violated(sample, "always[195.7m, 255.7m] (abs(curvature(ring)) > 1/m)", LOOP)
    (first, last) = ends(verdict)
    assert first[0] == 0.0
    assert first[1] == pytest.approx(30, abs=1)
    assert last[0] == pytest.approx(195.7, abs=1)
    assert last[1] == pytest.approx(225.7, abs=1.1)


def test_stations_where_a_strict_comparison_is_just_missed_are_violated(sample: Sample) -> None:
    """Beside the bump the roads are the same: 0 m is not less than 0 m."""
    verdict = violated(sample, "always (deviation(bent, main) < 0m)")
    assert ends(verdict) == [(0.0, 200.0)]
    verdict = violated(sample, "always (deviation(bent, main) <= 0m)")
    ((start, end),) = ends(verdict)
    assert 60 <= start < end <= 140


def test_two_runs_are_told_apart(sample: Sample) -> None:
    text = STRAIGHT + BUMP.replace("at: 100m", "at: 50m").replace(
        " } }", " } perturb with bump { at: 150m, height: 3m, length: 60m } }"
    )
    assert len(ends(violated(sample, "always (deviation(bent, main) < 1m)", text))) == 2
