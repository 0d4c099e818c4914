"""Boxes around agents and objects: in the world, in a camera's coordinates, and in its pictures."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from roadlang_standard.semantic_classes import SemanticClass

from ..build.label_parts import Instance
from ..build.mounted_camera import MountedCamera
from .camera_frames import CameraFrame, Pose

Floats = NDArray[np.float64]
Rectangle = tuple[float, float, float, float]
"""Left, top, right and bottom in pixels; pixel (i, j) covers i to i + 1 and j to j + 1."""

NEAREST = 0.1
"""Meters from the plane of a camera, before which nothing is seen."""
_SKIN = 0.02
"""Meters: what is this little nearer than a box does not hide it."""
_ROWS = 256
"""Of a picture, whose rays are held at once."""
_SIGNS = np.array([[x, y, z] for x in (1, -1) for y in (1, -1) for z in (1, -1)], dtype=float)
_EDGES = [(i, j) for i in range(8) for j in range(i) if np.abs(_SIGNS[i] - _SIGNS[j]).sum() == 2]


@dataclass(frozen=True, slots=True)
class SolidBox:
    """A box in the world: the place of its center (3,) in meters, its axes ahead, left and up as
    the columns of `axes` (3, 3), and its length, width and height."""

    place: Floats
    axes: Floats
    size: tuple[float, float, float]

    @property
    def corners(self) -> Floats:
        """(8, 3), in the order of the signs of their offsets ahead, left and up."""
        half: Floats = 0.5 * np.array(self.size)
        return np.asarray(self.place + (_SIGNS * half) @ self.axes.T)

    def seen_from(self, camera: Pose) -> SolidBox:
        """The same box in the coordinates of a camera: right, down and forward."""
        place = (self.place - camera.place) @ camera.axes
        return SolidBox(place, camera.axes.T @ self.axes, self.size)


@dataclass(frozen=True, slots=True)
class SeenThing:
    """An agent or object in a picture.

    `visible` is the extent of its pixels, None where it has none. `projected` is the extent of its
    solid box, also outside the picture. `occlusion` is the share of that box, as far as it is in
    the picture, that lies behind something nearer; `truncation` the share of `projected` outside
    the picture.
    """

    instance: Instance
    solid: SolidBox
    visible: Rectangle | None
    projected: Rectangle
    pixels: int
    occlusion: float
    truncation: float

    @property
    def category(self) -> SemanticClass:
        """Its class."""
        return self.instance.category


def seen_things(frame: CameraFrame, instances: Iterable[Instance]) -> tuple[SeenThing, ...]:
    """The agents and objects whose boxes are in a frame, seen or hidden, in order of their numbers;
    not the agent that carries the camera.

    The frame must have depth and instances. Raises `ValueError` where it has not.
    """
    if frame.instance is None or frame.depth is None:
        raise ValueError("boxes need a camera with the outputs `depth` and `instance`")
    extents = _pixel_extents(frame.instance)
    out = []
    for instance in instances:
        solid = solid_box(instance, frame)
        if solid is None or instance.actor.name == frame.camera.agent:
            continue
        projected = projected_box(solid, frame)
        if projected is None or (inside := _clipped(projected, frame.camera)) is None:
            continue
        visible, pixels = extents.get(instance.number, (None, 0))
        occlusion = _occlusion(solid, frame, instance.number, inside)
        truncation = 1.0 - _area(inside) / _area(projected)
        out.append(SeenThing(instance, solid, visible, projected, pixels, occlusion, truncation))
    return tuple(out)


def solid_box(instance: Instance, frame: CameraFrame) -> SolidBox | None:
    """The box of an agent or object at the time of a frame; None: not present any more."""
    actor = instance.actor
    size = (actor.length, actor.width, actor.height)
    if instance.number in frame.bodies:
        body = frame.bodies[instance.number]
        if body is None:
            return None
        place = body.place + 0.5 * actor.height * body.axes[:, 2]
        return SolidBox(place, body.axes, size)
    cos, sin = math.cos(actor.heading), math.sin(actor.heading)
    axes = np.array([[cos, -sin, 0.0], [sin, cos, 0.0], [0.0, 0.0, 1.0]])
    return SolidBox(np.array([actor.x, actor.y, 0.5 * actor.height]), axes, size)


def projected_box(solid: SolidBox, frame: CameraFrame) -> Rectangle | None:
    """The extent of what of a box is ahead of the camera's plane; None: nothing is."""
    corners = solid.seen_from(frame.pose).corners
    points = [corner for corner in corners if corner[2] >= NEAREST]
    for i, j in _EDGES:
        a, b = corners[i], corners[j]
        if (a[2] < NEAREST) != (b[2] < NEAREST):
            points.append(a + (b - a) * (NEAREST - a[2]) / (b[2] - a[2]))
    if not points:
        return None
    pixels = np.array(points) @ frame.camera.matrix().T
    pixels = pixels[:, :2] / pixels[:, 2:]
    (left, top), (right, bottom) = pixels.min(axis=0), pixels.max(axis=0)
    return float(left), float(top), float(right), float(bottom)


