"""The exit code of several runs is that of the severest."""

from __future__ import annotations

from pathlib import Path

import pytest

from roadlang.cli.exit_codes import exit_code_of, severest
from roadlang.diagnostics import Diagnostic
from tests.cli.command_lines import roadlang


@pytest.mark.parametrize(
    ("codes", "expected"),
    [
        ([], 0),
        ([0, 4], 4),
        ([4, 1], 1),
        ([4, 3], 3),
        ([1, 3], 3),
        ([3, 2], 2),
        ([2, 5], 5),
        ([5, 70], 70),
    ],
)
def test_the_severest_counts_in_any_order(codes: list[int], expected: int) -> None:
    assert severest(codes) == severest(reversed(codes)) == expected


def test_a_code_of_a_plugin_has_no_page_and_means_an_error_of_the_scenario() -> None:
    assert exit_code_of([Diagnostic("KIT02", "error", "")]) == 1
    assert exit_code_of([Diagnostic("KIT02", "warning", "")]) == 0


@pytest.mark.parametrize("number", ["nan", "inf", "-inf"])
@pytest.mark.parametrize(
    "line",
    [
        "run scene.rl --duration",
        "falsify scene.rl --seconds",
        "falsify scene.rl --random",
        "extract road.png --scale",
        "monitor x>0 drive.csv --wrap",
        "mine x>a drive.csv --param a=0..1 --margin",
        "render scene.rl --at",
        "watch scene.rl --for",
    ],
)
def test_a_number_of_an_option_is_finite(line: str, number: str, tmp_path: Path) -> None:
    done = roadlang(*line.split(), number, cwd=tmp_path)
    assert done.returncode == 2
    assert "Invalid value for" in done.stderr


@pytest.mark.parametrize("command", ["mine", "monitor", "run", "falsify"])
def test_help_states_no_bounds_that_there_are_not(command: str, tmp_path: Path) -> None:
    assert "None" not in roadlang(command, "--help", cwd=tmp_path).stdout
