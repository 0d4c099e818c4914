"""Scene to top view to extraction to road: the truth is known, so the error is measured."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.spatial import cKDTree

from roadlang import load
from roadlang.api import SceneRoad
from roadlang_formats.surfaces.built import built_roads
from roadlang_godot.build.line import line_of
from roadlang_godot.engines.engine import Engine
from roadlang_godot.rendering.pictures import Shot, build, take
from tests.godot.godot_scenes import bend, pieces, road, scene, straight

pytestmark = pytest.mark.godot

PIXELS, SCALE = 800, 0.35
EXAMPLES = Path(__file__).parents[2] / "examples"


def dense(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    return np.stack([x, y], axis=-1)


def test_a_road_found_in_its_own_picture_is_where_it_was(
    drawing_engine: Engine, tmp_path: Path
) -> None:
    truth = road(
        "main", pieces(straight(50), bend(45, 110), straight(40), bend(-35, 80), straight(30))
    )
    with drawing_engine.connect("round trip") as session:
        layout = build(session, scene(truth))
        picture = take(session, layout, Shot("top", PIXELS, PIXELS, SCALE))
    (tmp_path / "top.png").write_bytes(picture)
    file = tmp_path / "again.rl"
    file.write_text(
        f'image photo from "top.png" {{ scale: {SCALE}m/px }}\n'
        "network found from photo\n"
        "road main from found { select: longest }\n",
        encoding="utf-8",
    )
    made = load(file).sample(1)[0].record
    found = next(one for one in made.roads if one.name == "main")
    # The picture's bottom left corner is the origin of what is read from it.
    corner = np.array([layout.frame.x, layout.frame.y]) - 0.5 * PIXELS * SCALE
    line = line_of(found)
    points = line.at(np.linspace(line.s[0], line.s[-1], 800))[0] + corner
    tree = cKDTree(dense(np.array(truth.x), np.array(truth.y)))
    away, _ = tree.query(points)
    assert away.mean() < 0.5
    # All of it was found, but for a dozen meters at both ends, which thinning shortens.
    back, _ = cKDTree(points).query(dense(np.array(truth.x), np.array(truth.y)))
    assert (back < 1.5).mean() > 0.85


TYPED = '''
image plan from """
......#............
......#............
......#............
......#............
......#............
..#################
..#........#.......
..#........#.......
..#........#.......
..#........#.......
..#........#.......
..##########.......
......#............
......#............
......#............
......#............
""" { scale: 10m/px, legend: { "#": road } }
network main from plan { lanes: 3 }
object ash is tree at (100m, 60m)
object shop is building at (20m, 130m)
agent lorry is truck on main at random {}
'''
"""A town whose dead ends are long: of photos, short ones are taken for driveways."""


@pytest.mark.slow
@pytest.mark.parametrize("name", ["drawn_town", "signals", "typed"])
def test_networks_come_back_from_their_pictures(
    drawing_engine: Engine, tmp_path: Path, name: str
) -> None:
    """With houses, trees, cars, paint and shadows in them, as photos from above."""
    town = EXAMPLES / f"{name}.rl"
    if name == "typed":
        town = tmp_path / "typed.rl"
        town.write_text(TYPED, encoding="utf-8")
    made = load(town).sample(1)[0].record
    with drawing_engine.connect("round trip") as session:
        layout = build(session, made)
        picture = take(session, layout, Shot("top", PIXELS, PIXELS, SCALE))
    (tmp_path / "top.png").write_bytes(picture)
    file = tmp_path / "again.rl"
    file.write_text(
        f'image photo from "top.png" {{ scale: {SCALE}m/px }}\nnetwork found from photo\n',
        encoding="utf-8",
    )
    corner = np.array([layout.frame.x, layout.frame.y]) - 0.5 * PIXELS * SCALE
    truth, found = built_roads(made), load(file).sample(1)[0].record.roads
    assert len(found) == len(truth)
    there, back = along(truth), along(found) + corner
    assert (cKDTree(back).query(there)[0] < 1.5).mean() > 0.95
    assert (cKDTree(there).query(back)[0] < 1.5).mean() > 0.95


def along(roads: tuple[SceneRoad, ...]) -> np.ndarray:
    """Points half a meter apart along all roads (n, 2)."""
    lines = []
    for one in roads:
        at = np.arange(0.0, one.stations[-1], 0.5)
        lines.append(dense(*(np.interp(at, one.stations, v) for v in (one.x, one.y))))
    return np.concatenate(lines)
