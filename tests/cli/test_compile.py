"""`roadlang compile`: files, exit codes, nothing half-written."""

from __future__ import annotations

import json
from hashlib import sha256
from pathlib import Path
from typing import Any

import pytest

from tests.cli.command_lines import SCENE, roadlang


def test_compile_writes_scenes_figures_a_sheet_and_a_manifest(folder: Path) -> None:
    done = roadlang("compile", "scene.rl", "-n", "2", "-o", "out", cwd=folder)
    assert done.returncode == 0, done.stderr
    names = sorted(path.name for path in (folder / "out").iterdir())
    assert names == [
        "contact-sheet.svg",
        "manifest.json",
        "scene-0000.json",
        "scene-0000.svg",
        "scene-0001.json",
        "scene-0001.svg",
    ]


def test_the_manifest_has_the_digest_of_every_file(folder: Path) -> None:

    roadlang("compile", "scene.rl", "-n", "2", "-o", "out", cwd=folder)
    manifest = json.loads((folder / "out/manifest.json").read_text())
    for file in manifest["files"]:
        data = (folder / "out" / file["path"]).read_bytes()
        assert file["sha256"] == sha256(data).hexdigest()
    assert manifest["inputs"]["scene.rl"] == sha256(SCENE.encode()).hexdigest()
    assert [row["name"] for row in manifest["requirements"]] == ["near"]


