"""Robustness along the roads, and the place that decides it."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from roadlang.ir.scene import Verdict
from roadlang.scenes.sampling import SamplingResult
from tests.straight_road import STRAIGHT

Sample = Callable[..., SamplingResult]
BUMP = "road bent from main { perturb with bump { at: 100m, height: 3m, length: 80m } }\n"


def verdict(sample: Sample, formula: str) -> Verdict:
    (scene,) = sample(STRAIGHT + BUMP + f"expect e: {formula}\n").scenes
    return scene.expectations[0]


@pytest.mark.parametrize(
    ("formula", "place", "rho"),
    [
        ("always (deviation(bent, main) < 5m)", 100.0, 2.0),
        ("eventually (deviation(bent, main) > 1m)", 100.0, 2.0),
        ("always[0m, 80m] (deviation(bent, main) < 5m)", 80.0, 2.0 + 3.0 * (1 - 0.75**3)),
        ("eventually[110m, 200m] (deviation(bent, main) > 1m)", 110.0, 3.0 * 0.9375**3 - 1.0),
    ],
)
def test_the_place_that_decides(sample: Sample, formula: str, place: float, rho: float) -> None:
    """The least robustness for `always`, the greatest for `eventually`, within the interval."""
    found = verdict(sample, formula)
    assert found.tightest is not None
    assert (found.tightest.road, found.tightest.station) == ("bent", place)
    assert found.robustness == pytest.approx(rho, abs=1e-9)
    (profile,) = found.profiles
    at = dict(zip(profile.stations, profile.values, strict=True))
    assert at[place] == pytest.approx(rho, abs=1e-9)


def test_a_profile_has_the_robustness_of_the_operand_at_every_station(sample: Sample) -> None:
    (profile,) = verdict(sample, "always (deviation(bent, main) < 5m)").profiles
    share = np.clip((np.array(profile.stations) - 100.0) / 40.0, -1.0, 1.0)
    assert profile.values == pytest.approx(5.0 - 3.0 * (1.0 - share**2) ** 3, abs=1e-9)


@pytest.mark.parametrize(
    "formula", ["length(bent) > 1m", "not always (deviation(bent, main) < 5m)"]
)
def test_other_formulas_have_no_profile(sample: Sample, formula: str) -> None:
    assert verdict(sample, formula).profiles == ()


def test_a_scene_without_any_copy_has_no_profile_of_what_is_said_of_copies(sample: Sample) -> None:
    text = STRAIGHT + BUMP + "agent cars is car on main at 10m..20m { count: integer(0, 1) }\n"
    scenes = sample(text + "expect e: always (deviation(bent, main) < cars.start)\n", 8).scenes
    assert {len(scene.agents) for scene in scenes} == {0, 1}
    for scene in scenes:
        (found,) = scene.expectations
        least = [min(profile.values) for profile in found.profiles]
        assert least == pytest.approx([agent.x - 3.0 for agent in scene.agents])
        assert (found.tightest is None) is (not scene.agents)
