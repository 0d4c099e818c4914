"""Boxes, cylinders and cones of meshes: x forward, y to the left, z up, meters."""

from __future__ import annotations

import numpy as np

from roadlang.geometry import Floats

from .meshes import Faces

_SIDES = 12
"""Of a cylinder: a multiple of four, so that it is exactly as wide as it says."""
_FACES = (
    # axis of the normal, its direction, and the axes that span the face
    (0, 1, 1, 2),
    (0, -1, 2, 1),
    (1, 1, 2, 0),
    (1, -1, 0, 2),
    (2, 1, 0, 1),
    (2, -1, 1, 0),
)
_QUAD = np.array([[0, 1, 2], [0, 2, 3]])


def box(material: str, low: tuple[float, float, float], high: tuple[float, float, float]) -> Faces:
    """With flat faces, between two corners."""
    corners = np.array([low, high], dtype=float)
    points, normals = [], []
    for axis, sign, first, second in _FACES:
        for u, v in ((0, 0), (1, 0), (1, 1), (0, 1)):
            point = np.empty(3)
            point[axis] = corners[(sign + 1) // 2, axis]
            point[first], point[second] = corners[u, first], corners[v, second]
            points.append(point)
            normals.append(np.eye(3)[axis] * sign)
    triangles = np.concatenate([_QUAD + 4 * face for face in range(6)])
    return Faces(material, np.array(points), np.array(normals), triangles)


def tapered(
    material: str,
    radii: tuple[float, float],
    heights: tuple[float, float],
    stretch: tuple[float, float] = (1.0, 1.0),
) -> Faces:
    """A cylinder or cone that stands: its radii and heights below and above. `stretch`: factors
    along x and y."""
    turn = 2.0 * np.pi * np.arange(_SIDES) / _SIDES
    ring = np.round(np.column_stack((np.cos(turn), np.sin(turn))), 12)
    (below, above), (low, high) = radii, heights
    walls, ends = [], []
    tilt = (below - above) / (high - low)
    normals = np.column_stack((ring / stretch, np.full(_SIDES, tilt)))
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    for radius, height in ((below, low), (above, high)):
        points = np.column_stack((radius * ring * stretch, np.full(_SIDES, height)))
        walls.append(points)
        ends.append(points)
    at = np.arange(_SIDES)
    after = (at + 1) % _SIDES
    sides = np.concatenate((
        np.column_stack((at, after, at + _SIDES)),
        np.column_stack((after, after + _SIDES, at + _SIDES)),
    ))  # fmt: skip
    fan = np.column_stack((np.zeros(_SIDES - 2, int), at[1:-1], at[2:]))
    triangles = [sides, 2 * _SIDES + fan[:, ::-1], 3 * _SIDES + fan]
    up = np.tile([0.0, 0.0, 1.0], (_SIDES, 1))
    return _with_area(
        material,
        np.concatenate((*walls, *ends)),
        np.concatenate((normals, normals, -up, up)),
        np.concatenate(triangles),
    )


def wheel(material: str, x: float, y: tuple[float, float], radius: float) -> Faces:
    """On the ground, with its axle from side to side."""
    part = tapered(material, (radius, radius), (0.0, y[1] - y[0]))
    # The axis z becomes y, y becomes x, and x becomes z: a rotation.
    points, normals = (np.roll(rows, -1, axis=1) for rows in (part.points, part.normals))
    return Faces(material, points + np.array([x, y[0], radius]), normals, part.triangles)


def _with_area(material: str, points: Floats, normals: Floats, triangles: np.ndarray) -> Faces:
    a, b, c = (points[triangles[:, corner]] for corner in range(3))
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    return Faces(material, points, normals, triangles[area > 1e-12])
