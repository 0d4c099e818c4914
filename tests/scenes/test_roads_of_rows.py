"""Roads of many scenes, whose numbers are tuples only where somebody reads them."""

from __future__ import annotations

from typing import Any

import numpy as np

from roadlang.evaluate.candidates import CandidateBatch
from roadlang.evaluate.draw_record import DrawRecord
from roadlang.ir.scene import SceneRoad
from roadlang.ir.scene_road import numbers_of
from roadlang.scenes.instantiate import driven_scene, driven_scenes
from roadlang.session.loading import loads
from roadlang.world.index import index_scenario

BENT = """
road main { draw with waypoints { points: [(0m, 0m), (80m, 0m)] } width: 8m }
road bent from main { perturb with sine { amplitude: 1m..2m, wavelength: 40m } }
agent ego is car on bent at 5m { drive with stanley { speed: 30km/h } }
"""


def test_of_many_driven_scenes_no_tuple_of_a_road_is_made_that_nobody_reads() -> None:
    loaded = loads(BENT)
    scenario, zero = index_scenario(loaded.scenario, loaded.registry), np.zeros(3, np.int64)
    batch = CandidateBatch(scenario, 1, zero, np.arange(3), None, DrawRecord())
    roads = [scene.roads[-1] for scene in driven_scenes(batch, [0, 1, 2], {})]
    assert [numbers_of(road, "y").shape for road in roads] == [(81,)] * 3
    assert not any(_is_made(road, name) for road in roads for name in ("stations", "y", "heading"))
    assert all(_is_made(road, "width") for road in roads)  # the same numbers in all
    for row, road in enumerate(roads):
        alone = driven_scene(batch.take_recorded(np.array([row])), row, {}).roads[-1]
        assert road == alone
        assert _is_made(road, "y")
    assert len({road.y for road in roads}) == 3


def _is_made(road: SceneRoad, name: str) -> bool:
    member: Any = vars(SceneRoad)[name]
    try:
        member.__get__(road)
    except AttributeError:
        return False
    return True
