"""Where an agent was that a human drags: put down there again, it drives on from there."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ..build.agent_specs import AgentPose
    from .live import HandEdit, LiveScene


@dataclass(frozen=True)
class HeldAgent:
    """The agent of the drag with this number: its pose when it was taken, and the text then."""

    drag: int
    text: str
    poses: Mapping[str, AgentPose]

    def poses_in(self, text: str) -> Mapping[str, AgentPose]:
        """Where agents drive on in the scene of a text."""
        return self.poses if text == self.text else {}


NOBODY = HeldAgent(0, "", {})


def held_agent(held: HeldAgent, edit: HandEdit, live: LiveScene, text: str) -> HeldAgent:
    """Who is held during an edit of a text; `held`: who was before it."""
    if edit.what != "move" or edit.handle is None or edit.handle.sort != "agent":
        return NOBODY
    if edit.drag == held.drag:
        return held
    pose = live.pose(edit.handle.name)
    return HeldAgent(edit.drag, text, {} if pose is None else {edit.handle.name: pose})
