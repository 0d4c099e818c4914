"""Masks of roads: where the surface is, and the network that is read back from them."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
import pytest
from scipy.spatial import cKDTree

from roadlang import load
from roadlang.api import DiagnosticError, Scene, SceneRoad
from roadlang.geometry import Floats
from roadlang_formats.road_mask import road_mask
from roadlang_formats.surfaces.built import built_roads

EXAMPLES = Path(__file__).parents[2] / "examples"
STRAIGHT = (
    "road main {\n  draw with waypoints { points: [(10m, 20m), (90m, 20m)] }\n  width: 8m\n}\n"
)


def _scene(path: Path, text: str) -> Scene:
    path.write_text(text, encoding="utf-8")
    return load(path).sample(1)[0].record


def test_roads_are_white_where_the_world_file_says(tmp_path: Path) -> None:
    scene = _scene(tmp_path / "a.rl", STRAIGHT)
    mask = road_mask(scene, 0.5, 10.0)
    pixels = cv2.imdecode(np.frombuffer(mask.png(), np.uint8), cv2.IMREAD_GRAYSCALE)
    rows, columns = np.nonzero(pixels)
    right, _, _, down, x, y = map(float, mask.world_file().split())
    assert (right, down) == (0.5, -0.5)
    assert [x + right * columns.min(), x + right * columns.max()] == pytest.approx([10, 90], abs=1)
    assert [y + down * rows.max(), y + down * rows.min()] == pytest.approx([16, 24], abs=0.5)
    assert pixels.shape == (56, 200)


def test_a_picture_that_is_too_large_is_refused(tmp_path: Path) -> None:
    scene = _scene(tmp_path / "a.rl", STRAIGHT)
    with pytest.raises(DiagnosticError, match=r"RL480.*20000 x"):
        road_mask(scene, 0.005, 10.0)


@pytest.mark.parametrize(
    ("name", "share"), [("drawn_town", 0.97), ("signals", 0.99), ("typed_town", 0.97)]
)
def test_networks_come_back_from_their_masks(tmp_path: Path, name: str, share: float) -> None:
    """Of the length of the roads so much is found within 1.5 m, and nothing else."""
    scene = load(EXAMPLES / f"{name}.rl").sample(1)[0].record
    mask = road_mask(scene, 0.5, 10.0)
    (tmp_path / "top.png").write_bytes(mask.png())
    (tmp_path / "top.pgw").write_text(mask.world_file())
    found = _scene(
        tmp_path / "again.rl",
        'image top from "top.png" { legend: { "white": road } }\n'
        "network town from top { extract with pixels }\n",
    )
    truth = built_roads(scene)
    assert len(found.roads) == len(truth)
    there, back = _points(truth), _points(found.roads, mask.left, mask.bottom)
    assert (cKDTree(back).query(there)[0] < 1.5).mean() >= share
    assert (cKDTree(there).query(back)[0] < 1.5).mean() >= 0.99


def _points(roads: tuple[SceneRoad, ...], left: float = 0.0, bottom: float = 0.0) -> Floats:
    """(n, 2) points half a meter apart along all roads, moved by a corner."""
    lines = []
    for road in roads:
        at = np.arange(0.0, road.stations[-1], 0.5)
        lines.append(np.stack([np.interp(at, road.stations, v) for v in (road.x, road.y)], axis=-1))
    return np.asarray(np.concatenate(lines) + np.array([left, bottom]))
