"""roadlang inside a Godot project of somebody else."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import pytest
from click.testing import CliRunner

from roadlang import load
from roadlang_godot.build.layout import layout_of
from roadlang_godot.commands.godot import command
from roadlang_godot.drive import driving
from roadlang_godot.engines import engine as engines
from roadlang_godot.engines.addon import install_addon
from roadlang_godot.net import protocol
from tests.godot.godot_engines import require_engine, started, until
from tests.godot.godot_scenes import bends, call, car, pieces, road, scene, straight

PROJECT_FILE = """config_version=5

[application]
config/name="somebody's game"
run/main_scene="res://game.tscn"

[physics]
3d/physics_engine="Jolt Physics"
"""
GAME_SCENE = """[gd_scene load_steps=2 format=3]

[ext_resource type="Script" path="res://game.gd" id="1"]

[node name="Game" type="Node3D"]
script = ExtResource("1")
"""
GAME_SCRIPT = """extends Node3D

var stage := RoadlangStage.new()
var parent := Thread.new()


func _ready() -> void:
	parent.start(_follow_parent)
	stage.port = 0
	stage.scene_built.connect(_built)
	stage.drive_ended.connect(_ended)
	add_child(stage)


## The game ends with its test, however that ends: standard input does then.
func _follow_parent() -> void:
	while not OS.read_string_from_stdin().is_empty():
		pass
	OS.kill(OS.get_process_id())


func _built() -> void:
	var ego: RoadlangAgent = stage.agent("ego")
	var path: RoadlangPath = ego.path
	var says := [stage.scene().scene_name, ego.agent_name, path.length]
	print("game: built %s with %s on %.0f m" % says)


func _ended(reason: String) -> void:
	var ego: RoadlangAgent = stage.agent("ego")
	var says := [ego.speed, ego.acceleration, ego.station, ego.cross_track_error]
	print("game: drove at %.3f m/s, %.3f m/s^2 to %.3f m, %.3f m" % says)
	print("game: ended by ", reason)
"""


def _write_game(folder: Path) -> Path:
    (folder / "project.godot").write_text(PROJECT_FILE)
    (folder / "game.tscn").write_text(GAME_SCENE)
    (folder / "game.gd").write_text(GAME_SCRIPT)
    return folder


@pytest.fixture
def game(tmp_path: Path) -> Path:
    """A game that has a `RoadlangStage`."""
    return _write_game(tmp_path)


def _run(*arguments: str) -> tuple[int, str]:
    done = CliRunner().invoke(command, list(arguments))
    return done.exit_code, done.output


def test_the_addon_replaces_an_earlier_one_and_nothing_else(game: Path) -> None:
    assert _run("--addon", str(game))[0] == 0
    place = game / "addons" / "roadlang"
    (place / "left_over.gd").write_text("extends Node\n")
    assert _run("--addon", str(game))[0] == 0
    names = {path.name for path in place.iterdir()}
    assert {"plugin.cfg", "plugin.gd", "roadlang_stage.gd", "main.tscn"} <= names
    assert not {"left_over.gd", "project.godot", "tests", ".godot"} & names
    assert [path.name for path in (game / "addons").iterdir()] == ["roadlang"]
    (place / "plugin.cfg").write_text('[plugin]\n\nname="another"\n')
    code, text = _run("--addon", str(game))
    assert code == 2
    assert "is something else" in text


def test_what_is_no_godot_project_gets_no_addon(tmp_path: Path) -> None:
    code, text = _run("--addon", str(tmp_path))
    assert code == 2
    assert "no file `project.godot`" in text
    assert list(tmp_path.iterdir()) == []


def test_the_addon_has_the_version_of_the_protocol() -> None:
    config = (engines.project() / "plugin.cfg").read_text(encoding="utf-8")
    assert f'version="{protocol.VERSION}"' in config


@pytest.fixture(scope="module")
def imported_game(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Roadlang is in the game, and Godot has found its classes."""
    require_engine()
    game = _write_game(tmp_path_factory.mktemp("game"))
    install_addon(game)
    engine = str(engines.find())
    imported = subprocess.run(
        [engine, "--headless", "--path", str(game), "--import"], capture_output=True, text=True
    )
    assert imported.returncode == 0
    assert "ERROR" not in imported.stdout + imported.stderr
    return game


