"""`explain`, `schema` and commands that were guessed: what is meant is found, or named."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from roadlang.cli.main import run


def printed(capsys: pytest.CaptureFixture[str], *words: str) -> str:
    capsys.readouterr()
    assert run(list(words)) == 0
    return capsys.readouterr().out


@pytest.mark.parametrize("name", ["RL001", "rl001", "1", "001", "unexpected-token"])
def test_a_diagnostic_is_found_by_its_code_its_number_and_its_name(
    name: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert printed(capsys, "explain", name).startswith("RL001 unexpected-token: ")


def test_a_statement_is_explained_with_its_options(capsys: pytest.CaptureFixture[str]) -> None:
    shown = printed(capsys, "explain", "world")
    assert "time_of_day" in shown
    assert "friction" in shown


@pytest.mark.parametrize("words", [["sine"], ["perturb", "sine"], ["perturb with sine"]])
def test_a_kind_is_explained_with_its_options(
    words: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    shown = printed(capsys, "explain", *words)
    assert shown.startswith("perturb sine: ")
    assert "wavelength" in shown


def test_a_monitor_is_found_by_the_word_before_it_in_a_file(
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert printed(capsys, "explain", "require", "sbft").startswith("monitor sbft: ")


@pytest.mark.parametrize(
    ("words", "hint"),
    [
        (["explain", "sine_wave_"], "`roadlang plugins` all kinds"),
        (["explain", "run"], "`roadlang run --help` explains the command"),
        (["plugins", "sine"], "`roadlang plugins show sine`"),
        (["simulate"], "`run FILE`"),
        (["test"], "`run FILE`"),
        (["evaluate"], "`monitor FORMULA TRACE`"),
        (["validate"], "`check FILE`"),
        (["lint"], "`check FILE`"),
        (["export"], "`convert IN OUT`"),
        (["import"], "`convert IN OUT`"),
        (["show"], "`view FILE`"),
        (["list"], "`plugins`"),
        (["reprot"], "Did you mean `report`?"),
    ],
)
def test_a_guessed_command_is_told_the_right_one(
    words: list[str], hint: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(words) == 2
    assert hint in capsys.readouterr().err


def test_a_folder_of_failures_is_told_how_one_is_explained(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "failures").mkdir()
    for name in ("0001.json", "0001.explanation.json", "0001.shrunk.json", "0002.json"):
        (tmp_path / "failures" / name).write_text("{}")
    assert run(["explain", str(tmp_path)]) == 2
    assert "failures/0001.json`" in capsys.readouterr().err


def schema(capsys: pytest.CaptureFixture[str], *words: str) -> Any:
    return json.loads(printed(capsys, "schema", *words))


def test_a_name_of_several_verbs_gives_the_schemas_of_all(
    capsys: pytest.CaptureFixture[str],
) -> None:
    titles = [found["title"] for found in schema(capsys, "distance")]
    assert sorted(titles) == ["drive_signal distance", "number distance", "signal distance"]
    assert schema(capsys, "signal", "distance")["title"] == "signal distance"
    assert schema(capsys, "standard.sine")["title"] == "perturb sine"


def test_a_kind_of_another_verb_is_not_meant(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["schema", "nope"]) == 2
    assert "there are scene, manifest, trace, " in capsys.readouterr().err
    assert run(["plugins", "show", "nope"]) == 2
    assert "`roadlang plugins` lists all" in capsys.readouterr().err
    assert run(["schema", "emit", "sine"]) == 2
    assert "there is no schema called `emit sine`" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("words", "meant"),
    [
        (("explain", "lane_keep"), "drive lane_follow"),
        (("explain", "emit", "png"), "emit svg"),
        (("plugins", "show", "canny"), "extract contour"),
    ],
)
def test_the_name_that_another_tool_has_for_a_kind_leads_to_it(
    words: tuple[str, ...], meant: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(list(words)) == 2
    assert f"did you mean `{meant}`?" in capsys.readouterr().err


def test_the_name_of_a_plugin_shows_its_kinds(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["plugins", "show", "godot"]) == 0
    shown = capsys.readouterr().out
    assert "simulate godot: " in shown
    assert "emit svg: " not in shown
