"""The tags of TIFF files one by one, and what files beside a picture say of its pixels."""

from __future__ import annotations

import struct
from pathlib import Path

import pytest

from roadlang.images.georeference import Georeference, geotiff_reference, world_file_reference
from roadlang.images.image_scale import scale_in_file, unusable_world_file
from roadlang.images.tiff import TiffError, TiffTags

TYPES = {"B": (1, 1), "H": (3, 2), "I": (4, 4), "f": (11, 4), "d": (12, 8)}


def tiff(order: str, tags: dict[int, tuple[str, tuple[float, ...]]]) -> bytes:
    """A file without pixels: values of up to four bytes are in the entry, others behind it."""
    entries, behind = b"", b""
    start = 8 + 2 + 12 * len(tags)
    for tag, (letter, values) in tags.items():
        kind, size = TYPES[letter]
        packed = struct.pack(f"{order}{len(values)}{letter}", *values)
        place = packed.ljust(4, b"\0")
        if size * len(values) > 4:
            place = struct.pack(f"{order}I", start + len(behind))
            behind += packed
        entries += struct.pack(f"{order}HHI", tag, kind, len(values)) + place
    head = b"II*\0" if order == "<" else b"MM\0*"
    return head + struct.pack(f"{order}IH", 8, len(tags)) + entries + behind


@pytest.mark.parametrize("order", ["<", ">"])
@pytest.mark.parametrize(
    ("letter", "values"),
    [
        ("B", (1, 2, 3, 4)), ("B", (1, 2, 3, 4, 5)), ("H", (7, 8)), ("H", (7, 8, 9)),
        ("I", (70_000,)), ("I", (70_000, 80_000)), ("f", (0.5,)), ("d", (0.1,)), ("d", (0.1, -2.0)),
    ],
)  # fmt: skip
def test_values_are_in_their_entry_or_behind_it(
    order: str, letter: str, values: tuple[float, ...]
) -> None:
    tags = TiffTags(tiff(order, {200: ("H", (640,)), 300: (letter, values)}))
    assert tags.numbers(300) == values
    assert tags.numbers(200) == (640,)
    assert tags.numbers(301) == ()


@pytest.mark.parametrize("order", ["<", ">"])
def test_a_big_tiff_has_wider_places(order: str) -> None:
    start = (b"II+\0" if order == "<" else b"MM\0+") + struct.pack(f"{order}HHQ", 8, 0, 16)
    width = struct.pack(f"{order}HHQQ", 256, 16, 1, 640)
    scale = struct.pack(f"{order}HHQQ", 33550, 12, 2, 16 + 8 + 2 * 20)
    content = start + struct.pack(f"{order}Q", 2) + width + scale
    tags = TiffTags(content + struct.pack(f"{order}dd", 0.5, 0.25))
    assert tags.numbers(256) == (640,)
    assert tags.numbers(33550) == (0.5, 0.25)
    with pytest.raises(TiffError):
        TiffTags(content).numbers(33550)


def test_what_is_no_number_or_too_many_is_nothing() -> None:
    many = 10_001
    content = bytearray(tiff("<", {300: ("H", (1,)), 301: ("H", (2,)), 302: ("B", (1,) * 10_000)}))
    struct.pack_into("<H", content, 12, 2)  # text
    struct.pack_into("<I", content, 26, many)
    tags = TiffTags(bytes(content))
    assert (tags.numbers(300), tags.numbers(301)) == ((), ())
    assert len(tags.numbers(302)) == 10_000


def test_what_lies_beyond_the_end_is_a_fault() -> None:
    whole = tiff("<", {300: ("d", (0.1, 0.2))})
    assert TiffTags(whole).numbers(300) == (0.1, 0.2)
    with pytest.raises(TiffError):
        TiffTags(whole[:-1]).numbers(300)
    with pytest.raises(TiffError):
        TiffTags(whole[:15])


KEYS, SCALE, TIES, MATRIX = 34735, 33550, 33922, 34264


def keys(*pairs: tuple[int, int]) -> tuple[str, tuple[float, ...]]:
    flat = [number for id_, value in pairs for number in (id_, 0, 1, value)]
    return "H", (1, 1, 0, len(pairs), *flat)


