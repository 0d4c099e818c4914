"""`roadlang shrink` and `roadlang explain` on failures on disk, and both in the report."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest

from roadlang.cli.main import run
from roadlang.session.failure_files import failure_in

TEXT = """
road main { draw with waypoints { points: [(0m, 0m), (60m, 0m), (90m, 25m), (90m, 80m)] }, width: 7m }
agent ego is car on main at 5m..9m { drive with pure_pursuit { speed: 6m/s..15m/s, lookahead: 5m..9m } }
object oak is tree on main at 50m { side: right, offset: 2m..4m }
expect slow: always (ego.speed < 11m/s)
simulate with builtin { duration: 6s, control_step: 0.1s }
falsify with random { evaluations: 20, random: 0% }
"""  # noqa: E501
DRAWS = ["ego/at", "ego/drive 1/speed", "ego/drive 1/lookahead", "oak/offset"]


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    Path("bend.rl").write_text(TEXT)
    return tmp_path


@pytest.fixture(scope="module")
def search(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder in which a search has found failures, to be copied by whoever changes it."""
    made: Path = tmp_path_factory.mktemp("search")
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(made)
        Path("bend.rl").write_text(TEXT)
        assert run(["falsify", "bend.rl", "-o", "out", "--seed", "2"]) == 4
    return made


@pytest.fixture
def failure(search: Path, folder: Path) -> Path:
    shutil.copytree(search, folder, dirs_exist_ok=True)
    return Path("out/failures/0001.json")


