"""Which agents an edit of a scene file puts elsewhere: those whose own start is written anew."""

from __future__ import annotations

import pytest

import roadlang
from roadlang.ir.edited_starts import edited_starts

TEXT = """\
param first = 5m
let gap = 20m
road main { draw with waypoints { points: [(0m, 0m), (80m, 0m), (160m, 5m)] }, lanes: 2 }
agent ego is car on main at first { drive with stanley { speed: 9m/s } }
agent lead is car on main at first + gap { start_speed: 3m/s }
agent parked is van at (10m, 30m)
agent drawn is car on main at 0m..(gap * 2) { offset: choice(0m, first) }
"""


@pytest.mark.parametrize(
    ("old", "new", "moved"),
    [
        ("(160m, 5m)", "(160m, 9m)", set()),
        ("lanes: 2", "lanes: 4", set()),
        ("speed: 9m/s }", "speed: 8m/s }", set()),
        ("agent parked", "\n\nagent parked", set()),
        ("agent parked is van", "agent parked is truck", set()),
        ("(10m, 30m)", "(10m, 31m)", {"parked"}),
        ("start_speed: 3m/s", "start_speed: 4m/s", {"lead"}),
        ("{ start_speed: 3m/s }", "{ start_speed: 3m/s, lane: 1 }", {"lead"}),
        ("gap = 20m", "gap = 21m", {"lead", "drawn"}),
        ("first = 5m", "first = 6m", {"ego", "lead", "drawn"}),
        ("agent parked is van", "agent other is van", set()),
        ("agent drawn", "\n   agent drawn", set()),
        ("0m..(gap", "1m..(gap", {"drawn"}),
        ("choice(0m, first)", "choice(0m, gap)", {"drawn"}),
    ],
)
def test_only_what_is_written_of_the_start_counts(old: str, new: str, moved: set[str]) -> None:
    assert old in TEXT
    scenarios = [roadlang.loads(text).scenario for text in (TEXT, TEXT.replace(old, new, 1))]
    assert edited_starts(*scenarios) == moved
