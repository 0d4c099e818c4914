"""Placement and weighted choices as other languages write them: one error, with the fix."""

from __future__ import annotations

import pytest

from roadlang import testing

ROAD = "road main { draw with waypoints { points: [(0m, 0m), (200m, 0m)] } }\n"


@pytest.mark.parametrize("statement", ["agent ego is car", "object oak is tree"])
@pytest.mark.parametrize(
    "written", ["at main 5m", "at 5m main", "at 5m of main", "on main 5m", "main at 5m"]
)
@pytest.mark.parametrize("block", ["", " {}"])
def test_a_position_on_a_road_is_rewritten(statement: str, written: str, block: str) -> None:
    (found,) = testing.check(f"{ROAD}{statement} {written}{block}")
    assert found.code == "RL001"
    assert found.help == ("write `on main at 5m`",)
    fix = found.fixes[0]
    assert f"{fix.span.text} -> {fix.replacement}" == f"{written} -> on main at 5m"


@pytest.mark.parametrize(
    ("written", "meant"),
    [
        ("Discrete({1: 2})", "choice(1, weights: [2])"),
        ("Discrete({1m: 3, 2m: 1})", "choice(1m, 2m, weights: [3, 1])"),
        ("Options({1m..2m: 3, (4m): 1 + 1})", "choice(1m..2m, (4m), weights: [3, 1 + 1])"),
    ],
)
def test_a_weighted_choice_of_scenic_is_one_error(written: str, meant: str) -> None:
    (found,) = testing.check(f"{ROAD}let w = {written}\n")
    assert found.code == "RL225"
    assert found.help == (f"write `{meant}`",)
    assert [fix.replacement for fix in found.fixes] == [meant]
    assert not [d for d in testing.check(f"{ROAD}let w = {meant}\n") if d.is_error]


@pytest.mark.parametrize("written", ["Discrete({1: 2", "Discrete({1: })", "Discrete({1})"])
def test_half_a_weighted_choice_is_still_an_error(written: str) -> None:
    assert testing.check(f"{ROAD}let w = {written}\n")
