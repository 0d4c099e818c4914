"""Models of MuJoCo from above: boxes, and meshes whose vertices are in the file."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from roadlang.geometry import Floats

from ..map_xml import MapElement, MapFile
from .shapes import PlanShape, Pose, hex_color, numbers, placed, rectangle

_GRAY = (0.5, 0.5, 0.5)


def shapes(file: MapFile) -> Iterator[PlanShape]:
    """In the order of the file."""
    compiler = file.root.first("compiler")
    radians = compiler is not None and compiler.attributes.get("angle") == "radian"
    meshes = {
        file.attribute(mesh, "name"): numbers(file, mesh, "vertex")
        for mesh in file.root.all("asset", "mesh")
        if "vertex" in mesh.attributes and "name" in mesh.attributes
    }
    unit = 1.0 if radians else math.pi / 180.0
    for world in file.root.all("worldbody"):
        yield from _Bodies(file, meshes, unit).shapes(world, (0.0, 0.0, 0.0))


class _Bodies:
    """What belongs to bodies, and to those in them."""

    def __init__(self, file: MapFile, meshes: Mapping[str, Floats], unit: float) -> None:
        self._file, self._meshes, self._unit = file, meshes, unit

    def shapes(self, body: MapElement, at: Pose) -> Iterator[PlanShape]:
        """Of a body at this pose."""
        for geom in body.all("geom"):
            outline = self._outline(geom, self._pose(geom, at))
            if outline is not None:
                color = numbers(self._file, geom, "rgba", "0.5 0.5 0.5 1")
                yield PlanShape(
                    (outline,),
                    hex_color(color[:3] if len(color) >= 3 else _GRAY),
                    label=geom.attributes.get("name", ""),
                )
        for child in body.all("body"):
            yield from self.shapes(child, self._pose(child, at))

    def _outline(self, geom: MapElement, pose: Pose) -> Floats | None:
        x, y, heading = pose
        if geom.attributes.get("type") == "box":
            size = numbers(self._file, geom, "size")
            if len(size) < 2:
                raise self._file.fault(geom, "a box has three sizes")
            return rectangle(x, y, heading, 2.0 * float(size[0]), 2.0 * float(size[1]))
        found = self._meshes.get(geom.attributes.get("mesh", ""))
        if found is None or len(found) < 9 or len(found) % 3:
            return None
        hull = _hull(found.reshape(-1, 3)[:, :2])
        return None if hull is None else placed(hull, pose)

    def _pose(self, element: MapElement, parent: Pose) -> Pose:
        """x, y and heading; other rotations than about the vertical are ignored."""
        at = numbers(self._file, element, "pos", "0 0 0")
        euler = numbers(self._file, element, "euler", "0 0 0")
        if len(at) != 3 or len(euler) != 3:
            raise self._file.fault(element, "`pos` and `euler` have three numbers")
        turn = float(euler[2]) * self._unit
        if "quat" in element.attributes:
            quat = numbers(self._file, element, "quat")
            if len(quat) != 4:
                raise self._file.fault(element, "`quat` has four numbers")
            w, i, j, k = quat.tolist()
            turn = math.atan2(2.0 * (w * k + i * j), 1.0 - 2.0 * (j * j + k * k))
        x, y = placed(at[:2], parent).tolist()
        return x, y, parent[2] + turn


def _hull(points: Floats) -> Floats | None:
    """The convex outline of (n, 2) points; None where they are on a line."""
    from scipy.spatial import ConvexHull, QhullError

    try:
        found: Floats = points[ConvexHull(points).vertices]
    except QhullError:
        return None
    return found
