"""The settings of environments: their types and limits, and what follows from them."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from roadlang.envs import EnvSettings
from roadlang.envs.seeds import seed_of


def settings(**changes: Any) -> EnvSettings:
    return EnvSettings(**changes)


@pytest.mark.parametrize(
    ("duration", "step", "limit"), [(1.0, 0.1, 10), (1.26, 0.5, 3), (0.5, 0.5, 1), (0.1, 0.5, 1)]
)
def test_an_episode_has_as_many_steps_as_fit_and_one_at_least(
    duration: float, step: float, limit: int
) -> None:
    assert EnvSettings(duration=duration, step=step).limit == limit


def test_numbers_of_numpy_are_numbers() -> None:
    found = settings(
        scenes=np.int64(3), scene_seed=np.uint8(4), agents=np.int32(2), step=np.float32(0.5),
        violation_ends=np.bool_(True),
    )  # fmt: skip
    assert found == settings(scenes=3, scene_seed=4, agents=2, step=0.5, violation_ends=True)
    assert type(found.scenes) is int
    assert found.violation_ends is True


@pytest.mark.parametrize("seed", [np.int64(4), np.uint8(4)])
def test_seeds_of_resets_may_be_of_numpy(seed: Any) -> None:
    assert seed_of(seed) == 4
    assert type(seed_of(seed)) is int
    assert seed_of(None) is None


@pytest.mark.parametrize("seed", [1.0, "1", True])
def test_what_is_no_seed_is_refused_by_name(seed: Any) -> None:
    with pytest.raises(TypeError, match="`seed` must be an integer"):
        seed_of(seed)


def test_settings_are_checked() -> None:
    with pytest.raises(ValueError, match="step must be a number above 0"):
        EnvSettings(step=0.0)
    with pytest.raises(ValueError, match="scenes must be a whole number"):
        EnvSettings(scenes=0)


@pytest.mark.parametrize(
    ("name", "wrong", "told"),
    [
        ("off_road_ends", "no", "off_road_ends must be True or False, not 'no'"),
        ("violation_ends", 1, "violation_ends must be True or False, not 1"),
        ("agent", 3, "agent must be the name of an agent or None, not 3"),
        ("reward", 3, "reward must be the name of an `expect`, a formula, a function or None"),
    ],
)
def test_settings_of_another_type_are_refused(name: str, wrong: object, told: str) -> None:
    with pytest.raises(ValueError, match=told):
        settings(**{name: wrong})


@pytest.mark.parametrize(
    ("name", "least", "below"),
    [("scenes", 1, 0), ("scene_seed", 0, -1), ("agents", 0, -1)],
)
def test_whole_numbers_have_a_least(name: str, least: int, below: int) -> None:
    assert getattr(settings(**{name: least}), name) == least
    for wrong in (below, 1.5, True):
        with pytest.raises(ValueError, match=f"{name} must be a whole number of at least {least},"):
            settings(**{name: wrong})


@pytest.mark.parametrize("name", ["step", "vehicle_step", "duration", "acceleration"])
@pytest.mark.parametrize("wrong", [0.0, -1.0, math.inf, math.nan, True, "1"])
def test_what_is_measured_is_above_0_and_finite(name: str, wrong: object) -> None:
    with pytest.raises(ValueError, match=f"^{name} must be a number above 0, not "):
        settings(**{name: wrong})


@pytest.mark.parametrize(
    ("name", "most", "beyond"),
    [("vehicle_step", 0.05, 0.0501), ("step", 1.0, 1.01), ("distances", (0.0, 1000.0), (1001.0,))],
)
def test_steps_and_distances_have_a_greatest(name: str, most: object, beyond: object) -> None:
    assert getattr(settings(**{name: most}), name) == most
    with pytest.raises(ValueError, match=name):
        settings(**{name: beyond})
    with pytest.raises(ValueError, match="distances must be numbers from 0 to 1000 m"):
        settings(distances=(-1.0,))


@pytest.mark.parametrize(
    ("step", "vehicle_step", "substeps"), [(0.1, 0.05, 2), (0.02, 0.05, 1), (0.13, 0.05, 3)]
)
def test_a_step_is_made_of_whole_steps_of_the_equations(
    step: float, vehicle_step: float, substeps: int
) -> None:
    found = EnvSettings(step=step, vehicle_step=vehicle_step)
    assert (found.substeps, found.dt) == (substeps, step / substeps)