@pytest.mark.parametrize(
    ("pairs", "grid"),
    [
        (((1024, 1), (3072, 32632)), "EPSG:32632"),
        (((1024, 2), (2048, 4258)), "EPSG:4258"),
        (((1024, 2), (2048, 32767)), "EPSG:4326"),
        (((1024, 2),), "EPSG:4326"),
        (((1024, 1), (3072, 32767)), ""),
        (((1024, 1), (3072, 0)), ""),
        (((1024, 3), (3072, 32632)), ""),
        (((1024, 1), (2048, 4258)), ""),
        ((), ""),
    ],
)
def test_the_grid_of_a_geotiff(pairs: tuple[tuple[int, int], ...], grid: str) -> None:
    tags = {SCALE: ("d", (2.0, 3.0, 0.0)), TIES: ("d", (10.0, 20.0, 0.0, 500.0, 900.0, 0.0))}
    found = geotiff_reference(tiff("<", {**tags, KEYS: keys(*pairs)}))
    assert found == Georeference((2.0, 0.0, 480.0, 0.0, -3.0, 960.0), grid)
    assert found.at(10.0, 20.0) == (500.0, 900.0)
    assert found.at(11.0, 22.0) == (502.0, 894.0)


def test_a_whole_matrix_goes_first_and_points_are_middles_of_pixels() -> None:
    matrix = (2.0, 1.0, 0.0, 100.0, -1.0, -2.0, 0.0, 200.0, *([0.0] * 7), 1.0)
    tags = {SCALE: ("d", (9.0, 9.0)), TIES: ("d", (0.0,) * 6), MATRIX: ("d", matrix)}
    found = geotiff_reference(tiff("<", {**tags, KEYS: keys((1025, 1))}))
    assert found == Georeference((2.0, 1.0, 100.0, -1.0, -2.0, 200.0), "")
    middles = geotiff_reference(tiff("<", {**tags, KEYS: keys((1025, 2))}))
    assert middles is not None
    assert middles.at(0.5, 0.5) == (100.0, 200.0)


def test_without_a_place_or_whole_there_is_no_reference() -> None:
    assert geotiff_reference(tiff("<", {SCALE: ("d", (2.0, 2.0))})) is None
    assert geotiff_reference(tiff("<", {TIES: ("d", (0.0,) * 6)})) is None
    assert geotiff_reference(b"II*\0") is None


@pytest.mark.parametrize(
    ("numbers", "projection", "grid"),
    [
        ((1e-4, 0, 0, -1e-4, 11.5, 48.1), "", "EPSG:4326"),
        ((1e-4, 0, 0, -1e-4, 180.0, -90.0), "", "EPSG:4326"),
        ((1e-4, 0, 0, -1e-4, 180.5, 48.1), "", ""),
        ((1e-4, 0, 0, -1e-4, 11.5, 90.5), "", ""),
        ((1e-4, 0, 0, -1e-3, 11.5, 48.1), "", ""),
        ((1e-4, 1e-3, 0, -1e-4, 11.5, 48.1), "", ""),
        ((0.5, 0, 0, -0.5, 0.0, 0.0), "", ""),
        ((0.5, 0, 0, -0.5, 0.0, 0.0), 'PROJCS["x",AUTHORITY["EPSG","25832"]]', "EPSG:25832"),
        ((0.5, 0, 0, -0.5, 0.0, 0.0), 'PROJCRS["x",ID["EPSG",25833]]', "EPSG:25833"),
        ((0.5, 0, 0, -0.5, 0.0, 0.0), 'GEOGCS["WGS 84"]', "EPSG:4326"),
        ((0.5, 0, 0, -0.5, 0.0, 0.0), 'PROJCS["WGS_1984_UTM_Zone_32N"]', "EPSG:32632"),
        ((0.5, 0, 0, -0.5, 0.0, 0.0), 'PROJCS["WGS 84 / UTM zone 5S"]', "EPSG:32705"),
        ((0.5, 0, 0, -0.5, 0.0, 0.0), 'PROJCS["WGS 84 / Pseudo-Mercator"]', "EPSG:3857"),
        ((0.5, 0, 0, -0.5, 0.0, 0.0), 'PROJCS["Krovak"]', 'PROJCS["Krovak"]'),
    ],
)
def test_the_grid_of_a_world_file(numbers: tuple[float, ...], projection: str, grid: str) -> None:
    assert world_file_reference(numbers, projection).grid == grid


