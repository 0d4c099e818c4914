"""The front door: what a Python user does with a scene file."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest

import roadlang
from roadlang.api import Picture
from roadlang.commands import parse_overrides

SCENE = """\
param reach = 6m
param turns = 2
road main { draw with waypoints { points: [(0m, 0m), (80m, 10m), (160m, -10m), (240m, 30m)] } }
road bent from main { perturb with sine { amplitude: 1m..reach, wavelength: 80m..200m } }
let away = abs(deviation(bent, main))
require near: always (away < 3m)
"""
IMPOSSIBLE = SCENE + "require far: always (deviation(bent, main) > 50m)\n"


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "scene.rl"
    path.write_text(SCENE)
    return path


def test_importing_roadlang_imports_nothing_heavy(tmp_path: Path) -> None:
    code = "import roadlang, sys; print(*{m.partition('.')[0] for m in sys.modules})"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert not set(done.stdout.split()) & {"numpy", "scipy", "cv2", "lark", "click", "pluggy"}


def test_every_name_of_the_front_door_is_there() -> None:
    for name in roadlang.__all__:
        assert getattr(roadlang, name)
    assert set(dir(roadlang)) == set(roadlang.__all__)
    with pytest.raises(AttributeError, match="no attribute 'nonsense'"):
        _ = roadlang.nonsense


def test_scenes_are_those_of_the_command_line(
    file: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from roadlang.cli.main import run

    monkeypatch.chdir(tmp_path)
    assert run(["compile", "scene.rl", "-n", "2", "--seed", "3", "-o", "cli"]) == 0
    scenes = roadlang.load("scene.rl").sample(2, seed=3)
    scenes.emit("python")
    for path in (tmp_path / "cli").iterdir():
        assert (tmp_path / "python" / path.name).read_bytes() == path.read_bytes(), path.name
    assert scenes[1].to_json() == (tmp_path / "cli/scene-0001.json").read_text()


def test_a_road_is_read_only_arrays(file: Path) -> None:
    (scene,) = roadlang.load(file).sample()
    road = scene.roads["bent"]
    count = len(road.stations)
    assert road.points.shape == (count, 2)
    for array in (road.heading, road.curvature, road.width, road.reference_stations, road.x):
        assert array.shape == (count,)
        assert not array.flags.writeable
    np.testing.assert_array_equal(road.points[:, 1], road.y)
    assert road.stations[-1] == pytest.approx(road.length)
    assert set(road.to_dict()) == {"station", "x", "y", "heading", "curvature", "width"}
    assert road.root == "main"
    assert not scene.roads["main"].derived


def test_signals_and_robustness_along_the_road(file: Path) -> None:
    (scene,) = roadlang.load(file).sample()
    away = scene.signals["away"]
    near = scene.robustness["near"]
    assert away.unit == "m"
    assert (near.unit, near.text) == ("", "always (away < 3m)")
    np.testing.assert_allclose(near.values, 3.0 - away.values, atol=1e-9)
    assert near.values.min() == pytest.approx(scene.requirements["near"].robustness)
    assert away.stations[-1] == pytest.approx(scene.roads["main"].reference_stations[-1])


def test_values_along_several_roads_are_told_apart_by_name() -> None:
    text = '''\
image town from """
.......
.#####.
.#...#.
.#####.
.#.....
.......
""" { scale: 8m/px }
network net from town {}
let turn = abs(curvature(net))
require calm: always (turn < 10/m)
'''
    (scene,) = roadlang.loads(text).sample()
    turn = scene.signals["turn"]
    assert len(turn.roads) > 1
    with pytest.raises(ValueError, match="several roads"):
        _ = turn.values
    assert set(turn.roads) <= set(scene.roads)


def test_params_are_numbers_or_texts_of_the_language(file: Path) -> None:
    loaded = roadlang.load(file, reach="2m", turns=3)
    (scene,) = loaded.sample()
    assert (scene.values["reach"], scene.values["turns"]) == (2.0, 3.0)
    (other,) = loaded.sample(reach="1.5m")
    assert other.values["reach"] == 1.5
    assert other.provenance.overrides == {"reach": "1.5m", "turns": "3"}
    assert loaded.params["reach"] == "2m"
    assert loaded.with_params() is loaded


@pytest.mark.parametrize(
    ("value", "text"),
    [
        ("12m", "12m"),
        (3, "3"),
        (0.5, "0.5"),
        (True, "true"),
        (np.float64(0.25), "0.25"),
        (np.int64(4), "4"),
        ([1, 2.5], "[1, 2.5]"),
    ],
)
def test_how_a_value_is_written(value: Any, text: str) -> None:
    from roadlang.session.params import param_texts

    assert param_texts({"a": value}) == {"a": text}


def test_values_that_the_language_cannot_write_are_refused(file: Path) -> None:
    for number in ("nan", "inf", "-inf"):
        with pytest.raises(ValueError, match=f"`reach` is {number}"):
            roadlang.load(file, reach=float(number))
    with pytest.raises(TypeError, match="`reach` must be a number, or a text"):
        roadlang.load(file, reach={})  # type: ignore[arg-type]


def test_check_tells_all_and_sampling_raises_it_as_text(tmp_path: Path) -> None:
    loaded = roadlang.loads(SCENE.replace("amplitude", "amplitud").replace("< 3m", "< 3s"))
    assert len([found for found in loaded.check() if found.is_error]) == 2
    with pytest.raises(roadlang.DiagnosticError) as caught:
        loaded.sample()
    words = str(caught.value)
    assert "scene.rl:4:43" in words
    assert "did you mean `amplitude`?" in words
    assert caught.value.diagnostics == loaded.check()


def test_a_file_that_is_not_there(tmp_path: Path) -> None:
    with pytest.raises(roadlang.DiagnosticError, match="RL920"):
        roadlang.load(tmp_path / "nope.rl")


def test_what_cannot_be_satisfied_raises_with_the_statistics() -> None:
    with pytest.raises(roadlang.NoSceneError) as caught:
        roadlang.loads(IMPOSSIBLE).sample(3)
    result = caught.value.result
    assert len(result) == 0
    assert [row.name for row in result.rejections if row.impossible] == ["far"]
    assert "rejected" in str(caught.value)


def test_rejections_are_counted(file: Path) -> None:
    scenes = roadlang.load(file).sample(5, seed=1)
    (row,) = scenes.rejections
    assert (row.name, scenes.candidates - row.rejected) == ("near", 5)
    assert scenes.rejection_table.startswith(f"{scenes.candidates} candidates tried")


def test_requirements_are_recorded_in_the_order_of_the_file(tmp_path: Path) -> None:
    """However often each rejects, and whatever they are called."""
    limits = {"zeal": "20m", "calm": "2m", "mild": "4m"}
    lines = (f"require {name}: always (away < {most})\n" for name, most in limits.items())
    manifest = roadlang.loads(SCENE + "".join(lines)).sample(2).emit(tmp_path / "out", ["json"])
    assert [row.name for row in manifest.requirements] == ["near", *limits]


def test_fewer_scenes_than_asked_for_is_a_warning() -> None:
    text = "param side = choice(1m, 2m)\n" + SCENE + "sample with grid { steps: 2 }\n"
    scenes = roadlang.loads(text.replace("< 3m", "< 1.6m")).sample(50)
    assert 0 < len(scenes) < 50
    (short,) = [found for found in scenes.diagnostics if found.code == "RL602"]
    assert short.path == "scene.rl"
    assert short.help == ("the table shows what rejects most",)


def test_a_set_is_a_sequence_and_a_table(file: Path) -> None:
    scenes = roadlang.load(file).sample(3)
    assert [scene.index for scene in scenes] == [0, 1, 2]
    assert scenes[-1] is scenes[2]
    assert len(scenes[:2]) == 2
    table = scenes.to_dict()
    assert table["scene"] == [0, 1, 2]
    assert table["near"] == [scene.requirements["near"].robustness for scene in scenes]
    assert {len(column) for column in table.values()} == {3}
    assert "bent/perturb 1/amplitude" in table


def test_a_scene_survives_its_json(file: Path, tmp_path: Path) -> None:
    (scene,) = roadlang.load(file).sample()
    again = roadlang.Scene.from_json(scene.to_json())
    assert again.record == scene.record
    path = scene.save(tmp_path / "kept" / "scene.json")
    assert roadlang.Scene.from_json(path.read_bytes()).to_json() == scene.to_json()


@pytest.mark.parametrize("text", ["", "{}", "[]", '{"schema": "roadlang.trace/1"}', "\ud800"])
def test_what_is_no_scene_is_refused(text: str) -> None:
    with pytest.raises(roadlang.DiagnosticError, match="RL461"):
        roadlang.Scene.from_json(text)


def test_notebooks_show_the_figure_and_the_contact_sheet(file: Path) -> None:
    scenes = roadlang.load(file).sample(2)
    assert scenes[0]._repr_svg_().startswith("<svg") or "<svg" in scenes[0].svg()[:200]
    assert 'width="800"' in scenes[0].svg(size=800)
    assert scenes._repr_svg_() != scenes[0].svg()
    one = roadlang.load(file).sample(1)
    assert one._repr_svg_() == one[0].svg(), "one scene is its figure"


def test_options_of_a_figure_are_checked(file: Path) -> None:
    (scene,) = roadlang.load(file).sample()
    with pytest.raises(roadlang.DiagnosticError, match=r"RL220(.|\n)*did you mean `size`"):
        scene.svg(sizes=800)
    with pytest.raises(roadlang.DiagnosticError, match="RL208"):
        scene.svg(size=-1)


PICTURED = """image photo from "photo.png" { scale: 0.5m/px, legend: { "white": road } }
network town from photo
road main from town { select: longest }
road bent from main { perturb with bump { at: 10m, length: 10m, height: 1m } }
road drawn { draw with segments { pieces: [straight(100m)] } }
"""


@pytest.fixture
def pictured(tmp_path: Path) -> roadlang.Scene:
    pixels = np.zeros((40, 60), np.uint8)
    pixels[15:25] = 255
    cv2.imwrite(str(tmp_path / "photo.png"), pixels)
    return roadlang.loads(PICTURED, folder=tmp_path).sample()[0]


@pytest.mark.parametrize("name", ["photo", "town", "main", "bent"])
def test_a_figure_has_the_photo_that_is_named(pictured: roadlang.Scene, name: str) -> None:
    assert "data:image/jpeg" not in pictured.svg()
    assert pictured.svg(photo=name) == pictured.svg(photo="photo")
    assert pictured.svg(photo=name).count("data:image/jpeg") == 1


def test_a_figure_may_have_another_picture(pictured: roadlang.Scene) -> None:
    picture = Picture(np.zeros((30, 30, 3), np.uint8), 1.0)
    figures = [pictured.svg(photo=picture), pictured.svg(photo="photo"), pictured.svg(photo=None)]
    assert len(set(figures)) == 3
    again = roadlang.Scene.from_json(pictured.to_json())
    assert again.svg(photo=picture) == figures[0]


@pytest.mark.parametrize(
    ("photo", "message"),
    [
        ("phot", r"RL101.*`phot` is not defined(.|\n)*did you mean `photo`"),
        ("elsewhere", r"RL101(.|\n)*its images are `photo`"),
        ("drawn", "RL206.*`drawn` expects an image, but this is a road or network without one"),
        (3, "RL206.*`photo` expects the name of an image, or a `roadlang.api.Picture`, but this"),
    ],
)
def test_what_is_no_photo_of_a_figure(
    pictured: roadlang.Scene, photo: object, message: str
) -> None:
    with pytest.raises(roadlang.DiagnosticError, match=message):
        pictured.svg(photo=photo)


def test_a_scene_from_json_has_no_photos(pictured: roadlang.Scene) -> None:
    again = roadlang.Scene.from_json(pictured.to_json())
    with pytest.raises(roadlang.DiagnosticError, match=r"RL206(.|\n)*sample it to use names"):
        again.svg(photo="photo")


@pytest.mark.parametrize("kinds", [["json"], "json"])
def test_emit_takes_kinds(file: Path, tmp_path: Path, kinds: str | list[str]) -> None:
    manifest = roadlang.load(file).sample().emit(tmp_path / "out", kinds)
    assert [output.path for output in manifest.files] == ["scene-0000.json"]
    assert json.loads((tmp_path / "out/manifest.json").read_text())["scenes"] == 1


def test_an_unknown_engine_is_refused(file: Path) -> None:
    (scene,) = roadlang.load(file).sample()
    with pytest.raises(roadlang.DiagnosticError, match="RL930"):
        scene.run("gdot")


def test_objects_describe_themselves(file: Path) -> None:
    loaded = roadlang.load(file)
    scenes = loaded.sample(2)
    assert repr(loaded) == f"roadlang.load({str(file)!r})"
    assert repr(scenes).startswith("<2 scenes of ")
    assert repr(scenes[1]) == "<scene 1 of scene: main, bent>"
    assert repr(scenes[0].roads["main"]).startswith("<road main: ")


def test_the_place_of_a_byte_that_is_no_text_is_told(tmp_path: Path) -> None:
    (tmp_path / "scene.rl").write_bytes(b"# \xc3\xa4\nroad main {}\n# \xff\n")
    with pytest.raises(roadlang.DiagnosticError, match="line 3 has the byte 0xff"):
        roadlang.load(tmp_path / "scene.rl")


def test_the_least_robustness_of_several_scenes_is_the_worst(file: Path) -> None:
    text = file.read_text() + "expect flat: always (abs(curvature(bent)) < 0.001/m)\n"
    scenes = roadlang.loads(text, folder=file.parent).sample(4)
    values = [scene.expectations["flat"].robustness for scene in scenes]
    (found,) = [found for found in scenes.expectations if found.name == "flat"]
    assert len(set(values)) > 1
    assert found.worst == min(value for value in values if value is not None)
    assert found.judged == (0, 1, 2, 3)


def test_a_slip_in_the_name_of_a_file_is_found(file: Path) -> None:
    with pytest.raises(roadlang.DiagnosticError) as error:
        roadlang.load(file.with_name("scen.rl"))
    (found,) = error.value.diagnostics
    assert (found.code, found.help) == ("RL920", ("did you mean `scene.rl`?",))


def test_a_folder_of_an_earlier_version_is_written_over(file: Path, tmp_path: Path) -> None:
    """What a manifest of another version names is removed as well; another file is not replaced."""
    folder = tmp_path / "out"
    roadlang.load(file).sample(3).emit(folder, ["json"])
    manifest = folder / "manifest.json"
    manifest.write_text(manifest.read_text().replace("roadlang.manifest/2", "roadlang.manifest/0"))
    roadlang.load(file).sample(1).emit(folder, ["json"])
    assert sorted(path.name for path in folder.iterdir()) == ["manifest.json", "scene-0000.json"]
    manifest.write_text('{"schema": "npm/1", "files": []}')
    with pytest.raises(roadlang.DiagnosticError, match="RL460"):
        roadlang.load(file).sample(1).emit(folder, ["json"])


def test_the_seed_is_0_where_none_is_given_and_one_value_can_be_chosen_from(file: Path) -> None:
    scenario = roadlang.load(file)
    default, zero, one = (
        made[0].draws
        for made in (scenario.sample(1), scenario.sample(1, seed=0), scenario.sample(1, seed=1))
    )
    assert default == zero != one
    road = "road main { draw with segments { pieces: [straight(99m)] }, width: a }"
    text = f"param a = choice(5m)\n{road}"
    assert roadlang.loads(text).sample()[0].values["a"] == 5.0


def test_numbers_of_scenes_and_seeds_are_whole_numbers(file: Path) -> None:
    scenario = roadlang.load(file)
    numbers: Any = np.array([1, 3])  # those of numpy are as good
    assert repr(scenario.sample(numbers[0], seed=numbers[1])).startswith("<1 scene of ")
    wrong: tuple[tuple[type[Exception], dict[str, Any]], ...] = (
        (ValueError, {"n": 0}),
        (TypeError, {"n": "2"}),
        (TypeError, {"seed": "x"}),
        (ValueError, {"seed": -1}),
    )
    for error, arguments in wrong:
        with pytest.raises(error, match=f"`{next(iter(arguments))}` must be"):
            scenario.sample(**arguments)


def test_faults_of_params_name_what_was_given(file: Path) -> None:
    """An argument of Python is no option of a command line."""
    with pytest.raises(roadlang.DiagnosticError, match=r"RL108(.|\n)*--> argument reech:1:1"):
        roadlang.load(file, reech="6m").sample()
    with pytest.raises(roadlang.DiagnosticError, match="--> argument reech:1:1"):
        roadlang.load(file).with_params({"reech": 6}).sample()
    settings = parse_overrides(["reech=6m"])
    with pytest.raises(roadlang.DiagnosticError, match="--> --set reech:1:1"):
        roadlang.load(file).with_params(settings).sample()
