"""What a scene records of how it came to be: its draws, its input files, remarks of extractors."""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from pathlib import Path

import cv2
import numpy as np
import pytest

from roadlang.scenes.sampling import SamplingResult
from tests.straight_road import STRAIGHT

Sample = Callable[..., SamplingResult]
PERTURBED = (
    STRAIGHT + "road wavy from main { perturb with sine { amplitude: 0m..2m, wavelength: 80m } }\n"
)
DRAWN_SCALE = '''
image plan from """
  ##########
""" { scale: 9m/px..11m/px }
network lane from plan
road main from lane
'''


def test_a_draw_inside_a_requirement_is_recorded(sample: Sample) -> None:
    text = PERTURBED + "require near: always (deviation(wavy, main) < 3m..5m)\n"
    (scene,) = sample(text).scenes
    limits = [value for name, value in scene.draws.items() if name.startswith("near")]
    (limit,) = limits
    assert 3.0 <= limit <= 5.0
    largest = max(map(abs, scene.roads[1].y))
    assert scene.requirements[0].robustness == pytest.approx(limit - largest, abs=1e-6)


def test_nothing_is_drawn_for_the_copies_that_a_group_does_not_have(sample: Sample) -> None:
    text = (
        STRAIGHT
        + "agent ego is car on main at 10m\n"
        + "agent queue is car on main at 50%..100% { count: integer(0, 2) }\n"
        + "require apart: queue.start - ego.start > 20m\n"
    )
    for scene in sample(text, 8).scenes:
        copies = [name for name in scene.draws if name.startswith("queue/at")]
        assert len(copies) == scene.draws["queue/count"]


def test_the_files_behind_roads_are_recorded_with_their_digests(
    sample: Sample, tmp_path: Path
) -> None:
    content = "x,y\n0,0\n50,1\n100,0\n150,3\n"
    (tmp_path / "line.csv").write_text(content)
    (scene,) = sample('road main from "line.csv"\n').scenes
    digest = hashlib.sha256(content.encode()).hexdigest()
    assert dict(scene.provenance.inputs) == {"line.csv": digest}


def test_the_world_file_that_a_scale_is_from_is_recorded(sample: Sample, tmp_path: Path) -> None:
    (tmp_path / "maps").mkdir()
    pixels = np.full((80, 200, 3), 255, np.uint8)
    cv2.line(pixels, (0, 40), (199, 40), (0, 0, 0), 9)
    cv2.imwrite(str(tmp_path / "maps/town.png"), pixels)
    scale = "0.5\n0\n0\n-0.5\n1000\n2000\n"
    (tmp_path / "maps/town.pgw").write_text(scale)
    text = 'image drawing from "maps/town.png"\nnetwork town from drawing\n'
    (scene,) = sample(text + "road main from town { select: longest }\n").scenes
    inputs = scene.provenance.inputs
    assert list(inputs) == ["maps/town.pgw", "maps/town.png"]
    assert inputs["maps/town.pgw"] == hashlib.sha256(scale.encode()).hexdigest()
    assert scene.roads[0].length == pytest.approx(100, abs=5)


def test_remarks_of_networks_that_differ_between_scenes_are_reported(sample: Sample) -> None:
    assert "read as a typed grid" in sample(DRAWN_SCALE, 2).remarks


@pytest.mark.slow
def test_workers_change_neither_provenance_nor_remarks(sample: Sample) -> None:
    alone, together = sample(DRAWN_SCALE, 40, jobs=1), sample(DRAWN_SCALE, 40, jobs=2)
    assert [s.provenance for s in together.scenes] == [s.provenance for s in alone.scenes]
    assert together.remarks == alone.remarks


def test_a_typed_ring_that_meets_no_other_road_is_a_scene(sample: Sample) -> None:
    plan = 'image plan from """\n  ###\n  #.#\n  ###\n""" { scale: 8m/px }\n'
    (scene,) = sample(plan + "network town from plan\n").scenes
    (road,) = scene.roads
    assert road.closed
    assert road.length == pytest.approx(32 + 8 * np.pi, rel=2e-3)  # of chords


def test_a_part_of_the_day_is_a_time(sample: Sample) -> None:
    (scene,) = sample("world { time_of_day: dusk, weather: rain }").scenes
    assert dict(scene.world) == {"time_of_day": 18 * 3600.0, "weather": "rain"}
