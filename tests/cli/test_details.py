"""Details of commands that a user meets: color, completion, listings, files of `extract`."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import click
import cv2
import numpy as np
import pytest

from roadlang.cli.console import wants_color
from roadlang.cli.explain import command as explain
from roadlang.cli.plugins import show
from tests.cli.command_lines import roadlang


class Stream:
    """A terminal, or none."""

    def __init__(self, terminal: bool) -> None:
        self._terminal = terminal

    def isatty(self) -> bool:
        return self._terminal


@pytest.mark.parametrize(
    ("environment", "terminal", "colored"),
    [
        ({}, True, True), ({}, False, False), ({"TERM": "dumb"}, True, False),
        ({"NO_COLOR": "1"}, True, False), ({"NO_COLOR": ""}, True, True),
        ({"FORCE_COLOR": "1"}, False, True), ({"NO_COLOR": "1", "FORCE_COLOR": "1"}, False, False),
    ],
)  # fmt: skip
def test_color_is_for_people_unless_the_environment_says_otherwise(
    environment: dict[str, str], terminal: bool, colored: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("NO_COLOR", "FORCE_COLOR", "TERM"):
        monkeypatch.delenv(name, raising=False)
    for name, value in environment.items():
        monkeypatch.setenv(name, value)
    assert wants_color(Stream(terminal)) == colored  # type: ignore[arg-type]


def test_diagnostics_are_colored_on_wish(tmp_path: Path) -> None:
    (tmp_path / "scene.rl").write_text("param a = 3mtr\n")
    plain = roadlang("--color", "never", "check", "scene.rl", cwd=tmp_path).stderr
    colored = roadlang("--color", "always", "check", "scene.rl", cwd=tmp_path).stderr
    assert "\x1b[" not in plain
    assert "\x1b[" in colored


def completed(command: click.Command, parameter: str, typed: str) -> list[str]:
    context = click.Context(command)
    (found,) = [each for each in command.params if each.name == parameter]
    return [item.value for item in found.shell_complete(context, typed)]


def test_codes_and_kinds_are_completed() -> None:
    assert completed(explain, "words", "rl20")[:2] == ["RL201", "RL202"]
    assert all(code.startswith("RL20") for code in completed(explain, "words", "RL20"))
    assert "sine" in completed(show, "words", "si")
    assert all(name.startswith("si") for name in completed(show, "words", "si"))


def test_a_verb_of_plugins_is_checked(tmp_path: Path) -> None:
    done = roadlang("plugins", "--verb", "pertrub", cwd=tmp_path)
    assert done.returncode == 2
    assert "did you mean `perturb`?" in done.stderr
    assert "verbs: " in roadlang("plugins", "--verb", "xyzzy", cwd=tmp_path).stderr
    shown = roadlang("plugins", "--verb", "perturb", cwd=tmp_path).stdout
    assert "sine" in shown
    assert "pure_pursuit" not in shown


def test_kinds_are_listed_as_json_with_their_options(tmp_path: Path) -> None:
    (sine,) = json.loads(roadlang("plugins", "show", "sine", "--json", cwd=tmp_path).stdout)
    assert (sine["verb"], sine["name"]) == ("perturb", "sine")
    assert (sine["qualified"], sine["plugin"], sine["distribution"]) == (
        "standard.sine", "standard", "roadlang"
    )  # fmt: skip
    options = {option["name"]: option for option in sine["options"]}
    assert options["wavelength"] == {
        "name": "wavelength", "type": "length (m)", "required": True, "default": None,
        "bounds": "> 0m", "words": [],
        "help": "arc length of one period; a closed road has a whole number",
    }  # fmt: skip
    phase = options["phase"]
    assert (phase["required"], phase["default"], phase["bounds"]) == (False, "0deg", None)
    (contour,) = json.loads(roadlang("plugins", "show", "contour", "--json", cwd=tmp_path).stdout)
    words = {option["name"]: option["words"] for option in contour["options"]}
    assert words["road"] == ["auto", "dark", "light"]


def test_a_statement_is_shown_with_what_its_block_takes(tmp_path: Path) -> None:
    shown = roadlang("plugins", "show", "road", cwd=tmp_path).stdout
    assert "perturb with KIND: see `roadlang plugins`" in shown
    assert "every kind of `perturb` also has:" in shown
    before, _, after = shown.partition("every kind of `perturb` also has:")
    assert "      over: " in after
    assert "      over: " not in before
    assert "  example:" in shown


def test_templates_are_for_some_verbs(tmp_path: Path) -> None:
    done = roadlang("plugins", "new", "mine", "--kind", "emitt", cwd=tmp_path)
    assert done.returncode == 2
    assert "did you mean `emit`?" in done.stderr
    assert "there are templates for" in done.stderr
    assert not list(tmp_path.iterdir())


def test_a_faulty_scene_has_a_json_report_without_manifest(tmp_path: Path) -> None:
    (tmp_path / "scene.rl").write_text("param a = 3mtr\n")
    done = roadlang("compile", "scene.rl", "--json", cwd=tmp_path)
    record = json.loads(done.stdout)
    assert done.returncode == 1
    assert record["manifest"] is None
    assert [found["code"] for found in record["diagnostics"]] == ["RL203"]
    assert (record["requirements"], record["expectations"], record["remarks"]) == ([], [], [])


def plan(folder: Path) -> Any:
    """A white road, rows 20 to 29 of 60 x 100 pixels, and a red house of 12 x 6 pixels."""
    image = np.zeros((60, 100, 3), np.uint8)
    image[20:30] = 255
    image[40:46, 50:62] = (0, 0, 255)
    cv2.imwrite(str(folder / "plan.png"), image)
    legend = '{ "white": road, "red": building }'
    (folder / "scene.rl").write_text(
        f'image plan from "plan.png" {{ scale: 0.5m/px, legend: {legend} }}\n'
        "network town from plan\n"
    )
    return image


def test_a_mask_is_white_where_a_road_was_found(tmp_path: Path) -> None:
    image = np.full((60, 100, 3), 255, np.uint8)
    image[20:30] = 40
    cv2.imwrite(str(tmp_path / "plan.png"), image)
    done = roadlang("extract", "plan.png", "-o", "roads.json", "--mask", "mask.png", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    mask = cv2.imread(str(tmp_path / "mask.png"), 0)
    assert mask is not None
    assert mask[21:29].min() == 255
    assert mask[:18].max() == mask[32:].max() == 0
    (road,) = json.loads((tmp_path / "roads.json").read_text())["roads"]
    assert np.median(road["widths"]) == pytest.approx(10, abs=0.5)


def test_points_of_the_command_line_are_pairs(tmp_path: Path) -> None:
    plan(tmp_path)
    for words in (["--through", "1"], ["--through", "1,x"], ["--leave-out", "1,2,3"]):
        done = roadlang("extract", "plan.png", *words, cwd=tmp_path)
        assert done.returncode == 2
        assert f"{words[1]!r} is not" in done.stderr


def test_things_of_a_legend_have_their_place_and_sides_in_meters(tmp_path: Path) -> None:
    """Columns 50 to 61 and rows 40 to 45 of half a meter, y up from the lower edge at row 60."""
    plan(tmp_path)
    from roadlang import load

    (house,) = load(tmp_path / "scene.rl").sample(1)[0].record.objects
    assert (house.x, house.y, house.length, house.width) == pytest.approx(
        (0.5 * 56, 0.5 * (60 - 43), 6.0, 3.0), abs=0.02
    )
