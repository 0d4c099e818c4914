"""The commands as a user runs them: words on stdout and stderr, an exit code, no traceback."""

from __future__ import annotations

import io
import json
import subprocess
import sys
from concurrent.futures.process import BrokenProcessPool
from contextlib import redirect_stderr, redirect_stdout
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

SCENE = """\
road main { draw with waypoints { points: [(0m, 0m), (80m, 10m), (160m, -10m), (240m, 30m)] } }
road bent from main { perturb with sine { amplitude: 0m..6m, wavelength: 80m..200m } }
require near: always (deviation(bent, main) < 3m)
emit json
emit svg
"""


@dataclass(frozen=True)
class Done:
    """What a command left behind."""

    returncode: int
    stdout: str
    stderr: str


def roadlang(*arguments: str, cwd: Path, **environment: str) -> Done:
    """Run a command line in `cwd`, in this process."""
    from roadlang.cli.main import run

    out, err = io.StringIO(), io.StringIO()
    with pytest.MonkeyPatch.context() as patch, redirect_stdout(out), redirect_stderr(err):
        patch.chdir(cwd)
        for name, value in environment.items():
            patch.setenv(name, value)
        code = run(list(arguments))
    return Done(code, out.getvalue(), err.getvalue())


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "scene.rl").write_text(SCENE)
    return tmp_path


def imported_by(*arguments: str, cwd: Path) -> set[str]:
    """The top-level modules that a command leaves imported."""
    code = (
        "import sys\n"
        "from roadlang.cli.main import run\n"
        f"run({list(arguments)!r})\n"
        "print('\\nMODULES', *{name.partition('.')[0] for name in sys.modules})\n"
    )
    done = subprocess.run([sys.executable, "-c", code], cwd=cwd, capture_output=True, text=True)
    return set(done.stdout.rpartition("MODULES")[2].split())


@pytest.mark.parametrize("option", ["--help", "--version"])
def test_help_and_version_import_nothing_heavy(option: str, tmp_path: Path) -> None:
    heavy = {"numpy", "scipy", "cv2", "lark", "pluggy", "msgspec", "yaml"}
    assert not imported_by(option, cwd=tmp_path) & heavy


def test_check_imports_neither_numpy_nor_scipy_nor_opencv(folder: Path) -> None:
    assert not imported_by("check", "scene.rl", cwd=folder) & {"numpy", "scipy", "cv2"}


def test_help_lists_the_commands(tmp_path: Path) -> None:
    done = roadlang("--help", cwd=tmp_path)
    assert done.returncode == 0
    for name in ("compile", "check", "fmt", "init", "explain", "plugins", "schema", "completion"):
        assert f"  {name} " in done.stdout


def test_a_misspelled_command_gets_its_name(tmp_path: Path) -> None:
    done = roadlang("complie", cwd=tmp_path)
    assert done.returncode == 2
    assert "Did you mean `compile`?" in done.stderr


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
    from hashlib import sha256

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
    assert roadlang("compile", "scene.rl", "-o", "out", cwd=folder).returncode == 0
    assert "scene-0000.json" in files_of(folder / "out")


def test_an_output_folder_that_cannot_be_made_is_said(folder: Path) -> None:
    (folder / "file").write_text("")
    done = roadlang("compile", "scene.rl", "-o", "file/out", cwd=folder)
    assert (done.returncode, "RL460" in done.stderr) == (2, True)


def test_check_json_has_every_fault_with_its_place(folder: Path) -> None:
    (folder / "scene.rl").write_text(SCENE.replace("amplitude", "amplitud").replace("3m", "3s"))
    done = roadlang("check", "scene.rl", "--json", cwd=folder)
    found = json.loads(done.stdout)
    assert done.returncode == 1
    assert {
        "code",
        "severity",
        "message",
        "file",
        "line",
        "column",
        "end_line",
        "end_column",
        "help",
    } <= set(found[0])
    assert {entry["line"] for entry in found} == {2, 3}


def test_set_gives_a_param_another_value(folder: Path) -> None:
    (folder / "scene.rl").write_text("param reach = 2m\n" + SCENE.replace("6m", "reach"))
    roadlang("compile", "scene.rl", "--set", "reach=1m", "-o", "out", cwd=folder)
    scene = json.loads((folder / "out/scene-0000.json").read_text())
    assert scene["values"]["reach"] == 1.0
    assert scene["provenance"]["overrides"] == {"reach": "1m"}


