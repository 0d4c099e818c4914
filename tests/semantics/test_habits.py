"""What people write who know Scenic or Python gets one error, with a line of help that says how."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from roadlang.diagnostics import Diagnostic
from roadlang.plugins.discovery import load_registry
from roadlang.semantics import check_text

from .habit_statements import EGO, ROAD
from .habits import HABITS

EXAMPLES = Path(__file__).parents[2] / "examples"


def found_in(text: str, folder: Path) -> list[Diagnostic]:
    for name in ("town.png", "street.rl"):
        shutil.copy(EXAMPLES / name, folder)
    (folder / "lights.rl").write_text("param lights = 3\n")
    _, found = check_text(text, folder / "scene.rl", {}, load_registry())
    return [diagnostic for diagnostic in found if diagnostic.is_error]


@pytest.mark.parametrize("case", HABITS, ids=lambda case: case[0])
def test_a_habit_of_another_language_gets_one_error_with_help(
    case: tuple[str, str, str, str | None], tmp_path: Path
) -> None:
    text, code, help, replacement = case
    source = ROAD + text + "\n"
    found = found_in(source, tmp_path)
    assert [diagnostic.code for diagnostic in found] == [code]
    assert help in "\n".join(found[0].help)
    assert [fix.replacement for fix in found[0].fixes[:1]] == [replacement] * bool(replacement)
    for fix in found[0].fixes[:1]:
        mended = source[: fix.span.start] + fix.replacement + source[fix.span.end :]
        assert found_in(mended, tmp_path) == []


def test_a_lone_equals_sign_is_one_fault_not_two(tmp_path: Path) -> None:
    text = ROAD + "require r: always (curvature(main) = 1/m)\n"
    _, found = check_text(text, tmp_path / "scene.rl", {}, load_registry())
    assert [diagnostic.code for diagnostic in found] == ["RL010"]
    _, found = check_text(text.replace("=", "=="), tmp_path / "scene.rl", {}, load_registry())
    assert [diagnostic.code for diagnostic in found] == ["RL291"]


@pytest.mark.parametrize(
    ("formula", "help_"),
    [
        ("length(main) == 90m", "abs(length(main) - (90m)) < TOLERANCE`"),
        ("length(main) != 0m", "abs(length(main)) > TOLERANCE`"),
    ],
)
def test_equality_of_computed_numbers_gets_a_tolerance(formula: str, help_: str) -> None:
    _, found = check_text(ROAD + f"require r: {formula}\n", Path("a.rl"), {}, load_registry())
    assert help_ in next(each for each in found if each.code == "RL291").help[0]


def test_no_collision_is_said_by_contacts() -> None:
    text = ROAD + EGO + "expect r: always (ego.collision == 0m/s)\n"
    _, found = check_text(text, Path("a.rl"), {}, load_registry())
    assert "`abs(ego.collision) < TOLERANCE`, or `ego.contacts == 0`" in found[0].help[0]


@pytest.mark.parametrize(
    ("value", "found"),
    [("-1m..3m", "it can be -1m"), ("-1m", "it is -1m"), ("0m..3m", None), ("0m", None)],
)
def test_a_range_that_reaches_beyond_a_limit_says_what_it_can_be(
    value: str, found: str | None, tmp_path: Path
) -> None:
    passes = f"perturb with harmonics {{ amplitude: {value} }}"
    diagnostics = found_in(ROAD + f"road bent from main {{ {passes} }}\n", tmp_path)
    expected = [] if found is None else [f"`amplitude` must be at least 0m, but {found}"]
    assert [diagnostic.message for diagnostic in diagnostics] == expected


@pytest.mark.parametrize("value", ["0m", "0m..5m"])
def test_a_limit_that_is_excluded_is_too_little(value: str, tmp_path: Path) -> None:
    passes = f"perturb with sine {{ amplitude: 1m, wavelength: {value} }}"
    (found,) = found_in(ROAD + f"road bent from main {{ {passes} }}\n", tmp_path)
    assert found.code == "RL208"
    assert "greater than 0m" in found.message


@pytest.mark.parametrize(
    ("over", "taper"),
    [("[10m, 30m]", "5m"), ("[10m, 90m]", "10m"), ("[9m, 2 * 20m]", "10m"), ("[0m, 40m]", "10m")],
)
def test_an_abrupt_interval_gets_a_taper_of_a_quarter_of_its_length_or_10_m(
    over: str, taper: str, tmp_path: Path
) -> None:
    perturb = f"perturb with sine {{ amplitude: 1m, wavelength: 50m, over: {over} }}"
    text = ROAD + f"road bent from main {{ {perturb} }}\n"
    _, (warning,) = check_text(text, tmp_path / "scene.rl", {}, load_registry())
    assert warning.code == "RL193"
    assert [fix.replacement for fix in warning.fixes] == [f"over: {over}, taper: {taper}"]
