"""Pictures that say where on Earth they are: what is shown in them is found there again."""

from __future__ import annotations

import math
import sys
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import cv2
import numpy as np
import pytest

from roadlang.geometry.earth.local_projection import LocalProjection
from roadlang.images.image_file import OpenedImage, open_image
from roadlang.images.image_scale import FoundScale
from roadlang.images.placed_pixels import _to_degrees, placed
from roadlang.ir.picture import Picture
from roadlang.world.sources.pictures import picture_of
from tests.geometry.test_local_projection import kruger
from tests.images.geotiffs import written_geotiff

HEIGHT, WIDTH = 300, 400
SPOT = (310, 60)
"""Column and row of the upper left corner of a black square of 6 x 6 pixels on white."""


def shown() -> np.ndarray:
    pixels = np.full((HEIGHT, WIDTH), 255, np.uint8)
    pixels[SPOT[1] : SPOT[1] + 6, SPOT[0] : SPOT[0] + 6] = 0
    return pixels


def opened(path: Path) -> OpenedImage:
    return open_image(path, path.name, None)


def picture(found: OpenedImage) -> Picture:
    """What an extractor gets."""
    assert found.scale is not None
    return picture_of(found.shown, found.scale, "a")


def spot(found: OpenedImage) -> np.ndarray:
    """(2,) the middle of the square in what was opened."""
    dark = 255.0 - found.pixels[..., 0]
    rows, columns = np.indices(dark.shape)
    return np.array([np.average(each, weights=dark) for each in (columns, rows)])


def place_of_spot(found: OpenedImage) -> tuple[float, float]:
    """Latitude and longitude of the middle of the square, by origin and scale."""
    assert found.shown.origin is not None
    x, y = picture(found).to_world(spot(found))
    return LocalProjection(*found.shown.origin).place(x, y)


def away(place: tuple[float, float], expected: tuple[float, float]) -> float:
    """Meters between two places."""
    return math.hypot(*LocalProjection(*expected).point(*place))


MIDDLE = (SPOT[0] + 3.0, SPOT[1] + 3.0)
NORTH, EAST = 48.1, 11.61


def utm_corner() -> tuple[float, float]:
    """The upper left corner in UTM zone 32, such that the spot is at NORTH, EAST; pixels of 2 m."""
    x, y = kruger(NORTH, EAST, 9.0)
    return 500_000.0 + 0.9996 * x - 2.0 * MIDDLE[0], 0.9996 * y + 2.0 * MIDDLE[1]


def test_a_geotiff_in_utm_keeps_its_pixels_and_knows_how_north_is_turned(tmp_path: Path) -> None:
    """North of the grid is 1.94 degrees off here: 27 m at the other end of the picture."""
    x, y = utm_corner()
    numbers = {33550: (2.0, 2.0, 0.0), 33922: (0.0, 0.0, 0.0, x, y, 0.0)}
    keys = ((1024, 1), (1025, 1), (3072, 32632), (3076, 9001))
    found = opened(written_geotiff(tmp_path / "a.tif", shown(), keys, numbers))
    assert away(place_of_spot(found), (NORTH, EAST)) < 0.1
    assert found.scale == pytest.approx(2.0, rel=2e-4)
    assert (found.pixels[..., 0] == shown()).all()
    turned = math.radians(EAST - 9.0) * math.sin(math.radians(NORTH))
    assert found.shown.north_up is not None
    assert found.shown.north_up.height == pytest.approx(HEIGHT + WIDTH * math.sin(turned), abs=2)
    assert found.shown.north_up.turn == pytest.approx(-turned, abs=2e-4)
    assert found.shown.file is None
    assert found.shown.warning is None


def test_points_of_pixels_and_a_whole_matrix_are_the_same_place(tmp_path: Path) -> None:
    x, y = utm_corner()
    matrix = [0.0] * 16
    matrix[0], matrix[3], matrix[5], matrix[7] = 2.0, x + 1.0, -2.0, y - 1.0
    keys = ((1024, 1), (1025, 2), (3072, 25832))
    found = opened(written_geotiff(tmp_path / "a.tif", shown(), keys, {34264: matrix}))
    assert away(place_of_spot(found), (NORTH, EAST)) < 0.1


