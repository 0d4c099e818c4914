"""Tiles of a picture, named together, are that picture."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest
from click.testing import CliRunner

import roadlang
from roadlang.cli.check import command as check
from roadlang.cli.extract import command as extract
from roadlang.diagnostics import DiagnosticError
from roadlang.files.matching import files_matching
from roadlang.images.image_file import OpenedImage, open_image

PRJ = 'PROJCS["WGS 84 / UTM zone 32N",AUTHORITY["EPSG","32632"]]'
WEST, NORTH, SIZE = 691_000.0, 5_334_000.0, 0.5


def written(
    path: Path,
    pixels: np.ndarray,
    at: tuple[int, int] = (0, 0),
    size: float = SIZE,
    prj: str = PRJ,
) -> None:
    """A picture whose upper left pixel is at this column and row of the whole."""
    cv2.imwrite(str(path), pixels)
    x, y = WEST + (at[0] + 0.5) * SIZE, NORTH - (at[1] + 0.5) * SIZE
    path.with_suffix(".pgw").write_text(f"{size}\n0\n0\n-{size}\n{x}\n{y}\n")
    path.with_suffix(".prj").write_text(prj)


def opened(path: Path) -> OpenedImage:
    return open_image(path, f"maps/{path.name}", None)


@pytest.fixture
def pixels() -> np.ndarray:
    noise = np.random.default_rng(3).integers(0, 255, (90, 130, 3)).astype(np.uint8)
    return np.asarray(cv2.GaussianBlur(noise, (0, 0), 3.0))


def test_tiles_that_overlap_are_the_whole(tmp_path: Path, pixels: np.ndarray) -> None:
    written(tmp_path / "whole.png", pixels)
    for name, (top, left) in {"1": (40, 60), "2": (0, 50), "3": (35, 0), "4": (0, 0)}.items():
        tile = pixels[top : top + 55, left : left + 80]
        written(tmp_path / f"tile_{name}.png", tile, (left, top))
    whole, tiles = opened(tmp_path / "whole.png"), opened(tmp_path / "tile_?.png")
    assert np.array_equal(tiles.pixels, whole.pixels)
    assert tiles.scale == pytest.approx(whole.scale, rel=1e-6)
    assert tiles.shown.origin == pytest.approx(whole.shown.origin, abs=1e-8)
    names = [name for name, _ in tiles.inputs]
    assert names[:3] == ["maps/tile_1.png", "maps/tile_1.pgw", "maps/tile_1.prj"]
    assert len(names) == 12


def test_a_tile_that_is_turned_is_turned_back(tmp_path: Path, pixels: np.ndarray) -> None:
    written(tmp_path / "whole.png", pixels)
    written(tmp_path / "tile_1.png", pixels[:, :70])
    written(tmp_path / "tile_2.png", cv2.rotate(pixels[:, 70:], cv2.ROTATE_180))
    # Its first pixel is the last of the whole, and it goes on to the west and north.
    x, y = WEST + 129.5 * SIZE, NORTH - 89.5 * SIZE
    (tmp_path / "tile_2.pgw").write_text(f"-{SIZE}\n0\n0\n{SIZE}\n{x}\n{y}\n")
    whole, tiles = opened(tmp_path / "whole.png"), opened(tmp_path / "tile_*.png")
    assert np.abs(whole.pixels.astype(int) - tiles.pixels).max() <= 1


@pytest.mark.parametrize("turned", [False, True])
def test_transparent_pixels_do_not_cover_another_tile(
    tmp_path: Path, pixels: np.ndarray, turned: bool
) -> None:
    written(tmp_path / "whole.png", pixels)
    written(tmp_path / "tile_1.png", pixels[:, :80])
    right = np.dstack([pixels[:, 50:], np.full((90, 80), 255, np.uint8)])
    right[:, :30] = 0
    written(
        tmp_path / "tile_2.png", cv2.rotate(right, cv2.ROTATE_180) if turned else right, (50, 0)
    )
    if turned:
        x, y = WEST + 129.5 * SIZE, NORTH - 89.5 * SIZE
        (tmp_path / "tile_2.pgw").write_text(f"-{SIZE}\n0\n0\n{SIZE}\n{x}\n{y}\n")
    whole, tiles = opened(tmp_path / "whole.png"), opened(tmp_path / "tile_*.png")
    assert np.abs(whole.pixels.astype(int) - tiles.pixels).max() <= turned


def test_what_no_tile_shows_has_the_color_of_borders(tmp_path: Path) -> None:
    gray = np.full((20, 20, 3), 77, np.uint8)
    gray[5:15, 5:15] = 200
    written(tmp_path / "a.png", gray)
    written(tmp_path / "b.png", gray, (20, 20))
    for beside in tmp_path.glob("*.prj"):
        beside.unlink()  # without a grid nothing is turned to true north
    assert (opened(tmp_path / "?.png").pixels[:20, 20:] == 77).all()


@pytest.mark.parametrize(
    ("changed", "reason"),
    [
        ({"size": 0.6}, "the pixels of `maps/b.png` and `maps/a.png` differ in size"),
        ({"prj": PRJ.replace("32632", "32633")}, "use different coordinate systems"),
        (
            {"at": (30_000_000, 0)},
            "they span 30000020 x 20 px, and at most 100 million pixels can be read",
        ),
    ],
)
def test_tiles_that_do_not_fit(tmp_path: Path, changed: dict[str, Any], reason: str) -> None:
    written(tmp_path / "a.png", np.zeros((20, 20, 3), np.uint8))
    written(tmp_path / "b.png", np.zeros((20, 20, 3), np.uint8), **changed)
    with pytest.raises(DiagnosticError) as raised:
        opened(tmp_path / "?.png")
    assert raised.value.diagnostics[0].code == "RL442"
    assert reason in raised.value.diagnostics[0].message


def test_tiles_without_a_place(tmp_path: Path) -> None:
    written(tmp_path / "a.png", np.zeros((20, 20, 3), np.uint8))
    cv2.imwrite(str(tmp_path / "b.png"), np.zeros((20, 20, 3), np.uint8))
    with pytest.raises(DiagnosticError, match=r"`maps/b.png` is not georeferenced"):
        opened(tmp_path / "?.png")


def test_names_with_stars(tmp_path: Path) -> None:
    for name in ("b[1].png", "b[2].png", "a*.png", "b1.png", "ab.png"):
        (tmp_path / name).touch()
    (tmp_path / "b[3].png").mkdir()

    def matching(name: str) -> list[str]:
        return [path.name for path in files_matching(tmp_path / name)]

    assert matching("b[?].png") == ["b[1].png", "b[2].png"]
    assert matching("a*.png") == ["a*.png"]  # there is a file of that very name
    assert matching("*b.png") == ["ab.png"]
    assert matching("gone.png") == ["gone.png"]
    assert matching("gone*") == []


SCENE = 'image photo from "tiles/{}.png"\nnetwork town from photo\n'


def test_a_network_of_tiles(tmp_path: Path) -> None:
    """A street over three tiles is one road, in a scene and on the command line."""
    street = np.full((120, 300, 3), 255, np.uint8)
    cv2.line(street, (0, 60), (299, 60), (0, 0, 0), 9)
    folder = tmp_path / "tiles"
    folder.mkdir()
    for number in range(3):
        written(folder / f"t{number}.png", street[:, 100 * number :][:, :100], (100 * number, 0))
    (tmp_path / "scene.rl").write_text(SCENE.format("t*"))
    (scene,) = roadlang.load(tmp_path / "scene.rl").sample(1)
    (road,) = scene.roads.values()
    assert 140.0 < road.length < 152.0
    assert "tiles/t2.png" in scene.provenance.inputs

    names = [str(folder / f"t{number}.png") for number in range(3)]
    result = CliRunner().invoke(extract, names)
    assert result.exit_code == 0, result.output
    found = json.loads(result.stdout)
    assert len(found["polylines"]) == 1
    assert found["image"]["tiles"] == names
    edited = CliRunner().invoke(extract, [*names, "--edit", "x.rl"])
    assert edited.exit_code == 2
    assert "`--edit` takes one image" in edited.output


def test_check_names_tiles_that_are_not_there(tmp_path: Path) -> None:
    (tmp_path / "tiles").mkdir()
    scene = tmp_path / "scene.rl"
    scene.write_text(SCENE.format("q*"))
    result = CliRunner().invoke(check, [str(scene)])
    assert result.exit_code == 1
    assert "error[RL450]: there is no file named like `tiles/q*.png`" in result.output
    assert "there is no picture in" in result.output
    for number in range(6):
        (tmp_path / "tiles" / f"t{number}.png").touch()
    result = CliRunner().invoke(check, [str(scene)])
    assert "are `t0.png`, `t1.png`, `t2.png`, `t3.png` and 2 more" in result.output
    (tmp_path / "tiles" / "q1.png").write_text("no picture")
    result = CliRunner().invoke(check, [str(scene)])
    assert "`tiles/q1.png`" in result.output
    assert "it is not an image" in result.output
    scene.write_text(SCENE.format("q*").replace("tiles/", "none/"))
    result = CliRunner().invoke(check, [str(scene)])
    assert "there is no folder" in result.output
