"""Arrows painted on lanes."""

from __future__ import annotations

from collections.abc import Collection

import numpy as np

from ..geometry.arrays import Floats

_SHAPES = {
    "straight": ([(-1.6, 0.0), (1.0, 0.0)], (1.0, 0.0), 0.0),
    "left": ([(-1.6, 0.0), (-0.5, 0.0), (0.0, 0.5)], (0.0, 0.5), 50.0),
    "right": ([(-1.6, 0.0), (-0.5, 0.0), (0.0, -0.5)], (0.0, -0.5), -50.0),
    "u": ([(-1.6, 0.0), (-0.2, 0.0), (0.0, 0.4), (-0.4, 0.7)], (-0.4, 0.7), 150.0),
}
"""The line, the foot of the head and its direction in degrees; x along the lane, y to the left"""
_HEAD = [(0.0, 0.35), (0.9, 0.0), (0.0, -0.35)]


def arrow(turns: Collection[str], x: float, y: float, heading: float) -> list[tuple[Floats, bool]]:
    """Lines (False) and filled heads (True) of an arrow at (x, y), meters."""

    def placed(points: Floats) -> Floats:
        return np.asarray(points @ _turned(heading) + (x, y))

    found = []
    for turn, (line, foot, degrees) in _SHAPES.items():
        if turn in turns:
            head = np.array(_HEAD) @ _turned(np.radians(degrees)) + foot
            found += [(placed(np.array(line)), False), (placed(head), True)]
    return found


def _turned(angle: float) -> Floats:
    return np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
