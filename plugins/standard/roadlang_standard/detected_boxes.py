"""Boxes in the view of a camera: projected, and looked at by rays. Arrays are (N agents, K things).

Only elementwise arithmetic and sums over axes of fixed length: an agent gives the same bytes alone
and among others.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .semantic_classes import class_of_category

if TYPE_CHECKING:
    from roadlang.api import SensedBatch, SolidThings

Floats = NDArray[np.float64]
NEAREST = 0.1
"""Meters from the plane of a camera, before which nothing is seen."""
_SIGNS = np.array([[x, y, z] for x in (1, -1) for y in (1, -1) for z in (1, -1)], dtype=float)
_EDGES = np.array([(i, j) for i in range(8) for j in range(i)
                   if np.abs(_SIGNS[i] - _SIGNS[j]).sum() == 2])  # fmt: skip
_LOOKED_AT = np.concatenate([np.zeros((1, 3)), 0.9 * _SIGNS])
"""Points of a box, of its half sizes from its center, to which rays are cast."""
_SKIN = 0.05
"""Meters: a ray that ends this near to a box has met it."""
_FARTHER = 200.0
"""Meters: the far side of a box whose center is in range."""
_NOWHERE = 1e6


@dataclass(frozen=True, slots=True)
class BoxCamera:
    """Where the cameras of N agents are, and what they cover. Columns (N,), `at` (N, 3)."""

    width: Floats
    height: Floats
    fov: Floats
    at: Floats
    yaw: Floats
    pitch: Floats
    range: Floats

    @classmethod
    def of(cls, count: int, *values: ArrayLike) -> BoxCamera:
        """Of columns, or of numbers that are the same for all."""
        shapes = ((count, 3) if field.name == "at" else (count,) for field in fields(cls))
        arrays = (np.broadcast_to(np.asarray(value, dtype=np.float64), shape)
                  for value, shape in zip(values, shapes, strict=True))  # fmt: skip
        return cls(*arrays)

    def coordinates(self, points: Floats) -> Floats:
        """(N, ..., 3) to the right, down and forward, of points ahead, left and up of agents."""
        extra = (slice(None),) + (None,) * (points.ndim - 2)
        ahead, left, up = np.moveaxis(points - self.at[(*extra, slice(None))], -1, 0)
        cos_yaw, sin_yaw = np.cos(self.yaw)[extra], np.sin(self.yaw)[extra]
        cos_pitch, sin_pitch = np.cos(self.pitch)[extra], np.sin(self.pitch)[extra]
        onward = cos_yaw * ahead + sin_yaw * left
        right = sin_yaw * ahead - cos_yaw * left
        return np.stack(
            [right, sin_pitch * onward - cos_pitch * up, cos_pitch * onward + sin_pitch * up], -1
        )

    def rectangles(self, corners: Floats) -> Floats:
        """(N, K, 4) left, top, right and bottom in the picture of boxes with corners (N, K, 8, 3);
        of those that are not in it, right is not more than left."""
        seen = self.coordinates(corners)
        first, second = seen[:, :, _EDGES[:, 0]], seen[:, :, _EDGES[:, 1]]
        crosses = (first[..., 2] < NEAREST) != (second[..., 2] < NEAREST)
        rise = np.where(crosses, second[..., 2] - first[..., 2], 1.0)
        share = ((NEAREST - first[..., 2]) / rise)[..., None]
        points = np.concatenate([seen, first + (second - first) * share], axis=2)
        counts = np.concatenate([seen[..., 2] >= NEAREST, crosses], axis=2)
        depth = np.where(counts, points[..., 2], 1.0)
        focal = (0.5 * self.width / np.tan(0.5 * self.fov))[:, None, None]
        x = 0.5 * self.width[:, None, None] + focal * points[..., 0] / depth
        y = 0.5 * self.height[:, None, None] + focal * points[..., 1] / depth
        low = [np.where(counts, value, math.inf).min(axis=2) for value in (x, y)]
        high = [np.where(counts, value, -math.inf).max(axis=2) for value in (x, y)]
        size = [self.width[:, None], self.height[:, None]]
        begin = [np.minimum(np.maximum(v, 0.0), most) for v, most in zip(low, size, strict=True)]
        end = [np.maximum(np.minimum(v, most), 0.0) for v, most in zip(high, size, strict=True)]
        return np.stack([*begin, *end], axis=-1)


def detected(
    camera: BoxCamera, sensed: SensedBatch, most: int, noise: ArrayLike, missed: ArrayLike
) -> dict[str, NDArray[Any]]:
    """The arrays of a reading of `sense with boxes`: the `most` nearest things of N agents that are
    in the picture and not wholly hidden."""
    things = sensed.things()
    found = things.there
    lost = sensed.random.uniform(found.shape[1], stream=1) < np.asarray(missed)[..., None]
    center, heading, corners = _as_seen(things, sensed)
    box = camera.rectangles(corners)
    off = center - camera.at[:, None]
    distance = np.sqrt(off[..., 0] ** 2 + off[..., 1] ** 2 + off[..., 2] ** 2)
    found = found & (box[..., 2] > box[..., 0]) & (box[..., 3] > box[..., 1])
    found &= (distance <= camera.range[:, None]) & ~lost
    size = np.stack([things.length, things.width, things.height], axis=-1)
    columns: dict[str, NDArray[Any]] = {
        "center": center, "size": size, "heading": heading, "box": box,
        "class_id": _classes(things),
    }  # fmt: skip
    # What is not in the picture needs no rays.
    order = _by_distance(distance, found, int(found.sum(axis=1).max(initial=0)))
    columns = {name: _taken(column, order) for name, column in columns.items()}
    distance, found = _taken(distance, order), _taken(found, order)
    columns["visible"] = _visible_shares(columns, found, camera, sensed)
    found &= columns["visible"] > 0.0
    order = _by_distance(distance, found, most)
    out = {name: _filled(_taken(column, order), _taken(found, order), most)
           for name, column in columns.items()}  # fmt: skip
    errors = np.asarray(noise)[..., None, None] * sensed.random.normal(3 * most).reshape(
        -1, most, 3
    )
    out["center"] = np.where(out["class_id"][..., None] > 0, out["center"] + errors, 0.0)
    return out


def _classes(things: SolidThings) -> NDArray[np.uint8]:
    words = {word: int(class_of_category(word)) for word in set(things.category.ravel().tolist())}
    classes = [[words[word] for word in row] for row in things.category.tolist()]
    return np.array(classes, dtype=np.uint8).reshape(things.category.shape)


def _by_distance(distance: Floats, found: NDArray[np.bool_], most: int) -> NDArray[np.intp]:
    """(N, at most `most`) the nearest that are found come first."""
    order = np.argsort(np.where(found, distance, math.inf), axis=1, kind="stable")
    return np.asarray(order[:, :most])


def _taken(column: NDArray[Any], order: NDArray[np.intp]) -> NDArray[Any]:
    return np.take_along_axis(column, order[(...,) + (None,) * (column.ndim - 2)], axis=1)


def _filled(column: NDArray[Any], found: NDArray[np.bool_], most: int) -> NDArray[Any]:
    """(N, most, ...) the rows of what was found; 0 for no more."""
    out = np.zeros((len(column), most, *column.shape[2:]), dtype=column.dtype)
    out[:, : column.shape[1]] = np.where(found[(...,) + (None,) * (column.ndim - 2)], column, 0)
    return out


def _as_seen(things: SolidThings, sensed: SensedBatch) -> tuple[Floats, Floats, Floats]:
    """In the coordinates of the agents, ahead, left and up: centers (N, K, 3), headings (N, K) and
    corners (N, K, 8, 3)."""
    seen = sensed.seen
    cosine, sine = np.cos(seen.heading)[:, None], np.sin(seen.heading)[:, None]
    off_x, off_y = things.x - seen.x[:, None], things.y - seen.y[:, None]
    ahead, left = cosine * off_x + sine * off_y, cosine * off_y - sine * off_x
    center = np.stack([ahead, left, 0.5 * things.height], axis=-1)
    turned = things.heading - seen.heading[:, None]
    heading = np.arctan2(np.sin(turned), np.cos(turned))
    size = np.stack([things.length, things.width, things.height], axis=-1)
    return center, heading, _points(center, heading, size, _SIGNS)


def _points(center: Floats, heading: Floats, size: Floats, shares: Floats) -> Floats:
    """(N, K, P, 3) points of boxes, given in shares (P, 3) of their half sizes."""
    ahead, left, up = np.moveaxis(0.5 * size[..., None, :] * shares, -1, 0)
    cosine, sine = np.cos(heading)[..., None], np.sin(heading)[..., None]
    offset = np.stack([cosine * ahead - sine * left, sine * ahead + cosine * left, up], axis=-1)
    return np.asarray(center[:, :, None] + offset)


def _visible_shares(
    columns: Mapping[str, NDArray[Any]],
    found: NDArray[np.bool_],
    camera: BoxCamera,
    sensed: SensedBatch,
) -> Floats:
    """(N, K) of the rays to points of each box, the share that ends at it."""
    center, heading, size = columns["center"], columns["heading"], columns["size"]
    off = _points(center, heading, size, _LOOKED_AT) - camera.at[:, None, None]
    level = np.sqrt(off[..., 0] ** 2 + off[..., 1] ** 2)
    angles, rises = np.arctan2(off[..., 1], off[..., 0]), np.arctan2(off[..., 2], level)
    if not found.size:
        return np.zeros(found.shape)
    rows = (len(found), -1)
    met = sensed.cast_rays(
        camera.at, angles.reshape(rows), rises.reshape(rows), camera.range + _FARTHER
    )
    distance = np.minimum(met.reshape(level.shape), _NOWHERE)[..., None]
    rays = np.stack([np.cos(angles) * np.cos(rises), np.sin(angles) * np.cos(rises),
                     np.sin(rises)], axis=-1)  # fmt: skip
    end = camera.at[:, None, None] + rays * distance - center[:, :, None]
    cosine, sine = np.cos(heading)[..., None], np.sin(heading)[..., None]
    along = cosine * end[..., 0] + sine * end[..., 1]
    across = cosine * end[..., 1] - sine * end[..., 0]
    inside = np.abs(np.stack([along, across, end[..., 2]], axis=-1))
    at_box = (inside <= 0.5 * size[:, :, None] + _SKIN).all(axis=-1)
    return np.where(found, at_box.mean(axis=2), 0.0)
