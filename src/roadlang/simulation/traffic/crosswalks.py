"""Crosswalks between junctions: who stands at one, and whether the line of a car leads over it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ...ir.scene import Scene
from ..surroundings.outlines import Outlines

BEFORE_END = 3.0
"""Meters from the end of a crosswalk at which who wants to cross waits, at most."""
BESIDE = 0.5
"""Meters beside a crosswalk at which people still use it."""


@dataclass(frozen=True)
class Crosswalks:
    """Columns (M,) over those of some scenes."""

    scene: Integers
    """number of its scene among these"""
    outlines: Outlines

    @classmethod
    def of(cls, scenes: Sequence[Scene]) -> Crosswalks:
        """All of them."""
        counts = [len(scene.markings) for scene in scenes]
        found = [marking for scene in scenes for marking in scene.markings]
        return cls(np.repeat(np.arange(len(scenes)), counts), Outlines.of(found))

    def at(self, scene: Integers, x: Floats, y: Floats) -> Integers:
        """(P,) the crosswalk on which, or at an end of which, somebody (P,) of a scene is; -1 for
        none."""
        if not len(self.scene) or not len(x):
            return np.full(len(x), -1)
        along, across = self._beyond(x[:, None], y[:, None], slice(None))
        near = (along < BESIDE) & (across < BEFORE_END) & (scene[:, None] == self.scene)
        return np.where(near.any(axis=1), near.argmax(axis=1), -1)

    def width(self, number: Integers) -> Floats:
        """(P,) meters across the road of crosswalks by their numbers, 0 for none."""
        widths = np.append(2.0 * self.outlines.half_width, 0.0)
        return np.asarray(widths[number])

    def covers(self, number: Integers, x: Floats, y: Floats) -> Booleans:
        """(P,) whether places are on crosswalks by their numbers."""
        known = number >= 0
        if not known.any():
            return known
        along, across = self._beyond(x, y, np.where(known, number, 0))
        return np.asarray(known & (along < BESIDE) & (across < 0.0))

    def _beyond(self, x: Floats, y: Floats, number: Integers | slice) -> tuple[Floats, Floats]:
        """How far places are beyond the sides and beyond the ends of crosswalks, meters."""
        one = self.outlines.take(number)
        dx, dy = x - one.x, y - one.y
        along = np.abs(one.cosine * dx + one.sine * dy) - one.half_length
        across = np.abs(one.cosine * dy - one.sine * dx) - one.half_width
        return along, across
