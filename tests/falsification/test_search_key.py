"""What makes a search, or a run, another one: its journal is not gone on with then."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

import roadlang
from roadlang.falsification.evaluator import Task
from roadlang.falsification.plan import Plan
from roadlang.falsification.search_key import digest, search_key
from roadlang.plugins.configured import configured

TEXT = """
road main { draw with waypoints { points: [(0m, 0m), (90m, 20m)] }, lanes: 2 }
agent ego is car on main at 9m..30m { drive with lane_follow { speed: 9m/s } }
expect slow: always (ego.speed < 20m/s)
"""


def key(text: str, settings: dict[str, Any] | None = None, folder: Path = Path()) -> str:
    return digest(roadlang.loads(text, folder=folder).scenario, settings or {})


def test_comments_and_places_in_the_file_do_not_count() -> None:
    assert key(TEXT) == key(TEXT)
    assert key(TEXT) == key("# a comment\n\n" + TEXT.replace("lanes: 2", "lanes:   2"))


@pytest.mark.parametrize(
    ("old", "new"),
    [("20m)", "21m)"), ("9m..30m", "9m..31m"), ("slow", "fast"), ("< 20m/s", "<= 20m/s"),
     ("speed: 9m/s", "speed: 8m/s"), ("lanes: 2", "lanes: 4")],
)  # fmt: skip
def test_whatever_changes_the_scenes_or_their_verdicts_counts(old: str, new: str) -> None:
    assert key(TEXT) != key(TEXT.replace(old, new))


def test_settings_count() -> None:
    assert key(TEXT, {"seed": 1}) == key(TEXT, {"seed": 1})
    assert key(TEXT, {"seed": 1}) != key(TEXT, {"seed": 2})


def test_files_count_by_what_is_in_them_not_by_where_they_are(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    keys = []
    for name, last in (("a", 100), ("b", 100), ("c", 101)):
        (tmp_path / name).mkdir()
        monkeypatch.chdir(tmp_path / name)
        Path("line.csv").write_text(f"x,y\n0,0\n50,0\n{last},0\n")
        keys.append(key('road main from "line.csv"\n'))
    assert keys[0] == keys[1] != keys[2]


def test_a_search_can_go_on_with_other_stop_rules_but_not_as_another_search() -> None:
    loaded = roadlang.loads(TEXT)
    entry, searcher = configured(loaded.registry, "falsify", "random", {})
    plan = Plan(searcher, entry, 7, 100)
    task = Task(loaded.scenario, loaded.registry, 7, (), ("slow",), "builtin", {})
    known = search_key(task, plan)
    for same in (
        replace(plan, evaluations=200),
        replace(plan, failures=3),
        replace(plan, seconds=1.0),
    ):
        assert search_key(task, same) == known
    other_entry, other_searcher = configured(loaded.registry, "falsify", "halton", {})
    for other in (
        replace(plan, seed=8),
        replace(plan, batch=10),
        replace(plan, after_violation=3.0),
        replace(plan, searcher=other_searcher, entry=other_entry),
    ):
        assert search_key(task, other) != known
    for changed in (
        replace(task, expects=()),
        replace(task, engine="godot"),
        replace(task, options={"duration": 9.0}),
    ):
        assert search_key(changed, plan) != known
