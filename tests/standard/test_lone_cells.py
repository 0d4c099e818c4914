"""A cell of road that has no neighbor is no road, and that is said with its place."""

from __future__ import annotations

import pytest

import roadlang
from roadlang.diagnostics import DiagnosticError

PICTURE = """image plan from \"\"\"
..........
.%s..#.
..........
...#......
\"\"\" { scale: 10m/px, legend: { "#": road } }
network town from plan
"""
LONE = "the road cell at (%s) has no neighbor: a road has at least two cells"


def test_lone_cells_beside_a_road_are_remarked_on() -> None:
    remarks = roadlang.loads(PICTURE % "#####").sample(1).remarks
    assert LONE % "85 m, 25 m" in remarks
    assert LONE % "35 m, 5 m" in remarks
    assert len([remark for remark in remarks if "no neighbor" in remark]) == 2


def test_cells_that_touch_at_a_corner_are_not_alone() -> None:
    text = (
        (PICTURE % "#####")
        .replace("...#......", ".......#..")
        .replace("..........", "......##..", 2)
    )
    remarks = roadlang.loads(text).sample(1).remarks
    assert not [remark for remark in remarks if "no neighbor" in remark]


def test_a_picture_of_lone_cells_has_no_road_and_says_why() -> None:
    with pytest.raises(DiagnosticError) as found:
        roadlang.loads(PICTURE % ".....").sample(1)
    assert "RL412" in str(found.value)
    assert LONE % "35 m, 5 m" in str(found.value)
