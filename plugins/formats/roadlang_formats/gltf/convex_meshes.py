"""Convex meshes that Unreal Engine takes for the collision of another: `UCX_NAME_00`."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from roadlang.geometry import Floats

from .glb import GlbWriter
from .materials import MATERIALS
from .meshes import Faces, moved
from .solids import box

_MATERIAL = "asphalt"


def put_prisms(writer: GlbWriter, name: str, prisms: Iterable[Floats], at: Floats) -> list[int]:
    """Nodes for prisms (2 k, 3), each its top and then its bottom, of the mesh of this name, whose
    node is at `at`."""
    return [
        _put(writer, name, number, moved(prism_faces(corners), -at), at.tolist(), 0.0)
        for number, corners in enumerate(prisms)
    ]


def put_box(
    writer: GlbWriter,
    name: str,
    size: tuple[float, float, float],
    at: tuple[float, float, float],
    heading: float,
) -> int:
    """The node for a box of a length, width and height that stands at `at`."""
    length, width, height = size
    corner = (length / 2.0, width / 2.0, height)
    faces = box(_MATERIAL, (-length / 2.0, -width / 2.0, 0.0), corner)
    return _put(writer, name, 0, faces, list(at), heading)


def prism_faces(corners: Floats) -> Faces:
    """The flat faces of a prism (2 k, 3): its top, counter-clockwise, and then its bottom."""
    count = len(corners) // 2
    top, bottom = corners[:count], corners[count:]
    polygons = [top, bottom[::-1]]
    for at in range(count):
        after = (at + 1) % count
        polygons.append(np.stack((top[after], top[at], bottom[at], bottom[after])))
    points, normals, triangles = [], [], []
    first = 0
    for polygon in polygons:
        fan = [(first, first + k, first + k + 1) for k in range(1, len(polygon) - 1)]
        normal = sum(
            np.cross(polygon[k] - polygon[0], polygon[k + 1] - polygon[0])
            for k in range(1, len(polygon) - 1)
        )
        length = float(np.linalg.norm(normal))
        if length < 1e-9:
            continue
        points.append(polygon)
        normals.append(np.tile(normal / length, (len(polygon), 1)))
        triangles += fan
        first += len(polygon)
    return Faces(_MATERIAL, np.concatenate(points), np.concatenate(normals), np.array(triangles))


def _put(
    writer: GlbWriter, name: str, number: int, faces: Faces, at: list[float], heading: float
) -> int:
    label = f"UCX_{name}_{number:02d}"
    mesh = writer.mesh(label, [faces], MATERIALS)
    return writer.node(label, mesh=mesh, at=at, heading=heading, extras={"collision": "convex"})
