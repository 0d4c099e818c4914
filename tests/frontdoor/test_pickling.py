"""Scenes, sets of scenes and drives go to other processes, whatever was looked at before."""

from __future__ import annotations

import copy
import pickle
from typing import Any

import pytest

import roadlang

TEXT = """
road main { draw with waypoints { points: [(0m, 0m), (90m, 5m)] }, width: 7m }
road bent from main { perturb with sine { amplitude: 1m..2m, wavelength: 80m } }
let away = deviation(bent, main)
require near: always (away < 3m)
agent ego is car on bent at 5m { drive with pure_pursuit { speed: 9m/s } }
expect slow: always (ego.speed < 11m/s)
"""
VIEWS = ("values", "draws", "units", "world", "roads", "networks", "agents", "objects", "signals",
         "requirements", "expectations", "robustness", "places")  # fmt: skip


def looked_at() -> roadlang.SceneSet:
    """Two scenes all of whose views were made."""
    scenes = roadlang.loads(TEXT).sample(2)
    for scene in scenes:
        for name in VIEWS:
            getattr(scene, name)
    return scenes


@pytest.mark.parametrize("copied", [copy.deepcopy, lambda item: pickle.loads(pickle.dumps(item))])
def test_what_was_looked_at_can_be_copied_and_pickled(copied: Any) -> None:
    scenes = looked_at()
    again = copied(scenes)
    assert [scene.to_json() for scene in again] == [scene.to_json() for scene in scenes]
    assert again[1].draws == scenes[1].draws
    assert copied(scenes[0]).svg() == scenes[0].svg()
    drive = scenes[0].run(duration=1.0)
    assert drive.verdicts["slow"].satisfied
    assert copied(drive).to_json() == drive.to_json()
