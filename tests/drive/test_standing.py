"""Traces are stored without the objects that stand, and are whole again with those of the scene."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from roadlang.drive.standing import with_objects, without_objects
from roadlang.ir.trace import AgentTrace, Trace
from tests.backends.handmade_scenes import actor, bend

TIME = np.array([0.0, 1.0, 2.0])
TREE, BOX, EGO = actor("tree", "tree", 4, 5), actor("box", "box", 9, 1), actor("ego", "car", 0, 0)
SCENE = replace(bend(), objects=(TREE, BOX), agents=(EGO,))
STANDING = {one.name: AgentTrace.standing(one, TIME) for one in (EGO, TREE, BOX)}


def test_what_stands_is_at_rest_where_the_scene_has_it() -> None:
    place: dict[str, Any] = {"x": 4.0, "y": 5.0, "heading": 0.5}
    box = replace(BOX, **place, start=7.0, offset=-2.0, length=1.5, width=1.25)
    stands = AgentTrace.standing(box, TIME)
    at = {**place, "station": 7.0, "cross_track_error": -2.0, "present": 1.0}
    rest = ("speed", "acceleration", "steering", "progress", "contacts", "route_progress",
            "red_light", "collision")  # fmt: skip
    for member, value in {**at, **dict.fromkeys(rest, 0.0)}.items():
        np.testing.assert_array_equal(getattr(stands, member), [value] * 3, err_msg=member)
    assert (stands.name, stands.length, stands.width) == ("box", 1.5, 1.25)
    nowhere = AgentTrace.standing(replace(box, start=None, offset=None), TIME)
    assert (nowhere.station[0], nowhere.cross_track_error[0]) == (0.0, 0.0)


@pytest.mark.parametrize("column", ["x", "y", "heading"])
def test_what_stands_throughout_is_left_out_but_for_agents(column: str) -> None:
    moved: dict[str, Any] = {column: np.array([0.0, 0.0, 0.1])}
    pushed = replace(STANDING["box"], **moved)
    stored = without_objects(Trace(TIME, {**STANDING, "box": pushed}), SCENE)
    assert list(stored.agents) == ["ego", "box"]


def test_a_stored_trace_is_whole_again() -> None:
    stored = without_objects(Trace(TIME, STANDING), SCENE)
    assert list(stored.agents) == ["ego"]
    whole = with_objects(stored, SCENE)
    assert list(whole.agents) == ["ego", "tree", "box"]
    for name, one in whole.agents.items():
        np.testing.assert_array_equal(one.x, STANDING[name].x)
        np.testing.assert_array_equal(one.y, STANDING[name].y)


def test_objects_of_the_trace_are_kept_as_they_moved() -> None:
    pushed = replace(STANDING["box"], x=np.array([9.0, 9.5, 11.0]))
    whole = with_objects(Trace(TIME, {"ego": STANDING["ego"], "box": pushed}), SCENE)
    assert list(whole.agents) == ["ego", "box", "tree"]
    assert whole.agents["box"] is pushed
