"""How wide roads are in a picture that is typed in characters, which says nothing of widths."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang import testing

PLAN = '''image plan from """
..#..
#####
""" { scale: %sm/px }
network town from plan { %s }
'''


@pytest.mark.parametrize(
    ("scale", "options", "width"),
    [
        (20, "", 7.0),  # two lanes of 3.5 m
        (20, "lanes: 4, sidewalks: 2m", 14.0),  # sidewalks lie beside the driving lanes
        (20, "lanes: 1", 3.5),
        (20, "left: [drive(3m)], right: [drive(2.5m), sidewalk]", 5.5),
        (20, "extract with pixels { thickness: 0.5px }", 10.0),
        (20, "extract with auto { width: 9m }", 9.0),
        (5, "", 5.0),  # no more than a cell
        (5, "lanes: 4", 5.0),
        (5, "left: [drive(4m)], right: [drive(4m)]", 8.0),  # listed widths hold
    ],
)
def test_the_lanes_say_how_wide_a_typed_road_is(scale: int, options: str, width: float) -> None:
    scene = testing.sample(PLAN % (scale, options))[0].record
    assert len(scene.roads) == 3
    for road in scene.roads:
        assert np.asarray(road.width) == pytest.approx(width)
