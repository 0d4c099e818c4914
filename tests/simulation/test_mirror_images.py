"""Left-hand traffic is the mirror image of right-hand traffic: roads, junctions, drives."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest

from roadlang import testing
from roadlang.api import Scene, Trace

from .mirrored_scenes import Lines, random_pair
from .routed_scenes import drive_scenes

QUICK = (0, 6, 13)
OTHERS = tuple(seed for seed in range(14) if seed not in QUICK)[::4]


def sampled(text: str, folder: Path) -> Scene:
    return testing.sample(text, 1, kinds=[Lines], folder=folder, seed=1)[0].record


@pytest.mark.parametrize(
    "seeds",
    [
        QUICK,
        pytest.param(OTHERS, marks=pytest.mark.slow),
    ],
    ids=["few", "others"],
)
def test_the_mirror_image_drives_as_the_scene(seeds: Sequence[int], tmp_path: Path) -> None:
    scenes = []
    for seed in seeds:
        pair = random_pair(seed)
        pair.write(tmp_path)
        scenes += [sampled(text, tmp_path) for text in (pair.right, pair.left)]
    step = 0.1 if seeds is QUICK else 0.04
    traces = drive_scenes(scenes, duration=16.0, control_step=step)  # much faster in one block
    for n in range(0, len(scenes), 2):
        check_mirrored(scenes[n], scenes[n + 1], traces[n], traces[n + 1])


def check_mirrored(scene: Scene, image: Scene, trace: Trace, mirrored: Trace) -> None:
    junctions, others = (one.networks[-1].junctions for one in (scene, image))
    assert [len(j.connections) for j in junctions] == [len(j.connections) for j in others]
    for here, there in zip(scene.agents, image.agents, strict=True):
        assert there.x == pytest.approx(-here.x, abs=1e-6)
        assert there.y == pytest.approx(here.y, abs=1e-6)
    for name, agent in trace.agents.items():
        other = mirrored.agents[name]
        assert np.abs(agent.x + other.x).max() < 1e-5, name
        assert np.abs(agent.y - other.y).max() < 1e-5, name
        assert (agent.present == other.present).all()
        assert (agent.contacts == other.contacts).all()
    assert max(agent.route_progress[-1] for agent in trace.agents.values()) > 50.0


@pytest.mark.parametrize("seed", [103, 107])
def test_of_routes_that_cost_the_same_the_mirror_image_takes_the_same(
    seed: int, tmp_path: Path
) -> None:
    pair = random_pair(seed)
    pair.write(tmp_path)
    agents, others = (sampled(text, tmp_path).agents for text in (pair.right, pair.left))
    for one, other in zip(agents, others, strict=True):
        assert other.x == pytest.approx(-one.x, abs=1e-6), one.name
