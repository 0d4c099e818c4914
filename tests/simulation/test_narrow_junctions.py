"""Long vehicles that meet at junctions do not wait for each other for good."""

from __future__ import annotations

from pathlib import Path

import pytest

from benchmarks.traffic.__main__ import Outcome
from benchmarks.traffic.random_traffic import random_scene
from roadlang import testing

from .routed_scenes import drive_scenes


@pytest.mark.slow
def test_who_waits_for_oncoming_traffic_holds_nobody_up_for_having_waited_long(
    tmp_path: Path,
) -> None:
    """A bus that had waited longest was let go first, and had to let the next bus go before."""
    drawn = {seed: random_scene(seed, tmp_path) for seed in (31008, 31088)}
    scenes = [
        testing.sample(scene.text, 1, seed=seed, folder=tmp_path)[0].record
        for seed, scene in drawn.items()
    ]
    traces = drive_scenes(scenes, duration=60.0, control_step=0.04)
    for (seed, scene), record, trace in zip(drawn.items(), scenes, traces, strict=True):
        assert not Outcome.of(trace, record, scene.rule).words, seed