@pytest.mark.parametrize(
    ("content", "code", "status"),
    [
        (None, "RL920", 2),
        (b"\x89PNG\r\n\x1a\n\xff", "RL922", 1),
        (b"road main {\xff}", "RL922", 1),
        ("road main".encode("utf-16"), "RL922", 1),
        (b"#" * 5_000_000, "RL923", 1),
    ],
    ids=["missing", "picture", "latin", "utf16", "huge"],
)
@pytest.mark.parametrize("command", ["check", "compile", "fmt"])
def test_what_is_no_text_is_said_without_a_traceback(
    command: str, content: Any, code: str, status: int, tmp_path: Path
) -> None:
    if content is not None:
        (tmp_path / "scene.rl").write_bytes(content)
    done = roadlang(command, "scene.rl", cwd=tmp_path)
    assert done.returncode == status
    assert code in done.stderr
    assert "Traceback" not in done.stderr


def test_a_folder_is_no_scene_file(folder: Path) -> None:
    (folder / "scenes").mkdir()
    done = roadlang("check", "scenes", cwd=folder)
    assert (done.returncode, "RL921" in done.stderr) == (2, True)


def test_check_goes_on_after_a_file_that_is_not_there(folder: Path) -> None:
    done = roadlang("check", "nope.rl", "scene.rl", "gone.rl", "--json", cwd=folder)
    assert [entry["file"] for entry in json.loads(done.stdout)] == ["nope.rl", "gone.rl"]


def test_standard_input_is_a_file_called_dash(folder: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "roadlang", "fmt", "-"],
        input="param   a=3m\n",
        capture_output=True,
        text=True,
        cwd=folder,
    )
    assert done.stdout == "param a = 3m\n"


def test_fmt_check_and_diff_change_nothing(folder: Path) -> None:
    (folder / "scene.rl").write_text("param   a=3m   # why\n")
    checked = roadlang("fmt", "--check", "scene.rl", cwd=folder)
    shown = roadlang("fmt", "--diff", "scene.rl", cwd=folder)
    assert (checked.returncode, shown.returncode) == (1, 1)
    assert "+param a = 3m" in shown.stdout
    assert (folder / "scene.rl").read_text() == "param   a=3m   # why\n"
    assert roadlang("fmt", "scene.rl", cwd=folder).returncode == 0
    assert roadlang("fmt", "--check", "scene.rl", cwd=folder).returncode == 0


def test_fmt_leaves_a_file_with_errors_alone(folder: Path) -> None:
    (folder / "scene.rl").write_text("road main {\n")
    assert roadlang("fmt", "scene.rl", cwd=folder).returncode == 1
    assert (folder / "scene.rl").read_text() == "road main {\n"


