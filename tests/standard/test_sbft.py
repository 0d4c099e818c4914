"""Roads of the SBFT tool competition: points, interpolation, rules."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.interpolate import splev, splprep

import roadlang
from roadlang import testing
from roadlang_standard.sbft.interpolation import interpolated
from roadlang_standard.sbft.road_points import road_points
from roadlang_standard.sbft.rules import LEAST_RADIUS, judged

Floats = np.ndarray[Any, np.dtype[np.float64]]


def arc(radius: float, turn: float, count: int = 60) -> tuple[Floats, Floats]:
    """A road (1, S, 2) on a circle, and its headings."""
    angle = np.linspace(0.0, turn, count)
    points = radius * np.stack((np.sin(angle), 1.0 - np.cos(angle)), axis=-1)
    return points[None], angle[None]


def rules(points: Floats, heading: Floats, size: float = 200.0, centered: bool = True) -> Any:
    ((_, found),) = road_points(points, heading, 5.0, size, centered)
    return judged(found, size)


def random_roads(count: int, seed: int) -> tuple[Floats, Floats]:
    random = np.random.default_rng(seed)
    t = np.linspace(0.0, 1.0, 400)
    waves = sum(
        random.normal(size=(count, 1))
        * np.sin(2 * np.pi * k * t + random.uniform(0, 7, (count, 1)))
        for k in range(1, 6)
    )
    sharpest = 1.0 / random.uniform(13.0, 40.0, (count, 1))
    curvature = waves / np.abs(waves).max(axis=1, keepdims=True) * sharpest
    step = random.uniform(150.0, 450.0, (count, 1)) / len(t)
    heading = np.cumsum(curvature * step, axis=1)
    x, y = np.cumsum(np.cos(heading) * step, axis=1), np.cumsum(np.sin(heading) * step, axis=1)
    return np.stack((x, y), axis=-1), heading


def test_the_interpolation_is_that_of_fitpack() -> None:
    for rows, points in road_points(*random_roads(20, 0), 5.0, 200.0, True):
        nodes, counts = interpolated(points)
        for row in range(len(rows)):
            spline, _ = splprep(points[row].T, s=0, k=3)
            length = np.hypot(*np.diff(points[row], axis=0).T).sum()
            step = 1.0 / int(length)
            expected = np.array(splev(np.arange(0, 1 + step, step), spline)).T
            assert counts[row] == len(expected)
            assert np.abs(nodes[row, : counts[row]] - expected).max() < 6e-4  # rounded to 1 mm


@pytest.mark.parametrize(("radius", "fits"), [(13.9, False), (14.8, True), (40.0, True)])
def test_bends_need_a_radius_of_47_feet(radius: float, fits: bool) -> None:
    found = rules(*arc(radius, math.pi))
    assert bool(found.robustness[0] >= 0.0) is fits
    assert found.radius[0] + LEAST_RADIUS == pytest.approx(radius, rel=0.04)  # of nodes in mm


def test_the_whole_width_has_to_be_inside_the_map() -> None:
    heading = np.zeros((1, 50))
    x = np.linspace(0.0, 150.0, 50)
    for y, inside in ((5.0, 1.0), (3.0, -1.0), (197.0, -1.0)):
        points = np.stack((x + 20.0, np.full(50, y)), axis=-1)[None]
        assert rules(points, heading, centered=False).inside[0] == pytest.approx(inside)
    outside = np.stack((x + 300.0, np.full(50, 300.0)), axis=-1)[None]
    assert rules(outside, heading, centered=False).robustness[0] < 0.0
    assert rules(outside, heading).inside[0] == pytest.approx(25.0)


def test_a_road_may_not_meet_itself() -> None:
    loop = rules(*arc(30.0, 2.2 * math.pi, 200))
    assert loop.apart[0] < 0.0
    spiral_angle = np.linspace(0.0, 2.6 * math.pi, 300)
    for gain, meets in ((2.0, False), (1.0, True)):
        radius = 20.0 + gain * spiral_angle
        points = np.stack((radius * np.cos(spiral_angle), radius * np.sin(spiral_angle)), axis=-1)
        heading = np.unwrap(np.arctan2(*np.gradient(points, axis=0).T[::-1]))
        found = rules(points[None], heading[None])
        assert bool(found.apart[0] < 0.0) is meets
        if not meets:
            assert found.apart[0] == pytest.approx(gain * 2 * math.pi - 8.0, abs=0.8)


def test_a_road_is_longer_than_20_meters() -> None:
    for length, fits in ((18.0, False), (25.0, True)):
        x = np.linspace(0.0, length, 20)
        points = np.stack((x, np.zeros(20)), axis=-1)[None]
        assert bool(rules(points, np.zeros((1, 20))).robustness[0] >= 0.0) is fits


def test_many_roads_are_judged_as_each_alone() -> None:
    points, heading = random_roads(300, 5)
    together = np.empty(300)
    for rows, found in road_points(points, heading, 5.0, 200.0, True):
        together[rows] = judged(found, 200.0).robustness
    for row in range(0, 300, 37):
        alone = rules(points[[row]], heading[[row]]).robustness[0]
        assert alone == pytest.approx(together[row])
    assert 50 < (together >= 0.0).sum() < 250


FILE = """
road main { draw with waypoints { points: [(0m, 0m), (60m, 0m), (120m, 50m), (120m, 110m)] } }
road bent from main {
  perturb with sine { amplitude: -25m..25m, wavelength: 45m..90m, taper: 20m }
}
require valid with sbft { road: bent }
emit sbft
"""


def test_what_is_required_is_what_is_written(tmp_path: Path) -> None:
    scenes = testing.sample(FILE, 5)
    assert scenes.candidates > 5
    scenes.emit(tmp_path)
    for scene in scenes:
        points = np.array(json.loads((tmp_path / f"scene-{scene.index:04}.sbft.json").read_text()))
        assert points.shape[1] == 2
        assert points.min() > 4.0
        assert points.max() < 196.0
        written = judged(points[None], 200.0).robustness[0]
        required = scene.requirements["valid"].robustness
        assert required is not None
        assert required >= 0.0
        assert written == pytest.approx(required, abs=0.02)


def test_another_road_than_that_of_the_first_agent(tmp_path: Path) -> None:
    text = FILE.replace("emit sbft", 'emit sbft { road: "main", centered: false, spacing: 10m }')
    testing.sample(text, 1).emit(tmp_path)
    points = json.loads((tmp_path / "scene-0000.sbft.json").read_text())
    assert points[0] == [0.0, 0.0]
    assert points[-1] == [120.0, 110.0]
    with pytest.raises(
        roadlang.DiagnosticError, match=r"it has no road `mian`; did you mean `main`\?"
    ):
        testing.sample(text.replace('"main"', '"mian"'), 1).emit(tmp_path)


@pytest.mark.parametrize(
    "gaps",
    [
        [5.0] * 6,
        [1.0, 1.0, 1.0, 1.0, 60.0, 9.0, 1.0],
        [60.0, 9.0, 1.0, 1.0, 1.0, 1.0],
        [40.0, 1.0, 1.0, 40.0, 1.0, 1.0, 40.0],
        [2.0, 3.0, 2.0],
    ],
)
def test_points_may_be_anything_but_even(gaps: list[float]) -> None:
    """Where a parameter is many pieces away from where it would be between even points."""
    x = np.concatenate(([0.0], np.cumsum(gaps)))
    points = np.stack((x, 4.0 * np.sin(x / 9.0)), axis=-1)
    both = np.stack((points, points[:, ::-1]))
    nodes, counts = interpolated(both)
    spline, _ = splprep(points.T, s=0, k=3)
    whole = int(np.hypot(*np.diff(points, axis=0).T).sum())
    step = 1.0 / max(whole, 20)
    expected = np.array(splev(np.arange(0, 1 + step, step), spline)).T
    assert list(counts) == [len(expected)] * 2
    for found, wanted in zip(nodes, (expected, expected[:, ::-1]), strict=True):
        assert np.abs(found - wanted).max() < 6e-4


@pytest.mark.parametrize(
    ("points", "options", "reason"),
    [
        ("(0m, 0m), (600m, 0m)", "", "leaves the map of 200 m by 200 m by 200 m"),
        ("(0m, 0m), (150m, 0m)", ", centered: false", "`centered: true` moves it to the middle"),
        ("(0m, 0m), (15m, 0m)", "", "it is 15 m long; at least 20 m is required"),
        ("(0m, 0m), (1500m, 0m)", ", spacing: 1m, size: 2000m", "increase `spacing`"),
        ("(0m, 0m), (50m, 0m), (50m, 20m), (0m, 20m)", "", "at least 14.33 m is required"),
        ("(0m, 0m), (100m, 0m), (140m, 40m), (100m, 80m), (60m, 40m), (60m, -50m)", "", "overlap"),
    ],
)
def test_a_road_that_is_refused_is_told_which_rule_it_breaks(
    points: str, options: str, reason: str
) -> None:
    text = f"""road main {{ draw with waypoints {{ points: [{points}] }} }}
