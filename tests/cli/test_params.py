"""`--params FILE.yaml`: params from a map, or a run for each map of a list."""

from __future__ import annotations

import csv
import json
from hashlib import sha256
from pathlib import Path

import pytest

import roadlang
from roadlang.cli.main import run
from roadlang.session.param_files import read_params
from roadlang.session.params import parse_overrides
from roadlang.session.tables import columns_of, to_csv

from .command_lines import roadlang as command

SCENE = """\
param reach = 6m
param turns = 2
param both = false
param sides = [1m, 2m]
param name = "plain"
road main { draw with waypoints { points: [(0m, 0m), (80m, 10m), (160m, -10m), (240m, 30m)] } }
road bent from main { perturb with sine { amplitude: 1m..reach, wavelength: 80m..200m } }
expect near: always (abs(deviation(bent, main)) < 3m)
emit json
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "scene.rl").write_text(SCENE)
    return tmp_path


def write(folder: Path, text: str) -> Path:
    path = folder / "night.yaml"
    path.write_text(text)
    return path


def values_of(path: Path) -> dict[str, object]:
    values: dict[str, object] = json.loads(path.read_text())["values"]
    return values


def rows_of(path: Path) -> list[dict[str, str]]:
    return list(csv.DictReader(path.open()))


def test_a_map_sets_params(folder: Path) -> None:
    path = write(folder, "reach: 2m\nturns: 3\nboth: true\nsides: [3m, 4m]\nname: '\"other\"'\n")
    done = command("compile", "scene.rl", "--params", "night.yaml", "-o", "out", cwd=folder)
    assert done.returncode == 0, done.stderr
    values = values_of(folder / "out/scene-0000.json")
    assert values["reach"] == 2.0
    assert values["turns"] == 3.0
    assert values["both"] is True
    assert values["sides"] == [3.0, 4.0]
    assert values["name"] == "other"
    manifest = json.loads((folder / "out/manifest.json").read_text())
    assert manifest["inputs"]["night.yaml"] == sha256(path.read_bytes()).hexdigest()
    assert manifest["overrides"] == {
        "reach": "2m", "turns": "3", "both": "true", "sides": "[3m, 4m]", "name": '"other"'
    }  # fmt: skip


def test_set_wins_over_the_file(folder: Path) -> None:
    write(folder, "reach: 2m\nturns: 3\n")
    words = ("compile", "scene.rl", "--params", "night.yaml", "--set", "reach=1.5m", "-o", "out")
    assert command(*words, cwd=folder).returncode == 0
    values = values_of(folder / "out/scene-0000.json")
    assert (values["reach"], values["turns"]) == (1.5, 3.0)


def test_a_list_makes_a_folder_for_each_run_and_a_table(folder: Path) -> None:
    write(folder, "- reach: 2m\n- {reach: 20m, turns: 5}\n")
    words = ("compile", "scene.rl", "--params", "night.yaml", "-o", "out", "-n", "3")
    done = command(*words, cwd=folder)
    assert done.returncode == 4
    assert "3 scenes of 3 candidates, 3 files in out/run-000" in done.stdout
    assert values_of(folder / "out/run-001/scene-0002.json")["turns"] == 5.0
    first, second = rows_of(folder / "out/runs.csv")
    assert first == {
        "run": "run-000", "reach": "2m", "turns": "", "scenes": "3", "candidates": "3",
        "violated": "", "exit code": "0",
    }  # fmt: skip
    assert (second["turns"], second["violated"], second["exit code"]) == ("5", "near", "4")


def test_a_list_of_one_is_a_list(folder: Path) -> None:
    write(folder, "- reach: 2m\n")
    command("compile", "scene.rl", "--params", "night.yaml", "-o", "out", cwd=folder)
    assert (folder / "out/run-000/scene-0000.json").exists()


def test_json_of_a_list_is_a_list(folder: Path) -> None:
    write(folder, "- reach: 2m\n- reach: 1.5m\n")
    words = ("compile", "scene.rl", "--params", "night.yaml", "--json", "-o", "out")
    records = json.loads(command(*words, cwd=folder).stdout)
    assert [record["manifest"]["overrides"]["reach"] for record in records] == ["2m", "1.5m"]


def test_runs_of_an_earlier_table_go_and_files_of_others_stay(folder: Path) -> None:
    write(folder, "- reach: 2m\n- reach: 1.5m\n- reach: 3m\n")
    words = ("compile", "scene.rl", "--params", "night.yaml", "-o", "out")
    command(*words, cwd=folder)
    (folder / "out/run-002/notes.txt").write_text("mine")
    (folder / "out/run-old").mkdir()
    write(folder, "- reach: 2m\n")
    command(*words, cwd=folder)
    found = sorted(str(p.relative_to(folder / "out")) for p in (folder / "out").rglob("*"))
    assert found == [
        "run-000", "run-000/manifest.json", "run-000/scene-0000.json", "run-002",
        "run-002/notes.txt", "run-old", "runs.csv",
    ]  # fmt: skip


def test_a_run_without_scenes_does_not_end_the_others(folder: Path) -> None:
    (folder / "scene.rl").write_text(SCENE + "require r: length(main) < turns * 100m\n")
    write(folder, "- turns: 1\n- turns: 3\n")
    done = command("compile", "scene.rl", "--params", "night.yaml", "-o", "out", cwd=folder)
    assert (done.returncode, "RL600" in done.stderr) == (3, True)
    rows = rows_of(folder / "out/runs.csv")
    counts = [(row["scenes"], row["candidates"], row["exit code"]) for row in rows]
    assert counts == [("0", "0", "3"), ("1", "1", "0")]
    assert not (folder / "out/run-000").exists()


def test_params_of_included_files_are_set(folder: Path) -> None:
    (folder / "two.rl").write_text('include "scene.rl" as left\nemit json\n')
    write(folder, "- left.reach: 2m\n- left.reach: 1.5m\n")
    done = command("compile", "two.rl", "--params", "night.yaml", "-o", "out", cwd=folder)
    assert done.returncode == 0, done.stderr
    assert [row["left.reach"] for row in rows_of(folder / "out/runs.csv")] == ["2m", "1.5m"]


def test_a_fault_in_one_map_writes_nothing(folder: Path) -> None:
    write(folder, "- reach: 2m\n- reach: 2q\n")
    done = command("compile", "scene.rl", "--params", "night.yaml", "-o", "out", cwd=folder)
    assert (done.returncode, "night.yaml:2:10" in done.stderr) == (1, True), done.stderr
    assert not (folder / "out").exists()


@pytest.mark.parametrize(
    ("text", "code", "place", "words"),
    [
        ("reach: 12q", "RL203", "night.yaml:1:8", "reach: 12q"),
        ('turns: 1\nreach: "12q"', "RL203", "night.yaml:2:9", 'reach: "12q"'),
        ("reach: >\n  12q\n", "RL203", "night.yaml:1", "12q"),
        ("sides: [1m, 2q]", "RL203", "night.yaml:1:13", "sides: [1m, 2q]"),
        ("reach: 12", "RL202", "night.yaml:1:8", "reach: 12"),
        ("reach: 0x10", "RL202", "night.yaml:1", "16"),
        ("rech: 12m", "RL108", "night.yaml:1:7", "did you mean `reach`?"),
        ("reach: {a: 1}", "RL937", "night.yaml:1:8", "cannot have this value"),
        ("reach:", "RL937", "night.yaml:1:7", "cannot have this value"),
        ("reach: 2020-01-01", "RL937", "night.yaml:1:8", "cannot have this value"),
        ("reach: .nan", "RL937", "night.yaml:1:8", "cannot have this value"),
        ("reach: 1m\nreach: 2m", "RL937", "night.yaml:2:1", "set twice"),
        ("? [a]\n: 1", "RL937", "night.yaml:1:3", "the name of a param"),
        ("1: 2", "RL937", "night.yaml:1:1", "the name of a param"),
        ("turns: 010", "RL937", "night.yaml:1:8", "YAML 1.1 reads `010` as 8"),
        ("turns: [1, 1:30]", "RL937", "night.yaml:1:12", "YAML 1.1 reads `1:30` as 90"),
        ("turns: 1_0", "RL937", "night.yaml:1:8", "YAML 1.1 reads `1_0` as 10"),
        ("both: yes", "RL937", "night.yaml:1:7", "YAML 1.1 reads `yes` as true"),
        ("12m", "RL937", "night.yaml:1:1", "expected params"),
        ("- 12m\n- reach: 1m", "RL937", "night.yaml:1:3", "expected params"),
        ("", "RL937", "night.yaml:1:1", "expected params"),
        ("[]", "RL937", "night.yaml:1:1", "the list is empty"),
        ("a: [1", "RL936", "night.yaml:1:6", "expected"),
        ("a: *b", "RL936", "night.yaml:1:4", "undefined alias"),
        ("a: 1\n---\nb: 1", "RL936", "night.yaml:2:1", "document"),
        ("a: \x01", "RL936", "night.yaml", "special characters"),
        ("sides: !mine [1m, 2m]", "RL937", "night.yaml:1:8", "cannot have this value"),
        ("a: !!python/object:os.system x", "RL937", "night.yaml:1:4", "cannot have this value"),
    ],
)
def test_faults_are_placed_in_the_file(
    text: str, code: str, place: str, words: str, folder: Path
) -> None:
    write(folder, text)
    done = command("compile", "scene.rl", "--params", "night.yaml", "-o", "out", cwd=folder)
    assert done.returncode in (1, 2)
    assert f"[{code}]" in done.stderr
    assert place in done.stderr
    assert words in done.stderr
    assert "RL900" not in done.stderr


def test_aliases_of_aliases_are_bounded(folder: Path) -> None:
    lines = ["a0: &a0 [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]"]
    lines += [f"a{i}: &a{i} [{', '.join([f'*a{i - 1}'] * 10)}]" for i in range(1, 12)]
    write(folder, "\n".join(lines))
    with pytest.raises(roadlang.DiagnosticError, match="RL937"):
        read_params(str(folder / "night.yaml"))


@pytest.mark.parametrize(
    ("content", "code"), [(None, "RL920"), (b"\xff\xfe", "RL922"), (b"#" * 4_000_001, "RL920")]
)
def test_a_file_that_cannot_be_read(content: bytes | None, code: str, folder: Path) -> None:
    if content is not None:
        (folder / "night.yaml").write_bytes(content)
    with pytest.raises(roadlang.DiagnosticError, match=code):
        read_params(str(folder / "night.yaml"))


def test_from_python(folder: Path) -> None:
    path = write(folder, "- reach: 2m\n- reach: 1.5m\n")
    variants = roadlang.load(folder / "scene.rl").with_param_file(path)
    assert [variant.sample()[0].values["reach"] for variant in variants] == [2.0, 1.5]
    assert variants[0].params == {"reach": "2m"}


def test_a_table_has_a_cell_for_every_name() -> None:
    rows = [{"a": 1, "b": [1, 2]}, {"a": True, "c": 'say "x"'}]
    assert to_csv(columns_of(rows)) == 'a,b,c\n1,"[1, 2]",\ntrue,,"say ""x"""\n'


