"""Scenes are made many at a time: each is the same, to the last bit, as the scene made alone."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
import pytest

from roadlang.evaluate.candidates import CandidateBatch
from roadlang.evaluate.draw_record import DrawRecord
from roadlang.ir.encoding import to_json
from roadlang.ir.scene import Scene
from roadlang.scenes.instantiate import driven_scenes_or_faults, instantiate
from roadlang.scenes.sampling import sample_scenes
from roadlang.testing import scenario
from roadlang.world.index import index_scenario
from roadlang.world.placement import placement_without_overlap

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


DRAWN_LANES = """
road base {
  draw with segments { pieces: [straight(60m), arc(40m, 80deg)] }
  lanes: integer(1, 3), width: 6m..9m, speed_limit: (8m/s)..(12m/s)
}
agent ego is car on base at 10m { drive with lane_follow {} }
agent late is car on base at 40m { start_speed: (1m/s)..(5m/s), drive with car_follow {} }
"""
LISTED_LANES = """
road base {
  draw with segments { pieces: [straight(60m), arc(40m, 80deg)] }
  left: [drive(3m..4m)], right: [drive(3m), shoulder(0.5m..2m)]
}
road bent from base { perturb with bump { height: 0m..2m, at: 30m, length: 40m } }
agent ego is choice(car, truck) on bent at 10m { drive with lane_follow {} }
"""
JUDGED = (
    BASE
    + """
let limit = 2m..5m
road bent from base { perturb with sine { amplitude: 0m..3m, wavelength: 60m..90m } }
let e = deviation(bent, base)
require near: always (e < limit)
require later: eventually[10m, 30m] always[0m, 10m] (e < 1m)
require whole: lp_distance(bent, base, 2) < 90m^1.5
agent ego is car on bent at 5m { drive with lane_follow { speed: (8m/s)..(20m/s) } }
agent queue is car on base at random { count: integer(0, 2), drive with brake {} }
expect flat: always (abs(curvature(bent)) < 0.02/m)
expect inside: always (abs(ego.cross_track_error) < limit)
"""
)
CLOSED = """
road base {
  draw with waypoints { points: [(0m, 0m), (80m, 0m), (80m, 60m), (0m, 60m)] }, closed: true
}
road bent from base { perturb with harmonics { amplitude: 2m } }
require near: always (deviation(bent, base) < 2m)
agent ego is car on bent at 5m..60m { drive with pure_pursuit {} }
world { friction: 0.5..0.9 }
"""
NETWORK = '''
image plan from """
  #########
      #
      #
  #########
""" { scale: 8m/px }
network town from plan
network moved from town { perturb with sine { amplitude: 0m..1m, wavelength: 60m..90m } }
agent ego is car on moved at random { drive with traffic {} }
object trees is tree on moved at random { count: 3, side: left, offset: 2m..8m }
require straight: always (abs(curvature(moved)) < 0.2/m)
'''
DRAWN_KINDS = (
    BASE
    + """
object things is choice(tree(height: 2m..9m), cone, building(length: 6m..9m), weights: [2, 1, 1])
  on base at random { count: integer(0, 4), side: left, offset: 2m..30m }
"""
)
TEXTS = {
    "several passes": SEVERAL_PASSES, "drawn count": DRAWN_COUNT, "drawn length": DRAWN_LENGTH,
    "drawn lanes": DRAWN_LANES, "listed lanes": LISTED_LANES, "judged": JUDGED, "closed": CLOSED,
    "network": NETWORK, "drawn kinds": DRAWN_KINDS,
}  # fmt: skip


@pytest.mark.parametrize("count", [2, 8])
@pytest.mark.parametrize("text", TEXTS.values(), ids=TEXTS)
def test_a_scene_made_to_be_driven_is_the_scene_made_alone(text: str, count: int) -> None:
    loaded = scenario(text)
    indexed = index_scenario(loaded.scenario, loaded.registry)
    numbers = np.arange(count)
    first = np.zeros_like(numbers)
    batch = CandidateBatch(indexed, 5, first, numbers, None, DrawRecord())
    for number, made in enumerate(driven_scenes_or_faults(batch, numbers.tolist(), {})):
        assert isinstance(made, Scene)
        single = np.array([number])
        alone = CandidateBatch(indexed, 5, first[:1], single, None, DrawRecord())
        whole = instantiate(alone, number, {}).scene
        judged = {verdict.name for verdict in whole.requirements}
        kept = {place: value for place, value in whole.draws.items() if place in made.draws}
        assert dict(made.draws) == kept
        assert {place.partition("/")[0] for place in whole.draws.keys() - made.draws} <= judged
        assert _driven(made) == _driven(whole)


def _driven(scene: Scene) -> dict[str, object]:
    """All that a drive depends on."""
    members = {field.name: getattr(scene, field.name) for field in dataclasses.fields(scene)}
    for name in ("signals", "requirements", "expectations", "draws", "units"):
        del members[name]
    return members


def places_found(text: str, n: int, monkeypatch: pytest.MonkeyPatch) -> int:
    """How often anything looked for a place while `n` scenes were sampled and made."""
    found = 0
    settle = placement_without_overlap._Turn.settle

    def counted(*arguments: Any) -> None:
        nonlocal found
        found += 1
        settle(*arguments)

    monkeypatch.setattr(placement_without_overlap._Turn, "settle", counted)
    loaded = scenario(text)
    result = sample_scenes(loaded.scenario, loaded.registry, n)
    assert result.accepted == n
    return found


def test_an_accepted_scene_is_not_placed_again(monkeypatch: pytest.MonkeyPatch) -> None:
    assert places_found(SEVERAL_PASSES, 1, monkeypatch) == 3
    assert places_found(SEVERAL_PASSES, 17, monkeypatch) == 6


@pytest.mark.parametrize("text", TEXTS.values(), ids=TEXTS)
def test_sampled_scenes_are_those_of_their_attempts_alone(text: str) -> None:
    loaded = scenario(text)
    indexed = index_scenario(loaded.scenario, loaded.registry)
    for scene in sample_scenes(loaded.scenario, loaded.registry, 12, seed=3).scenes[::3]:
        number, attempt = np.array([scene.index]), np.array([scene.provenance.attempt])
        alone = CandidateBatch(indexed, 3, number, attempt, None, DrawRecord())
        assert to_json(scene) == to_json(instantiate(alone, scene.index, {}).scene)
