"""Some of many candidates are what they were among all."""

from __future__ import annotations

import numpy as np

import roadlang
from roadlang.evaluate.candidates import CandidateBatch
from roadlang.session.scene import installed
from roadlang.world.index import index_scenario

ROAD = "road main { draw with segments { pieces: [straight(90m..120m)] } }\n"


def test_candidates_that_are_taken_keep_their_scene_attempt_and_draws() -> None:
    scenario = index_scenario(roadlang.loads(ROAD).scenario, installed())
    scenes, attempts = np.array([3, 3, 4, 7]), np.array([0, 5, 2, 2])
    coordinates = {"a": np.array([0.1, 0.2, 0.3, 0.4])}
    batch = CandidateBatch(scenario, 11, scenes, attempts, coordinates)
    rows = np.array([3, 1])
    taken = batch.take(rows)
    assert taken.count == 2
    assert taken.scenes.tolist() == [7, 3]
    assert taken.attempts.tolist() == [2, 5]
    assert taken.coordinates["a"].tolist() == [0.4, 0.2]
    np.testing.assert_array_equal(taken.keys, batch.keys[rows])
    assert len(set(batch.keys.ravel().tolist())) == 4
