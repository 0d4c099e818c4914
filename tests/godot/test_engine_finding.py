"""Where an engine is looked for, and what is said where there is none."""

from __future__ import annotations

from pathlib import Path

import pytest

from roadlang.api import Code
from roadlang.cli import main as cli
from roadlang_godot.engines import engine, engine_places
from roadlang_godot.faults import EngineError, fault

SCENE = """road main { draw with waypoints { points: [(0m, 0m), (80m, 0m)] }, width: 8m }
agent ego is car on main at 5m { drive with pure_pursuit { speed: 8m/s } }
expect calm: always (ego.speed < 9m/s)
"""


@pytest.fixture
def nowhere(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    """A machine without an engine."""
    monkeypatch.delenv("ROADLANG_GODOT", raising=False)
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setattr(engine_places, "_PLACES", ())
    return tmp_path


def test_the_project_is_where_the_package_or_the_checkout_has_it() -> None:
    assert (engine.project() / "project.godot").is_file()


def executable(path: Path, text: str) -> Path:
    path.write_text(f"#!/bin/sh\n{text}\n", encoding="utf-8")
    path.chmod(0o755)
    return path


def test_without_an_engine_the_diagnostic_says_how_to_get_one(nowhere: Path) -> None:
    with pytest.raises(EngineError, match="RL500") as caught:
        engine.find()
    assert any("Godot 4.3" in line for line in caught.value.diagnostics[0].help)


def test_an_engine_on_the_path_is_found(nowhere: Path) -> None:
    godot = executable(nowhere / "godot4", "echo 4.5")
    assert engine.find() == godot


def test_the_variable_goes_before_the_path(nowhere: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    executable(nowhere / "godot4", "echo 4.5")
    own = executable(nowhere / "my-godot", "echo 4.4")
    monkeypatch.setenv("ROADLANG_GODOT", str(own))
    assert engine.find() == own


def test_a_variable_that_names_nothing_is_told(
    nowhere: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    executable(nowhere / "godot4", "echo 4.5")
    monkeypatch.setenv("ROADLANG_GODOT", "/no/such/engine")
    with pytest.raises(EngineError, match=r"RL500.*no/such/engine"):
        engine.find()


@pytest.mark.parametrize("version", ["3.5.2.stable", "4.2.1.stable"])
def test_an_engine_that_is_too_old_is_refused(nowhere: Path, version: str) -> None:
    old = executable(nowhere / "godot4", f"echo {version}")
    with pytest.raises(EngineError, match=f"RL511.*{version}"):
        engine.version_of(old)


def test_an_engine_that_does_not_start_is_told_with_its_last_words(nowhere: Path) -> None:
    executable(nowhere / "godot4", "echo out of luck; exit 3")
    with pytest.raises(EngineError, match="RL501") as caught:
        engine.start()
    assert caught.value.diagnostics[0].help == ("out of luck",)


def test_nobody_at_the_address_is_no_endless_wait() -> None:
    with pytest.raises(EngineError, match="RL502"):
        engine.connect("127.0.0.1", 9, patience=0.3)


def test_who_emits_to_nobody_is_told_how_to_start_an_engine(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def unanswered(*_: object) -> None:
        raise fault(Code.GODOT_NOT_ANSWERING, seconds=5)

    monkeypatch.setattr(engine, "connect", unanswered)
    scene = tmp_path / "scene.rl"
    scene.write_text(f"{SCENE}emit godot {{ port: 4299 }}\n", encoding="utf-8")
    assert cli.run(["compile", str(scene), "-o", str(tmp_path / "out")]) == 5
    told = capsys.readouterr().err
    assert "error[RL502]" in told
    assert "`roadlang godot --port 4299`" in told
    assert "`roadlang render FILE -o scene.tscn` writes a scene" in told


def test_nobody_behind_a_websocket_address() -> None:
    with pytest.raises(EngineError, match="RL512"):
        engine.connect("127.0.0.1", 9, "websocket", patience=0.3)


def test_the_command_leaves_with_5_where_there_is_no_engine(
    nowhere: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    scene = nowhere / "scene.rl"
    scene.write_text(SCENE, encoding="utf-8")
    code = cli.run(["run", str(scene), "--engine", "godot", "-o", str(nowhere)])
    assert code == 5
    assert "RL500" in capsys.readouterr().err
    assert not list(nowhere.glob("*.csv"))
