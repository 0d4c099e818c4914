"""The names of files of results."""

from __future__ import annotations

from pathlib import Path

import pytest

from roadlang.ir.result_files import (
    is_scene_file_name,
    numbered_runs,
    numbered_scenes,
    numbered_stem,
    run_name,
)


def test_runs_are_in_the_order_of_their_numbers(tmp_path: Path) -> None:
    numbers = [0, 2, 100, 999, 1000, 10_000]
    for name in (*map(run_name, numbers), "run-12-old", "run-x", "running"):
        (tmp_path / name).mkdir()
    (tmp_path / "run-007").write_text("no folder")
    assert numbered_runs(tmp_path) == [tmp_path / run_name(number) for number in numbers]


def test_scenes_of_failures_are_no_other_files_and_in_order(tmp_path: Path) -> None:
    for number in (2, 10_000, 9_999):
        for ending in (".json", ".explanation.json", ".shrunk.json", ".trace.json", ".svg"):
            (tmp_path / f"{numbered_stem(number)}{ending}").touch()
    (tmp_path / "index.json").touch()
    found = [path.name for path in numbered_scenes(tmp_path)]
    assert found == ["0002.json", "9999.json", "10000.json"]


def test_nothing_is_in_a_folder_that_is_not_there(tmp_path: Path) -> None:
    assert numbered_runs(tmp_path / "no") == numbered_scenes(tmp_path / "no") == []


@pytest.mark.parametrize(
    ("name", "is_scene"),
    [("a/scene.json", True), ("SCENE.JSON", True), ("bend.rl", False), ("json", False)],
)
def test_a_file_of_one_scene_is_known_by_its_ending(name: str, is_scene: bool) -> None:
    assert is_scene_file_name(name) is is_scene
