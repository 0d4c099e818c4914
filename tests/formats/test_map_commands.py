"""`roadlang convert` and `roadlang view`."""

from __future__ import annotations

from pathlib import Path

import pytest

import roadlang
from tests.cli.command_lines import Done
from tests.cli.command_lines import roadlang as run
from tests.formats.opendrive_reader import ReadFile
from tests.formats.small_maps import crossing, straight, xodr
from tests.formats.test_read_json_maps import geojson, line
from tests.formats.test_read_osm import osm, way


def ran(*arguments: str) -> Done:
    return run(*arguments, cwd=Path.cwd())


@pytest.fixture
def town(tmp_path: Path) -> Path:
    path = tmp_path / "my town.xodr"
    path.write_text(crossing())
    return path


def test_a_map_becomes_a_scene_and_a_map_again(town: Path, tmp_path: Path) -> None:
    scene, again = tmp_path / "scene.json", tmp_path / "again.xodr"
    assert ran("convert", str(town), str(scene)).returncode == 0
    assert set(roadlang.Scene.from_json(scene.read_text()).roads) == {"town/1", "town/2", "town/3"}
    assert ran("convert", str(scene), str(again)).returncode == 0
    outside = [road for road in ReadFile.of(again.read_text()).roads.values() if road.junction < 0]
    assert [road.length for road in outside] == [40.0, 40.0, 40.0]


def test_streets_become_opendrive(tmp_path: Path) -> None:
    source, target = tmp_path / "town.osm", tmp_path / "town.xodr"
    source.write_text(osm(way(1, "31 33 35"), way(2, "13 33 53")))
    assert ran("convert", str(source), str(target)).returncode == 0
    assert len(ReadFile.of(target.read_text()).roads) > 4


def test_the_first_scene_of_a_scene_file_is_converted(town: Path, tmp_path: Path) -> None:
    source, target = tmp_path / "scene.rl", tmp_path / "scene.svg"
    source.write_text(f'network town from "{town}"\nemit json\n')
    assert ran("convert", str(source), str(target)).returncode == 0
    assert target.read_text().rstrip().endswith("</svg>")


def test_the_format_may_be_named(town: Path, tmp_path: Path) -> None:
    assert ran("convert", str(town), str(tmp_path / "a.json"), "--emit", "json").returncode == 0
    assert (tmp_path / "a.json").exists()


@pytest.mark.parametrize("name", ["road.geojson", "7.geojson", "map.geojson"])
def test_a_map_may_be_called_like_a_keyword(tmp_path: Path, name: str) -> None:
    source, target = geojson(tmp_path, line((0, 0), (1, 0))).rename(tmp_path / name), "out.xodr"
    result = ran("convert", str(source), str(tmp_path / target))
    assert result.returncode == 0, result.stderr


def test_view_draws_next_to_the_map(town: Path) -> None:
    assert ran("view", str(town)).returncode == 0
    assert town.with_suffix(".svg").read_text().rstrip().endswith("</svg>")


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("a.xodr", "b.doc"), "RL930"),
        (("none.xodr", "b.svg"), "RL400"),
        (("a.xodr", "b.doc", "--emit", "nothing"), "RL471"),
        (("a.xodr", "b.doc", "--emit", "svg"), "RL930"),
        (("broken.xodr", "b.svg"), "RL479"),
        (("broken.json", "b.svg"), "--> broken.json:1:2"),
    ],
)
def test_what_cannot_be_converted_is_said(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, arguments: tuple[str, ...], said: str
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("a.xodr").write_text(xodr(straight(1, 0, 0)))
    Path("broken.xodr").write_text("<OpenDRIVE>")
    Path("broken.json").write_text("{")
    result = ran("convert", *arguments)
    assert result.returncode in (1, 2)
    assert said in result.stderr
    assert not Path("b.svg").exists()


def test_networks_of_sumo_become_opendrive_first(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("town.net.xml").write_text("<net/>")
    result = ran("convert", "town.net.xml", "town.json")
    assert result.returncode == 2
    assert "netconvert -s town.net.xml --opendrive-output town.xodr" in result.stderr