require valid with sbft {{ road: main{options} }}
"""
    with pytest.raises(roadlang.NoSceneError) as raised:
        roadlang.loads(text).sample()
    assert "no draw can satisfy `valid` (with sbft)" in str(raised.value)
    assert reason in str(raised.value)


ROAD = "road main { draw with waypoints { points: [(0m, 0m), (150m, 0m)] } }\n"


@pytest.mark.parametrize(
    ("statement", "code", "help"),
    [
        ("require with sbft { road: main }", "RL023", "write `require NAME with ...`"),
        ("require valid: sbft(main)", "RL225", "write `require NAME with sbft { ... }`"),
        ("require valid: sbft", "RL101", "write `require NAME with sbft { ... }`"),
        ("emit sbft { road: main }", "RL206", 'write `"main"`'),
    ],
)
def test_statements_that_are_nearly_right_are_told_the_form(
    statement: str, code: str, help: str
) -> None:
    (found,) = testing.check(ROAD + statement)
    assert found.code == code
    assert any(help in line for line in found.help)


def test_a_network_is_no_road() -> None:
    network = 'image i from """\n#######\n""" { scale: 9m/px }\nnetwork town from i\n'
    (found,) = testing.check(network + "require valid with sbft { road: town }")
    assert found.code == "RL228"
    assert found.help == ("`road NAME from town { select: longest }` makes a road of it",)
    (found,) = testing.check(network + 'emit sbft { road: "town" }')
    assert found.message.endswith('`town` is a network: name one of its roads, as in `"town/ID"`')
