"""`then:`: roads of any origin end to end, as one road of the scene."""

from __future__ import annotations

from collections.abc import Callable

import pytest

import roadlang
from roadlang import DiagnosticError, testing
from roadlang.ir.scene import Scene, SceneRoad
from roadlang.scenes.sampling import SamplingResult

Sample = Callable[..., SamplingResult]

HEADER = """
road wide {
  draw with segments { pieces: [straight(100m)] }
  lanes: 3, oneway: true, speed_limit: 100km/h
}
road narrow {
  draw with segments { pieces: [straight(80m)] }
  lanes: 2, oneway: true, speed_limit: 60km/h
}
"""


def scenes(text: str, sample: Sample, count: int = 1) -> list[Scene]:
    return list(sample(text, count).scenes)


def road(scene: Scene, name: str) -> SceneRoad:
    return next(road for road in scene.roads if road.name == name)


def test_the_parts_are_not_built_but_the_whole_is(sample: Sample) -> None:
    (scene,) = scenes(HEADER + "road both from wide { then: narrow }", sample)
    assert {road.name: road.derived for road in scene.roads} == {
        "wide": False, "narrow": False, "both": True,
    }  # fmt: skip
    both = road(scene, "both")
    assert both.length == pytest.approx(180.0)
    assert both.root == "both"


def test_speed_limits_are_those_of_the_parts(sample: Sample) -> None:
    text = HEADER + "road both from wide { then: [narrow, wide] }"
    zones = road(scenes(text, sample)[0], "both").speed_zones
    assert [(zone.start, zone.speed_limit) for zone in zones] == [
        pytest.approx((0.0, 100 / 3.6)),
        pytest.approx((100.0, 60 / 3.6)),
        pytest.approx((180.0, 100 / 3.6)),
    ]


def test_a_limit_of_the_whole_replaces_those_of_the_parts(sample: Sample) -> None:
    text = HEADER + "road both from wide { then: narrow, speed_limit: 50km/h }"
    both = road(scenes(text, sample)[0], "both")
    assert both.speed_zones == ()
    assert both.speed_limit == pytest.approx(50 / 3.6)


def test_a_joined_road_can_be_perturbed_as_any_other(sample: Sample) -> None:
    text = HEADER + (
        "road both from wide { then: narrow }\n"
        "road swayed from both { perturb with sine { amplitude: 2m..4m, wavelength: 90m } }\n"
        "require near: always (deviation(swayed, both) < 5m)"
    )
    for scene in scenes(text, sample, 3):
        assert road(scene, "swayed").root == "both"
        assert len(road(scene, "swayed").speed_zones) == 2


def test_a_part_that_is_drawn_at_random_differs_between_scenes(sample: Sample) -> None:
    text = HEADER + (
        "road bent from narrow { perturb with bump { at: 40m, height: 1m..6m, length: 60m } }\n"
        "road both from wide { then: bent }"
    )
    lengths = {round(road(scene, "both").length, 6) for scene in scenes(text, sample, 4)}
    assert len(lengths) == 4


def test_the_end_of_a_perturbed_part_is_where_the_next_begins(sample: Sample) -> None:
    text = HEADER + (
        "road bent from wide { perturb with shift { at: 20m, offset: 6m, length: 50m } }\n"
        "road both from bent { then: narrow }"
    )
    both = road(scenes(text, sample)[0], "both")
    assert both.y[-1] == pytest.approx(6.0, abs=0.05)


def test_joined_roads_can_be_joined(sample: Sample) -> None:
    text = HEADER + (
        "road both from wide { then: narrow }\nroad more from both { then: [both, narrow] }"
    )
    more = road(scenes(text, sample)[0], "more")
    assert more.length == pytest.approx(440.0)
    assert len(more.speed_zones) == 4


@pytest.mark.parametrize("driver", ["lane_follow", "traffic"])
def test_an_agent_obeys_the_limit_where_it_drives(driver: str) -> None:
    text = HEADER + (
        "road street from wide { then: [narrow, wide] }\n"
        "agent ego is car on street at 5m { lane: -1, start_speed: 70km/h, drive with "
        + driver
        + " }"
    )
    (scene,) = roadlang.loads(text).sample()
    ego = scene.run(duration=30.0).trace.agents["ego"]
    inside = (ego.station > 100.0) & (ego.station < 180.0)
    assert ego.speed[inside].max() < 60 / 3.6 + 0.3
    assert ego.speed_limit[inside] == pytest.approx(60 / 3.6)
    assert ego.speed[ego.station > 230.0].max() > 70 / 3.6


def test_a_loop_cannot_be_joined() -> None:
    loop = "draw with waypoints { points: [(0m, 0m), (80m, 0m), (40m, 60m)] }, closed: true"
    text = HEADER + f"road loop {{ {loop} }}\nroad both from wide {{ then: loop }}\n"
    with pytest.raises(DiagnosticError) as caught:
        testing.sample(text)
    (found,) = caught.value.diagnostics
    assert found.code == "RL432"
