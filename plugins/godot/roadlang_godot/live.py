"""A scene that lives in an engine: it drives on while it is changed, from either side."""

from __future__ import annotations

import json
from collections import deque
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .layout import Layout, layout_of
from .protocol import Message
from .session import Session
from .telemetry import Records, records
from .traces import trace_of

if TYPE_CHECKING:
    from roadlang.api import Scene, Trace

RATE = 60
MEMORY = 120.0
"""Seconds of driving that are kept for judging."""


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
        self._kept: deque[Records] = deque()
        self.scene = scene
        self.layout: Layout = layout_of(scene, road)
        session.begin(self.layout.settings(RATE), clear=True)
        session.update(self.layout.things)
        session.prove()
        session.send_json(Message.RUN, {"mode": "free", "every": 2})
        session.flush()

    def change(self, scene: Scene) -> int:
        """Send what differs; everything else drives on. Returns how many messages it took."""
        layout = layout_of(scene, self._road, self.layout.frame)
        count = self._session.update(layout.things)
        self.scene, self.layout = scene, layout
        return count

    def show(self, lines: list[str]) -> None:
        """Lines of text over the picture."""
        ascii = [line.encode("ascii", "replace").decode() for line in lines]
        self._session.send_json(Message.NOTE, {"lines": ascii})

    def listen(self, timeout: float) -> list[Move]:
        """Wait a moment; take what was driven and what a human moved meanwhile."""
        self._session.pump(timeout)
        while (part := self._session.take(Message.TRACE)) is not None:
            self._kept.append(records(part))
        while self._kept and self._span() > MEMORY * RATE:
            self._kept.popleft()
        changes = []
        while (edit := self._session.take(Message.EDIT)) is not None:
            changes += self._move(edit)
        return changes

    def trace(self) -> Trace | None:
        """What was driven lately; None where nothing was."""
        if not self._kept or not self.layout.agents:
            return None
        rows = np.concatenate(list(self._kept))
        rows = rows[np.lexsort((rows["agent"], rows["world"], rows["tick"]))]
        ticks = [set(rows["tick"][rows["agent"] == n]) for n in self.layout.agents.values()]
        common = np.array(sorted(set.intersection(*ticks)), dtype=rows["tick"].dtype)
        if len(common) < 2:
            return None
        rows = rows[np.isin(rows["tick"], common)].copy()
        rows["tick"] -= common[0]
        return trace_of(rows, self.layout, self.scene, 1.0 / RATE, "Godot")

    def _span(self) -> int:
        return int(self._kept[-1]["tick"][-1]) - int(self._kept[0]["tick"][0])

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
        for thing in self.layout.things:
            if thing.kind == Message.OBJECTS and thing.id == number:
                return thing.label
        return None
