"""Who is held while a human drags, and where an agent drives on that was let go."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, cast

import pytest

from roadlang.handles.handle import Handle
from roadlang_godot.build.agent_specs import AgentPose
from roadlang_godot.editing.held_agent import NOBODY, HeldAgent, held_agent
from roadlang_godot.editing.live import HandEdit, LiveScene

HERE = AgentPose(1.0, 2.0, 0.5, 8.0)


class _Live:
    """Knows the pose of one agent, and another one at each question."""

    def __init__(self) -> None:
        self.asked = 0

    def pose(self, name: str) -> AgentPose | None:
        self.asked += 1
        return HERE if name == "ego" else None


def _agent(name: str) -> Handle:
    return Handle("agent", name, 1.0, 2.0)


def _held(before: HeldAgent, edit: HandEdit, live: _Live | None = None) -> HeldAgent:
    return held_agent(before, edit, cast(LiveScene, cast(Any, live or _Live())), "text")


@pytest.mark.parametrize(
    "edit",
    [
        HandEdit("move"),
        HandEdit("remove", _agent("ego"), drag=3),
        HandEdit("move", replace(_agent("ego"), sort="waypoint"), drag=3),
    ],
)
def test_nobody_is_held_but_an_agent_that_is_moved(edit: HandEdit) -> None:
    assert _held(NOBODY, edit) is NOBODY


def test_an_agent_is_held_from_the_first_move_of_a_drag() -> None:
    live, edit = _Live(), HandEdit("move", _agent("ego"), drag=3)
    first = _held(NOBODY, edit, live)
    assert first == HeldAgent(3, "text", {"ego": HERE})
    assert _held(first, edit, live) is first
    assert live.asked == 1
    assert _held(first, replace(edit, drag=4), live).drag == 4
    assert _held(NOBODY, HandEdit("move", _agent("other"), drag=3)).poses == {}
    assert first.poses_in("text") == {"ego": HERE}
    assert first.poses_in("another") == {}
