"""The commands as a user runs them: words on stdout and stderr, an exit code, no traceback."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

from tests.cli.command_lines import SCENE, roadlang


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


def test_scenes_without_pictures_are_compiled_without_opencv(tmp_path: Path) -> None:
    (tmp_path / "scene.rl").write_text("road r { draw with segments { pieces: [straight(9m)] } }\n")
    found = imported_by("compile", "scene.rl", "-o", "out", cwd=tmp_path)
    assert (tmp_path / "out" / "scene-0000.svg").exists()
    assert "numpy" in found
    assert "cv2" not in found


def test_help_lists_the_commands(tmp_path: Path) -> None:
    done = roadlang("--help", cwd=tmp_path)
    assert done.returncode == 0
    for name in ("compile", "check", "fmt", "init", "explain", "plugins", "schema", "completion"):
        assert f"  {name} " in done.stdout


def test_a_misspelled_command_gets_its_name(tmp_path: Path) -> None:
    done = roadlang("complie", cwd=tmp_path)
    assert done.returncode == 2
    assert "Did you mean `compile`?" in done.stderr


def test_fmt_check_and_diff_change_nothing(folder: Path) -> None:
    (folder / "scene.rl").write_text("param   a=3m   # why\n")
    checked = roadlang("fmt", "--check", "scene.rl", cwd=folder)
    shown = roadlang("fmt", "--diff", "scene.rl", cwd=folder)
    assert (checked.returncode, shown.returncode) == (1, 1)
    assert "+param a = 3m" in shown.stdout
    assert (folder / "scene.rl").read_text() == "param   a=3m   # why\n"
    assert roadlang("fmt", "scene.rl", cwd=folder).returncode == 0
    assert roadlang("fmt", "--check", "scene.rl", cwd=folder).returncode == 0


def test_fmt_keeps_the_line_ends_of_windows(folder: Path) -> None:
    """Where git checks files out with them, all files of a project would change."""
    scene = folder / "scene.rl"
    scene.write_bytes(b"param   a=3m\r\n\r\nparam b = 4m\r\n")
    assert roadlang("fmt", "scene.rl", cwd=folder).returncode == 0
    assert scene.read_bytes() == b"param a = 3m\r\n\r\nparam b = 4m\r\n"
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


def test_init_leaves_nothing_on_a_full_disk(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    from roadlang.cli.main import run

    def full(handle: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("os.fsync", full)
    monkeypatch.chdir(tmp_path)
    assert run(["init", "new.rl"]) == 2
    assert "no space left on device" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


def test_init_says_a_command_that_can_be_pasted(tmp_path: Path) -> None:
    done = roadlang("init", "my scene.rl", cwd=tmp_path)
    assert "roadlang compile 'my scene.rl' -o out -n 4" in done.stdout
    assert "'my scene.rl'" in (tmp_path / "my scene.rl").read_text().splitlines()[0]


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


@pytest.mark.parametrize(
    "name", ["scene", "manifest", "trace", "scenario", "labels", "dataset", "sine"]
)
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
