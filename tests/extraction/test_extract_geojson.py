"""`roadlang extract -o roads.geojson`: roads in longitude and latitude."""

from __future__ import annotations

import json
from pathlib import Path

import cv2
import numpy as np
import pytest
from click.testing import CliRunner, Result

from roadlang.cli.extract import command
from roadlang.diagnostics import DiagnosticError
from roadlang.geometry.earth.local_projection import LocalProjection
from tests.geometry.test_local_projection import kruger
from tests.images.geotiffs import written_geotiff

HEIGHT, WIDTH = 240, 320
ROW = 70
"""Rows from the top to the middle of the road, pixel corners."""


def mask() -> np.ndarray:
    pixels = np.zeros((HEIGHT, WIDTH), np.uint8)
    pixels[ROW - 4 : ROW + 4] = 255
    return pixels


def extracted(*words: object) -> Result:
    words = (*words, "--with", "contour")
    return CliRunner().invoke(command, [str(word) for word in words], catch_exceptions=True)


def road_of(path: Path) -> tuple[dict[str, object], np.ndarray]:
    (feature,) = json.loads(path.read_text())["features"]
    return feature["properties"], np.array(feature["geometry"]["coordinates"])


@pytest.mark.parametrize(("latitude", "longitude"), [(48.1, 11.5), (-33.9, 151.2), (0.0, -179.999)])
def test_a_road_is_where_the_stated_corner_puts_it(
    tmp_path: Path, latitude: float, longitude: float
) -> None:
    cv2.imwrite(str(tmp_path / "road.png"), mask())
    done = extracted(
        tmp_path / "road.png", "-o", tmp_path / "a.geojson", "--scale", 0.5,
        f"--origin={latitude},{longitude}",
    )  # fmt: skip
    assert done.exit_code == 0, done.output
    properties, line = road_of(tmp_path / "a.geojson")
    assert properties["width"] == pytest.approx(4.0, abs=0.3)
    projection = LocalProjection(latitude, longitude)
    points = np.array([projection.point(lat, lon) for lon, lat in line])
    assert np.abs(points[:, 1] - (HEIGHT - ROW) * 0.5).max() < 0.3
    assert np.ptp(points[:, 0]) == pytest.approx(WIDTH * 0.5, abs=2.5)
    assert np.abs(line[:, 0]).max() <= 180.0


def test_a_geotiff_says_where_its_roads_are(tmp_path: Path) -> None:
    """In a grid whose north is 1.9 degrees off: a line along a row leaves the parallel by 5 m."""
    east, north = kruger(48.1, 11.61, 9.0)
    x, y = 500_000.0 + 0.9996 * east, 0.9996 * north
    numbers = {33550: (0.5, 0.5, 0.0), 33922: (0.0, ROW, 0.0, x, y, 0.0)}
    written_geotiff(tmp_path / "a.tif", mask(), ((1024, 1), (1025, 1), (3072, 32632)), numbers)
    done = extracted(tmp_path / "a.tif", "-o", tmp_path / "a.geojson")
    assert done.exit_code == 0, done.output
    _, line = road_of(tmp_path / "a.geojson")
    local = LocalProjection(48.1, 11.61)
    points = np.array([local.point(lat, lon) for lon, lat in line])
    for lon, lat in line[[0, len(line) // 2, -1]]:
        _, northing = kruger(lat, lon, 9.0)
        assert 0.9996 * northing == pytest.approx(y, abs=0.4)
    assert abs(points[-1, 1] - points[0, 1]) == pytest.approx(5.4, abs=0.6)


@pytest.mark.parametrize(
    ("words", "said"),
    [((), "--origin"), (("--origin", "48,11"), "--scale"), (("--scale", "0.5"), "--origin")],
)
def test_a_picture_without_a_place_or_size_says_what_is_missing(
    tmp_path: Path, words: tuple[str, ...], said: str
) -> None:
    cv2.imwrite(str(tmp_path / "road.png"), mask())
    done = extracted(tmp_path / "road.png", "-o", tmp_path / "a.geojson", *words)
    assert isinstance(done.exception, DiagnosticError)
    assert done.exception.diagnostics[0].code == "RL433"
    assert said in done.exception.diagnostics[0].help[0]
    assert not (tmp_path / "a.geojson").exists()


@pytest.mark.parametrize("place", ["91,0", "0,181", "48", "north,east"])
def test_a_corner_that_is_not_on_earth_is_refused(tmp_path: Path, place: str) -> None:
    cv2.imwrite(str(tmp_path / "road.png"), mask())
    done = extracted(tmp_path / "road.png", "-o", tmp_path / "a.geojson", "--origin", place)
    assert done.exit_code == 2
    assert place.split(",")[0] in done.output
