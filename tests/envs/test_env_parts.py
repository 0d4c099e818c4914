"""Spaces, actions and rewards of environments, each by itself."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from gymnasium.spaces import Box, Dict

import roadlang
from roadlang.api import ReadingArray
from roadlang.envs import SceneEnv
from roadlang.envs.episode_rewards import reward_function
from roadlang.envs.episodes import Episodes
from roadlang.envs.observed import joined, observation_space, row_of
from roadlang.envs.scene_pool import pool_of
from roadlang.envs.settings import EnvSettings
from roadlang.envs.spaces import checked_actions
from roadlang.geometry.arrays import Floats
from roadlang.simulation.vehicles.poses import Poses
from tests.envs.scene_texts import FOLLOWED

VECTOR: Any = SimpleNamespace(
    low=np.array([-1.0, 0.0], np.float32), high=np.array([1.0, 9.0], np.float32)
)


def test_an_agent_without_sensors_observes_a_box() -> None:
    space = observation_space(VECTOR, {})
    assert space == Box(VECTOR.low, VECTOR.high, (2,), np.float32)


def test_readings_have_boxes_of_their_own_within_their_types() -> None:
    arrays = {
        "ranges": ReadingArray((4,), "float32", low=0.0, high=50.0),
        "kinds": ReadingArray((2, 3), "uint8", low=-5.0, high=1000.0),
        "few": ReadingArray((1,), "int16", low=-3.0, high=7.0),
    }
    space = observation_space(VECTOR, {"front": arrays})
    assert isinstance(space, Dict)
    assert space["state"] == observation_space(VECTOR, {})
    front: Any = space["sensors"]
    assert front["front"]["ranges"] == Box(0.0, 50.0, (4,), np.float32)
    assert front["front"]["kinds"] == Box(0, 255, (2, 3), np.uint8)
    assert front["front"]["few"] == Box(-3, 7, (1,), np.int16)


def test_batches_are_joined_and_taken_apart_by_rows() -> None:
    first = {"state": np.array([[1.0], [2.0]]), "sensors": {"gps": {"x": np.array([[3], [4]])}}}
    second = {"state": np.array([[5.0]]), "sensors": {"gps": {"x": np.array([[6]])}}}
    both = joined([first, second])
    assert both["state"].tolist() == [[1.0], [2.0], [5.0]]
    assert both["sensors"]["gps"]["x"].tolist() == [[3], [4], [6]]
    row = row_of(both, 1)
    assert (row["state"].tolist(), row["sensors"]["gps"]["x"].tolist()) == ([2.0], [4])


def test_actions_are_held_within_their_space() -> None:
    held = checked_actions([[-2.0, 0.5], [np.inf, -np.inf]], 2, 2)
    assert held.tolist() == [[-1.0, 0.5], [1.0, -1.0]]
    for wrong in ([[1.0, 0.0]], [[1.0], [0.0]], [1.0, 0.0]):
        with pytest.raises(ValueError, match=r"must have the shape \(2, 2\), not"):
            checked_actions(wrong, 2, 2)
    with pytest.raises(ValueError, match=r"must have the shape \(2,\), not \(1,\)"):
        checked_actions([0.0], 2)
    with pytest.raises(ValueError, match="not a number"):
        checked_actions([[0.0, 0.0], [np.nan, 0.0]], 2, 2)


@pytest.mark.parametrize(
    ("name", "help"),
    [("scene", "did you mean `scenes`"), ("pictures", "its settings are agent")],
)
def test_a_setting_that_there_is_not_is_named_with_those_that_there_are(
    name: str, help: str
) -> None:
    settings: dict[str, Any] = {name: 3}
    with pytest.raises(TypeError, match=f"SceneEnv has no setting `{name}`: {help}"):
        SceneEnv("never_read.rl", None, **settings)


def happened(**margins: list[float]) -> Any:
    return SimpleNamespace(
        moved=np.array([0.5, 2.0]), speed=np.array([1.0, 4.0]),
        margins={name: np.array(values) for name, values in margins.items()},
    )  # fmt: skip


def reward(given: Any, names: tuple[str, ...], now: Any) -> list[float]:
    pool: Any = SimpleNamespace(reward=names)
    return np.asarray(reward_function(given, pool)(now)).tolist()  # type: ignore[no-any-return]


def test_the_reward_is_the_way_or_the_least_margin_or_what_a_function_says() -> None:
    now = happened(near=[3.0, -1.0], slow=[1.0, 2.0])
    assert reward(None, (), now) == [0.5, 2.0]
    assert reward("near", ("near",), now) == [3.0, -1.0]
    assert reward(None, ("near", "slow"), now) == [1.0, -1.0]
    assert reward(lambda step: 2 * step.speed, ("near",), now) == [2.0, 8.0]
    assert reward(lambda step: 3, (), now) == [3.0, 3.0]


@pytest.mark.parametrize(
    ("found", "fault"),
    [([1.0], "has the shape"), ([[1.0, 2.0]], "has the shape"), ([1.0, np.nan], "not finite"),
     (np.inf, "not finite")],
)  # fmt: skip
def test_rewards_that_are_none_are_refused(found: Any, fault: str) -> None:
    with pytest.raises(ValueError, match=fault):
        reward(lambda step: found, (), happened())


def test_poses_of_who_begins_again_are_those_of_the_world() -> None:
    settings = EnvSettings()
    pool = pool_of(roadlang.loads(FOLLOWED), settings)
    episodes = Episodes(pool, [0] * 6, settings)
    every = np.arange(6)
    for _ in range(5):
        episodes.step(every, np.full((6, 2), 0.3))
    before = episodes.places[0].copy()
    episodes.restart(every[::2])
    world = episodes._world
    for now, expected in zip(episodes.places, (*_columns(world.poses), world.present), strict=True):
        np.testing.assert_array_equal(now, expected)
    assert (episodes.places[0] != before).any()


def _columns(poses: Poses) -> tuple[Floats, ...]:
    return poses.x, poses.y, poses.heading
