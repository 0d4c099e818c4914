"""Scenes side by side for Stable-Baselines3, or what stands for its base class here."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from importlib import import_module
from importlib.util import find_spec
from types import ModuleType
from typing import Any

import numpy as np
import pytest

import roadlang
from roadlang.envs import SceneEnv
from tests.envs.scene_texts import ALONE, FOLLOWED
from tests.envs.test_env_sensors import SCENE as WITH_SENSORS

COUNT = 4


class StandIn:
    """What the base class of vectors in Stable-Baselines3 does, as far as it is used."""

    def __init__(self, num_envs: int, observation_space: Any, action_space: Any) -> None:
        self.num_envs = num_envs
        self.observation_space, self.action_space = observation_space, action_space
        self.reset_infos: list[Any] = [{} for _ in range(num_envs)]
        self._reset_seeds()
        self._reset_options()
        self.render_mode = self.get_attr("render_mode")[0]  # type: ignore[attr-defined]

    def _reset_seeds(self) -> None:
        self._seeds: list[int | None] = [None] * self.num_envs

    def _reset_options(self) -> None:
        self._options: list[dict[str, Any]] = [{} for _ in range(self.num_envs)]

    def seed(self, seed: int) -> None:
        self._seeds = [seed + place for place in range(self.num_envs)]

    def step(self, actions: Any) -> Any:
        self.step_async(actions)  # type: ignore[attr-defined]
        return self.step_wait()  # type: ignore[attr-defined]


@pytest.fixture(name="SceneVecEnv")
def adapter(monkeypatch: pytest.MonkeyPatch) -> Iterator[Any]:
    place = "roadlang.envs.stable_baselines"
    if find_spec("stable_baselines3") is None:
        for name in ("", ".common", ".common.vec_env"):
            module = ModuleType(f"stable_baselines3{name}")
            module.VecEnv = StandIn  # type: ignore[attr-defined]
            monkeypatch.setitem(sys.modules, module.__name__, module)
    yield import_module(place).SceneVecEnv
    sys.modules.pop(place, None)


def actions(steps: int) -> Any:
    drawn = np.random.default_rng(0).uniform(-1.0, 1.0, (steps, COUNT, 2)) * [0.3, 0.5]
    return np.asarray(drawn + np.array([0.0, 0.4]), dtype=np.float32)


@pytest.mark.parametrize("text", [ALONE, FOLLOWED])
def test_each_is_what_it_would_be_alone(SceneVecEnv: Any, text: str) -> None:
    envs = SceneVecEnv(roadlang.loads(text), COUNT, scenes=8, duration=2.0, scenes_each=4)
    alone = [SceneEnv(roadlang.loads(text), scenes=8, duration=2.0) for _ in range(COUNT)]
    envs.seed(5)
    seen = envs.reset()
    ends = 0
    for row, env in enumerate(alone):
        first, info = env.reset(seed=5 + row)
        assert (seen[row] == first).all()
        assert envs.reset_infos[row] == info
    for action in actions(50):
        seen, rewards, over, infos = envs.step(action)
        assert (rewards.dtype, over.dtype) == (np.float32, np.bool_)
        for row, env in enumerate(alone):
            one, reward, terminated, truncated, info = env.step(action[row])
            assert rewards[row] == np.float32(reward)
            assert over[row] == (terminated or truncated)
            last = infos[row].pop("terminal_observation", None)
            assert infos[row] == {**info, "TimeLimit.truncated": truncated}
            if over[row]:
                assert (last == one).all()
                ends += 1
                one, _ = env.reset()
            else:
                assert last is None
            assert (seen[row] == one).all()
    assert ends > COUNT


def test_readings_of_sensors_are_on_one_level(SceneVecEnv: Any) -> None:
    envs = SceneVecEnv(roadlang.loads(WITH_SENSORS), COUNT, scenes=3, duration=1.0)
    names = set(envs.observation_space.spaces)
    assert "state" in names
    assert not any("." in name for name in names)  # which torch refuses in names of modules
    assert any(name.startswith("front/") for name in names)
    seen = envs.reset()
    assert set(seen) == names
    for name, space in envs.observation_space.spaces.items():
        assert seen[name].shape == (COUNT, *space.shape)
        assert seen[name][0] in space
        assert space.shape != ()
    seen, _, over, infos = envs.step(actions(1)[0])
    assert set(seen) == names
    while not over.any():
        seen, _, over, infos = envs.step(actions(1)[0])
    assert infos[over.argmax()]["terminal_observation"] in envs.observation_space


def test_seeds_are_used_once(SceneVecEnv: Any) -> None:
    envs = SceneVecEnv(roadlang.loads(ALONE), COUNT, scenes=100)
    envs.seed(3)
    envs.reset()
    first = [info["scene"] for info in envs.reset_infos]
    envs.reset()
    assert [info["scene"] for info in envs.reset_infos] != first
    envs.seed(3)
    envs.reset()
    assert [info["scene"] for info in envs.reset_infos] == first


def test_what_they_share_is_not_set_one_by_one(SceneVecEnv: Any) -> None:
    envs = SceneVecEnv(roadlang.loads(ALONE), COUNT, scenes=2)
    assert envs.get_attr("names", [1, 2]) == [envs.envs.names] * 2
    assert envs.get_attr("render_mode") == [None] * COUNT
    assert envs.env_is_wrapped(object, 0) == [False]
    with pytest.raises(AttributeError, match="cannot set `reward` of one environment"):
        envs.set_attr("reward", None)
    with pytest.raises(AttributeError, match="cannot call `render` of one environment"):
        envs.env_method("render")
    envs.close()


@pytest.mark.skipif(find_spec("stable_baselines3") is not None, reason="it is there")
def test_without_stable_baselines_it_is_said_how_to_get_it() -> None:
    with pytest.raises(ImportError, match=r"roadlang\[sb3\]"):
        import_module("roadlang.envs.stable_baselines")