@pytest.mark.parametrize("command", ["compile", "run"])
def test_an_error_that_all_runs_share_is_said_once(
    command: str, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / "scene.rl").write_text(SCENE + "require odd: always (bent < 3m)\n")
    params = write(folder, "- reach: 4m\n- reach: 5m\n")
    words = [command, str(folder / "scene.rl"), "--params", str(params)]
    assert run([*words, "-o", str(folder / "out")]) == 1
    assert capsys.readouterr().err.count("error[") == 1
    assert not (folder / "out").exists()


@pytest.mark.parametrize(
    ("setting", "fits"),
    [
        ("reach=4m", True),
        (" reach = 4m ", True),
        ("left.reach=4m", True),
        ("reach=a=b", True),
        ("reach", False),
        ("reach=", False),
        ("=4m", False),
        ("", False),
        ("left.=4m", False),
        (".reach=4m", False),
        ("left.9=4m", False),
        ("9.reach=4m", False),
        ("left reach=4m", False),
    ],
)
def test_a_setting_is_a_name_and_a_value(setting: str, fits: bool) -> None:
    if fits:
        name, _, value = setting.partition("=")
        found = parse_overrides([setting])
        assert {name: value.text for name, value in found.items()} == {name.strip(): value.strip()}
    else:
        with pytest.raises(roadlang.DiagnosticError, match="RL924") as caught:
            parse_overrides(["turns=3", setting, "reach"])
        assert len(caught.value.diagnostics) == 2


def test_all_runs_are_checked_before_the_first_is_driven(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    agent = "agent ego is car on bent at 5m { drive with lane_follow { speed: 5m/s } }\n"
    (folder / "scene.rl").write_text(SCENE + agent)
    params = write(folder, "- reach: 3m\n- reach: 4kg\n- turns: x3\n")
    out = folder / "out"
    code = run(["run", str(folder / "scene.rl"), "--params", str(params), "-o", str(out)])
    found = capsys.readouterr()
    assert code == 1
    assert found.err.count("error[") == 2
    assert "night.yaml:2" in found.err
    assert "night.yaml:3" in found.err
    assert not out.exists()


def test_runs_of_which_there_is_only_a_warning_are_driven(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    agent = "agent ego is car on main at 5m { drive with lane_follow { speed: 5m/s } }\n"
    (folder / "scene.rl").write_text(SCENE + agent)
    params = write(folder, "- reach: 2m\n- reach: 2.5m\n")
    out = folder / "out"
    words = ["run", str(folder / "scene.rl"), "--params", str(params), "-o", str(out)]
    assert run([*words, "--duration", "1s"]) == 0
    assert "warning[RL192]" in capsys.readouterr().err
    assert len([*out.glob("run-*")]) == 2