def _pixel_extents(numbers: NDArray[np.uint16]) -> dict[int, tuple[Rectangle, int]]:
    """The extent and the count of the pixels of each number but 0."""
    rows, columns = np.nonzero(numbers)
    found = numbers[rows, columns]
    order = np.argsort(found, kind="stable")
    found, rows, columns = found[order], rows[order], columns[order]
    values, starts = np.unique(found, return_index=True)
    ends = np.append(starts, len(found))[1:]
    out = {}
    for value, start, end in zip(values.tolist(), starts.tolist(), ends.tolist(), strict=True):
        x, y = columns[start:end], rows[start:end]
        box = (float(x.min()), float(y.min()), float(x.max() + 1), float(y.max() + 1))
        out[value] = (box, end - start)
    return out


def _clipped(box: Rectangle, camera: MountedCamera) -> Rectangle | None:
    """The part of a rectangle that is in the picture."""
    left, top = max(box[0], 0.0), max(box[1], 0.0)
    right, bottom = min(box[2], float(camera.width)), min(box[3], float(camera.height))
    return (left, top, right, bottom) if left < right and top < bottom else None


def _area(box: Rectangle) -> float:
    return (box[2] - box[0]) * (box[3] - box[1])


def _occlusion(solid: SolidBox, frame: CameraFrame, number: int, within: Rectangle) -> float:
    """Of the pixels whose rays meet a box, the share that shows something else before it."""
    assert frame.depth is not None
    assert frame.instance is not None
    left, top = math.floor(within[0]), math.floor(within[1])
    right, bottom = math.ceil(within[2]), math.ceil(within[3])
    columns: Floats = np.arange(left, right, dtype=np.float64) + 0.5
    in_camera, hidden, met = solid.seen_from(frame.pose), 0, 0
    for first in range(top, bottom, _ROWS):
        last = min(first + _ROWS, bottom)
        rows: Floats = np.arange(first, last, dtype=np.float64) + 0.5
        entry = _entry_depth(in_camera, frame.camera, columns, rows)
        region = (slice(first, last), slice(left, right))
        nearer = (frame.depth[region] < entry - _SKIN) & (frame.instance[region] != number)
        met += int(np.isfinite(entry).sum())
        hidden += int(nearer.sum())
    return hidden / max(1, met)


def _entry_depth(solid: SolidBox, camera: MountedCamera, columns: Floats, rows: Floats) -> Floats:
    """(rows, columns) depths at which rays enter a box in camera coordinates; NaN: they miss it.

    The slab method: Kay and Kajiya, Ray tracing complex scenes, 1986.
    """
    f = camera.focal_length
    rays = np.ones((len(rows), len(columns), 3))
    rays[..., 0] = (columns - 0.5 * camera.width) / f
    rays[..., 1] = (rows[:, None] - 0.5 * camera.height) / f
    rays, origin = rays @ solid.axes, -solid.place @ solid.axes
    half = 0.5 * np.array(solid.size)
    with np.errstate(divide="ignore", invalid="ignore"):
        first, second = (-half - origin) / rays, (half - origin) / rays
    entry = np.fmin(first, second).max(axis=-1)
    leave = np.fmax(first, second).min(axis=-1)
    return np.where((entry <= leave) & (leave > 0.0), np.maximum(entry, 0.0), np.nan)
