"""A route that cannot be followed from where another agent makes it start is named."""

from __future__ import annotations

import pytest

from roadlang import NoSceneError, testing

TWO_PARTS = '''
image plan from """
..#.......#..
..#.......#..
###..###..#..
.......#..#..
.......#..#..
""" { scale: 25m/px, legend: { "#": road } }
network town from plan { lanes: 2 }
agent lead is car on town at (62m, 108m) { drive with traffic }
agent ego is car on town at ahead_of(lead, 10m) { route: %s }
'''


def test_a_route_in_another_part_of_the_network_is_told() -> None:
    with pytest.raises(NoSceneError) as caught:
        testing.sample(TWO_PARTS % "[(260m, 5m), (262m, 110m)]", 1)
    help_ = "no path in `town` follows the `route` of `ego` from where it starts"
    assert help_ in caught.value.diagnostics[0].help


def test_a_route_from_there_on_is_driven() -> None:
    assert len(testing.sample(TWO_PARTS % "random", 1)) == 1
