"""A scene that lives in an engine: it drives on while it is changed, from either side."""

from __future__ import annotations

import json
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from ..build.agent_specs import AgentPose
from ..build.handle_parts import handle_parts
from ..build.layout import Layout, layout_of
from ..build.moved_parts import PlaneMap, moved_parts
from ..drive.followed_scene import FollowedScene
from ..drive.paced_drive import PacedDrive
from ..net.protocol import Message
from ..net.session import Session
from ..sensors.eyes import Eyes

if TYPE_CHECKING:
    from roadlang.api import Controller, Scene, Trace
    from roadlang.commands import Handle

RATE = 60
EVERY = 2
"""Ticks from one decision to the next."""
MEMORY = 120.0
"""Seconds of driving that are kept for judging, at most."""


@dataclass(frozen=True, slots=True)
class HandEdit:
    """What a human does in the window. `what`: `move`, `insert` near a handle, `remove`, `undo`,
    `redo`. A drag of one number has many moves, of which the last is `done`. It begins at `start`,
    which is not the place of the handle where an agent is dragged that has driven on from it."""

    what: str
    handle: Handle | None = None
    to: tuple[float, float] = (0.0, 0.0)
    drag: int = 0
    done: bool = True
    start: tuple[float, float] | None = None


class LiveScene:
    """Keeps the engine's world equal to the scene, drives in it, and collects what is driven.

    `controllers`: of the agents that Python drives; the engine drives the others by itself.
    """

    def __init__(
        self,
        session: Session,
        scene: Scene,
        controllers: Mapping[str, Controller] | None = None,
        road: str = "mesh",
        handles: Sequence[Handle] = (),
    ) -> None:
        self._session = session
        self._road = road
        controllers = controllers or {}
        self.scene = scene
        self.layout: Layout = layout_of(scene, road, controllers)
        self._shown, self._handles = handle_parts(handles, self.layout.frame)
        self._drive: PacedDrive | None = None
        self._begin(scene, controllers)
        session.begin(self.layout.settings(RATE), clear=True)
        session.update([*self.layout.parts, *self._shown])
        session.prove()
        self._run()

    def change(
        self,
        scene: Scene,
        controllers: Mapping[str, Controller] | None = None,
        restarted: frozenset[str] = frozenset(),
        handles: Sequence[Handle] = (),
        poses: Mapping[str, AgentPose] | None = None,
        *,
        waits: bool = True,
    ) -> int:
        """Send what differs; everything else drives on. Returns how many messages it took.

        Where it does not wait, the engine may not have all of it yet. Agents keep pose, speed and
        what their controllers remember, wherever their roads are now, but for agents or groups that
        are `restarted`: at one of the `poses` where there is one.
        """
        controllers = controllers or {}
        layout = layout_of(scene, self._road, controllers, self.layout, restarted, poses)
        followed, was_driven = self._followed, self._drive is not None
        self._shown, self._handles = handle_parts(handles, layout.frame)
        count = self._session.update([*layout.parts, *self._shown], waits=waits)
        self.scene, self.layout = scene, layout
        self._begin(scene, controllers)
        if self._drive is not None and layout.agents:
            assert self._followed is not None
            assert followed is not None
            self._followed.carry_on(followed, restarted)
            self._drive.look_again()
        elif was_driven or layout.agents:
            self._run()
        return count

    def show_moved(self, plane: PlaneMap) -> int:
        """Show all roads and junctions moved by a map of the plane, until the next change. Agents
        and objects stay. Does not wait for it. Returns how many messages it took."""
        parts = moved_parts(self.layout.parts, self.layout.frame, plane)
        return self._session.update([*parts, *self._shown], waits=False)

    def show(self, lines: list[str]) -> None:
        """Lines of text over the picture."""
        ascii = [line.encode("ascii", "replace").decode() for line in lines]
        self._session.send_json(Message.NOTE, {"lines": ascii})

    def listen(self, timeout: float) -> list[HandEdit]:
        """Drive on for some seconds, or until a human does something; returns what that is.

        Raises RL470, RL474 of controllers, RL513 of conditions: the drive then waits for a change.
        """
        end = time.monotonic() + timeout
        while (left := end - time.monotonic()) > 0.0:
            self._session.pump(left)
            self._drive_on()
            if edits := self._edits():
                return edits
        return self._edits()

    def pose(self, name: str) -> AgentPose | None:
        """Where an agent is now, if that is known."""
        return None if self._followed is None else self._followed.pose(name)

    def trace(self) -> Trace | None:
        """What was driven lately; None where nothing was."""
        driven = self._followed is not None and self._samples > 1
        return self._followed.trace("Godot") if driven and self._followed is not None else None

    def _begin(self, scene: Scene, controllers: Mapping[str, Controller]) -> None:
        """What is driven from now on is judged."""
        step, eyes = EVERY / RATE, Eyes(self._session, scene, self.layout)
        self._followed = (
            FollowedScene(scene, self.layout, step, RATE, controllers, eyes)
            if scene.agents
            else None
        )
        self._samples = 0
        self._waits = False

    def _run(self) -> None:
        """Start the drive; without agents there are only the lights to run."""
        if self._drive is not None:
            self._drive.stop()
        if self.layout.agents:
            self._drive = PacedDrive(self._session)
        else:
            self._drive = None
            self._session.send_json(Message.RUN, {"mode": "free", "every": EVERY})
        self._session.flush()

    def _drive_on(self) -> None:
        """Look at the newest state, and decide."""
        if self._drive is None or self._followed is None or self._waits:
            return
        state = self._drive.state(len(self.layout.agents))
        if state is None:
            return
        if self._samples * EVERY > MEMORY * RATE:
            self._followed.forget()
            self._samples = 0
        self._followed.look(state)
        self._samples += 1
        self._waits = True  # for a change, should a controller fail
        self._drive.answer(state, self._followed.controls(), EVERY)
        self._waits = False

    def _edits(self) -> list[HandEdit]:
        found = []
        while (payload := self._session.take(Message.EDIT)) is not None:
            edit = json.loads(payload)
            handles = self._handles.get(int(edit.get("id", 0)), ())
            index = int(edit.get("index", 0))
            handle = handles[index] if 0 <= index < len(handles) else None
            if handle is not None or edit["what"] in ("undo", "redo"):
                found.append(self._edit(edit, handle))
        return found

    def _edit(self, edit: Mapping[str, Any], handle: Handle | None) -> HandEdit:
        to = self._place(edit.get("to", (0.0, 0.0)))
        start = self._place(edit["from"]) if "from" in edit else None
        done = bool(edit.get("done", True))
        return HandEdit(str(edit["what"]), handle, to, int(edit.get("drag", 0)), done, start)

    def _place(self, local: Sequence[float]) -> tuple[float, float]:
        frame = self.layout.frame
        return float(local[0]) + frame.x, float(local[1]) + frame.y
