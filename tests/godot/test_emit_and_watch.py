"""`emit godot` and `roadlang watch`, as a user runs them against an engine that is there."""

from __future__ import annotations

import threading
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from godot_engines import started

from roadlang.cli import main as cli
from roadlang_godot.engine import Engine

pytestmark = pytest.mark.godot

ROAD = "road main { draw with waypoints { points: [(0m, 0m), (80m, %sm)] }, width: 8m }\n"
TOWN = """image plan from \"\"\"
  .#...
  .###.
  .#.T.
\"\"\" { scale: 8m/px, legend: { "#": road, "T": tree } }
network town from plan
"""
CAR = "agent ego is car on main at 5m { drive with pure_pursuit { speed: 8m/s } }\n"


@pytest.fixture
def listening() -> Iterator[Engine]:
    with started() as engine:
        yield engine


@pytest.mark.parametrize(
    ("text", "road"), [(ROAD % 0, "mesh"), (TOWN, "mesh"), (TOWN, "tiles")], ids=str
)
def test_compiling_builds_the_scene_in_the_running_engine(
    listening: Engine, tmp_path: Path, text: str, road: str
) -> None:
    file = tmp_path / "scene.rl"
    file.write_text(f"{text}emit godot {{ road: {road}, port: {listening.port} }}\n")
    assert cli.run(["compile", str(file), "-o", str(tmp_path / "out")]) == 0


def test_compiling_without_an_engine_leaves_with_5_and_says_where_it_looked(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "scene.rl"
    file.write_text(ROAD % 0 + 'emit godot { port: 9, host: "no such host" }\n')
    assert cli.run(["compile", str(file), "-o", str(tmp_path / "out")]) == 5
    assert "RL512" in capsys.readouterr().err


def test_a_saved_change_is_sent_and_a_fault_is_told_without_harm(
    listening: Engine, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "scene.rl"
    file.write_text(ROAD % 0 + CAR)

    def save_twice() -> None:
        time.sleep(1.2)
        file.write_text(ROAD % 6 + CAR)
        time.sleep(0.8)
        file.write_text("raod main\n")

    saver = threading.Thread(target=save_twice)
    saver.start()
    port = str(listening.port)
    code = cli.run(["watch", str(file), "--host", "127.0.0.1", "--port", port, "--for", "3.5"])
    saver.join()
    seen = capsys.readouterr()
    assert code == 0
    assert "changes in" in seen.out
    assert "raod" in seen.err
    assert "SCRIPT ERROR" not in listening.output()
