"""From meters to the pixels of the drawing."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from roadlang.api import Scene, SceneActor, SceneRoad
    from roadlang.geometry import Floats


_WIDEST = 3.2
_TALLEST = 1.05
_MARGIN = 0.06
_SMALLEST_SPAN = 20.0


@dataclass(frozen=True)
class BoundingBox:
    """A rectangle in meters."""

    left: float
    bottom: float
    right: float
    top: float

    @property
    def width(self) -> float:
        return self.right - self.left

    @property
    def height(self) -> float:
        return self.top - self.bottom

    def around(self, other: BoundingBox) -> BoundingBox:
        """The smallest box around both."""
        return BoundingBox(
            min(self.left, other.left),
            min(self.bottom, other.bottom),
            max(self.right, other.right),
            max(self.top, other.top),
        )


@dataclass(frozen=True)
class Viewport:
    """The map's rectangle in the drawing: `x`, `y`, `width`, `height` in pixels, showing `box`."""

    box: BoundingBox
    x: float
    y: float
    width: float
    height: float

    @property
    def pixels_per_meter(self) -> float:
        return self.width / self.box.width

    def place(self, points: ArrayLike) -> Floats:
        """(..., 2) meters to pixels."""
        import numpy as np

        meters = np.asarray(points, dtype=float)
        scale = self.pixels_per_meter
        east = self.x + (meters[..., 0] - self.box.left) * scale
        south = self.y + (self.box.top - meters[..., 1]) * scale
        return np.stack([east, south], axis=-1)


def fitted(box: BoundingBox, x: float, y: float, width: float) -> Viewport:
    """A viewport `width` pixels wide on `box` with a margin, widened to a pleasant shape."""
    margin = _MARGIN * max(box.width, box.height, _SMALLEST_SPAN)
    wide = max(box.width, _SMALLEST_SPAN) + 2 * margin
    height = max(box.height, _SMALLEST_SPAN / 2) + 2 * margin
    wide, height = max(wide, height / _TALLEST), max(height, wide / _WIDEST)
    return _centered(box, wide, height, Viewport(box, x, y, width, width * height / wide))


def within(box: BoundingBox, frame: Viewport) -> Viewport:
    """A viewport of the size and place of `frame` (its box is ignored) that shows all of `box`."""
    margin = _MARGIN * max(box.width, box.height, _SMALLEST_SPAN)
    wide = max(box.width, _SMALLEST_SPAN) + 2 * margin
    height = max(box.height, _SMALLEST_SPAN) + 2 * margin
    shape = frame.height / frame.width
    wide, height = max(wide, height / shape), max(height, wide * shape)
    return _centered(box, wide, height, frame)


def _centered(box: BoundingBox, wide: float, height: float, frame: Viewport) -> Viewport:
    east, north = (box.left + box.right) / 2, (box.bottom + box.top) / 2
    shown = BoundingBox(east - wide / 2, north - height / 2, east + wide / 2, north + height / 2)
    return Viewport(shown, frame.x, frame.y, frame.width, frame.height)


def bounds(scene: Scene) -> BoundingBox:
    """All of a scene in meters: roads with their width, agents and objects."""
    boxes = [*map(_road_box, scene.roads), *map(_actor_box, (*scene.agents, *scene.objects))]
    if not boxes:
        return BoundingBox(-50.0, -50.0, 50.0, 50.0)
    left, bottom, right, top = zip(*boxes, strict=True)
    return BoundingBox(min(left), min(bottom), max(right), max(top))


Edges = tuple[float, float, float, float]
"""Left, bottom, right and top."""


def _road_box(road: SceneRoad) -> Edges:
    half = max(road.width) / 2
    return min(road.x) - half, min(road.y) - half, max(road.x) + half, max(road.y) + half


def _actor_box(actor: SceneActor) -> Edges:
    radius = math.hypot(actor.length, actor.width) / 2
    x, y = actor.x, actor.y
    return x - radius, y - radius, x + radius, y + radius
