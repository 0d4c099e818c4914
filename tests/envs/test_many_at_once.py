"""Hundreds of environments with numpy: rows of memory that stay, and the bits of one alone."""

from __future__ import annotations

import pickle
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import roadlang
from roadlang.envs import SceneEnv, SceneVectorEnv, Transition
from roadlang.envs.rows import Together
from roadlang.simulation.vehicles import compiled
from roadlang.simulation.vehicles.path_calls import FEWEST, PathRows
from roadlang.simulation.vehicles.verges import Verges
from tests.envs.scene_texts import ALONE, FOLLOWED

STEPS = 30


@pytest.fixture(autouse=True)
def numpy_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(compiled, "is_installed", lambda: False)
    monkeypatch.setattr(compiled, "is_loaded", lambda: False)


def actions(count: int) -> np.ndarray[Any, np.dtype[np.float32]]:
    drawn = np.random.default_rng(0).uniform(-1.0, 1.0, (STEPS, count, 2)) * [0.2, 0.5]
    return np.asarray(drawn + np.array([0.0, 0.4]), dtype=np.float32)


@pytest.mark.parametrize("text", [ALONE, FOLLOWED])
def test_they_see_and_get_what_each_would_alone(text: str, monkeypatch: pytest.MonkeyPatch) -> None:
    used: list[int] = []
    seen_by = PathRows.seen

    def noted(self: PathRows, columns: Any) -> Any:
        used.append(len(columns[0]))
        return seen_by(self, columns)

    monkeypatch.setattr(PathRows, "seen", noted)
    together = SceneVectorEnv(roadlang.loads(text), FEWEST, scenes=8, duration=2.0)
    alone = SceneEnv(roadlang.loads(text), scenes=8, duration=2.0)
    chosen = FEWEST - 1
    seen, _ = together.reset(seed=11)
    first, _ = alone.reset(seed=11 + chosen)
    assert (seen[chosen] == first).all()
    for action in actions(FEWEST):
        seen, rewards, terminated, truncated, _ = together.step(action)
        one, reward, *ends, _ = alone.step(action[chosen])
        assert (seen[chosen] == one).all()
        assert rewards[chosen] == reward
        assert [terminated[chosen], truncated[chosen]] == ends
        if any(ends):
            break
    assert used
    assert set(used) == {FEWEST}


def test_observations_are_kept_apart() -> None:
    env = SceneVectorEnv(roadlang.loads(ALONE), FEWEST, scenes=8)
    env.reset(seed=0)
    kept = [env.step(action)[0] for action in actions(FEWEST)]
    copies = [seen.copy() for seen in kept]
    env.step(actions(FEWEST)[0])
    assert all((seen == copy).all() for seen, copy in zip(kept, copies, strict=True))
    assert not np.shares_memory(kept[0], kept[1])


def test_a_transition_that_is_kept_says_what_was_then() -> None:
    kept: list[Transition] = []

    def reward(step: Transition) -> Any:
        kept.append(step)
        return step.speed

    env = SceneVectorEnv(roadlang.loads(ALONE), 20, scenes=8, duration=0.5, reward=reward)
    env.reset(seed=0)
    for action in actions(20)[:12]:
        env.step(action)
    assert kept[1].time.tolist() == [0.2] * 20  # looked at after they have begun anew
    assert (kept[0].previous_action == 0.0).all()
    assert (kept[2].previous_action == kept[1].action).all()
    assert (np.abs(kept[1].action) > 0.0).all()
    copy = pickle.loads(pickle.dumps(kept[4]))
    assert (copy.steering == kept[4].steering).all()
    assert (replace(kept[4], speed=kept[4].speed + 1.0).time == kept[4].time).all()
    with pytest.raises(AttributeError, match="no member `sped`"):
        _ = kept[0].sped  # type: ignore[attr-defined]


def test_edges_of_roads_are_not_looked_up_step_by_step(monkeypatch: pytest.MonkeyPatch) -> None:
    env = SceneVectorEnv(roadlang.loads(ALONE), 50, scenes=8)
    env.reset(seed=0)
    assert isinstance(env._rows, Together)

    def never(*_: Any) -> None:
        raise AssertionError("looked up")

    monkeypatch.setattr(Verges, "_looked_up", never)
    left = np.tile(np.array([0.3, 1.0], dtype=np.float32), (50, 1))
    for _ in range(40):
        env.step(left)
