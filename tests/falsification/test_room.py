"""A search drives no scene in which agents stand in each other: `run` makes none."""

from __future__ import annotations

import pytest

import roadlang
from roadlang.diagnostics import DiagnosticError

PAIR = """\
road main { draw with segments { pieces: [straight(150m)] }, lanes: 2 }
agent ego is car on main at 5m..60m { drive with car_follow { speed: 8m/s } }
agent other is car on main at 5m..60m { drive with car_follow { speed: 7m/s } }
expect apart: always (gap(ego, other) > 0.4m)
simulate with builtin { duration: 1s }
"""


@pytest.mark.parametrize("searcher", ["random", "cma"])
def test_agents_that_overlap_are_not_driven(searcher: str) -> None:
    search = roadlang.loads(PAIR).falsify(evaluations=60, searcher=searcher)
    assert len(search.outcomes) == 60
    assert 10 < len(search.driven) < 60
    for outcome in search.driven:
        assert abs(outcome.draws["ego/at"] - outcome.draws["other/at"]) >= 5.0
    assert not search.failures
    invalid = [found for found in search.outcomes if not found.is_valid]
    assert all(found.violation is not None and found.violation > 0.0 for found in invalid)


def test_a_scene_without_room_is_worse_the_more_room_it_lacks() -> None:
    search = roadlang.loads(PAIR).falsify(evaluations=60, searcher="random")
    lacking = [
        (abs(found.point[0] - found.point[1]), found.violation)
        for found in search.outcomes
        if found.violation is not None and not found.is_valid
    ]
    assert len(lacking) > 5
    assert [violation for _, violation in sorted(lacking)] == sorted(
        (violation for _, violation in lacking), reverse=True
    )


def test_what_the_file_puts_in_one_place_is_an_error() -> None:
    """On two roads that lie on each other, which `check` does not look at."""
    text = PAIR.replace("at 5m..60m", "at 10m").replace("8m/s", "8m/s..9m/s")
    text = text.replace("other is car on main", "other is car on second")
    text += "road second { draw with segments { pieces: [straight(150m)] }, lanes: 2 }\n"
    with pytest.raises(DiagnosticError, match="RL616"):
        roadlang.loads(text).falsify(evaluations=10)
