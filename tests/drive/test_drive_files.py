"""`Backend.drive_files`: what a backend writes of each drive, beside the traces."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar

import numpy as np
import pytest

from roadlang import testing
from roadlang.api import Backend, DiagnosticError, Scene, String, Trace, option
from roadlang.cli.main import run
from roadlang.session.drive_outputs import drive_backends
from roadlang.session.finished_drives import finished
from roadlang.session.run_files import RunFolder
from tests.straight_road import STRAIGHT

TEXT = (
    STRAIGHT
    + """
agent ego is car on main at 5m { drive with pure_pursuit { speed: 6m/s }, sense with gps }
object oak is tree on main at 50m { side: right, offset: 2m }
simulate with builtin { duration: 2s }
"""
)


@dataclass(frozen=True)
class Log(Backend):
    """Names and number of samples of what moves."""

    name: ClassVar[str] = "log"
    ending: String = option("drive.txt", help="of the file")
    fails_in: String = option("", help="the scene in which it raises")

    def drive_files(self, scene: Scene, trace: Trace) -> Mapping[str, str]:
        """One file."""
        if scene.stem == self.fails_in:
            raise ValueError("no")
        return {self.ending: f"{scene.stem} {list(trace.agents)} {len(trace.time)}\n"}


def written(folder: Path, emits: str = "emit log\n", n: int = 1, resume: bool = False) -> RunFolder:
    """The folder of a run of which the scenes without an entry in its journal are driven."""
    scenes = testing.sample(TEXT + emits, n, kinds=[Log])
    found = RunFolder(folder, "key", "{}", resume)
    open_ = [number for number in range(n) if number not in found.finished]
    if open_:
        found.add(finished(scenes.run(), drive_backends(scenes.loaded)))
    return found


def test_files_of_drives_are_beside_the_traces(tmp_path: Path) -> None:
    written(tmp_path, n=2)
    assert (tmp_path / "scene-0001.drive.txt").read_text() == "scene-0001 ['ego'] 21\n"
    assert (tmp_path / "scene-0001.trace.csv").is_file()
    with np.load(tmp_path / "scene-0001.ego.gps.npz") as readings:
        assert len(readings["time"]) == len(readings["arrival"]) > 0


def test_backends_of_scenes_alone_write_nothing_of_drives(tmp_path: Path) -> None:
    written(tmp_path, "emit log\nemit svg\n")
    assert not (tmp_path / "scene-0000.svg").exists()


@pytest.mark.parametrize(
    ("emits", "code", "says"),
    [
        ('emit log { ending: "trace.csv" }', "RL474", "which `roadlang run` uses"),
        ('emit log { ending: "Ego.gps.npz" }', "RL474", "which `roadlang run` uses"),
        ('emit log { ending: "../x" }', "RL474", "gave a file the name '../x'"),
        ("emit log\nemit log", "RL931", "both write `scene-0000.drive.txt`"),
        ('emit log { fails_in: "scene-0001" }', "RL470", "no"),
    ],
)
def test_of_a_faulty_backend_nothing_is_written(
    emits: str, code: str, says: str, tmp_path: Path
) -> None:
    with pytest.raises(DiagnosticError) as caught:
        written(tmp_path, emits + "\n", n=2)
    assert (caught.value.diagnostics[0].code, says in caught.value.diagnostics[0].message) == (
        code,
        True,
    )
    assert not list(tmp_path.glob("scene-*"))


def test_a_drive_without_its_files_is_not_finished(tmp_path: Path) -> None:
    written(tmp_path)
    assert list(written(tmp_path, resume=True).finished) == [0]
    (tmp_path / "scene-0000.drive.txt").unlink()
    again = RunFolder(tmp_path, "key", "{}", True)
    assert not again.finished


def test_other_outputs_are_refused_before_anything_is_driven(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("bend.rl").write_text(TEXT)
    for file in ("bend.rl", "scene.json"):
        assert run(["run", file, "--emit", "svg"]) == 2
        printed = capsys.readouterr().err
        assert "error[RL939]: `emit svg` writes no files for drives" in printed
        assert "those that do are `commonroad`" in printed
        Path("scene.json").write_text(testing.sample(TEXT)[0].to_json())
    assert run(["run", "bend.rl", "--emit", "svgg"]) == 2
    assert "did you mean `svg`" in capsys.readouterr().err
    assert not Path("out").exists()


def test_results_say_what_was_emitted(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("bend.rl").write_text(TEXT)
    assert run(["run", "bend.rl", "-o", "out"]) == 0
    assert "--emit" not in json.loads(Path("out/provenance.json").read_text())["again"]
