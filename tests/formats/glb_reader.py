"""Binary glTF, read by the standard alone: nodes with the triangles of their meshes."""

from __future__ import annotations

import json
import struct
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

_TYPES = {5123: "<u2", 5125: "<u4", 5126: "<f4"}
_COUNTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}


@dataclass(frozen=True)
class ReadGlb:
    """A file: its JSON part and its binary part."""

    document: dict[str, Any]
    blob: bytes

    @classmethod
    def of(cls, content: bytes) -> ReadGlb:
        magic, version, length = struct.unpack_from("<4sII", content)
        assert (magic, version, length) == (b"glTF", 2, len(content))
        chunks = {}
        at = 12
        while at < len(content):
            size, kind = struct.unpack_from("<I4s", content, at)
            assert size % 4 == 0
            chunks[kind] = content[at + 8 : at + 8 + size]
            at += 8 + size
        assert list(chunks) == [b"JSON", b"BIN\0"]
        return cls(json.loads(chunks[b"JSON"]), chunks[b"BIN\0"])

    def values(self, accessor: int) -> NDArray[Any]:
        """(n, components) of an accessor, whose bounds are checked."""
        found = self.document["accessors"][accessor]
        view = self.document["bufferViews"][found["bufferView"]]
        kind, columns = np.dtype(_TYPES[found["componentType"]]), _COUNTS[found["type"]]
        assert view["byteLength"] == found["count"] * columns * kind.itemsize
        assert view["byteOffset"] % 4 == 0
        assert view["byteOffset"] + view["byteLength"] <= len(self.blob)
        values = np.frombuffer(self.blob, kind, found["count"] * columns, view["byteOffset"])
        table = values.reshape(-1, columns)
        assert np.isfinite(table.astype(float)).all()
        if "min" in found:
            assert table.min(axis=0).tolist() == found["min"]
            assert table.max(axis=0).tolist() == found["max"]
        return table

    @property
    def nodes(self) -> dict[str, dict[str, Any]]:
        """By name; names are unique."""
        nodes: list[dict[str, Any]] = self.document["nodes"]
        assert len({node["name"] for node in nodes}) == len(nodes)
        return {node["name"]: node for node in nodes}

    def triangles(self, name: str) -> NDArray[np.float64]:
        """(t, 3, 3) corners of a node, x east, y north and z up. Only agents, objects and signals
        are turned, about the vertical."""
        node = self.nodes[name]
        x, y, z, w = node.get("rotation", (0.0, 0.0, 0.0, 1.0))
        assert x == z == 0.0
        cos, sin = w * w - y * y, 2.0 * w * y
        turn = np.array([[cos, 0.0, sin], [0.0, 1.0, 0.0], [-sin, 0.0, cos]])
        found = []
        for primitive in self.document["meshes"][node["mesh"]]["primitives"]:
            points = self.values(primitive["attributes"]["POSITION"]).astype(float)
            normals = self.values(primitive["attributes"]["NORMAL"])
            np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1.0, atol=1e-5)
            indices = self.values(primitive["indices"]).reshape(-1, 3).astype(int)
            assert indices.max() < len(points)
            corners = points[indices]
            front = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
            # Every face looks where its normals say that it does.
            assert ((front * normals[indices].mean(axis=1)).sum(axis=1) > 0.0).all()
            found.append(corners @ turn.T + node.get("translation", (0.0, 0.0, 0.0)))
        east, up, south = np.moveaxis(np.concatenate(found), -1, 0)
        return np.stack((east, -south, up), axis=-1)
