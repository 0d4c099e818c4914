"""Old names of public Python modules work for one more minor version, and say what to write."""

from __future__ import annotations

import importlib
from typing import Any

import pytest

from roadlang.api import LaneKind


@pytest.mark.parametrize(
    ("module", "old", "new"),
    [
        ("roadlang.api", "Stretch", "ViolatedSegment"),
        ("roadlang.api", "Whole", "Integer"),
        ("roadlang.stl", "Monitor", "OnlineMonitor"),
        ("roadlang.stl", "Junction", "LogicalJunction"),
        ("roadlang.stl", "Stretch", "ViolationInterval"),
    ],
)
def test_an_old_name_is_the_new_one_with_a_warning(module: str, old: str, new: str) -> None:
    found: Any = importlib.import_module(module)
    with pytest.warns(DeprecationWarning, match=f"{module}.{old} is now {module}.{new}") as caught:
        assert getattr(found, old) is getattr(found, new)
    assert caught[0].filename == __file__


def test_names_that_never_were_are_unknown() -> None:
    from roadlang import api, stl

    for module in (api, stl):
        assert not hasattr(module, "Stretches")


def test_a_lane_kind_may_still_state_its_width_and_marking_by_their_old_names() -> None:
    with pytest.warns(DeprecationWarning, match="`usual_width` is now `default_width`"):

        class TramLane(LaneKind):
            usual_width = 2.8

    assert TramLane.default_width == 2.8
