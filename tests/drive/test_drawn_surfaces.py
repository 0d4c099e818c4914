"""Figures of drives show what lies on lanes, as those of scenes do."""

from __future__ import annotations

from roadlang import testing
from roadlang.scenes.figure_colors import FIGURE_COLORS

ROAD = """
road main { draw with segments { pieces: [straight(100m)] }, %s }
agent ego is car on main at 10m { drive with lane_follow { speed: 10m/s } }
"""
TOWN = """
image plan from \"\"\"
..........
##########
....#.....
\"\"\" { scale: 20m/px, legend: { "#": road } }
network town from plan { lanes: 2, surface: %s }
agent ego is car on town at random { drive with lane_follow { speed: 10m/s } }
"""


def drawn(text: str, name: str) -> int:
    """How many areas of a figure have the color of a surface."""
    color = FIGURE_COLORS.of_surface(name)  # type: ignore[arg-type]
    return testing.sample(text, 1)[0].run(duration=1.0).svg().count(f'fill="{color}"')


def test_each_lane_of_a_patch_is_drawn() -> None:
    over = "lanes: 2, surface_patches: [{ surface: ice, over: [40m, 60m]%s }]"
    assert drawn(ROAD % (over % ""), "ice") == 2
    assert drawn(ROAD % (over % ", side: left"), "ice") == 1
    assert drawn(ROAD % "lanes: 2", "ice") == 0


def test_junctions_have_the_surface_of_their_roads() -> None:
    lanes = 3 * 2
    assert drawn(TOWN % "gravel", "gravel") == lanes + 1
    assert drawn(TOWN % "asphalt", "gravel") == 0
