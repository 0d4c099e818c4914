"""A folder holds the results of one command: `compile`, `run` and `falsify` mix none."""

from __future__ import annotations

from pathlib import Path

import pytest

import roadlang
from roadlang.cli.main import run

TEXT = """
param fastest = 16m/s
road main { draw with waypoints { points: [(0m, 0m), (60m, 0m), (90m, 25m), (90m, 80m)] }, width: 7m }
agent ego is car on main at 5m { drive with pure_pursuit { speed: 6m/s..fastest } }
expect slow: always (ego.speed < 11m/s)
simulate with builtin { duration: 2s, control_step: 0.1s }
falsify with random { evaluations: 6, random: 0% }
"""  # noqa: E501
COMMANDS = {
    "compile": ["compile", "bend.rl", "-o", "out"],
    "run": ["run", "bend.rl", "-o", "out"],
    "falsify": ["falsify", "bend.rl", "-o", "out"],
    "compile --params": ["compile", "bend.rl", "-o", "out", "--params", "runs.yaml"],
    "run --params": ["run", "bend.rl", "-o", "out", "--params", "runs.yaml"],
}
DONE = (0, 4)


@pytest.fixture(autouse=True)
def scene_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("bend.rl").write_text(TEXT)
    Path("runs.yaml").write_text("[{fastest: 7m/s}, {fastest: 8m/s}, {fastest: 9m/s}]")


def files() -> dict[Path, bytes]:
    return {path: path.read_bytes() for path in Path("out").rglob("*") if path.is_file()}


@pytest.mark.parametrize("first", COMMANDS)
def test_results_of_another_command_are_neither_replaced_nor_mixed_with(
    first: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(COMMANDS[first]) in DONE
    before = files()
    for second, words in COMMANDS.items():
        capsys.readouterr()
        resumed = [[*words, "--resume"]] if second in ("run", "falsify") else []
        for each in [words, *resumed] if second != first else resumed:
            code = run(each)
            if second == first:
                assert code in DONE
                continue
            error = capsys.readouterr().err
            assert code == 2
            assert "error[RL460]: cannot write `" in error
            assert f"it holds the results of `roadlang {first}`" in error
            assert files() == before
    assert run([*COMMANDS[first], "-o", "out/other"]) in DONE


def test_commands_without_a_named_folder_write_beside_each_other() -> None:
    for command in ("compile", "run", "falsify", "run", "compile"):
        assert run([command, "bend.rl"]) in DONE
    written = ("manifest.json", "drives/results.csv", "search/failures/0001.json")
    assert all(Path("out", name).is_file() for name in written)


def test_a_failure_is_not_driven_into_the_folder_of_its_search(
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert run(COMMANDS["falsify"]) == 4
    before = files()
    assert run(["run", "out/failures/0001.json", "-o", "out"]) == 2
    assert "it holds the results of `roadlang falsify`" in capsys.readouterr().err
    assert files() == before
    assert run(["run", "out/failures/0001.json", "-o", "out/drives"]) == 4
    assert run(["falsify", "bend.rl", "-o", "out", "--resume"]) == 4


def test_from_python() -> None:
    assert run(COMMANDS["run"]) in DONE
    loaded = roadlang.load("bend.rl")
    with pytest.raises(roadlang.DiagnosticError, match="`roadlang run`"):
        loaded.falsify(evaluations=2, folder="out")
    search = loaded.falsify(evaluations=2)
    for write in (search.write, loaded.sample(1).emit):
        with pytest.raises(roadlang.DiagnosticError, match="RL460"):
            write("out")


@pytest.mark.parametrize("command", ["run", "falsify"])
def test_a_report_goes_with_the_results_that_it_is_of(command: str) -> None:
    assert run(COMMANDS[command]) in DONE
    assert run(["report", "out"]) == 0
    assert run([*COMMANDS[command], "--seed", "1"]) in DONE
    assert not Path("out/report.html").exists()
    Path("out/report.html").write_text("mine")
    assert run(COMMANDS[command]) in DONE
    assert Path("out/report.html").read_text() == "mine"


def test_an_interrupted_search_leaves_no_record_of_the_one_before(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """The report would show its failures beside the evaluations of the other."""
    assert run(COMMANDS["falsify"]) == 4

    def interrupted(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("roadlang.session.falsification.Falsification.write", interrupted)
    assert run([*COMMANDS["falsify"], "--seed", "1"]) not in DONE
    capsys.readouterr()
    assert run(["report", "out"]) == 2
    assert "run the same command again with `--resume`" in capsys.readouterr().err


def test_fewer_runs_replace_those_of_an_earlier_table() -> None:
    assert run(COMMANDS["run --params"]) in DONE
    Path("out/run-002/notes.txt").write_text("mine")
    Path("runs.yaml").write_text("[{fastest: 7m/s}]")
    assert run(COMMANDS["run --params"]) in DONE
    assert {path.name for path in Path("out").iterdir()} == {"run-000", "run-002", "results.csv"}
    assert [path.name for path in Path("out/run-002").iterdir()] == ["notes.txt"]
