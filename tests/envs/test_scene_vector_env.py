"""Many environments side by side: to the last bit what each would be alone."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from gymnasium.vector import AutoresetMode

import roadlang
from roadlang.envs import SceneEnv, SceneVectorEnv
from roadlang.envs.episodes import can_restart
from roadlang.envs.rows import rows_of
from roadlang.envs.scene_pool import pool_of
from roadlang.envs.settings import EnvSettings
from roadlang.simulation.vehicles import compiled
from tests.envs.scene_texts import ALONE, CUT_IN, FOLLOWED, ROAD

COUNT, STEPS = 3, 50


def actions() -> np.ndarray[Any, np.dtype[np.float32]]:
    drawn = np.random.default_rng(0).uniform(-1.0, 1.0, (STEPS, COUNT, 2)) * [0.2, 0.5]
    return np.asarray(drawn + np.array([0.0, 0.4]), dtype=np.float32)


def vector(text: str, **settings: Any) -> SceneVectorEnv:
    return SceneVectorEnv(roadlang.loads(text), COUNT, scenes=8, duration=3.0, **settings)


def single(text: str) -> SceneEnv:
    return SceneEnv(roadlang.loads(text), scenes=8, duration=3.0)


@pytest.mark.parametrize(
    ("text", "mode"),
    [
        (ALONE, AutoresetMode.NEXT_STEP),
        *((FOLLOWED, mode) for mode in AutoresetMode),
        (CUT_IN, AutoresetMode.SAME_STEP),
    ],
)
def test_each_is_what_it_would_be_alone(text: str, mode: AutoresetMode) -> None:
    together = vector(text, autoreset_mode=mode, scenes_each=8)
    alone = [single(text) for _ in range(COUNT)]
    seen, info = together.reset(seed=11)
    for i, env in enumerate(alone):
        first, about = env.reset(seed=11 + i)
        assert (seen[i] == first).all()
        assert info["scene"][i] == about["scene"]
    over = np.zeros(COUNT, dtype=bool)
    ends = 0
    for action in actions():
        if mode is AutoresetMode.DISABLED and over.any():
            with pytest.raises(RuntimeError, match="an episode is over"):
                together.step(action)
            seen, _ = together.reset(options={"reset_mask": over})
            for i in np.flatnonzero(over).tolist():
                assert (seen[i] == alone[i].reset()[0]).all()
        seen, rewards, terminated, truncated, info = together.step(action)
        for i, env in enumerate(alone):
            if over[i] and mode is AutoresetMode.NEXT_STEP:
                expected: tuple[Any, ...] = (env.reset()[0], 0.0, False, False)
            else:
                expected = env.step(action[i])[:4]
            if (expected[2] or expected[3]) and mode is AutoresetMode.SAME_STEP:
                assert info["_final_obs"][i]
                assert (info["final_obs"][i] == expected[0]).all()
                expected = (env.reset()[0], *expected[1:])
            assert (seen[i] == expected[0]).all()
            assert (rewards[i], terminated[i], truncated[i]) == expected[1:]
        over = terminated | truncated
        ends += int(over.sum())
    assert ends >= COUNT


def test_after_its_scenes_each_begins_with_the_first_again() -> None:
    env = vector(ALONE, scenes_each=2, autoreset_mode="SameStep")
    first, _ = env.reset(seed=0)
    episodes = 0
    still = np.tile(np.array([0.0, 0.0], dtype=np.float32), (COUNT, 1))
    while episodes < 2:
        seen, _, _, truncated, _ = env.step(still)
        episodes += bool(truncated.all())
    assert (seen == first).all()


def test_another_reset_draws_other_scenes() -> None:
    env = vector(ALONE, scenes_each=1)
    _, before = env.reset(seed=0)
    _, after = env.reset()
    _, again = env.reset(seed=0)
    assert (before["scene"] != after["scene"]).any()
    assert (before["scene"] == again["scene"]).all()


def test_spaces_are_those_of_gymnasium() -> None:
    env = vector(ALONE)
    seen, _ = env.reset(seed=0)
    assert env.observation_space.contains(seen)
    assert env.action_space.contains(env.action_space.sample())
    assert env.metadata["autoreset_mode"] is AutoresetMode.NEXT_STEP


def test_wrong_calls_say_what_is_wrong() -> None:
    env = vector(ALONE, autoreset_mode="Disabled")
    with pytest.raises(RuntimeError, match="reset"):
        env.step(env.action_space.sample())
    env.reset(seed=0)
    with pytest.raises(ValueError, match="shape"):
        env.step(np.zeros((COUNT, 3), dtype=np.float32))
    with pytest.raises(ValueError, match="reset_mask"):
        env.reset(options={"reset_mask": [True] * COUNT})
    for _ in range(30):
        env.step(np.zeros((COUNT, 2), dtype=np.float32))
    with pytest.raises(RuntimeError, match="is over"):
        env.step(np.zeros((COUNT, 2), dtype=np.float32))


TOWN = '''image plan from """
.#.
###
.#.
""" { scale: 30m/px }
network town from plan { lanes: 2 }
agent ego is car on town at random
'''
FAST = "when: other.speed > 5m/s"
TRUCK = ALONE + "agent other is truck on main at 80m { length: %gm, drive with lane_follow }\n"
MET = "expect far: always (ego.speed < 1m/s)\nagent other is car on main at 90m { %s }\n"


@pytest.mark.parametrize(
    ("text", "together"),
    [
        (ALONE, True),
        (FOLLOWED, True),
        (TRUCK % 6.5, True),
        (TRUCK % 12, False),
        (ALONE + MET % f"drive with lane_follow, drive with brake {{ {FAST} }}", False),
        (TOWN, False),
        (ALONE + MET % "drive with lane_follow, drive with brake", True),
    ],
)
def test_scenes_begin_again_beside_others_unless_something_waits(text: str, together: bool) -> None:
    """For a condition, at a junction, or for a long vehicle in a bend."""
    pool = pool_of(roadlang.loads(text), EnvSettings(scenes=2))
    assert can_restart(pool) is together


@pytest.mark.parametrize(
    ("count", "scenes_each", "drawn"), [(1, None, 64), (40, None, 1), (65, None, 1), (1, 1, 1)]
)
def test_as_few_as_one_at_once_and_one_scene_for_each(
    count: int, scenes_each: int | None, drawn: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    seen: list[list[list[int]]] = []

    def note(pool: Any, draws: list[list[int]], settings: Any) -> Any:
        seen.append(draws)
        return rows_of(pool, draws, settings)

    monkeypatch.setattr("roadlang.envs.scene_vector_env.rows_of", note)
    loaded = roadlang.loads(ALONE)
    env = SceneVectorEnv(loaded, count, scenes=2, duration=1.0, scenes_each=scenes_each)
    observed, _ = env.reset(seed=0)
    assert len(observed) == count
    assert [len(each) for each in seen[0]] == [drawn] * count


@pytest.mark.parametrize(("count", "scenes_each"), [(0, None), (-1, 4), (2, 0), (2, -1), (0, 0)])
def test_none_at_once_or_no_scene_for_each_is_refused(count: int, scenes_each: int | None) -> None:
    with pytest.raises(ValueError, match="at least 1"):
        SceneVectorEnv(roadlang.loads(ALONE), count, scenes_each=scenes_each)


EGO_LATER = f"""{ROAD}
agent lead is car on bent at 25m {{ lane: -1, drive with car_follow {{ speed: 6m/s..9m/s }} }}
agent parked is car on bent at 120m..140m {{ lane: 1 }}
agent ego is car on bent at 5m {{ lane: -1 }}
"""


def test_others_drive_whoever_stands_and_wherever_the_ego_is_in_the_list() -> None:
    together = SceneVectorEnv(roadlang.loads(EGO_LATER), 3, scenes=3, agent="ego", scenes_each=3)
    first, info = together.reset(seed=2)
    ahead = together.names.index("agent1_ahead")
    np.testing.assert_allclose(first[:, ahead], 20.0, atol=1.5)
    still = np.zeros((3, 2), dtype=np.float32)
    for _ in range(10):
        seen, *_ = together.step(still)
    assert (seen[:, ahead] > first[:, ahead] + 2.0).all()
    for row, scene in enumerate(info["scene"]):
        alone = SceneEnv([together.pool.scenes[int(scene)]], agent="ego")
        assert (alone.reset(seed=0)[0] == first[row]).all()
        for action in still[:1].repeat(10, axis=0):
            last = alone.step(action)[0]
        assert (last == seen[row]).all()


def test_a_mode_that_gymnasium_does_not_have_is_refused_with_those_it_has() -> None:
    with pytest.raises(ValueError, match="must be one of NextStep, SameStep, Disabled, not 'same'"):
        vector(ALONE, autoreset_mode="same")


@pytest.mark.skipif(not compiled.is_installed(), reason="needs numba: pip install roadlang[fast]")
def test_the_compiled_motion_takes_over_and_changes_nothing(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def observations(*, fast: bool) -> list[Any]:
        monkeypatch.setattr(compiled, "pays", lambda steps, agents: fast)
        env = vector(FOLLOWED)
        env.reset(seed=4)
        found = [env.step(action)[0] for action in actions()]
        assert (env._running()._episodes._world.advance is compiled.advance) == fast  # type: ignore[attr-defined]
        return found

    slow, fast = observations(fast=False), observations(fast=True)
    assert all((a == b).all() for a, b in zip(slow, fast, strict=True))


def test_gymnasium_knows_the_seed() -> None:
    env = vector(ALONE)
    env.reset(seed=3)
    assert env.np_random_seed == 3
    drawn = env.np_random.random()
    env.reset(seed=3)
    assert env.np_random.random() == drawn
