"""How long an agent is there, and what stands all along."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang import testing
from roadlang.ir.scene import SceneActor
from roadlang.ir.trace import AgentTrace

TIME = np.array([0.0, 0.5, 1.0, 1.5])


@pytest.mark.parametrize(
    ("present", "samples"),
    [([1, 1, 1, 1], 4), ([1, 1, 0, 0], 2), ([1, 1, 1, 0], 3), ([0, 0, 0, 0], 0), ([np.nan] * 4, 4)],
)
def test_an_agent_is_there_until_it_leaves(present: list[float], samples: int) -> None:
    ego = testing.agent_trace(time=TIME, present=present)
    assert ego.samples_there == samples
    assert ego.has_left.tolist() == [value == 0 for value in present]


def test_what_stands_is_in_its_place_at_all_times() -> None:
    tree = SceneActor("tree", "tree", "tree", 3.0, 4.0, 0.5, 1.5, 0.5, 8.0, start=20.0, offset=-6.0)
    standing = AgentTrace.standing(tree, TIME)
    for name, value in {
        "x": 3.0, "y": 4.0, "heading": 0.5, "station": 20.0, "cross_track_error": -6.0,
        "speed": 0.0, "acceleration": 0.0, "steering": 0.0, "progress": 0.0, "contacts": 0.0,
        "route_progress": 0.0, "red_light": 0.0, "collision": 0.0, "present": 1.0,
    }.items():  # fmt: skip
        assert getattr(standing, name).tolist() == [value] * 4, name
    assert (standing.name, standing.length, standing.width) == ("tree", 1.5, 0.5)
    assert standing.samples_there == 4


def test_what_stands_beside_all_roads_is_at_station_zero() -> None:
    standing = AgentTrace.standing(SceneActor("rock", "rock", "rock", 1, 2, 0, 1, 1, 1), TIME)
    assert standing.station.tolist() == [0.0] * 4
    assert standing.cross_track_error.tolist() == [0.0] * 4