@pytest.mark.parametrize("form", ["world file", "geotiff"])
def test_pixels_of_degrees_become_square(tmp_path: Path, form: str) -> None:
    step = 1e-5
    west, north = EAST - step * MIDDLE[0], NORTH + step * MIDDLE[1]
    if form == "geotiff":
        numbers = {33550: (step, step, 0.0), 33922: (0.0, 0.0, 0.0, west, north, 0.0)}
        path = written_geotiff(tmp_path / "a.tif", shown(), ((1024, 2), (2048, 4326)), numbers)
    else:
        path = tmp_path / "a.png"
        cv2.imwrite(str(path), shown())
        lines = (step, 0, 0, -step, west + step / 2, north - step / 2)
        (tmp_path / "a.pgw").write_text("\n".join(map(repr, lines)))
    found = opened(path)
    assert away(place_of_spot(found), (NORTH, EAST)) < 0.1
    width = WIDTH * step * 111_320.0 * math.cos(math.radians(NORTH))
    assert found.pixels.shape[1] * (found.scale or 0) == pytest.approx(width, rel=0.01)


@pytest.mark.parametrize(
    ("projection", "x", "y"),
    [
        ('PROJCS["WGS_1984_Web_Mercator_Auxiliary_Sphere",GEOGCS["GCS_WGS_1984"]]', None, None),
        ('PROJCS["WGS 84 / Pseudo-Mercator",AUTHORITY["EPSG","3857"]]', None, None),
        ('PROJCS["WGS_1984_UTM_Zone_32N",GEOGCS["GCS_WGS_1984"]]', 2.0, 2.0),
    ],
)
def test_the_grid_of_a_world_file_is_in_a_prj_file(
    tmp_path: Path, projection: str, x: float | None, y: float | None
) -> None:
    if x is None or y is None:
        radius = 6_378_137.0
        west = radius * math.radians(EAST) - 2.0 * MIDDLE[0]
        tangent = math.tan(math.radians(45.0 + NORTH / 2.0))
        north = radius * math.log(tangent) + 2.0 * MIDDLE[1]
    else:
        west, north = utm_corner()
    path = tmp_path / "a.png"
    cv2.imwrite(str(path), shown())
    (tmp_path / "a.pgw").write_text(f"2\n0\n0\n-2\n{west + 1.0!r}\n{north - 1.0!r}\n")
    (tmp_path / "a.prj").write_text(projection)
    found = opened(path)
    assert away(place_of_spot(found), (NORTH, EAST)) < 0.15
    shrunk = math.cos(math.radians(NORTH)) if x is None else 1.0
    assert found.scale == pytest.approx(2.0 * shrunk, rel=5e-3)
    assert [name for name, _ in found.inputs[1:]] == ["a.pgw", "a.prj"]


def test_other_grids_need_pyproj_and_keep_their_scale(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "pyproj", None)
    numbers = {33550: (2.0, 2.0, 0.0), 33922: (0.0, 0.0, 0.0, 2.6e6, 1.2e6, 0.0)}
    path = written_geotiff(tmp_path / "a.tif", shown(), ((1024, 1), (3072, 2056)), numbers)
    found = opened(path)
    assert (found.scale, found.shown.origin) == (2.0, None)
    assert found.shown.warning is not None
    assert found.shown.warning.code == "RL439"
    assert "EPSG:2056 needs `pyproj`: pip install" in found.shown.warning.message


class Grids:
    """Stands in for `pyproj`: a grid in hundredths of degrees, and one that it does not know."""

    class exceptions:
        class ProjError(Exception):
            pass

    class Transformer:
        @staticmethod
        def from_crs(grid: str, to: str, *, always_xy: bool) -> Any:
            assert (to, always_xy) == ("EPSG:4326", True)
            if grid != "EPSG:2056":
                raise Grids.exceptions.ProjError
            return SimpleNamespace(transform=lambda x, y: (x / 100.0, y / 100.0))


def test_pyproj_is_asked_for_longitude_and_latitude(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "pyproj", Grids)
    degrees, reason = _to_degrees("EPSG:2056")
    assert degrees is not None
    assert (degrees(700.0, 4700.0), reason) == ((47.0, 7.0), "")
    beside = "the coordinate system beside it"
    for grid, name in (("EPSG:1", "its coordinate system EPSG:1"), ('PROJCS["odd"]', beside)):
        assert _to_degrees(grid) == (None, f"{name} is not known to `pyproj`")


