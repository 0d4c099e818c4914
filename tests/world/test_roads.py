"""Roads: where they come from, and passes in the order written."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from roadlang.diagnostics import DiagnosticError
from roadlang.ir.scene import SceneRoad
from roadlang.scenes.sampling import SamplingResult
from tests.straight_road import STRAIGHT

Sample = Callable[..., SamplingResult]


def last_road(sample: Sample, text: str) -> SceneRoad:
    return sample(text).scenes[0].roads[-1]


def bent(*passes: str) -> str:
    return STRAIGHT + "road bent from main {\n" + "\n".join(passes) + "\n}\n"


def test_pieces_are_laid_end_to_end(sample: Sample) -> None:
    road = last_road(
        sample,
        "road street { draw with segments {"
        " pieces: [straight(50m), clothoid(30m, to: 0.02/m), arc(50m, 90deg), straight(20m)] } }",
    )
    length = 50 + 30 + 50 * np.pi / 2 + 20
    assert road.length == pytest.approx(length, rel=1e-4)
    assert road.heading[-1] == pytest.approx(30 * 0.02 / 2 + np.pi / 2, abs=1e-3)
    middle = np.searchsorted(road.stations, 50 + 30 + 40)
    assert road.curvature[middle] == pytest.approx(1 / 50, rel=1e-3)


def test_a_drawn_road_may_close(sample: Sample) -> None:
    ring = "(50m, 0m), (0m, 50m), (-50m, 0m), (0m, -50m)"
    text = f"road track {{ draw with waypoints {{ points: [{ring}] }}, closed: true }}"
    road = last_road(sample, text)
    assert road.closed
    assert road.length == pytest.approx(2 * np.pi * 50, rel=0.02)


def test_a_lane_change_by_waypoints_does_not_swing_out(sample: Sample) -> None:
    points = "(0m, 1.9m), (60m, 1.9m), (100m, 1.9m), (140m, -1.9m), (180m, -1.9m), (600m, -1.9m)"
    text = f"road path {{ draw with waypoints {{ points: [{points}] OPTIONS }} }}"
    assert max(map(abs, last_road(sample, text.replace("OPTIONS", "")).y)) < 2.1
    road = last_road(sample, text.replace("OPTIONS", ", curve: polyline, radius: 150m"))
    assert max(map(abs, road.y)) <= 1.9 + 1e-6
    assert max(map(abs, road.curvature)) == pytest.approx(1 / 150, rel=0.02)
    assert road.x[-1] == pytest.approx(600)


def test_the_displacement_is_to_the_left(sample: Sample) -> None:
    road = last_road(sample, bent("perturb with bump { at: 100m, height: 3m, length: 80m }"))
    assert max(road.y) == pytest.approx(3, abs=1e-3)
    assert min(road.y) == pytest.approx(0, abs=1e-9)


def test_a_stretch_ends_where_it_says(sample: Sample) -> None:
    wave = "perturb with sine { amplitude: 3m, wavelength: 30m, over: [50m, 120m], taper: 15m }"
    road = last_road(sample, bent(wave))
    outside = [y for s, y in zip(road.reference_stations, road.y, strict=True) if not 50 < s < 120]
    inside = [y for s, y in zip(road.reference_stations, road.y, strict=True) if 65 < s < 105]
    assert max(map(abs, outside)) < 1e-9
    assert max(inside) == pytest.approx(3, abs=0.05)


def test_passes_add_up_in_their_order(sample: Sample) -> None:
    first = "perturb with bump { at: 60m, height: 2m, length: 60m }"
    second = "perturb with bump { at: 140m, height: -3m, length: 60m }"
    road = last_road(sample, bent(first, second))
    assert max(road.y) == pytest.approx(2, abs=1e-2)
    assert min(road.y) == pytest.approx(-3, abs=1e-2)
    text = bent(first, second) + "require e: always (deviation(bent, main) <= 3.001m)\n"
    (scene,) = sample(text).scenes
    assert scene.requirements[0].robustness == pytest.approx(0.001, abs=2e-3)


@pytest.mark.parametrize("interval", ["[500m, 600m]", "[50m, 50m]", "[50.3m, 50.3m]"])
def test_an_interval_that_holds_no_part_of_the_road_is_refused(
    sample: Sample, interval: str
) -> None:
    """Beyond the end, or without length, whether or not there is a station."""
    with pytest.raises(DiagnosticError) as caught:
        sample(bent(f"perturb with sine {{ amplitude: 1m, wavelength: 30m, over: {interval} }}"))
    errors = [found for found in caught.value.diagnostics if found.is_error]
    assert [error.code for error in errors] == ["RL414"]


def test_a_road_that_folds_is_never_a_scene(sample: Sample) -> None:
    text = """
