"""Triangles by material, in the axes of glTF: x east, y up, z south, meters."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from roadlang.geometry import Floats, Integers

_FLAT = 1e-9
"""Square meters of a triangle that is left out."""


@dataclass(frozen=True, eq=False)
class Faces:
    """Triangles of one material: points (n, 3) and unit normals (n, 3), x east, y north and z up;
    `triangles` (t, 3) run counter-clockwise seen from the front. `uv` (n, 2) in meters."""

    material: str
    points: Floats
    normals: Floats
    triangles: Integers
    uv: Floats | None = None


def strip(
    material: str, left: Floats, right: Floats, normals: Floats, along: Floats | None = None
) -> Faces | None:
    """The quads between two lines (n, 3); who looks at the front along the lines has `left` on the
    left. `normals` (n, 3), or (3,) for all. None where there is no area."""
    count = len(left)
    points = np.stack((left, right), axis=1).reshape(-1, 3)
    first = 2 * np.arange(count - 1)[:, None, None]
    triangles = (first + np.array([[0, 1, 2], [2, 1, 3]])).reshape(-1, 3)
    a, b, c = (points[triangles[:, corner]] for corner in range(3))
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    triangles = triangles[area > _FLAT]
    if not len(triangles):
        return None
    normals = np.repeat(np.broadcast_to(normals, (count, 3)), 2, axis=0)
    uv = None
    if along is not None:
        width = np.linalg.norm(left - right, axis=1)
        across = np.stack((np.zeros(count), width), axis=1).reshape(-1)
        uv = np.column_stack((across, np.repeat(along, 2)))
    return Faces(material, points, normals, triangles, uv)


def joined(parts: Iterable[Faces | None]) -> tuple[Faces, ...]:
    """One part for each material, in the order in which they first come."""
    groups: dict[tuple[str, bool], list[Faces]] = {}
    for part in parts:
        if part is not None and len(part.triangles):
            groups.setdefault((part.material, part.uv is None), []).append(part)
    return tuple(_joined(group) for group in groups.values())


def moved(part: Faces, by: Floats) -> Faces:
    """The same part elsewhere."""
    points = part.points + by
    return Faces(part.material, points, part.normals, part.triangles, part.uv)


def _joined(parts: Sequence[Faces]) -> Faces:
    if len(parts) == 1:
        return parts[0]
    first = np.cumsum([0, *(len(part.points) for part in parts[:-1])])
    uvs = [part.uv for part in parts if part.uv is not None]
    return Faces(
        parts[0].material,
        np.concatenate([part.points for part in parts]),
        np.concatenate([part.normals for part in parts]),
        np.concatenate([part.triangles + at for part, at in zip(parts, first, strict=True)]),
        np.concatenate(uvs) if uvs else None,
    )