def test_the_simplest_scene_needs_its_speed_alone(
    failure: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    capsys.readouterr()
    assert run(["shrink", str(failure)]) == 0
    printed = capsys.readouterr().out
    assert "3 of 4 random values are at their simplest; it needs" in printed
    before, after = (json.loads(path.read_text()) for path in (failure, shrunk_of(failure)))
    speed = after["draws"]["ego/drive 1/speed"]
    assert 11.0 < speed <= before["draws"]["ego/drive 1/speed"]
    assert (speed + 6.0) / 2.0 < 11.0
    assert f"  ego/drive 1/speed = {speed:.3g} m/s" in printed
    assert after["draws"]["ego/at"] == 5.0
    assert after["draws"]["oak/offset"] == 2.0


def test_a_failure_is_driven_as_it_was_found_when_the_plan_has_changed() -> None:
    Path("bend.rl").write_text(TEXT.replace("random: 0%", "random: 0%, after_violation: 0.2s"))
    assert run(["falsify", "bend.rl", "-o", "out", "--seed", "2"]) == 4
    (found, *_) = json.loads(Path("out/failures/index.json").read_text())["failures"]
    Path("bend.rl").write_text(TEXT.replace("random: 0%", "random: 0%, after_violation: 5s"))
    again = failure_in("out/failures/0001.json")
    assert dict(again.robustness) == found["robustness"]
    assert again.drive.to_csv() == Path("out/failures/0001.trace.csv").read_text()


def test_a_failing_scene_of_a_run_is_driven_as_long_as_the_run_drove_it() -> None:
    assert run(["run", "bend.rl", "-n", "10", "-o", "out"]) == 4
    again = failure_in("out/scene-0000.json")
    assert again.drive.to_csv() == Path("out/scene-0000.trace.csv").read_text()


def test_scenes_name_their_scene_file(failure: Path) -> None:
    assert json.loads(failure.read_text())["provenance"]["source"] == "bend.rl"


def test_choices_shrink_to_their_first_item_and_integers_toward_zero() -> None:
    text = TEXT.replace("speed: 6m/s..15m/s", "speed: choice(14m/s, 6m/s, 15m/s)")
    Path("bend.rl").write_text(
        text.replace("side: right", "side: right, count: integer(2, 4), spacing: 9m")
    )
    run(["falsify", "bend.rl", "-o", "out", "--seed", "4", "--evaluations", "20"])
    draws = [
        json.loads(path.read_text())["draws"] for path in Path("out/failures").glob("0*1.json")
    ]
    assert run(["shrink", "out/failures/0001.json"]) == 0
    after = json.loads(Path("out/failures/0001.shrunk.json").read_text())["draws"]
    assert draws[0]["ego/drive 1/speed"] == 15.0 or draws[0]["oak/count"] > 2
    assert (after["ego/drive 1/speed"], after["oak/count"]) == (14.0, 2)


def test_a_scene_may_fail_without_any_of_its_draws(
    failure: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    Path("bend.rl").write_text(TEXT.replace("6m/s..15m/s", "13m/s..40m/s"))
    run(["falsify", "bend.rl", "-o", "out"])
    capsys.readouterr()
    run(["shrink", str(failure)])
    assert "it fails with all of its 4 random values at their simplest" in capsys.readouterr().out


def test_a_failure_that_is_not_the_worst_shrinks_too() -> None:
    Path("bend.rl").write_text(
        TEXT.replace("simulate", "expect slower: always (ego.speed < 8m/s)\nsimulate")
    )
    assert run(["falsify", "bend.rl", "-o", "out", "--evaluations", "8"]) == 4
    second = Path("out/failures/0002.json")
    assert failure_in(second).rank == 2
    assert run(["shrink", str(second)]) == 0
    assert second.with_name("0002.shrunk.svg").read_text().startswith("<svg")


def shrunk_of(failure: Path) -> Path:
    return failure.with_name("0001.shrunk.json")


def test_the_simplest_scene_fails_when_it_is_driven(
    failure: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    run(["shrink", str(failure)])
    assert run(["explain", str(shrunk_of(failure))]) == 2
    assert "it was made by `roadlang shrink` from 0001.json" in capsys.readouterr().err
    assert run(["run", str(shrunk_of(failure)), "-o", "again"]) == 4
    assert failure.with_name("0001.shrunk.svg").read_text().startswith("<svg")


def test_the_scene_goes_where_the_option_says(failure: Path) -> None:
    run(["shrink", str(failure), "-o", "simple/scene.json"])
    assert run(["run", "simple/scene.json", "-o", "again"]) == 4
    assert not shrunk_of(failure).exists()


def test_what_is_shrunk_has_the_ending_of_a_scene(
    failure: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    run(["shrink", str(failure), "-o", "simple"])
    assert "written to simple.json" in capsys.readouterr().out
    assert run(["run", "simple.json", "-o", "again"]) == 4


def test_an_explanation_names_the_moment_and_what_matters(
    failure: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    capsys.readouterr()
    assert run(["explain", str(failure)]) == 0
    lines = capsys.readouterr().out.splitlines()
    record = json.loads(failure.with_name("0001.explanation.json").read_text())
    index = json.loads(failure.with_name("index.json").read_text())["failures"][0]
    assert record["moment"] == index["moment"]
    assert record["robustness"] == index["robustness"]["slow"]
    assert record["unit"] == "m/s"
    assert lines[0].startswith("violated  slow: always (ego.speed < 11m/s)  robustness")
    assert lines[1].startswith(f"goes wrong at {index['moment']['time']:.1f} s, s = ")
    singles = {i["draws"][0]: i["robustness"] for i in record["medians"] if len(i["draws"]) == 1}
    assert sorted(singles) == sorted(DRAWS)
    assert next(iter(singles)) == "ego/drive 1/speed"
    assert singles["ego/drive 1/lookahead"] < 0
    assert len(record["medians"]) == 4 + 6


def test_a_failing_scene_of_a_run_is_taken_as_well(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["run", "bend.rl", "-n", "4", "-o", "drives", "--seed", "4"]) == 4
    failing = [
        path
        for path in sorted(Path("drives").glob("scene-????.json"))
        if '"satisfied": false' in path.with_name(f"{path.stem}.verdicts.json").read_text()
    ]
    assert 0 < len(failing) < 4
    for path in failing[:2]:
        assert run(["shrink", str(path)]) == 0
        assert run(["explain", str(path)]) == 0
        verdict = json.loads(path.with_name(f"{path.stem}.verdicts.json").read_text())
        record = json.loads(path.with_name(f"{path.stem}.explanation.json").read_text())
        assert record["robustness"] == verdict["expectations"][0]["robustness"]


def test_what_was_found_is_in_the_report_and_goes_with_the_failure(failure: Path) -> None:
    run(["shrink", str(failure)])
    run(["explain", str(failure)])
    assert run(["report", "out"]) == 0
    data = Path("out/report.html").read_text().partition('id="data">')[2].partition("</script>")[0]
    first, *others = json.loads(data)["drives"]
    assert first["shrunk"]["others"] == 3
    assert [row[0] for row in first["shrunk"]["draws"]] == ["ego/drive 1/speed"]
    assert first["explanation"]["medians"][0][0] == "ego/drive 1/speed"
    assert all(drive["shrunk"] is None for drive in others)
    run(["falsify", "bend.rl", "-o", "out", "--seed", "3"])
    assert not list(failure.parent.glob("*.shrunk.*"))
    assert not list(failure.parent.glob("*.explanation.json"))


@pytest.mark.parametrize("command", ["shrink", "explain"])
class TestRefused:
    def refused(self, *words: str, code: str, capsys: pytest.CaptureFixture[str]) -> int:
        capsys.readouterr()
        result = run([*words])
        written = capsys.readouterr().err
        assert code in written
        assert "help: \n" not in written
        return result

    def test_a_file_that_is_not_there(
        self, command: str, capsys: pytest.CaptureFixture[str]
    ) -> None:
        assert self.refused(command, "no.json", code="RL920", capsys=capsys) == 2

    def test_a_scene_without_results(
        self, command: str, failure: Path, capsys: pytest.CaptureFixture[str]
    ) -> None:
        shutil.copy(failure, "alone.json")
        assert self.refused(command, "alone.json", code="RL722", capsys=capsys) == 2

    def test_a_scene_file(
        self, command: str, failure: Path, capsys: pytest.CaptureFixture[str]
    ) -> None:
        Path("some.rl").write_text("road main {}")
        assert run([command, "some.rl"]) == 2
        written = capsys.readouterr().err
        assert "RL722" in written
        assert "`roadlang falsify some.rl -o DIR` searches for failures" in written

    def test_a_safe_scene(
        self, command: str, failure: Path, capsys: pytest.CaptureFixture[str]
    ) -> None:
        words = (command, "out/safe/0001.json")
        assert self.refused(*words, code="RL722", capsys=capsys) == 2

    def test_a_scene_file_that_has_changed(
        self, command: str, failure: Path, capsys: pytest.CaptureFixture[str]
    ) -> None:
        Path("bend.rl").write_text(TEXT.replace("25m", "30m"))
        assert self.refused(command, str(failure), code="RL723", capsys=capsys) == 1

    def test_a_scene_file_with_other_random_values(
        self, command: str, failure: Path, capsys: pytest.CaptureFixture[str]
    ) -> None:
        Path("bend.rl").write_text(TEXT.replace("5m..9m {", "6m {"))
        assert self.refused(command, str(failure), code="RL723", capsys=capsys) == 1

    def test_a_scene_file_that_was_moved(
        self, command: str, failure: Path, capsys: pytest.CaptureFixture[str]
    ) -> None:
        Path("bend.rl").rename("moved.rl")
        assert self.refused(command, str(failure), code="RL920", capsys=capsys) == 2
        assert run([command, str(failure), "--file", "moved.rl"]) == 0
