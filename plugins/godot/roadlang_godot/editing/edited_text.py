"""The text of a watched file and what a human does to it in the window: shown, undone, redone."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from roadlang.api import Scene
    from roadlang.commands import Handle

    from ..build.moved_parts import PlaneMap
    from .live import HandEdit


MOVING_KIND = "nudges"
"""What roads that are not drawn through points are perturbed with."""
SAME = 0.005
"""Meters within which a place is the same: texts are written to the centimeter."""


@dataclass(frozen=True)
class _Drag:
    """What is dragged, and what the text and the scene were when it was taken."""

    number: int
    handle: Handle
    text: str
    scene: Scene
    start: tuple[float, float]
    to: tuple[float, float]

    @property
    def is_back(self) -> bool:
        """Whether it is where it began."""
        return math.dist(self.to, self.start) < SAME


class EditedText:
    """`shown` is the text of the scene that is to be shown: `text`, or during a drag what it would
    be. Each change of `text` by hand can be undone."""

    def __init__(self, text: str) -> None:
        self.text = self.shown = text
        self._past: list[str] = []
        self._future: list[str] = []
        self._drag: _Drag | None = None

    def take(self, edit: HandEdit, scene: Scene) -> bool:
        """Do what a human did, in a scene; whether it can be written."""
        from roadlang.commands import inserted, removed

        if edit.what in ("undo", "redo"):
            return self._step(*self._stacks(edit.what))
        assert edit.handle is not None
        if edit.what == "move":
            return self._dragged(edit, edit.handle, scene)
        if edit.what == "insert":
            return self._commit(inserted(self.text, scene, edit.handle, edit.to, MOVING_KIND))
        return self._commit(removed(self.text, edit.handle))

    def preview(self, scene: Scene) -> Scene | None:
        """A scene with what is dragged where it is now, where that is known without compiling:
        unless a network is dragged."""
        from .dragged_scene import dragged_scene  # imports numpy

        drag = self._drag
        if drag is None:
            return None
        return dragged_scene(scene, drag.scene, (drag.text, self.shown), drag.handle, drag.to)

    @property
    def dragged_agent(self) -> frozenset[str]:
        """The name of the agent that is dragged, if one is."""
        drag = self._drag
        held = drag is not None and drag.handle.sort == "agent"
        return frozenset([drag.handle.name] if drag is not None and held else ())

    def motion(self, compiled: str) -> PlaneMap | None:
        """How what is dragged moves what was built of a text that was compiled, where a network is
        dragged."""
        from roadlang.commands import network_motion

        drag = self._drag
        if drag is None or drag.handle.sort not in ("junction", "street"):
            return None
        return network_motion(compiled, self.shown, drag.handle.name)

    def replace(self, text: str) -> None:
        """The file was saved by someone else: there is nothing to undo."""
        self.text = self.shown = text
        self._past, self._future, self._drag = [], [], None

    def withdraw(self, failed: str) -> None:
        """What is shown has no scene: it is as before the last change by hand."""
        if self.shown != failed:
            return
        if self.text == failed and self._past:
            self.text = self._past.pop()
        self.shown = self.text

    def _dragged(self, edit: HandEdit, handle: Handle, scene: Scene) -> bool:
        from roadlang.commands import dragged

        if self._drag is None or self._drag.number != edit.drag:
            start = edit.start or (handle.x, handle.y)
            self._drag = _Drag(edit.drag, handle, self.text, scene, start, edit.to)
        self._drag = drag = replace(self._drag, to=edit.to)
        text: str | None = drag.text
        if not drag.is_back:
            text = dragged(drag.text, drag.scene, drag.handle, edit.to, MOVING_KIND)
        if edit.done:
            self._drag = None
            return self._commit(text)
        if text is not None:
            self.shown = text
        return text is not None

    def _commit(self, text: str | None) -> bool:
        if text is None:
            self.shown = self.text
            return False
        if text != self.text:
            self._past.append(self.text)
            self._future.clear()
        self.text = self.shown = text
        return True

    def _stacks(self, what: str) -> tuple[list[str], list[str]]:
        stacks = self._past, self._future
        return stacks if what == "undo" else stacks[::-1]

    def _step(self, source: list[str], target: list[str]) -> bool:
        if source:
            target.append(self.text)
            self.text = self.shown = source.pop()
        return True
