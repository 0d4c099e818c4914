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

XOSC = (
    '<OpenSCENARIO><RoadNetwork><LogicFile filepath="street.road.xodr"/></RoadNetwork>'
    "</OpenSCENARIO>"
)


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


def test_extensions_may_be_in_capitals_and_names_stay_as_they_are_written(tmp_path: Path) -> None:
    source, target = tmp_path / "TOWN.XODR", tmp_path / "AGAIN.XODR"
    source.write_text(crossing())
    assert ran("convert", str(source), str(target)).returncode == 0
    assert {path.name for path in tmp_path.iterdir()} == {"TOWN.XODR", "AGAIN.XODR"}


def test_files_that_name_each_other_have_the_names_that_are_written(tmp_path: Path) -> None:
    source, target = tmp_path / "TOWN.XODR", tmp_path / "A.XOSC"
    source.write_text(crossing())
    assert ran("convert", str(source), str(target)).returncode == 0
    assert (tmp_path / "A.road.xodr").exists()
    assert "A.road.xodr" in target.read_text()


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


def test_the_format_may_have_options(town: Path, tmp_path: Path) -> None:
    target = tmp_path / "a.xodr"
    ran("convert", str(town), str(target), "--emit", 'opendrive{version: "1.6"}')
    assert 'revMinor="6"' in target.read_text()
    target = tmp_path / "a.geojson"
    ran("convert", str(town), str(target), "--emit", "geojson { origin: (48deg, 11deg) }")
    assert '"coordinates"' in target.read_text()


@pytest.mark.parametrize("output", ["my town.xodr", "./other/../my town.xodr", "linked.xodr"])
def test_a_map_is_not_written_over_itself(
    town: Path, output: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(town.parent)
    Path("other").mkdir()
    Path("linked.xodr").symlink_to(town)
    before = town.read_bytes()
    result = ran("convert", "my town.xodr", output)
    assert result.returncode == 2
    assert "from which it is made: choose another name" in result.stderr
    assert town.read_bytes() == before


def test_nor_is_it_by_a_second_file_of_a_format(tmp_path: Path) -> None:
    source = tmp_path / "town.road.xodr"
    source.write_text(crossing())
    result = ran("convert", str(source), str(tmp_path / "town.xosc"))
    assert result.returncode == 2
    assert source.read_text() == crossing()
    assert not (tmp_path / "town.xosc").exists()


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
        (("a.xodr", "b.doc", "--emit", "xosc"), "did you mean `openscenario`?"),
        (("a.xodr", "b.doc", "--emit", "nothing"), "there is no backend called `nothing`"),
        (("a.xodr", "b.svg", "--emit", ""), "name one format"),
        (("a.xodr", "b.svg", "--emit", "svg,json"), "name one format"),
        (("a.xodr", "b.svg", "--emit", "svg{sise: 800px}"), "did you mean `size`?"),
        (("a.xodr", "b.svg", "--emit", "godot"), "`emit godot` writes no file of a scene"),
        (("a.xodr", "b"), "there is no output format called `b`"),
        (("a.xodr", ""), "OUTPUT is empty"),
        (("a.xodr", "folder"), "folder is a folder: name a file, such as folder/town.xodr"),
        (("folder", "b.svg"), "FILE is a folder, folder"),
        (("", "b.svg"), "FILE is a folder"),
        (("empty.xodr", "b.svg"), "RL451"),
        (("table.csv", "b.svg"), "RL214"),
        (("street.xosc", "b.svg"), "its roads are in `street.road.xodr`: convert that"),
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
    Path("empty.xodr").touch()
    Path("table.csv").write_text("x,y\n0,0\n")
    Path("street.xosc").write_text(XOSC)
    Path("folder").mkdir()
    result = ran("convert", *arguments)
    assert result.returncode in (1, 2)
    assert said in result.stderr
    assert "scene.rl" not in result.stderr, "there is no scene file"
    assert "read with" not in result.stderr, "there is no block to write it in"
    assert not Path("b.svg").exists()


def test_networks_of_sumo_become_opendrive_first(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("town.net.xml").write_text("<net/>")
    result = ran("convert", "town.net.xml", "town.json")
    assert result.returncode == 2
    assert "netconvert -s town.net.xml --opendrive-output town.xodr" in result.stderr
