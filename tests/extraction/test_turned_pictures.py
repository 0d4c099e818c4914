"""Pictures whose up is not north, or whose pixels are not square: all that users state and read is
in pixels of the file, and roads are where they are on Earth."""

from __future__ import annotations

import base64
import json
import math
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest
from click.testing import CliRunner

import roadlang
from roadlang.api import OptionError, Picture
from roadlang.cli.extract import command
from roadlang.correcting.picture_roads import PictureRoads
from roadlang.geometry.earth.pixel_map import PixelMap
from roadlang.syntax.correction_edits import WrittenCorrections
from roadlang_standard.photo_hints import boxes_in_picture, check_hints, roads_in_picture

UTM = 'PROJCS["WGS_1984_UTM_Zone_32N",GEOGCS["GCS_WGS_1984"]]'
WIDTH, HEIGHT = 360, 240
LINE = np.column_stack([np.linspace(-20, 380, 2000), 120 + 60 * np.sin(np.linspace(0, 6, 2000))])
"""The middle of the road, in pixels."""
ROAD = 11.3
"""Its width: OpenCV draws a smooth line of 9 pixels so."""


def written(folder: Path, numbers: tuple[float, ...], projection: str) -> Path:
    """A drawing of the road, with a world file: pixels in x, y, their turns, where the first is."""
    pixels = np.full((HEIGHT, WIDTH, 3), 255, np.uint8)
    cv2.polylines(pixels, [np.round(LINE * 16).astype(np.int32)], False, (0, 0, 0), 9, 8, 4)
    cv2.imwrite(str(folder / "plan.png"), pixels)
    (folder / "plan.pgw").write_text("\n".join(map(repr, numbers)))
    (folder / "plan.prj").write_text(projection)
    return folder / "plan.png"


def turned(by: float, size: float = 0.5) -> tuple[float, ...]:
    """A world file of pixels of `size` meters in UTM, up turned to the left of the grid's north."""
    c, s = size * math.cos(by), size * math.sin(by)
    return c, s, s, -c, 700_000.0, 5_330_000.0


DEGREES = (1e-5, 0.0, 0.0, -0.7e-5, 11.6, 48.1)
PLACES: dict[str, tuple[tuple[float, ...], str]] = {
    "of UTM, up to 3 degrees off north": (turned(0.0), UTM),
    "turned by 30 degrees": (turned(math.radians(30.0)), UTM),
    "with its first row in the south": ((0.5, 0.0, 0.0, 0.5, 700_000.0, 5_330_000.0), UTM),
    "of degrees": (DEGREES, 'GEOGCS["GCS_WGS_1984"]'),
}


@pytest.fixture(params=list(PLACES))
def plan(request: Any, tmp_path: Path) -> Path:
    return written(tmp_path, *PLACES[request.param])


def run(*words: Any) -> Any:
    done = CliRunner().invoke(command, [str(word) for word in words])
    assert done.exit_code == 0, done.output
    return done


def away(points: np.ndarray) -> np.ndarray:
    """Pixels from the middle of the road, of points (n, 2) that are not near the rim."""
    points = points[(points[:, 0] > 10.0) & (points[:, 0] < WIDTH - 10.0)]
    return np.array([np.hypot(*(LINE - point).T).min() for point in points])


def test_roads_masks_and_overlays_are_in_pixels_of_the_file(plan: Path) -> None:
    folder = plan.parent
    names = [folder / name for name in ("roads.json", "roads.svg", "mask.png")]
    run(plan, "-o", names[0], "--overlay", names[1], "--mask", names[2])
    document = json.loads(names[0].read_text())
    (line,) = document["polylines"]
    assert away(np.array(line)).max() < 1.0
    assert np.median(document["roads"][0]["widths"]) == pytest.approx(ROAD, abs=0.3)
    assert (document["image"]["width"], document["image"]["height"]) == (WIDTH, HEIGHT)
    assert f'viewBox="-0.5 -0.5 {WIDTH} {HEIGHT}"' in names[1].read_text()
    mask, drawn = (cv2.imread(str(each), 0) for each in (names[2], plan))
    assert mask is not None
    assert drawn is not None
    assert np.mean((mask > 0) == (drawn < 128)) > 0.98


