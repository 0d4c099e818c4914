"""`emit godot` and `roadlang watch`, as a user runs them against an engine that is there."""

from __future__ import annotations

import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from roadlang.cli import main as cli
from roadlang_godot.engines.engine import Engine
from tests.godot.godot_engines import started, until

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


def _heeds_ctrl_c() -> None:
    """Tests that a script runs in the background inherit a SIGINT that is ignored."""
    signal.signal(signal.SIGINT, signal.default_int_handler)


class Watching:
    """`roadlang watch` in a process of its own, with what it has printed so far."""

    def __init__(self, file: Path, port: int) -> None:
        self._log = (file.parent / "watch.log").open("w+", encoding="utf-8")
        command = [sys.executable, "-u", "-m", "roadlang", "watch", str(file)]
        command += ["--host", "127.0.0.1", "--port", str(port)]
        self.process = subprocess.Popen(
            command, stdout=self._log, stderr=subprocess.STDOUT, preexec_fn=_heeds_ctrl_c
        )

    def printed(self) -> str:
        return Path(self._log.name).read_text(encoding="utf-8")

    def waits_for(self, text: str) -> None:
        until(lambda: text in self.printed() or self.process.poll() is not None)
        assert text in self.printed(), self.printed()

    def stop(self) -> int:
        self.process.send_signal(signal.SIGINT)
        return self.process.wait()


@pytest.fixture
def watching(listening: Engine, tmp_path: Path) -> Iterator[Watching]:
    file = tmp_path / "scene.rl"
    file.write_text(ROAD % 0 + CAR)
    process = Watching(file, listening.port)
    yield process
    process.process.kill()
    process.process.wait()


def test_a_saved_change_is_sent_and_a_fault_is_reported_without_harm(
    watching: Watching, listening: Engine, tmp_path: Path
) -> None:
    file = tmp_path / "scene.rl"
    watching.waits_for("is being driven")
    file.write_text(ROAD % 6 + CAR)
    watching.waits_for("changes in")
    file.write_text("raod main\n")
    watching.waits_for("raod")
    file.write_text(ROAD % 3 + CAR)
    until(lambda: watching.printed().count("changes in") == 2)
    assert watching.stop() == 130
    assert "SCRIPT ERROR" not in listening.output()
