"""The scenes of a dataset are sampled as they are needed. Needs no engine."""

from __future__ import annotations

from dataclasses import replace
from itertools import islice
from typing import Any

import pytest

import roadlang
from roadlang.api import DiagnosticError
from roadlang_godot.commands.render_dataset import _driven_scenes
from roadlang_godot.rendering.labeled_frames import default_camera

TEXT = """
road main { draw with waypoints { points: [(0m, 0m), (90m, 0m)] } }
agent ego is car on main at 5m..9m { drive with pure_pursuit { speed: 8m/s } }
"""


class Noting:
    """A scene file that notes how many scenes it is asked for."""

    def __init__(self, text: str) -> None:
        self.loaded = roadlang.loads(text)
        self.registry, self.places = self.loaded.registry, self.loaded.places
        self.asked: list[int] = []

    def sample(self, n: int, seed: int) -> Any:
        self.asked.append(n)
        return self.loaded.sample(n, seed=seed)


@pytest.mark.parametrize(
    ("first", "most", "taken", "asked"),
    [
        (2, 9, 2, [2]), (2, 9, 3, [2, 4]), (2, 9, 9, [2, 4, 8, 9]), (3, 3, 3, [3]),
        (5, 4, 4, [4]), (1, 3, 3, [1, 2, 3]),
    ],
)  # fmt: skip
def test_twice_as_many_are_sampled_when_they_have_run_out(
    first: int, most: int, taken: int, asked: list[int]
) -> None:
    loaded = Noting(TEXT)
    found = [scene for scene, _ in islice(_driven_scenes(loaded, first, 7, most), taken)]
    assert loaded.asked == asked
    assert found == [one.record for one in roadlang.loads(TEXT).sample(taken, seed=7)]


def test_there_are_no_more_than_asked_for_and_each_has_its_controllers() -> None:
    found = list(_driven_scenes(Noting(TEXT), 2, 0, 5))
    assert len(found) == 5
    assert all(list(controllers) == ["ego"] for _, controllers in found)


def test_without_a_camera_it_is_the_ego_or_the_first_agent_that_sees() -> None:
    (ego,) = roadlang.loads(TEXT).sample(1)[0].record.agents
    empty = replace(roadlang.loads(TEXT).sample(1)[0].record, agents=())
    ahead = replace(ego, name="ahead")
    for agents, seeing in (((ahead, ego), "ego"), ((ahead,), "ahead")):
        camera = default_camera(replace(empty, agents=agents), (320, 180))
        assert (camera.agent, camera.width, camera.height) == (seeing, 320, 180)
    with pytest.raises(DiagnosticError, match="RL700"):
        default_camera(empty, (320, 180))