def test_a_world_file_names_the_middle_of_the_first_pixel() -> None:
    """Its lines: x and y along a row, x and y down a column, x and y of the middle."""
    found = world_file_reference((2.0, 0.5, 0.25, -3.0, 100.0, 200.0), "")
    assert found.at(0.5, 0.5) == (100.0, 200.0)
    assert found.at(1.5, 0.5) == (102.0, 200.5)
    assert found.at(0.5, 1.5) == (100.25, 197.0)


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("0.5 0 zero -0.5 1 2", "`a.pgw`, line 3: 'zero' is not a number"),
        ("0.5 0 0 -0.5 1 inf", "`a.pgw`, line 6: 'inf' is not a number"),
        ("0.5 0 0 -0.5", "`a.pgw`, line 5: a world file has six numbers"),
        ("0 0 0 0 1 2", "`a.pgw`, line 1: the size of a pixel is not a length in meters"),
    ],
)
def test_why_a_world_file_says_no_scale(tmp_path: Path, text: str, reason: str) -> None:
    (tmp_path / "a.pgw").write_text(text)
    found = scale_in_file(tmp_path / "a.png", b"", "PNG")
    assert found is None or found.meters is None
    assert unusable_world_file(tmp_path / "a.png") == reason
    assert unusable_world_file(tmp_path / "b.png") is None


@pytest.mark.parametrize("name", ["a.pgw", "a.pngw", "a.wld"])
def test_the_scale_of_a_world_file_is_the_root_of_the_area_of_a_pixel(
    tmp_path: Path, name: str
) -> None:
    (tmp_path / name).write_text("4\n0\n0\n-9\n100\n200\nmore\n")
    (tmp_path / "a.prj").write_text('GEOGCS["WGS 84"]')
    found = scale_in_file(tmp_path / "a.png", b"", "PNG")
    assert found is not None
    assert (found.meters, [file for file, _ in found.files]) == (6.0, [name, "a.prj"])
    assert found.reference is not None
    assert found.reference.grid == "EPSG:4326"


@pytest.mark.parametrize(
    ("scale", "pairs", "meters"),
    [
        ((2.0, 8.0), (), 4.0),
        ((2.0, -8.0, 5.0), ((1024, 1),), 4.0),
        ((2.0,), (), None),
        ((2.0, 8.0), ((1024, 2),), None),
        ((2.0, 8.0), ((3076, 9001),), 4.0),
        ((2.0, 8.0), ((3076, 9002),), 4.0 * 0.3048),
        ((2.0, 8.0), ((3076, 9003),), 4.0 * 1200.0 / 3937.0),
        ((2.0, 8.0), ((3076, 9036),), None),
        ((1e-3, 1e-3), (), None),
        ((1.001e-3, 1.001e-3), (), 1.001e-3),
    ],
)
def test_the_scale_of_a_geotiff_is_in_meters(
    tmp_path: Path,
    scale: tuple[float, ...],
    pairs: tuple[tuple[int, int], ...],
    meters: float | None,
) -> None:
    """Of a grid in meters, feet or survey feet; kilometers and degrees say none."""
    content = tiff("<", {SCALE: ("d", scale), KEYS: keys(*pairs)})
    found = scale_in_file(tmp_path / "a.tif", content, "TIFF")
    assert (None if found is None else found.meters) == (
        None if meters is None else pytest.approx(meters)
    )


def test_a_geotiff_that_says_nothing_has_the_scale_of_its_world_file(tmp_path: Path) -> None:
    (tmp_path / "a.tfw").write_text("3\n0\n0\n-3\n100\n200\n")
    content = tiff("<", {256: ("H", (640,))})
    found = scale_in_file(tmp_path / "a.tif", content, "TIFF")
    assert found is not None
    assert found.meters == 3.0
