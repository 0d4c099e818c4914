"""What the lines of `roadlang run` say of drives in which nothing is violated."""

from __future__ import annotations

import csv
import json
import re
from pathlib import Path

import numpy as np
import pytest

from roadlang.cli.main import run

CRASH = """
road main { draw with segments { pieces: [straight(200m)] }, lanes: 2 }
agent ego is car on main at 5m { lane: 1, facing: forward, drive with lane_follow { speed: 5m/s } }
agent front is car on main at 60m { drive with lane_follow { speed: 2m/s } }
agent rear is car on main at 40m { drive with lane_follow { speed: 12m/s } }
expect unharmed: always (ego.contacts == 0)
%s
simulate with builtin { duration: 5s }
"""


def lines_of(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], more: str, count: int
) -> list[str]:
    path = tmp_path / "crash.rl"
    path.write_text(CRASH % more)
    run(["run", str(path), "-n", str(count), "-o", str(tmp_path / "out")])
    return capsys.readouterr().out.splitlines()


def test_contacts_that_no_expectation_is_about_are_named(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    first, contact, *_, last = lines_of(tmp_path, capsys, "", 2)
    assert first == "scene 0: holds (5.0 s driven)"
    assert contact.startswith("  contact  front and rear at 1.")
    assert "worst" not in last
    assert last.startswith("all expectations hold in 2 of 2 scenes, with contacts in 2 of them; ")


def test_contacts_are_counted_where_nothing_is_expected(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "crash.rl"
    path.write_text((CRASH % "").replace("expect unharmed: always (ego.contacts == 0)", ""))
    for again in ([], ["--resume"]):
        assert run(["run", str(path), "-n", "2", "-o", str(tmp_path / "out"), *again]) == 0
        last = capsys.readouterr().out.splitlines()[-1]
        assert last.startswith("contacts in 2 of 2 scenes; traces and verdicts in ")


def test_contacts_are_not_named_beside_a_violation(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    first, *others = lines_of(tmp_path, capsys, "expect apart: always (rear.contacts == 0)", 2)
    assert first.startswith("scene 0: violated apart -1 at 1.")
    assert not any("contact " in line or "with contacts" in line for line in others)


def test_no_place_is_given_for_what_never_came_near(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The time to a collision with one in the other lane is infinite all along."""
    apart = "expect apart: always (time_to_collision(ego, front) > 1s)"
    lines = lines_of(tmp_path, capsys, apart, 2)
    assert lines[0] == "scene 0: holds (5.0 s driven)"
    assert "worst time" not in (tmp_path / "out" / "results.csv").read_text().splitlines()[0]
    near = lines_of(tmp_path, capsys, "expect slow: always (ego.speed < 6m/s)", 2)
    assert near[0].startswith("scene 0: holds, worst: slow 1 at ")


def test_a_violation_is_told_with_its_beginning_and_its_worst_moment(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """`falsify` and `report` name the beginning; one time is enough where both are the same."""
    late = """agent late is car on main at 5m {
  lane: -1, start_speed: 0m/s, drive with lane_follow { speed: 20m/s }
}
expect slow: always (late.speed < 3m/s)"""
    told, *_ = lines_of(tmp_path, capsys, late, 2)
    both = r"first at \d\.\d s, worst at 5\.0 s, s = \d+ m"
    assert re.match(rf"scene 0: violated slow -\S+, {both} \(5", told)
    told, *_ = lines_of(tmp_path, capsys, "expect slow: always (rear.speed < 5m/s)", 2)
    assert re.match(r"scene 0: violated slow -7 at 0\.0 s, s = 40 m \(5", told)


BENT = """
road main { draw with waypoints { points: [(0m, 0m), (60m, 0m), (90m, 25m), (90m, 80m)] }, width: 7m }
road bent from main { perturb with sine { amplitude: 1m..3m, wavelength: 40m..90m } }
agent ego is car on bent at 5m { drive with pure_pursuit { speed: 6m/s } }
expect flat: always (abs(curvature(bent)) < 0.03/m)
simulate with builtin { duration: 1s }
"""  # noqa: E501


def test_an_expectation_over_a_road_is_placed_on_it(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "bent.rl"
    path.write_text(BENT)
    assert run(["run", str(path), "-n", "3", "-o", str(tmp_path / "out")]) == 4
    *lines, last = capsys.readouterr().out.splitlines()
    with (tmp_path / "out" / "results.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    for line, row in zip(lines, rows, strict=True):
        number = int(row["scene"])
        scene = json.loads((tmp_path / "out" / f"scene-{number:04d}.json").read_text())
        road = next(road for road in scene["roads"] if road["name"] == "bent")
        at = int(np.argmax(np.abs(road["curvature"])))
        assert float(row["worst station"]) == pytest.approx(road["reference_stations"][at], abs=1)
        place = float(row["worst x"]), float(row["worst y"])
        assert place == pytest.approx((road["x"][at], road["y"][at]), abs=1)
        assert (row["worst"], row["worst road"]) == ("flat", "bent")
        assert f" on bent, s = {float(row['worst station']):.0f} m (1.0 s driven)" in line
    assert " on bent, s = " in last
