"""What makes the roads of scenes differ before they are perturbed, and what does not."""

from __future__ import annotations

import pytest

import roadlang
from roadlang.evaluate.indexed_scenario import IndexedScenario
from roadlang.world.index import index_scenario

STREET = "road {} {{ draw with segments {{ pieces: [straight({})] }}{} }}\n"
DRAWN = STREET.format("main", "90m..120m", "")
FIXED = STREET.format("main", "90m", "")
TOWN = '''image plan from """
..#..
#####
..#..
""" {{ scale: 25m/px, legend: {{ "#": road }} }}
network town from plan {{ {} }}
'''
TWO = STREET.format("two", "60m", "")
JOINED_OF_FIXED = STREET.format("one", "60m", "") + TWO
JOINED_OF_DRAWN = STREET.format("one", "60m..70m", "") + TWO


def indexed(text: str) -> IndexedScenario:
    loaded = roadlang.loads(text)
    return index_scenario(loaded.scenario, loaded.registry)


@pytest.mark.parametrize(
    ("text", "name", "varies"),
    [
        (FIXED, "main", False),
        (DRAWN, "main", True),
        (STREET.format("main", "90m", ", lanes: choice(1, 2)"), "main", False),
        (STREET.format("main", "90m", ", width: 6m..8m"), "main", False),
        (STREET.format("main", "90m", ", speed_limit: 30km/h..50km/h"), "main", False),
        (FIXED + "road bent from main { perturb with bump { at: 40m, length: 30m, height: 0m..1m }}"
         , "bent", False),
        (DRAWN + "road bent from main { perturb with bump { at: 40m, length: 30m, height: 1m } }",
         "bent", True),
        (TOWN.format("lanes: 2"), "town", False),
        (TOWN.format("speed_limit: 30km/h..50km/h"), "town", False),
        (TOWN.format("lanes: 2") + "road some from town { select: any }", "some", True),
        (TOWN.format("lanes: 2") + "road some from town { select: longest }", "some", False),
        (TOWN.format("") + "network busy from town { speed_limit: 30km/h..50km/h }", "town", False),
        (JOINED_OF_FIXED + "road both from one { then: two }", "both", False),
        (JOINED_OF_DRAWN + "road both from one { then: two }", "both", True),
        (JOINED_OF_DRAWN + "road both from two { then: one }", "both", True),
        (JOINED_OF_FIXED + "road both from two { then: one, taper: 9m..20m }", "both", True),
        (JOINED_OF_FIXED + "road bent from two { perturb with bump"
         " { at: 30m, length: 9m..30m, height: 1m } }\nroad both from one { then: bent }",
         "both", True),
    ],
)  # fmt: skip
def test_what_differs_between_candidates(text: str, name: str, varies: bool) -> None:
    assert indexed(text).is_varying(name) is varies


@pytest.mark.parametrize("derived", [False, True])
@pytest.mark.parametrize(
    "lanes", ["lanes: choice(1, 2)", "right: [drive(3m..4m)]", "sidewalks: 1m..2m",
              "oneway: choice(true, false)", 'center_marking: choice("solid", "broken")']
)  # fmt: skip
def test_the_lanes_of_a_network_are_the_same_in_every_scene(lanes: str, derived: bool) -> None:
    """Its junctions depend on them."""
    text = TOWN.format("" if derived else lanes)
    text += f"network busy from town {{ {lanes} }}\n" if derived else ""
    found = roadlang.loads(text).check()
    assert [diagnostic.code for diagnostic in found if diagnostic.is_error] == ["RL229"]