def files_of(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def test_two_runs_and_any_number_of_jobs_give_the_same_bytes(folder: Path) -> None:
    for name, jobs in (("a", "1"), ("b", "1"), ("c", "2")):
        roadlang(
            "compile", "scene.rl", "-n", "3", "--seed", "5", "--jobs", jobs, "-o", name, cwd=folder
        )
    assert files_of(folder / "a") == files_of(folder / "b") == files_of(folder / "c")


def test_a_scene_does_not_depend_on_how_many_are_asked_for(folder: Path) -> None:
    roadlang("compile", "scene.rl", "-n", "2", "-o", "few", cwd=folder)
    roadlang("compile", "scene.rl", "-n", "6", "-o", "many", cwd=folder)
    few, many = files_of(folder / "few"), files_of(folder / "many")
    for name in ("scene-0000.json", "scene-0001.json", "scene-0001.svg"):
        assert few[name] == many[name]


def test_outputs_are_one_list_or_several_options(folder: Path) -> None:
    roadlang("compile", "scene.rl", "--emit", "svg,json", "-o", "one", cwd=folder)
    roadlang("compile", "scene.rl", "--emit", "svg", "--emit", "json", "-o", "two", cwd=folder)
    names = [sorted(path.name for path in (folder / out).iterdir()) for out in ("one", "two")]
    assert names[0] == names[1]
    assert {"scene-0000.json", "scene-0000.svg"} <= set(names[0])


def test_emit_on_the_command_line_replaces_the_files(folder: Path) -> None:
    roadlang("compile", "scene.rl", "--emit", "svg", "-o", "out", cwd=folder)
    assert sorted(files_of(folder / "out")) == ["manifest.json", "scene-0000.svg"]


def test_an_output_on_the_command_line_has_options_as_in_a_file(folder: Path) -> None:
    words = ("compile", "scene.rl", "-o", "out", "--emit")
    assert roadlang(*words, "json, svg{size: 300px, labels: false}", cwd=folder).returncode == 0
    assert 'width="300"' in (folder / "out/scene-0000.svg").read_text()
    done = roadlang(*words, "svg{size: 300}", cwd=folder)
    assert (done.returncode, "--emit:1:16" in done.stderr) == (1, True), done.stderr
    done = roadlang(*words, "svg{size: 300px", cwd=folder)
    assert (done.returncode, "RL003" in done.stderr) == (1, True), done.stderr
    done = roadlang(*words, "json road", cwd=folder)
    assert (done.returncode, "RL900" in done.stderr) == (1, False), done.stderr


def test_an_output_that_the_file_has_keeps_its_options(folder: Path) -> None:
    (folder / "scene.rl").write_text(SCENE.replace("emit svg", "emit svg { size: 300px }"))
    roadlang("compile", "scene.rl", "-o", "out", "--emit", "svg", cwd=folder)
    assert set(files_of(folder / "out")) == {"manifest.json", "scene-0000.svg"}
    assert 'width="300"' in (folder / "out/scene-0000.svg").read_text()
    roadlang("compile", "scene.rl", "-o", "out", "--emit", "standard.svg", cwd=folder)
    assert 'width="300"' in (folder / "out/scene-0000.svg").read_text()


def test_an_unknown_output_is_said_before_any_search(folder: Path) -> None:
    done = roadlang("compile", "scene.rl", "--emit", "svgg,json,nope", cwd=folder)
    assert (done.returncode, done.stderr.count("RL930")) == (2, 2)
    assert "did you mean `svg`?" in done.stderr


def test_a_file_without_emit_gets_json_and_svg(folder: Path) -> None:
    (folder / "scene.rl").write_text(SCENE.replace("emit json\nemit svg\n", ""))
    assert roadlang("compile", "scene.rl", cwd=folder).returncode == 0
    assert set(files_of(folder / "out")) == {"manifest.json", "scene-0000.json", "scene-0000.svg"}


def test_emitting_nothing_is_refused(folder: Path) -> None:
    done = roadlang("compile", "scene.rl", "--emit", "", cwd=folder)
    assert (done.returncode, "RL928" in done.stderr) == (2, True)


def test_compile_json_prints_manifest_and_diagnostics(folder: Path) -> None:
    done = roadlang("compile", "scene.rl", "-o", "out", "--json", cwd=folder)
    record = json.loads(done.stdout)
    assert record["manifest"]["scenes"] == 1
    assert record["diagnostics"] == []


VIOLATED = (
    SCENE
    + """\
expect tight: always (abs(deviation(bent, main)) < 0.1m)
expect loose: always (abs(deviation(bent, main)) < 9m)
"""
)


def test_a_road_that_violates_an_expectation_is_written_and_exits_4(folder: Path) -> None:
    (folder / "scene.rl").write_text(VIOLATED)
    done = roadlang("compile", "scene.rl", "-n", "3", "-o", "out", cwd=folder)
    assert done.returncode == 4
    lines = done.stdout.splitlines()
    assert lines[0].startswith("  violated  tight: always (abs(deviation(bent, main)) < 0.1m), in ")
    assert lines[1].endswith("all expectations hold in 0 of 3 scenes")
    assert "loose" not in done.stdout
    assert len(files_of(folder / "out")) == 8
    found = json.loads(roadlang("compile", "scene.rl", "--json", cwd=folder).stdout)
    assert [(e["name"], e["judged"], e["violated"]) for e in found["expectations"]] == [
        ("tight", [0], [0]),
        ("loose", [0], []),
    ]


def test_expectations_over_the_drive_are_not_judged_by_compile(folder: Path) -> None:
    drive = "agent ego is car on bent at 5m {}\nexpect slow: always (ego.speed < 1m/s)\n"
    (folder / "scene.rl").write_text(SCENE + drive)
    done = roadlang("compile", "scene.rl", "--json", cwd=folder)
    assert done.returncode == 0, done.stderr
    (found,) = json.loads(done.stdout)["expectations"]
    assert (found["judged"], found["violated"], found["worst"]) == ([], [], None)


def test_impossible_requirements_exit_3_with_the_table_and_write_nothing(folder: Path) -> None:
    (folder / "scene.rl").write_text(SCENE + "require far: always (deviation(bent, main) > 50m)\n")
    done = roadlang("compile", "scene.rl", "-o", "out", cwd=folder)
    assert done.returncode == 3
    assert "far" in done.stderr
    assert "rejected" in done.stderr
    assert not (folder / "out").exists()


def test_a_failing_run_leaves_an_earlier_output_as_it_was(folder: Path) -> None:
    roadlang("compile", "scene.rl", "-o", "out", cwd=folder)
    before = files_of(folder / "out")
    (folder / "scene.rl").write_text(SCENE.replace("sine", "sinus"))
    assert roadlang("compile", "scene.rl", "-o", "out", cwd=folder).returncode == 1
    assert files_of(folder / "out") == before


def test_scenes_of_an_earlier_run_go_and_files_of_others_stay(folder: Path) -> None:
    roadlang("compile", "scene.rl", "-n", "3", "-o", "out", cwd=folder)
    (folder / "out/notes.txt").write_text("mine")
    roadlang("compile", "scene.rl", "-n", "1", "--emit", "json", "-o", "out", cwd=folder)
    assert set(files_of(folder / "out")) == {"manifest.json", "notes.txt", "scene-0000.json"}


def test_a_manifest_of_something_else_is_left_alone(folder: Path) -> None:
    (folder / "manifest.json").write_text('{"name": "a web page"}')
    done = roadlang("compile", "scene.rl", "-o", ".", cwd=folder)
    assert (done.returncode, "RL460" in done.stderr) == (2, True)
    assert set(files_of(folder)) == {"manifest.json", "scene.rl"}


def test_a_plugin_that_changes_the_current_folder_changes_no_output(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from roadlang_standard.emit_json import Json

    files = Json.files
    (folder / "elsewhere").mkdir()

    def wandering(self: Any, scene: Any) -> Any:
        monkeypatch.chdir(folder / "elsewhere")
        return files(self, scene)

    monkeypatch.setattr(Json, "files", wandering)
    done = roadlang("compile", "scene.rl", "-o", "out", cwd=folder)
    assert done.returncode == 0
    assert "scene-0000.json" in files_of(folder / "out")
    assert f"files in {Path('out')}\n" in done.stdout


def test_an_output_folder_that_cannot_be_made_is_said(folder: Path) -> None:
    (folder / "file").write_text("")
    done = roadlang("compile", "scene.rl", "-o", "file/out", cwd=folder)
    assert (done.returncode, "RL460" in done.stderr) == (2, True)
