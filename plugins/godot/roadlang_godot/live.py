"""A scene that lives in an engine: it drives on while it is changed, from either side."""

from __future__ import annotations

import json
import time
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from .followed_scene import FollowedScene
from .layout import Layout, layout_of
from .paced_drive import PacedDrive
from .protocol import Message
from .session import Session

if TYPE_CHECKING:
    from roadlang.api import Controller, Scene, Trace

RATE = 60
EVERY = 2
"""Ticks from one decision to the next."""
MEMORY = 120.0
"""Seconds of driving that are kept for judging, at most."""


@dataclass(frozen=True, slots=True)
class Move:
    """What a human moved: an object or the point of a road, from where to where."""

    what: str
    name: str
    start: tuple[float, float]
    end: tuple[float, float]
    done: bool


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
    ) -> None:
        self._session = session
        self._road = road
        controllers = controllers or {}
        self.scene = scene
        self.layout: Layout = layout_of(scene, road, controllers)
        self._drive: PacedDrive | None = None
        self._begin(scene, controllers)
        session.begin(self.layout.settings(RATE), clear=True)
        session.update(self.layout.parts)
        session.prove()
        self._run()

    def change(
        self,
        scene: Scene,
        controllers: Mapping[str, Controller] | None = None,
        restarted: frozenset[str] = frozenset(),
    ) -> int:
        """Send what differs; everything else drives on. Returns how many messages it took.

        Agents keep pose, speed and what their controllers remember, wherever their roads are now,
        but for agents or groups that are `restarted`.
        """
        controllers = controllers or {}
        layout = layout_of(scene, self._road, controllers, self.layout, restarted)
        followed, was_driven = self._followed, self._drive is not None
        count = self._session.update(layout.parts)
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

    def show(self, lines: list[str]) -> None:
        """Lines of text over the picture."""
        ascii = [line.encode("ascii", "replace").decode() for line in lines]
        self._session.send_json(Message.NOTE, {"lines": ascii})

    def listen(self, timeout: float) -> list[Move]:
        """Drive on for some seconds; take what a human moved meanwhile.

        Raises RL470, RL474 of controllers, RL513 of conditions: the drive then waits for a change.
        """
        end = time.monotonic() + timeout
        while (left := end - time.monotonic()) > 0.0:
            self._session.pump(left)
            self._drive_on()
        changes = []
        while (edit := self._session.take(Message.EDIT)) is not None:
            changes += self._move(edit)
        return changes

    def trace(self) -> Trace | None:
        """What was driven lately; None where nothing was."""
        driven = self._followed is not None and self._samples > 1
        return self._followed.trace("Godot") if driven and self._followed is not None else None

    def _begin(self, scene: Scene, controllers: Mapping[str, Controller]) -> None:
        """What is driven from now on is judged."""
        step = EVERY / RATE
        self._followed = (
            FollowedScene(scene, self.layout, step, RATE, controllers) if scene.agents else None
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

    def _move(self, payload: bytes) -> list[Move]:
        edit = json.loads(payload)
        frame = self.layout.frame
        name = self._name(str(edit["what"]), int(edit["id"]))
        if name is None:
            return []
        start, end = (
            (float(x) + frame.x, float(y) + frame.y) for x, y in (edit["from"], edit["to"])
        )
        return [Move(str(edit["what"]), name, start, end, bool(edit["done"]))]

    def _name(self, what: str, number: int) -> str | None:
        if what == "road":
            names = {id: name for name, id in self.layout.paths.items()}
            return names.get(number >> 16)
        for part in self.layout.parts:
            if part.kind == Message.OBJECTS and part.id == number:
                return part.label
        return None
