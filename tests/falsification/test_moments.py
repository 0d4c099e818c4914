"""When, where and for whom a drive goes wrong."""

from __future__ import annotations

import pytest

from roadlang import testing
from roadlang.falsification.descriptors import moment_of
from roadlang.falsification.outcome import Moment, Outcome
from roadlang.plugins.discovery import load_registry

TEXT = """road main {{ draw with waypoints {{ points: [(0m, 0m), (200m, 0m)] }} }}
agent ego is car on main at 10m {{ drive with lane_follow {{ speed: 10m/s }} }}
agent lead is truck on main at 60m {{ drive with lane_follow {{ speed: 2m/s }} }}
expect it: {0}
simulate with builtin {{ control_step: 0.1s }}
"""


TOWN = """image plan from \"\"\"
...#...
...#...
#######
...#...
...#...
\"\"\" {{ scale: 10m/px }}
network town from plan {{ lanes: 2 }}
agent ego is car on town {{ route: [(2m, 25m), straight], drive with traffic }}
expect it: {0}
simulate with builtin {{ control_step: 0.1s }}
"""


def moment(formula: str, text: str = TEXT) -> Moment:
    scene = testing.sample(text.format(formula))[0]
    drive = scene.run()
    (verdict,) = drive.verdicts.values()
    found = moment_of(verdict, scene.record, drive.trace, load_registry())
    assert found is not None
    return found


def test_of_two_agents_the_moment_names_the_other_and_how_fast_they_close() -> None:
    found = moment("always (gap(ego, lead) > 20m)")
    assert (found.agent, found.partner, found.partner_kind) == ("ego", "lead", "truck")
    assert found.closing == pytest.approx(8.0, abs=0.5)
    assert found.station is not None
    assert found.station > 10.0


def test_of_one_agent_there_is_no_other() -> None:
    found = moment("always (ego.progress < 50%)")
    assert (found.agent, found.partner, found.partner_kind, found.closing) == ("ego", "", "", None)


@pytest.mark.parametrize(
    ("formula", "is_junction"),
    [("always (ego.route_progress < 5m)", False), ("always (ego.route_progress < 35m)", True)],
)
def test_in_a_network_the_moment_is_on_a_road_or_in_a_junction(
    formula: str, is_junction: bool
) -> None:
    """The road from the west is 30 m long; the junction in the middle is number 1."""
    found = moment(formula, TOWN)
    assert found.place == "junction 1 of town" if is_junction else found.place.startswith("town/")
    assert f" {found.place}" in Outcome(0, (), False, None, moment=found).cause


def test_beside_networks_there_is_no_such_place() -> None:
    assert moment("always (ego.progress < 50%)").place == ""