@pytest.mark.parametrize("template", ["bend", "town", "sweep"])
def test_every_starter_scene_compiles(template: str, tmp_path: Path) -> None:
    assert roadlang("init", "new.rl", "--template", template, cwd=tmp_path).returncode == 0
    done = roadlang("compile", "new.rl", "-o", "out", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert roadlang("fmt", "--check", "new.rl", cwd=tmp_path).returncode == 0


def test_init_never_writes_over_a_file(folder: Path) -> None:
    done = roadlang("init", "scene.rl", cwd=folder)
    assert (done.returncode, "RL929" in done.stderr) == (2, True)
    assert (folder / "scene.rl").read_text() == SCENE


def test_explain_prints_a_page_and_knows_a_near_code(tmp_path: Path) -> None:
    assert "internal-error: internal error" in roadlang("explain", "RL900", cwd=tmp_path).stdout
    done = roadlang("explain", "RL999", cwd=tmp_path)
    assert (done.returncode, "RL925" in done.stderr) == (2, True)


def test_plugins_lists_kinds_and_shows_options(tmp_path: Path) -> None:
    record = json.loads(roadlang("plugins", "--json", cwd=tmp_path).stdout)
    assert {"verb": "perturb", "name": "sine"}.items() <= next(
        kind for kind in record["kinds"] if kind["name"] == "sine"
    ).items()
    shown = roadlang("plugins", "show", "perturb", "sine", cwd=tmp_path).stdout
    assert "wavelength: length (m); required; > 0m" in shown


@pytest.mark.parametrize("name", ["scene", "manifest", "trace", "scenario", "sine"])
def test_schemas_are_json_schemas(name: str, tmp_path: Path) -> None:
    import jsonschema

    schema = json.loads(roadlang("schema", name, cwd=tmp_path).stdout)
    jsonschema.Draft202012Validator.check_schema(schema)


def test_manifest_and_scenario_fit_their_schemas(folder: Path) -> None:
    import jsonschema

    roadlang("compile", "scene.rl", "-o", "out", cwd=folder)
    manifest = json.loads((folder / "out/manifest.json").read_text())
    jsonschema.validate(manifest, json.loads(roadlang("schema", "manifest", cwd=folder).stdout))
    scenario = json.loads(roadlang("check", "--scenario", "scene.rl", cwd=folder).stdout)
    jsonschema.validate(scenario, json.loads(roadlang("schema", "scenario", cwd=folder).stdout))


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_completion_scripts(shell: str, tmp_path: Path) -> None:
    assert "roadlang" in roadlang("completion", shell, cwd=tmp_path).stdout


def test_color_only_where_it_is_wanted(folder: Path) -> None:
    (folder / "scene.rl").write_text("raod main {}\n")
    assert "\x1b[" not in roadlang("check", "scene.rl", cwd=folder).stderr
    assert "\x1b[" in roadlang("--color", "always", "check", "scene.rl", cwd=folder).stderr
    assert "\x1b[" in roadlang("check", "scene.rl", cwd=folder, FORCE_COLOR="1").stderr
    quiet = roadlang("check", "scene.rl", cwd=folder, FORCE_COLOR="1", NO_COLOR="1")
    assert "\x1b[" not in quiet.stderr


def test_a_closed_pipe_ends_quietly(tmp_path: Path) -> None:
    done = subprocess.run(
        ["bash", "-c", f"{sys.executable} -m roadlang schema scenario | head -n 1"],
        capture_output=True,
        text=True,
        cwd=tmp_path,
    )
    assert done.stdout == "{\n"
    assert done.stderr == ""


def test_an_interruption_ends_quietly(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    from roadlang.cli import explain
    from roadlang.cli.main import run

    def interrupted() -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(explain, "codes", interrupted)
    assert run(["explain"]) == 130
    assert capsys.readouterr().err.strip() == "interrupted"


def test_a_bug_is_a_short_report_and_exit_70(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    from roadlang.cli import explain
    from roadlang.cli.main import run

    def broken() -> None:
        raise RuntimeError("the moon is full")

    monkeypatch.setattr(explain, "codes", broken)
    assert run(["explain"]) == 70
    words = capsys.readouterr().err
    assert "RL900" in words
    assert "the moon is full" in words
    assert "Traceback" not in words
    monkeypatch.setenv("ROADLANG_TRACEBACK", "1")
    with pytest.raises(RuntimeError):
        run(["explain"])


@pytest.mark.parametrize("words", ["schema scene", "explain", "compile scene.rl --json", "--help"])
def test_a_full_device_behind_standard_output_is_said(words: str, folder: Path) -> None:
    with open("/dev/full", "w") as full:
        command = [sys.executable, "-m", "roadlang", *words.split()]
        done = subprocess.run(command, stdout=full, stderr=subprocess.PIPE, text=True, cwd=folder)
    assert done.returncode == 2
    assert "RL927" in done.stderr
    assert "standard output" in done.stderr
    assert "Traceback" not in done.stderr
    assert "Exception ignored" not in done.stderr


@pytest.mark.parametrize(
    ("error", "code", "status"),
    [
        (MemoryError(), "RL933", 5),
        (ImportError("libx.so: failed to map segment from shared object"), "RL933", 5),
        (OSError(28, "No space left on device", "a.json"), "RL927", 2),
        (BrokenProcessPool("ended abruptly"), "RL934", 5),
        (OSError(2, "No such file"), "RL900", 70),
        (ValueError("no number"), "RL900", 70),
    ],
)
def test_what_the_machine_refuses_is_no_bug(
    error: Any,
    code: str,
    status: int,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    from roadlang.cli import explain
    from roadlang.cli.main import run

    def refused() -> None:
        raise error

    monkeypatch.setattr(explain, "codes", refused)
    assert run(["explain"]) == status
    assert f"[{code}]" in capsys.readouterr().err


def test_little_memory_leaves_nothing_written(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from roadlang_standard.emit_svg import Svg

    def drawn(self: Svg, scene: object) -> None:
        bytearray(1 << 62)

    monkeypatch.setattr(Svg, "files", drawn)
    done = roadlang("compile", "scene.rl", "-o", "out", cwd=folder)
    assert (done.returncode, "too little memory" in done.stderr) == (5, True), done.stderr
    assert not (folder / "out").exists()


def test_check_writes_the_fixes_that_leave_no_choice(folder: Path) -> None:
    (folder / "scene.rl").write_text(
        SCENE.replace("require near:", "requir near=") + "emit teleport\n"
    )
    done = roadlang("check", "--fix", "scene.rl", cwd=folder)
    assert "2 fixes" in done.stderr
    assert "teleport" in done.stderr
    assert done.returncode == 1
    assert (folder / "scene.rl").read_text() == SCENE + "emit teleport\n"


def test_check_fix_leaves_a_good_file_untouched(folder: Path) -> None:
    before = (folder / "scene.rl").stat()
    assert roadlang("check", "--fix", "scene.rl", cwd=folder).returncode == 0
    assert (folder / "scene.rl").stat().st_mtime_ns == before.st_mtime_ns
