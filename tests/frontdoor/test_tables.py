"""Tables as CSV: integers look as they are written in scene files."""

from __future__ import annotations

import csv
from pathlib import Path
from typing import Any

from roadlang.cli import main as cli
from roadlang.session.tables import to_csv

SCENE = """
road main { draw with waypoints { points: [(0m, 0m), (200m, 0m)] }, lanes: 2, oneway: true }
let k = integer(2, 5)
let half = choice(1.5, 2.5)
agent ego is car on main at 10m..20m { lane: -1, drive with lane_follow { speed: 8m/s } }
agent others is car on main at 60m { lane: choice(-1, -2), count: k, spacing: 12m }
expect slow: always (ego.speed < half * 1m/s)
simulate with builtin { duration: 1s }
"""


def test_whole_numbers_have_no_decimal_point() -> None:
    columns: dict[str, list[Any]] = {"a": [8.0, -2.0, 0.5, 1e16], "b": [8, True, None, [1.0, 2.5]]}
    assert to_csv(columns) == 'a,b\n8,8\n-2,true\n0.5,\n1e+16,"[1.0, 2.5]"\n'


def test_integers_that_a_search_draws_are_integers_in_its_tables(tmp_path: Path) -> None:
    file, out = tmp_path / "scene.rl", tmp_path / "out"
    file.write_text(SCENE, encoding="utf-8")
    cli.run(["falsify", str(file), "-o", str(out), "--with", "random", "--evaluations", "3"])
    rows = list(csv.DictReader((out / "failing.csv").open(encoding="utf-8")))
    assert len(rows) == 3
    for row in rows:
        assert row["k"] in ("2", "3", "4", "5")
        assert row["half"] in ("1.5", "2.5")
        assert row["others/lane[1]"] in ("-1", "-2")
