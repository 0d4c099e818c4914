"""A scene that lives in an engine: it drives on while it is changed, from either side."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .followed_scene import FollowedScene
from .layout import Layout, layout_of
from .protocol import Message
from .session import Session
from .telemetry import CONTACT, Records, records

if TYPE_CHECKING:
    from roadlang.api import Scene, Trace

RATE = 60
EVERY = 2
"""Ticks from one record to the next."""
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
    """Keeps the engine's world equal to the scene, and collects what is driven in it."""

    def __init__(self, session: Session, scene: Scene, road: str = "mesh") -> None:
        self._session = session
        self._road = road
        self.scene = scene
        self.layout: Layout = layout_of(scene, road)
        self._forget()
        session.begin(self.layout.settings(RATE), clear=True)
        session.update(self.layout.parts)
        session.prove()
        session.send_json(Message.RUN, {"mode": "free", "every": EVERY})
        session.flush()

    def change(self, scene: Scene) -> int:
        """Send what differs; everything else drives on. Returns how many messages it took."""
        layout = layout_of(scene, self._road, self.layout.frame)
        count = self._session.update(layout.parts)
        self.scene, self.layout = scene, layout
        self._forget()
        return count

    def show(self, lines: list[str]) -> None:
        """Lines of text over the picture."""
        ascii = [line.encode("ascii", "replace").decode() for line in lines]
        self._session.send_json(Message.NOTE, {"lines": ascii})

    def listen(self, timeout: float) -> list[Move]:
        """Wait a moment; take what was driven and what a human moved meanwhile."""
        self._session.pump(timeout)
        self._record()
        changes = []
        while (edit := self._session.take(Message.EDIT)) is not None:
            changes += self._move(edit)
        return changes

    def trace(self) -> Trace | None:
        """What was driven lately; None where nothing was."""
        return self._followed.trace("Godot") if self._samples > 1 else None

    def _forget(self) -> None:
        """What is driven from now on is judged."""
        self._followed = FollowedScene(self.scene, self.layout, EVERY / RATE, RATE)
        self._rows: dict[int, list[Records]] = {}
        self._contacts: list[Records] = []
        self._samples = 0

    def _record(self) -> None:
        """Make samples of the ticks of which the records of all agents are here."""
        numbers = set(self.layout.agents.values())
        while (part := self._session.take(Message.CONTACTS)) is not None:
            self._contacts += list(records(part, CONTACT))
        while (part := self._session.take(Message.TRACE)) is not None:
            for row in records(part):
                if int(row["agent"]) in numbers:
                    self._rows.setdefault(int(row["tick"]), []).append(row)
        for tick in sorted(self._rows):
            rows = self._rows[tick]
            if len(rows) < len(numbers):
                continue
            if self._samples * EVERY > MEMORY * RATE:
                self._forget()
                return
            rows.sort(key=lambda row: int(row["agent"]))
            self._followed.look_at_records(np.array(rows), np.array(self._contacts, dtype=CONTACT))
            self._samples += 1
            self._contacts = []
            self._rows = {late: some for late, some in self._rows.items() if late > tick}

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
