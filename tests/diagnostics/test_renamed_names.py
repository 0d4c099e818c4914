"""Old names of public Python modules work for one more minor version, and say what to write."""

from __future__ import annotations

import importlib
from typing import Any

import pytest

from roadlang.api import (
    AgentTrace,
    Code,
    LaneKind,
    LanePlace,
    LanePlaces,
    Neighbors,
    ObservationBatch,
)


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


@pytest.mark.parametrize(
    ("old", "new", "value"),
    [
        ("usual_width", "default_width", 2.8),
        ("usual_marking", "default_marking", "double"),
        ("is_whole", "is_integer", True),
    ],
)
def test_a_kind_may_still_use_the_old_names_of_its_attributes(
    old: str, new: str, value: object
) -> None:
    with pytest.warns(DeprecationWarning, match=f"`{old}` is now `{new}`"):
        kind = type("TramLane", (LaneKind,), {old: value})
    assert getattr(kind, new) == value


@pytest.mark.parametrize(
    ("owner", "old", "new"),
    [
        (Code, "NO_WAY", "NO_ROUTE"),
        (AgentTrace, "still", "standing"),
        (LanePlace, "usual_speed", "default_speed"),
        (LanePlaces, "usual_speed", "default_speed"),
        (LanePlaces, "of_one", "of_single"),
        (Neighbors, "of_one", "of_single"),
        (ObservationBatch, "of_one", "of_single"),
    ],
)
def test_an_old_name_of_a_member_is_the_new_one_with_a_warning(
    owner: Any, old: str, new: str
) -> None:
    text = f"{owner.__name__}.{old} is now {owner.__name__}.{new}"
    with pytest.warns(DeprecationWarning, match=text) as caught:
        assert getattr(owner, old) == getattr(owner, new)
    assert caught[0].filename == __file__


def test_an_old_name_works_on_an_object_too() -> None:
    with pytest.warns(DeprecationWarning, match="is now LanePlace.default_speed"):
        assert LanePlace().usual_speed == LanePlace.default_speed
