"""What gymnasium and its wrappers do with environments: make them by name, copy them, reset them
with options."""

from __future__ import annotations

import pickle
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
import pytest

import roadlang
from roadlang.envs import SceneEnv, SceneVectorEnv, Transition
from tests.envs.scene_texts import ALONE, FOLLOWED, STRAIGHT

ACTION = np.array([0.05, 0.5], dtype=np.float32)


@pytest.fixture
def file(tmp_path: Path) -> str:
    path = tmp_path / "scene.rl"
    path.write_text(ALONE)
    return str(path)


def test_one_is_made_by_name(file: str) -> None:
    made = gymnasium.make("roadlang/Scene-v0", source=file, scenes=2)
    assert isinstance(made.unwrapped, SceneEnv)
    observed, _ = made.reset(seed=3)
    expected, _ = SceneEnv(file, scenes=2).reset(seed=3)
    np.testing.assert_array_equal(observed, expected)


def test_many_are_a_native_vector(file: str) -> None:
    made = gymnasium.make_vec("roadlang/Scene-v0", num_envs=3, source=file, scenes=2)
    assert isinstance(made, SceneVectorEnv)
    assert made.num_envs == 3


def speed(happened: Transition) -> Any:
    return happened.speed


@pytest.mark.parametrize("settings", [{}, {"reward": "in_lane"}, {"reward": speed}])
def test_an_environment_is_pickled_in_the_middle_of_an_episode(settings: dict[str, Any]) -> None:
    """As by processes that are spawned, and by checkpoints."""
    env = SceneEnv(roadlang.loads(FOLLOWED), scenes=2, **settings)
    env.reset(seed=1)
    env.step(ACTION)
    copy = pickle.loads(pickle.dumps(env))
    one, other = env.step(ACTION), copy.step(ACTION)
    np.testing.assert_array_equal(one[0], other[0])
    assert one[1:] == other[1:]


def test_a_vector_and_an_environment_without_expectations_are_pickled() -> None:
    many = pickle.loads(pickle.dumps(SceneVectorEnv(roadlang.loads(FOLLOWED), 2, scenes=2)))
    assert many.reset(seed=1)[0].shape[0] == 2
    one = pickle.loads(pickle.dumps(SceneEnv(roadlang.loads(STRAIGHT), scenes=1)))
    one.reset(seed=1)
    assert one.step(ACTION)[1] > 0.0


def test_unknown_options_of_reset_are_refused() -> None:
    """A misspelled one did nothing."""
    env = SceneEnv(roadlang.loads(STRAIGHT), scenes=1)
    with pytest.raises(ValueError, match="did you mean `scene`"):
        env.reset(options={"scne": 0})
    many = SceneVectorEnv(roadlang.loads(STRAIGHT), 2, scenes=1)
    with pytest.raises(ValueError, match="may have `reset_mask`, not `scene`"):
        many.reset(options={"scene": 0})


def test_a_reward_that_is_no_number_is_shown() -> None:
    env = SceneEnv(roadlang.loads(STRAIGHT), scenes=1, reward=lambda _: "much")
    env.reset(seed=0)
    with pytest.raises(ValueError, match="the reward must be numbers, not 'much'"):
        env.step(ACTION)
