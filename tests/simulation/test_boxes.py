"""Boxes of agents and objects in the view of a camera: of `sense with boxes`."""

from __future__ import annotations

import math

import numpy as np
import pytest

from roadlang import testing
from roadlang.envs import SceneEnv
from roadlang_standard.semantic_classes import SemanticClass
from tests.simulation.sensed_drives import agent, record, runs

VAN = "object van is parked_van on main at 30m { lane: none, offset: 0m }\n"


def boxes(options: str, others: str) -> dict[str, np.ndarray]:
    """The first reading of an ego at 5 m of a straight road."""
    text = agent(f"sense with boxes {{ every: 1h, {options} }}").replace("40m", "0m", 1) + others
    return {name: array[0] for name, array in record(runs(text)[0], "boxes").arrays.items()}


def test_a_box_is_where_pinhole_optics_put_it() -> None:
    sensor = "sense with boxes { every: 1h, at: (1m, 0m, 1.5m), fov: 90deg }"
    text = agent(f"lane: none, {sensor}").replace("40m", "0m", 1) + VAN
    arrays = record(runs(text)[0], "boxes").arrays
    found = {name: array[0] for name, array in arrays.items()}
    assert found["class_id"][:2].tolist() == [SemanticClass.VAN, 0]
    length, width, height = found["size"][0]
    ahead, left, up = found["center"][0]
    assert (ahead, up) == pytest.approx((25.0, height / 2))
    assert abs(found["heading"][0]) < 1e-9
    depth = ahead - 1.0 - length / 2
    edges = [160 - 160 * (left + width / 2) / depth, 160 - 160 * (left - width / 2) / depth]
    assert found["box"][0, [0, 2]] == pytest.approx(edges)
    assert found["box"][0, 1] == pytest.approx(90 - 160 * (height - 1.5) / depth)
    assert found["box"][0, 3] == pytest.approx(90 + 160 * 1.5 / depth)
    assert found["visible"][0] > 0.4  # the far corners are behind the near ones
    assert not any(found[name][1:].any() for name in found)


def test_what_is_hidden_behind_is_not_found() -> None:
    truck = "agent truck is truck on main at 20m { lane: none }\n"
    pole = "object cone is cone on main at 60m { lane: none }\n"
    ego = "lane: none"
    text = agent(f"{ego}, sense with boxes {{ every: 1h }}").replace("40m", "0m", 1)
    seen = record(runs(text + truck + pole)[0], "boxes").arrays["class_id"][0]
    assert seen[:2].tolist() == [SemanticClass.TRUCK, 0]
    alone = record(runs(text + pole)[0], "boxes").arrays["class_id"][0]
    assert alone[:2].tolist() == [SemanticClass.CONE, 0]


def test_boxes_are_sorted_by_distance_and_as_many_as_wanted() -> None:
    cones = "object cones is cone on main at 12m..90m { count: 9, offset: -4m..4m }\n"
    found = boxes("most: 4, range: 80m", cones)
    distance = np.hypot(found["center"][:, 0] - 1.5, found["center"][:, 1])
    assert (found["class_id"] == SemanticClass.CONE).all()
    assert (np.diff(distance) > 0).all()
    behind = boxes("yaw: 180deg", cones)
    assert not behind["class_id"].any()


def test_noise_and_misses_are_as_large_as_stated() -> None:
    text = agent("sense with boxes { every: 20ms, noise: 0.5m, missed: 25% }") + VAN
    drive = runs(text.replace("40m", "0m", 1))[0]
    exact = runs(text.replace("40m", "0m", 1).replace("0.5m, missed: 25%", "0m"))[0]
    noisy, true = (record(one, "boxes").arrays for one in (drive, exact))
    found = noisy["class_id"][:, 0] > 0
    assert 0.6 < found.mean() < 0.9
    error = (noisy["center"] - true["center"])[found, 0]
    assert error.std() == pytest.approx(0.5, rel=0.2)
    assert abs(error.mean()) < 0.15


def test_a_scene_reads_the_same_alone_and_among_others() -> None:
    text = (
        agent("sense with boxes { noise: 0.2m, missed: 10% }")
        + "object cones is cone on main at 10m..99m { count: integer(2, 9), offset: -6m..6m }\n"
    )
    together = [record(drive, "boxes").arrays for drive in runs(text, 3)]
    scenes = testing.sample(text, 3)
    for number in (0, 2):
        scene = scenes[number]
        alone = record(scene.run("builtin", duration=4.0), "boxes").arrays
        for name, array in alone.items():
            np.testing.assert_array_equal(array, together[number][name], name)


def test_boxes_are_observations_of_environments() -> None:
    env = SceneEnv(testing.sample(agent("sense with boxes { most: 3 }") + VAN, 1))
    observation, _ = env.reset(seed=0)
    assert env.observation_space.contains(observation)
    reading = observation["sensors"]["boxes"]
    assert reading["class_id"].tolist() == [SemanticClass.VAN, 0, 0]
    assert math.hypot(*reading["center"][0, :2]) == pytest.approx(25.0, rel=0.1)