@pytest.mark.parametrize(
    ("text", "fault"),
    [
        ("0.5\n0\nabc\n-0.5\n691000\n5334000\n", "`town.pgw`, line 3: 'abc' is not a number"),
        ("0.5\n0\n0\n-0.5\n691000\n", "`town.pgw`, line 6: a world file has six numbers"),
    ],
)
def test_a_world_file_that_cannot_be_used_is_named(tmp_path: Path, text: str, fault: str) -> None:
    cv2.imwrite(str(tmp_path / "town.png"), shown())
    (tmp_path / "town.pgw").write_text(text)
    found = opened(tmp_path / "town.png")
    assert (found.scale, found.shown.origin) == (None, None)
    assert found.shown.warning is not None
    assert found.shown.warning.code == "RL439"
    assert fault in found.shown.warning.message
    (tmp_path / "town.pgw").unlink()
    assert opened(tmp_path / "town.png").shown.warning is None


def test_other_grids_are_where_pyproj_has_them(tmp_path: Path) -> None:
    """The old observatory of Bern is the origin of the Swiss grid."""
    pytest.importorskip("pyproj")
    numbers = {33550: (2.0, 2.0, 0.0),
        33922: (MIDDLE[0], MIDDLE[1], 0.0, 2_600_000.0, 1_200_000.0, 0.0)}  # fmt: skip
    path = written_geotiff(tmp_path / "a.tif", shown(), ((1024, 1), (3072, 2056)), numbers)
    assert away(place_of_spot(opened(path)), (46.951083, 7.438632)) < 1.0


@pytest.mark.parametrize(
    ("x", "y", "warns"),
    [
        (691_000.0, 691_000.0, True), (0.0, 0.0, False), (0.0, 10_001.0, True),
        (-10_001.0, 0.0, True), (10_000.25, 0.0, False), (0.0, -10_000.25, False),
    ],
)  # fmt: skip
def test_a_world_file_in_meters_alone_is_no_place(
    tmp_path: Path, x: float, y: float, warns: bool
) -> None:
    """That of a plan which is in no grid is there for its scale: up to 10 km from (0, 0)."""
    cv2.imwrite(str(tmp_path / "town.png"), shown())
    (tmp_path / "town.pgw").write_text(f"0.5\n0\n0\n-0.5\n{x}\n{y}\n")
    found = opened(tmp_path / "town.png")
    assert found.scale == 0.5
    assert found.shown.origin is None
    codes = [found.shown.warning.code] if found.shown.warning else []
    assert codes == ["RL439"] * warns


def test_coordinates_that_are_not_on_earth_are_no_place(tmp_path: Path) -> None:
    numbers = {33550: (2.0, 2.0, 0.0), 33922: (0.0, 0.0, 0.0, 5e5, 1e9, 0.0)}
    path = written_geotiff(tmp_path / "a.tif", shown(), ((1024, 1), (3072, 32632)), numbers)
    found = opened(path)
    assert (found.scale, found.shown.origin) == (2.0, None)
    assert found.shown.warning is not None


@pytest.mark.parametrize(
    ("west", "north", "is_place"),
    [
        (10.0, 88.99, True), (10.0, 89.0, False), (-359.9, 10.0, True),
        (359.0, 10.0, True), (360.1, 10.0, False), (10.0, -88.0, True), (10.0, -88.9, False),
    ],
)  # fmt: skip
def test_a_place_is_on_earth_but_not_next_to_a_pole(
    tmp_path: Path, west: float, north: float, is_place: bool
) -> None:
    numbers = {33550: (1e-3, 1e-3, 0.0), 33922: (0.0, 0.0, 0.0, west, north, 0.0)}
    path = written_geotiff(tmp_path / "a.tif", shown(), ((1024, 2), (2048, 4326)), numbers)
    found = opened(path)
    assert (found.shown.origin is not None) is is_place
    assert (found.shown.warning is None) is is_place


def test_a_world_file_does_not_matter_where_the_picture_says_its_scale() -> None:
    fault = "`town.pgw`, line 3: 'abc' is not a number"
    assert placed(shown(), FoundScale(0.5), "town.png", None, fault).warning is None
    for found in (None, FoundScale(None)):
        assert placed(shown(), found, "town.png", None, fault).warning is not None
