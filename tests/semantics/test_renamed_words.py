"""Words that were renamed: the fix is the new one, also where another word is nearer."""

from __future__ import annotations

import pytest

from roadlang import testing
from roadlang.ir.renamed_words import KINDS, OPERANDS, OPTIONS
from roadlang.plugins.discovery import load_registry

SCENE = """\
road main { draw with waypoints { points: [(0m, 0m), (200m, 0m)] } }
agent ego is car on main at 5m {}
agent lead is car on main at 25m {}
"""


@pytest.mark.parametrize(
    ("text", "old", "new"),
    [
        ('object oak is tree on main at 5m { colour: "red" }', "colour", "color"),
        ("expect x: always (distance(one: ego, second: lead) > 5m)", "one", "first"),
        ("expect x: always (distance(ego, other: lead) > 5m)", "other", "second"),
        ("expect x: always (ego.cross_track < 1m)", "cross_track", "cross_track_error"),
        ("expect x: always (cross_track(ego) < 1m)", "cross_track", "cross_track_error"),
    ],
)
def test_the_new_word_is_the_fix(text: str, old: str, new: str) -> None:
    (found,) = testing.check(SCENE + text)
    assert found.span is not None
    assert found.span.text == old
    assert found.help == (f"it is now called `{new}`",)
    assert [fix.replacement for fix in found.fixes] == [new]


def test_no_kind_has_an_old_word_beside_the_new_one() -> None:
    entries = [entry for entry in load_registry().entries if entry.origin.is_shipped]
    assert not {entry.name for entry in entries} & KINDS.keys()
    for entry in entries:
        options = {option.name for option in entry.options}
        for old, new in {**OPTIONS, **OPERANDS}.items():
            assert not {old, new} <= options, entry.qualified