@pytest.mark.slow
@pytest.mark.godot
def test_a_game_receives_scenes(imported_game: Path) -> None:
    line = bends()
    sent = scene(line, agents=[car("ego", line, 5.0, call("lane_follow", speed=10.0))])
    with (
        started(fixed_fps=60, extra=["--path", str(imported_game)]) as running,
        running.connect() as session,
    ):
        layout = layout_of(sent)
        session.begin(layout.settings(60), clear=True)
        session.update(layout.parts)
        session.prove()
        driven = driving.run(session, 60)
        until(lambda: "game: ended by time" in running.output())
        assert "game: built test with ego on 869 m" in running.output()
        assert "ERROR" not in running.output()
    assert driven.trace["x"][-1] > driven.trace["x"][0]


@pytest.mark.slow
@pytest.mark.godot
def test_scenes_are_driven_in_a_game(imported_game: Path, tmp_path: Path) -> None:
    file = tmp_path / "scene.rl"
    with started(fixed_fps=60, extra=["--path", str(imported_game)]) as running:
        file.write_text(f"""
road main {{ draw with waypoints {{ points: [(0m, 0m), (80m, 0m), (160m, 40m)] }} }}
agent ego is car on main at 5m {{ drive with lane_follow {{ speed: 3m/s..9m/s }} }}
expect slow: always (ego.speed < 10m/s)
simulate with godot {{ duration: 2s, host: "127.0.0.1", port: {running.port} }}
""")
        driven = load(file).sample(2, seed=1).run()
        printed = running.output()
    assert [drive.verdicts["slow"].satisfied for drive in driven] == [True, True]
    assert len(re.findall("game: ended by time", printed)) == 2


@pytest.mark.slow
@pytest.mark.godot
def test_a_game_knows_where_an_agent_is_that_python_drives(imported_game: Path) -> None:
    line = road("line", pieces(straight(200.0)))
    ego = car("ego", line, 5.0, call("lane_follow", speed=10.0), offset=1.0)
    layout = layout_of(scene(line, agents=[ego]))
    with (
        started(fixed_fps=20, extra=["--path", str(imported_game)]) as running,
        running.connect() as session,
    ):
        session.begin(layout.settings(60), clear=True)
        session.update(layout.parts)
        session.prove()
        with driving.LockStep(session) as lock:
            for _ in range(40):
                lock.step({1: driving.EngineControl.steer(0.02, 2.0)}, 3)
            (at,) = lock.state.poses
        until(lambda: "game: ended by" in running.output())
        (said,) = re.findall("game: drove at (.*)", running.output())
    speed, acceleration, station, error = map(float, re.findall(r"-?\d+\.\d+", said))
    assert speed == pytest.approx(at["speed"], abs=2e-3)
    assert acceleration == pytest.approx(2.0, abs=0.3)
    assert station == pytest.approx(at["x"] + layout.frame.x, abs=0.01)
    assert error == pytest.approx(at["y"] + layout.frame.y - 1.0, abs=0.01)


def test_an_interrupt_leaves_the_earlier_addon(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    place = install_addon(tmp_path)
    rename = Path.rename

    def interrupted(path: Path, target: Path) -> Path:
        if path.name.startswith(".roadlang-new"):
            raise KeyboardInterrupt
        return rename(path, target)

    monkeypatch.setattr(Path, "rename", interrupted)
    with pytest.raises(KeyboardInterrupt):
        install_addon(tmp_path)
    assert (place / "plugin.cfg").is_file()
    assert [path.name for path in place.parent.iterdir()] == ["roadlang"]
