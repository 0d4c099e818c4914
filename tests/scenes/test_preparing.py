"""Scenes of many candidates, prepared together: each is the same as the scene made alone."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
import pytest

from roadlang.evaluate.candidates import CandidateBatch
from roadlang.evaluate.draw_record import DrawRecord
from roadlang.ir.encoding import to_json
from roadlang.ir.scene import Scene
from roadlang.scenes.instantiate import driven_scene, instantiate
from roadlang.scenes.preparing import prepare_scenes
from roadlang.scenes.sampling import sample_scenes
from roadlang.testing import scenario
from roadlang.world import arrangement
from roadlang.world.index import index_scenario

BASE = """
road base {
  draw with segments { pieces: [straight(60m), arc(40m, 80deg), straight(60m)] }
  width: 8m, lanes: 2
}
"""
SEVERAL_PASSES = (
    BASE
    + """
road bent from base {
  perturb with harmonics { amplitude: 2m }
  perturb with sine { amplitude: 0m..3m, wavelength: 60m..90m }
  perturb with sine { amplitude: 1m, wavelength: 50m }
}
agent ego is car on bent at 5m..25m { drive with lane_follow { speed: (8m/s)..(20m/s) } }
agent lead is choice(car, truck) on bent at ahead_of(ego, 30m..50m) { drive with brake {} }
object trees is tree on bent at random { count: 5, side: left, offset: 2m..8m }
"""
)
DRAWN_COUNT = (
    BASE
    + """
agent ego is car on base at random { drive with lane_follow {} }
agent queue is choice(car, van) on base at random { count: integer(0, 3), drive with brake {} }
"""
)
DRAWN_LENGTH = """
road base { draw with segments { pieces: [straight(60m..90m), arc(40m, 80deg)] }, width: 8m }
agent ego is car on base at 10%..50% { drive with lane_follow {} }
"""


@pytest.mark.parametrize("text", [SEVERAL_PASSES, DRAWN_COUNT, DRAWN_LENGTH])
def test_a_scene_made_of_prepared_candidates_is_the_scene_made_alone(text: str) -> None:
    loaded = scenario(text)
    indexed = index_scenario(loaded.scenario, loaded.registry)
    numbers = np.arange(8)
    first = np.zeros_like(numbers)
    batch = CandidateBatch(indexed, 5, first, numbers, None, DrawRecord())
    prepare_scenes(batch)
    for number in numbers.tolist():
        row = np.array([number])
        prepared = driven_scene(batch.take_recorded(row), number, {})
        alone = CandidateBatch(indexed, 5, first[:1], row, None, DrawRecord())
        assert _driven(prepared) == _driven(instantiate(alone, number, {}).scene)


def _driven(scene: Scene) -> dict[str, object]:
    """All that a drive depends on, and the draws."""
    members = {field.name: getattr(scene, field.name) for field in dataclasses.fields(scene)}
    for name in ("signals", "requirements", "expectations"):
        del members[name]
    return members


def places_found(text: str, n: int, monkeypatch: pytest.MonkeyPatch) -> int:
    """How often anything looked for a place while `n` scenes were sampled and made."""
    found = 0
    settle = arrangement._Turn.settle

    def counted(*arguments: Any) -> None:
        nonlocal found
        found += 1
        settle(*arguments)

    monkeypatch.setattr(arrangement._Turn, "settle", counted)
    loaded = scenario(text)
    result = sample_scenes(loaded.scenario, loaded.registry, n)
    assert result.accepted == n
    return found


def test_an_accepted_scene_is_not_placed_again(monkeypatch: pytest.MonkeyPatch) -> None:
    assert places_found(SEVERAL_PASSES, 1, monkeypatch) == 3
    assert places_found(SEVERAL_PASSES, 17, monkeypatch) == 6


@pytest.mark.parametrize("text", [SEVERAL_PASSES, DRAWN_COUNT, DRAWN_LENGTH])
def test_sampled_scenes_are_those_of_their_attempts_alone(text: str) -> None:
    loaded = scenario(text)
    indexed = index_scenario(loaded.scenario, loaded.registry)
    for scene in sample_scenes(loaded.scenario, loaded.registry, 12, seed=3).scenes:
        number, attempt = np.array([scene.index]), np.array([scene.provenance.attempt])
        alone = CandidateBatch(indexed, 3, number, attempt, None, DrawRecord())
        assert to_json(scene) == to_json(instantiate(alone, scene.index, {}).scene)
