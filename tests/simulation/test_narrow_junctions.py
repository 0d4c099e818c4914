"""Long vehicles that meet at junctions do not wait for each other for good."""

from __future__ import annotations

from pathlib import Path

import pytest

from benchmarks.traffic.__main__ import Outcome
from benchmarks.traffic.random_traffic import random_scene
from roadlang import testing


@pytest.mark.slow
@pytest.mark.parametrize("seed", [31008, 31088])
def test_who_waits_for_oncoming_traffic_holds_nobody_up_for_having_waited_long(
    seed: int, tmp_path: Path
) -> None:
    """A bus that had waited longest was let go first, and had to let the next bus go before."""
    scene = random_scene(seed, tmp_path)
    scenes = testing.sample(scene.text, 1, seed=seed, folder=tmp_path)
    (driven,) = scenes.run("builtin", duration=60.0)
    outcome = Outcome.of(driven.trace, scenes[0].record, scene.rule)
    assert not outcome.words
