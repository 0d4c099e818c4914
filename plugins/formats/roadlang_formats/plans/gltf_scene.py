"""Binary glTF from above: triangles that face up, from the lowest mesh to the highest."""

from __future__ import annotations

import json
import struct
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from roadlang.api import read_input
from roadlang.geometry import Floats

from ..gltf.materials import srgb
from ..map_xml import LARGEST, fault_at
from .shapes import MOST_COORDINATE, PlanShape, hex_color

_INTEGERS = {5121: "<u1", 5123: "<u2", 5125: "<u4"}
_FLOAT, _TRIANGLES = 5126, 4
_DEEPEST = 60
_FLATTEST = 0.05
"""Vertical part of the normal from which on a triangle is seen from above."""


def shapes(path: Path) -> Iterator[PlanShape]:
    """Raises RL479 where the file is damaged. The ground is left out: a drawing has its own."""
    content = read_input(path, LARGEST)
    try:
        found = sorted(_Glb.of(content).meshes(), key=lambda mesh: mesh.height)
    except (
        ArithmeticError,
        AttributeError,
        LookupError,
        TypeError,
        ValueError,
        struct.error,
    ) as error:
        reason = f"it is not a valid binary glTF file: {type(error).__name__}: {error}"
        raise fault_at(path, "", 0, reason) from None
    for mesh in found:
        yield PlanShape(tuple(mesh.triangles), mesh.color, label=mesh.name)


@dataclass(frozen=True)
class _Mesh:
    """(t, 3, 2) triangles that face up, and their mean height, meters."""

    name: str
    triangles: Floats
    height: float
    color: str


@dataclass(frozen=True)
class _Glb:
    """The JSON and the binary part of a file."""

    document: dict[str, Any]
    blob: bytes

    @classmethod
    def of(cls, content: bytes) -> _Glb:
        magic, version, length = struct.unpack_from("<4sII", content)
        if (magic, version, length) != (b"glTF", 2, len(content)):
            raise ValueError("its header is not that of binary glTF 2.0")
        chunks, at = [], 12
        while at < length:
            size, kind = struct.unpack_from("<I4s", content, at)
            chunks.append((kind, content[at + 8 : at + 8 + size]))
            at += 8 + size
        (kind, text), *rest = chunks
        if kind != b"JSON":
            raise ValueError("its first chunk is not JSON")
        return cls(json.loads(text), rest[0][1] if rest else b"")

    def meshes(self) -> Iterator[_Mesh]:
        scene = self.document["scenes"][self.document.get("scene", 0)]
        for root in scene["nodes"]:
            yield from self._below(root, np.eye(4), 0)

    def _below(self, index: int, outer: Floats, depth: int) -> Iterator[_Mesh]:
        if depth > _DEEPEST:
            raise ValueError("its nodes are nested too deeply")
        node = self.document["nodes"][index]
        matrix = outer @ _matrix(node)
        if "mesh" in node and node.get("extras", {}).get("part") != "ground":
            for primitive in self.document["meshes"][node["mesh"]]["primitives"]:
                mesh = self._mesh(str(node.get("name", "")), primitive, matrix)
                if mesh is not None:
                    yield mesh
        for child in node.get("children", ()):
            yield from self._below(child, matrix, depth + 1)

    def _mesh(self, name: str, primitive: dict[str, Any], matrix: Floats) -> _Mesh | None:
        if primitive.get("mode", _TRIANGLES) != _TRIANGLES:
            return None
        local = self._values(primitive["attributes"]["POSITION"], 3)
        points = local @ matrix[:3, :3].T + matrix[:3, 3]
        if not (np.abs(points) <= MOST_COORDINATE).all():
            raise ValueError("its coordinates are not finite")
        rows = np.arange(len(points))
        if "indices" in primitive:
            rows = self._values(primitive["indices"], 1)[:, 0].astype(np.intp)
        corners = points[rows[: len(rows) // 3 * 3]].reshape(-1, 3, 3)
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        up = normals[:, 1] > _FLATTEST * np.linalg.norm(normals, axis=1)
        if not up.any():
            return None
        seen = corners[up]
        plan = np.stack((seen[..., 0], -seen[..., 2]), axis=-1)
        return _Mesh(name, plan, float(seen[..., 1].mean()), self._color(primitive))

    def _values(self, index: int, columns: int) -> Floats:
        """(n, columns) of an accessor."""
        accessor = self.document["accessors"][index]
        view = self.document["bufferViews"][accessor["bufferView"]]
        kind = np.dtype(
            "<f4" if accessor["componentType"] == _FLOAT else _INTEGERS[accessor["componentType"]]
        )
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        stride = view.get("byteStride", columns * kind.itemsize)
        shape, strides = (accessor["count"], columns), (stride, kind.itemsize)
        table = np.ndarray(shape, kind, self.blob, start, strides)
        return table.astype(float)

    def _color(self, primitive: dict[str, Any]) -> str:
        """In sRGB; glTF states components in linear light."""
        materials = self.document.get("materials", [])
        material = materials[primitive["material"]] if "material" in primitive else {}
        factor = material.get("pbrMetallicRoughness", {}).get("baseColorFactor", (0.5, 0.5, 0.5))
        linear = np.clip(np.array(factor[:3], dtype=float), 0.0, 1.0)
        return hex_color([srgb(component) for component in linear.tolist()])


def _matrix(node: dict[str, Any]) -> Floats:
    """(4, 4) of a node in its parent."""
    if "matrix" in node:
        return np.array(node["matrix"], dtype=float).reshape(4, 4).T
    x, y, z, w = node.get("rotation", (0.0, 0.0, 0.0, 1.0))
    turn = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
    found = np.eye(4)
    found[:3, :3] = turn * np.array(node.get("scale", (1.0, 1.0, 1.0)), dtype=float)
    found[:3, 3] = node.get("translation", (0.0, 0.0, 0.0))
    return found
