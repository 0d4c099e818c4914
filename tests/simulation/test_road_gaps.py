"""Gaps between agents on one road, in compiled loops: the same bits as with numpy."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from roadlang.simulation.building.world_building import world_of
from roadlang.simulation.surroundings.leaders import Pairing
from roadlang.simulation.surroundings.road_gaps import RoadColumns
from roadlang.simulation.vehicles import compiled

from .test_same_bytes import records

pytest.importorskip("numba")

QUEUE = """
road main { draw with segments { pieces: [straight(160m)] }, width: 8m, lanes: 2 }
agent cars is choice(car, truck, motorcycle) on main at random { count: 6, lane: -1 }
agent others is car on main at random { count: 3, lane: 1 }
"""
LOOP = """
road main {
  draw with waypoints { points: [(0m, 0m), (60m, -5m), (80m, 50m), (10m, 60m)] }
  closed: true, width: 8m
}
agent cars is car on main at random { count: 7 }
"""


def both(monkeypatch: pytest.MonkeyPatch, measure: Any) -> tuple[Any, Any]:
    """With numba and without."""
    monkeypatch.setattr(compiled, "is_loaded", lambda: True)
    fast = measure()
    monkeypatch.setattr(compiled, "is_loaded", lambda: False)
    return fast, measure()


@pytest.mark.parametrize("text", [QUEUE, LOOP], ids=["queue", "loop"])
@pytest.mark.parametrize("straying", [0.0, 0.5], ids=["straight", "straying"])
def test_compiled_gaps_are_the_same(
    text: str, straying: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    world = world_of(records(text, 12), {}, 0.02, 0.1)
    random = np.random.default_rng(1)
    count = len(world.present)
    world.motion.speed = random.uniform(0.0, 20.0, count)
    world.motion.offset = world.motion.offset + random.normal(0.0, 1.0, count)
    world.motion.sine = straying * random.uniform(-0.4, 0.4, count)
    world.present = world.present & (random.uniform(size=count) > 0.1)
    pairs = Pairing.of(world).on_road
    fast, plain = both(monkeypatch, lambda: RoadColumns.of(world).least_gaps(pairs))
    assert [column.tobytes() for column in fast] == [column.tobytes() for column in plain]
    assert 0.05 < np.isfinite(fast[0]).mean() < 0.7