road main { draw with segments { pieces: [straight(40m), arc(10m, 120deg), straight(40m)] } }
road bent from main { perturb with bump { at: 50m, height: 0m..30m, length: 60m } }
"""
    result = sample(text, 20)
    assert all(scene.draws["bent/perturb 1/height"] < 10.5 for scene in result.scenes)
    assert any("does not fold" in row.text for row in result.table)


def test_width_and_lanes_are_inherited(sample: Sample) -> None:
    text = (
        "road main { draw with waypoints { points: [(0m, 0m), (99m, 0m)] }, width: 9m, lanes: 3 }\n"
        "road bent from main { perturb with sine { amplitude: 1m, wavelength: 50m } }\n"
    )
    road = last_road(sample, text)
    assert set(road.width) == {9.0}
    assert road.lanes == 3


def test_roads_of_different_roots_are_compared_by_the_nearest_point(sample: Sample) -> None:
    text = (
        STRAIGHT
        + """
road other { draw with waypoints { points: [(-10m, 6m), (210m, 6m)] } }
require apart: always (distance(main, other) > 5m)
require lp: lp_distance(main, other, 1) < 1300m^2
require sup: sup_distance(main, other) < 7m
"""
    )
    verdicts = {v.name: v.robustness for v in sample(text).scenes[0].requirements}
    assert verdicts["apart"] == pytest.approx(1, abs=1e-6)
    assert verdicts["lp"] == pytest.approx(100, abs=1e-3)
    assert verdicts["sup"] == pytest.approx(1, abs=1e-6)


def test_a_violated_expectation_tells_the_stretch(sample: Sample) -> None:
    text = bent("perturb with bump { at: 100m, height: 3m, length: 80m }")
    (scene,) = sample(text + "expect near: always (deviation(bent, main) < 1m)\n").scenes
    (verdict,) = scene.expectations
    assert verdict.satisfied is False
    assert verdict.robustness == pytest.approx(-2, abs=1e-3)
    (stretch,) = verdict.violated
    assert stretch.road == "bent"
    assert 60 < stretch.start < 100 < stretch.end < 140
    assert stretch.start + stretch.end == pytest.approx(200, abs=1)


def test_a_track_of_a_table_keeps_its_digest(sample: Sample, tmp_path: Path) -> None:
    (tmp_path / "track.csv").write_text("x,y,width\n0,0,6\n50,0,7\n100,0,8\n")
    (scene,) = sample('road main from "track.csv"\n').scenes
    assert scene.roads[0].width[0] == pytest.approx(6)
    assert len(scene.provenance.inputs["track.csv"]) == 64


def test_a_bump_into_the_center_of_a_bend_is_no_scene(sample: Sample) -> None:
    text = """
road main { draw with segments { pieces: [straight(30m), arc(5m, 170deg), straight(30m)] } }
road bent from main { perturb with bump { at: 37m, height: HEIGHT, length: 60m } }
"""
    assert sample(text.replace("HEIGHT", "3m")).accepted == 1
    assert sample(text.replace("HEIGHT", "4.99m")).accepted == 0
    again = text.replace("perturb", "perturb with bump { at: 5m, height: 1m, length: 8m } perturb")
    assert sample(again.replace("HEIGHT", "3m")).accepted == 1
    assert sample(again.replace("HEIGHT", "4.99m")).accepted == 0


def test_the_length_of_a_road_is_its_last_station_and_of_a_loop_a_step_more(sample: Sample) -> None:
    bump = "perturb with bump { at: 100m, height: 3m, length: 80m }"
    open_road = last_road(sample, bent(bump))
    assert open_road.length == pytest.approx(open_road.stations[-1], rel=1e-12)
    pieces = "straight(40m), arc(30m, 180deg), straight(40m), arc(30m, 180deg)"
    loop = last_road(
        sample, f"road ring {{ draw with segments {{ pieces: [{pieces}] }}, closed: true }}"
    )
    step = np.hypot(loop.x[0] - loop.x[-1], loop.y[0] - loop.y[-1])
    assert loop.length == pytest.approx(loop.stations[-1] + step, rel=1e-4)
