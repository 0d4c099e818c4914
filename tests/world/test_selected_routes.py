"""Roads selected from a network: what they run over, and how one drives on them."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roadlang.ir.scene import Scene, SceneRoad
from roadlang.scenes.sampling import SamplingResult
from tests.route_geometry import faults_of
from tests.world.test_routes import DRIVES, agent, town

Sample = Callable[..., SamplingResult]
TOUR = "road tour from town { select: route((10m, 54m), (100m, 18m)) }\n"


def scene_of(sample: Sample, text: str, options: str = "lanes: 2") -> Scene:
    (scene,) = sample(town(options, scale=12) + text).scenes
    return scene


def road(scene: Scene, name: str) -> SceneRoad:
    return next(item for item in scene.roads if item.name == name)


def test_a_selected_road_says_what_it_runs_over(sample: Sample) -> None:
    tour = road(scene_of(sample, TOUR), "tour")
    roads = [part.road for part in tour.along]
    assert len(roads) == 3
    assert all(name.startswith("town/") for name in roads)
    assert sum(abs(part.stop - part.start) for part in tour.along) == pytest.approx(
        tour.length, abs=10.0
    )


def test_nothing_is_built_twice(sample: Sample) -> None:
    """A road over a network that is built is none itself; a bent one stands for the network."""
    scene = scene_of(sample, TOUR)
    assert not road(scene, "tour").derived
    assert all(item.derived for item in scene.roads if item.network)
    bend = "road bent from tour { perturb with sine { amplitude: 1m, wavelength: 60m } }"
    bent = scene_of(sample, TOUR + bend)
    assert [item.name for item in bent.roads if item.derived] == ["bent"]
    assert road(bent, "bent").along == ()


def test_who_drives_on_a_selected_road_follows_the_lanes_of_the_network(sample: Sample) -> None:
    scene = scene_of(sample, TOUR + f"agent ego is car on tour at 6m {{ {DRIVES} }}")
    ego, tour = agent(scene), road(scene, "tour")
    assert ego.route is not None
    assert not faults_of(scene, ego.route)
    assert list(dict.fromkeys(step.road for step in ego.route.steps)) == [
        part.road for part in tour.along
    ]
    assert (ego.road, ego.lane) == (ego.route.steps[0].road, ego.route.steps[0].lane)


def test_who_faces_back_drives_the_other_way_round(sample: Sample) -> None:
    scene = scene_of(sample, TOUR + f"agent ego is car on tour at 95% {{ facing: back, {DRIVES} }}")
    ego, tour = agent(scene), road(scene, "tour")
    assert ego.route is not None
    assert not faults_of(scene, ego.route)
    assert list(dict.fromkeys(step.road for step in ego.route.steps)) == [
        part.road for part in reversed(tour.along)
    ]


@pytest.mark.parametrize(
    "text",
    [
        "road tour from town { select: route((10m, 54m), (100m, 18m)), width: 6m }\n"
        f"agent ego is car on tour at 6m {{ {DRIVES} }}",
        TOUR + "agent ego is car on tour at 6m",
        TOUR + f"agent ego is car on tour at 6m {{ lane: none, {DRIVES} }}",
        TOUR
        + "road bent from tour { perturb with sine { amplitude: 1m, wavelength: 60m } }\n"
        + f"agent ego is car on bent at 6m {{ {DRIVES} }}",
    ],
    ids=["with a width of its own", "standing", "in no lane", "on a bent road"],
)
def test_others_keep_to_the_road(sample: Sample, text: str) -> None:
    ego = agent(scene_of(sample, text))
    assert ego.route is None
    assert ego.road in ("tour", "bent")
