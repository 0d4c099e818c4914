"""The place of a picture from the file that GDAL writes beside it."""

from __future__ import annotations

from pathlib import Path

import pytest

from roadlang.images.image_scale import scale_in_file

GRID = "PROJCS[&quot;UTM 33&quot;,AUTHORITY[&quot;EPSG&quot;,&quot;32633&quot;]]"
PLACE = "  5.0e+05,  2.0, 0.25,  5.3e+06, -0.5, -3.0"


def beside(folder: Path, srs: str = GRID, place: str = PLACE) -> None:
    of_place = f"<GeoTransform>{place}</GeoTransform>" if place else ""
    text = f'<PAMDataset><SRS dataAxisToSRSAxisMapping="1,2">{srs}</SRS>{of_place}</PAMDataset>'
    (folder / "a.png.aux.xml").write_text(text)


def test_gdal_states_grid_and_place(tmp_path: Path) -> None:
    beside(tmp_path)
    found = scale_in_file(tmp_path / "a.png", b"", "PNG")
    assert found is not None
    assert found.reference is not None
    assert found.reference.grid == "EPSG:32633"
    assert found.reference.at(0.0, 0.0) == (500_000.0, 5_300_000.0)
    assert found.reference.at(1.0, 2.0) == (500_002.5, 5_299_993.5)
    assert found.meters == pytest.approx((2.0 * 3.0 - 0.25 * 0.5) ** 0.5)
    assert [name for name, _ in found.files] == ["a.png.aux.xml"]


@pytest.mark.parametrize(
    ("prj", "grid", "last"),
    [("", "EPSG:32633", "a.png.aux.xml"), ('GEOGCS["WGS 84"]', "EPSG:4326", "a.prj")],
)
def test_a_world_file_goes_first_and_so_does_a_prj_file(
    tmp_path: Path, prj: str, grid: str, last: str
) -> None:
    beside(tmp_path)
    (tmp_path / "a.pgw").write_text("4 0 0 -4 102 198")
    if prj:
        (tmp_path / "a.prj").write_text(prj)
    found = scale_in_file(tmp_path / "a.png", b"", "PNG")
    assert found is not None
    assert found.reference is not None
    assert (found.reference.at(0.0, 0.0), found.reference.grid) == ((100.0, 200.0), grid)
    assert [name for name, _ in found.files] == ["a.pgw", last]


@pytest.mark.parametrize(
    "place", ["", "1, 2, 3", "1, 2, 0, 4, 0, x", "1, 0, 0, 4, 0, 0", "1, nan, 0, 4, 0, 1"]
)
def test_without_a_usable_place_there_is_none(tmp_path: Path, place: str) -> None:
    beside(tmp_path, place=place)
    assert scale_in_file(tmp_path / "a.png", b"", "PNG") is None


def test_statistics_alone_say_nothing(tmp_path: Path) -> None:
    (tmp_path / "a.png.aux.xml").write_text("<PAMDataset><Histograms/></PAMDataset>")
    assert scale_in_file(tmp_path / "a.png", b"", "PNG") is None
