"""What has no place at all is reported, and is never taken for something a meter away."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang import NoSceneError, testing
from roadlang.world.placement.spots import NoPlace, shortfall

TOWN = '''
image plan from """
..#..
..#..
#####
..#..
""" { scale: 25m/px, legend: { "#": road } }
network town from plan { lanes: 2 }
'''


def help_of(text: str) -> tuple[str, ...]:
    """The help lines where no scene is found."""
    with pytest.raises(NoSceneError) as caught:
        testing.sample(text, 1)
    return caught.value.diagnostics[0].help


@pytest.mark.parametrize(("at", "beyond"), [("98.75m", "1m"), ("99m", "1.25m")])
def test_any_distance_beyond_the_end_of_a_road_is_told(at: str, beyond: str) -> None:
    """The front bumper of a car of 4.5 m: a whole meter is a distance like any other."""
    told = help_of(f"""
road main {{ draw with waypoints {{ points: [(0m, 0m), (100m, 0m)] }} }}
agent ego is car on main at choice({at}, {at}) {{ drive with pure_pursuit }}
""")
    assert f"`ego` would stand {beyond} beyond the end of `main`" in told


@pytest.mark.parametrize("lead", ["lead", "lead[0]"])
def test_what_is_placed_by_something_that_is_not_there_is_told(lead: str) -> None:
    told = help_of(f"""{TOWN}
agent lead is car on town at random {{ count: integer(0, 0) }}
agent ego is car on town at ahead_of({lead}, 10m..12m) {{ drive with traffic }}
""")
    assert f"`ego` is placed relative to `{lead}`, which does not exist in this scene" in told


def test_the_search_counts_no_place_beside_meters() -> None:
    """0 where there is a place, the meters where it is too far, at least 1 where there is none."""
    places = np.array([NoPlace.HAS_ONE, NoPlace.HAS_ONE, NoPlace.NO_WAY, NoPlace.NO_OTHER])
    assert shortfall(np.array([0.0, 2.5, 0.0, 2.5]), places).tolist() == [0.0, 2.5, 1.0, 2.5]