def test_the_size_of_a_pixel_is_that_of_the_file(plan: Path) -> None:
    found = json.loads(run(plan).stdout)
    of_degrees = math.sqrt(1e-5 * 0.7e-5 * math.cos(math.radians(48.1))) * 111_250.0
    expected = of_degrees if "GEOGCS" in (plan.parent / "plan.prj").read_text()[:6] else 0.5
    assert found["meters_per_pixel"] == pytest.approx(expected, rel=2e-3)


def test_geojson_is_where_the_road_is_on_earth(tmp_path: Path) -> None:
    plan = written(tmp_path, *PLACES["of degrees"])
    run(plan, "-o", tmp_path / "roads.geojson")
    (road,) = json.loads((tmp_path / "roads.geojson").read_text())["features"]
    places = np.array(road["geometry"]["coordinates"])
    pixels = (places - (DEGREES[4], DEGREES[5])) / (DEGREES[0], DEGREES[3])
    assert away(pixels).max() < 1.0


SCENE = """image photo from "plan.png"
network town from photo { extract with contour }
agent ego is car on town at random
"""


def scene(plan: Path) -> Path:
    path = plan.parent / "a.rl"
    path.write_text(SCENE)
    return path


def test_corrections_are_stated_in_pixels_of_the_file(plan: Path) -> None:
    roads = PictureRoads.of(scene(plan), plan)
    drawn = ((20.0, 20.0), (200.0, 20.0))
    after = roads.roads(WrittenCorrections(drawn=(drawn,)))
    lines = [np.array(road["points"]) for road in after["roads"]]
    (new,) = (line for line in lines if away(line).max() > 40.0)
    assert np.abs(new[:, 1] - 20.0).max() < 0.2
    assert sorted(new[[0, -1], 0].tolist()) == pytest.approx([20.0, 200.0], abs=0.2)


def test_the_mask_of_a_scene_lies_beneath_its_roads(plan: Path) -> None:
    """Tiles are built from it: rows from north to south, the lower left corner at (0, 0)."""
    (made,) = roadlang.load(scene(plan)).sample(1)
    (network,), (road,) = made.networks.values(), made.roads.values()
    assert network.mask is not None
    assert network.mask_scale is not None
    packed = np.frombuffer(base64.b64decode(network.mask), np.uint8)
    mask = np.asarray(cv2.imdecode(packed, cv2.IMREAD_GRAYSCALE)) > 0
    x, y = np.array([road.x, road.y]) / network.mask_scale
    inside = (x > 0) & (y > 0) & (x < mask.shape[1]) & (y < len(mask))
    columns, rows = x[inside].astype(int), len(mask) - 1 - y[inside].astype(int)
    assert mask[rows, columns].mean() > 0.97
    assert 0.9 < mask.sum() / (ROAD * np.hypot(*np.diff(LINE[100:1900], axis=0).T).sum()) < 1.2


def test_hints_are_stated_in_pixels_of_the_file() -> None:
    """Its rows were doubled to make them square, and run from south to north."""
    file = PixelMap((1.0, 0.0, 0.0, 0.0, -0.5, 99.25), 200, 100)
    picture = Picture(np.zeros((200, 200, 3), np.uint8), 1.0, file=file)
    assert roads_in_picture([(20.0, 10.0)], picture) == ((20.0, 178.5),)
    (box,) = boxes_in_picture([[(20.0, 10.0), (40.0, 30.0)]], picture)
    assert sorted({x for x, _ in box}) == [20.0, 40.0]
    assert sorted({y for _, y in box}) == [138.5, 178.5]
    with pytest.raises(OptionError, match="200 x 100 px"):
        check_hints([(20.0, 150.0)], (), picture)
