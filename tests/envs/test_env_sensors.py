"""Environments of scenes whose driven agent has sensors."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env

from roadlang import DiagnosticError, loads
from roadlang.envs import SceneEnv, SceneVectorEnv

SCENE = """
road main { draw with waypoints { points: [(0m, 0m), (200m, 0m)] }, lanes: 2 }
agent ego is car on main at 5m {
  start_speed: 8m/s
  sense with ranges as front { rays: 5, angle: 20deg, noise: 5cm, every: 200ms, delay: 0ms..200ms }
  sense with gps
  sense with noise { position: 0.3m }
}
agent lead is car on main at 20m..40m { drive with lane_follow { speed: 6m/s } }
expect apart: always (gap(ego, lead) > 2m)
"""


def parts(observed: Any) -> list[Any]:
    """The arrays of an observation, in order."""
    if isinstance(observed, dict):
        return [array for name in sorted(observed) for array in parts(observed[name])]
    return [observed]


def test_an_observation_holds_the_readings() -> None:
    env = SceneEnv(loads(SCENE), scenes=2, step=0.1)
    check_env(env, skip_render_check=True)
    observed, _ = env.reset(seed=1)
    assert observed in env.observation_space
    assert sorted(observed["sensors"]) == ["front", "gps", "noise"]
    lead = env.pool.scenes[0].agents[1].x
    assert observed["sensors"]["front"]["distances"][2] == pytest.approx(lead - 7.25, abs=20.0)
    error = env.names.index("cross_track_error")
    errors = [env.step(np.zeros(2, np.float32))[0]["state"][error] for _ in range(20)]
    assert 0.1 < np.std(errors) < 0.6


def test_each_of_a_vector_reads_what_it_reads_alone() -> None:
    loaded = loads(SCENE)
    vector = SceneVectorEnv(loaded, 3, scenes=3, step=0.1, duration=0.5, scenes_each=2)
    alone = SceneEnv(loaded, scenes=3, step=0.1, duration=0.5)
    observed, _ = vector.reset(seed=5)
    single, _ = alone.reset(seed=6)
    over = False
    for _ in range(12):
        for one, many in zip(parts(single), parts(observed), strict=True):
            assert one.tobytes() == many[1].tobytes()
        observed = vector.step(np.full((3, 2), 0.1, np.float32))[0]
        if over:
            (single, _), over = alone.reset(), False
        else:
            single, _, terminated, truncated, _ = alone.step(np.full(2, 0.1, np.float32))
            over = terminated or truncated


def test_bounds_of_readings_hold_in_all_scenes() -> None:
    text = SCENE.replace("noise: 5cm", "range: 20m..90m")
    env = SceneEnv(loads(text), scenes=3, step=0.1)
    ranges = [scene.agents[0].sensors[0].options["range"] for scene in env.pool.scenes]
    space: Any = env.observation_space
    assert space["sensors"]["front"]["distances"].high.max() == max(ranges)
    for scene in range(3):
        assert env.reset(options={"scene": scene})[0] in space


def test_a_camera_needs_an_engine_that_draws() -> None:
    with pytest.raises(DiagnosticError, match="RL257"):
        SceneEnv(loads(SCENE.replace("sense with gps", "sense with camera")))
