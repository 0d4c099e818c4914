"""The reference of statements: complete, and its examples are valid."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Any

import pytest

from roadlang.cli.main import run
from roadlang.plugins.discovery import load_registry
from roadlang.semantics import check_text
from roadlang.semantics.statement_reference import BY_WORD, REFERENCE
from roadlang.syntax.words import STATEMENTS

EXAMPLES = Path(__file__).parents[2] / "examples"
CONTEXT = """
image plan from "town.png" { SCALE }
network town from plan
road main { draw with waypoints { points: [(0m, 0m), (160m, 0m)] }, lanes: 2 }
agent lead is car on main at 20m
let centered = abs(curvature(main)) < 1/m
expect in_lane: always (abs(lead.cross_track_error) < 1m)
expect arrives: eventually[0s, 60s] (lead.progress > 99%)
"""
PLACES = {
    "image": 'image IT from "town.png" {{ scale: 1m/px, {} }}',
    "network": "network IT from plan {{ {} }}",
    "road": "road IT from town {{ {} }}",
    "agent": "agent ego is car on main at 5m {{ {} }}",
    "object": "object IT is tree on main at 5m {{ {} }}",
    "require": "require r: always (centered and length(main) > 1m) {{ {} }}",
    "expect": "expect e: always (centered and length(main) > 1m) {{ {} }}",
}
OPTIONS = [(statement.word, option) for statement in REFERENCE for option in statement.options]


def errors(text: str, folder: Path) -> list[str]:
    for name in ("town.png", "street.rl", "hairpin.jpg"):
        shutil.copy(EXAMPLES / name, folder)
    _, found = check_text(text, folder / "scene.rl", {}, load_registry())
    return [diagnostic.message for diagnostic in found if diagnostic.is_error]


def test_every_statement_is_in_the_reference() -> None:
    assert set(BY_WORD) == set(STATEMENTS)


@pytest.mark.parametrize("statement", REFERENCE, ids=lambda statement: statement.word)
def test_a_statement_has_a_meaning_and_a_valid_example(statement: Any, tmp_path: Path) -> None:
    assert statement.form.startswith(statement.word)
    assert statement.help.endswith(".")
    assert errors(statement.example, tmp_path) == []


@pytest.mark.parametrize("statement", REFERENCE, ids=lambda statement: statement.word)
def test_every_option_has_help(statement: Any) -> None:
    passes = [option for options in statement.passes.values() for option in options]
    for option in (*statement.options, *passes):
        assert len(option.help.split()) >= 1, option.name
        assert option.constraints.example or option.default is not None or option.name == "closed"


@pytest.mark.parametrize(("word", "option"), OPTIONS, ids=lambda part: getattr(part, "name", part))
def test_the_example_of_an_option_is_valid(word: Any, option: Any, tmp_path: Path) -> None:
    example = option.constraints.example
    if not example:
        return
    statement = (
        PLACES.get(word, f"{word} {{{{ {{}} }}}}")
        .replace("IT", "it")
        .format(f"{option.name}: {example}")
    )
    if option.name == "spacing":
        statement = statement.replace("spacing:", "count: 2, spacing:")
    if option.name == "moved_at":
        statement = statement.replace(example, f"{example}, moved_by: [(1m, 1m)]")
    if option.name == "moved_by":
        statement = statement.replace(option.name, "moved_at: [(40m, 32m)], moved_by")
    if option.name == "then":
        statement = (
            f"road avenue from town\nroad school from town\nroad it from main {{ then: {example} }}"
        )
    if option.name == "taper":
        statement = f"road it from main {{ then: main, taper: {example} }}"
    if option.name in ("route", "route_length"):
        statement = statement.replace("on main at 5m", "on town at random")
    if option.name in ("scale", "legend"):
        statement = statement.replace(
            "scale: 1m/px, ", "" if option.name == "scale" else "scale: 1m/px, "
        )
    assert errors(CONTEXT.replace("SCALE", "scale: 1m/px") + statement, tmp_path) == []


@pytest.mark.parametrize("command", [["explain", "world"], ["plugins", "show", "world"]])
def test_the_commands_show_the_options_of_a_statement(
    command: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(command) == 0
    printed = capsys.readouterr().out
    assert "rain: speed (m/s); optional; >= 0m/s; for example 5mm/h" in printed
    assert "rainfall rate" in printed


def test_a_verb_before_a_name_shows_the_kind_and_not_the_statement(
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert run(["plugins", "show", "car"]) == 0
    alone = capsys.readouterr().out
    assert run(["plugins", "show", "agent", "car"]) == 0
    assert capsys.readouterr().out == alone
    assert run(["plugins", "show", "agent"]) == 0
    assert capsys.readouterr().out != alone


def test_a_bare_number_gets_the_usual_unit_of_the_option(tmp_path: Path) -> None:
    text = "world { rain: 4, time_of_day: 14 }"
    _, found = check_text(text, tmp_path / "scene.rl", {}, load_registry())
    assert [fix.replacement for each in found for fix in each.fixes] == ["4mm/h", "14h"]


def test_a_bare_angle_may_mean_degrees_or_radians(tmp_path: Path) -> None:
    _, found = check_text(
        "world { sun: { azimuth: 3 } }", tmp_path / "scene.rl", {}, load_registry()
    )
    assert found[0].help == ("write `3deg` or `3rad`",)
