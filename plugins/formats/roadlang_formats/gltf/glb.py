"""Binary glTF 2.0 (Khronos Group, ISO/IEC 12113): nodes with meshes in one file."""

from __future__ import annotations

import json
import math
import struct
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Floats

from .materials import Material
from .meshes import Faces

_FLOAT, _U16, _U32 = 5126, 5123, 5125
_VERTICES, _INDICES = 34962, 34963
_JSON, _BIN = 0x4E4F534A, 0x004E4942


class GlbWriter:
    """Collects nodes, and the meshes, materials and animations that they share."""

    def __init__(self, generator: str) -> None:
        self._generator = generator
        self._blob = bytearray()
        self._tables: dict[str, list[dict[str, Any]]] = {
            name: []
            for name in ("nodes", "meshes", "materials", "accessors", "bufferViews", "animations")
        }
        self._materials: dict[Material, int] = {}
        self._roots: list[int] = []

    def mesh(self, name: str, parts: Sequence[Faces], materials: Mapping[str, Material]) -> int:
        """A mesh of at least one part. The same mesh may be that of many nodes."""
        primitives = [self._primitive(part, materials[part.material]) for part in parts]
        return self._add("meshes", {"name": name, "primitives": primitives})

    def node(
        self,
        name: str,
        *,
        mesh: int | None = None,
        at: Sequence[float] = (0.0, 0.0, 0.0),
        heading: float = 0.0,
        children: Sequence[int] = (),
        extras: Mapping[str, Any] | None = None,
    ) -> int:
        """A node at a place (x east, y north, z up), turned counter-clockwise by a heading."""
        found: dict[str, Any] = {"name": name}
        if mesh is not None:
            found["mesh"] = mesh
        if any(at):
            found["translation"] = [float(value) + 0.0 for value in to_axes(np.asarray(at))]
        if heading:
            found["rotation"] = turned(np.array([heading]))[0].tolist()
        if children:
            found["children"] = list(children)
        if extras:
            found["extras"] = dict(extras)
        return self._add("nodes", found)

    def name(self, node: int) -> str:
        """Of a node."""
        return str(self._tables["nodes"][node]["name"])

    def root(self, node: int) -> None:
        """Makes a node a root of the scene."""
        self._roots.append(node)

    def animation(
        self, name: str, times: Floats, poses: Mapping[int, tuple[Floats, Floats]]
    ) -> None:
        """Places (t, 3) and headings (t,) of nodes at times (t,), increasing seconds."""
        clock = self._accessor(times.astype("<f4")[:, None], "SCALAR", bounds=True)
        samplers: list[dict[str, Any]] = []
        channels: list[dict[str, Any]] = []
        for node, (places, headings) in poses.items():
            for path, values in (
                ("translation", to_axes(places)),
                ("rotation", turned(headings)),
            ):
                kind = "VEC3" if path == "translation" else "VEC4"
                output = self._accessor(values.astype("<f4"), kind)
                target = {"node": node, "path": path}
                channels.append({"sampler": len(samplers), "target": target})
                samplers.append({"input": clock, "output": output, "interpolation": "LINEAR"})
        if channels:
            self._add("animations", {"name": name, "channels": channels, "samplers": samplers})

    def content(self, extras: Mapping[str, Any] | None = None) -> bytes:
        """The file."""
        document: dict[str, Any] = {"asset": {"version": "2.0", "generator": self._generator}}
        if extras:
            document["asset"]["extras"] = dict(extras)
        document |= {"scene": 0, "scenes": [{"nodes": self._roots}]}
        document |= {name: rows for name, rows in self._tables.items() if rows}
        if self._blob:
            document["buffers"] = [{"byteLength": len(self._blob)}]
        text = json.dumps(document, separators=(",", ":"), allow_nan=False).encode()
        chunks = _chunk(_JSON, text, b" ")
        if self._blob:
            chunks += _chunk(_BIN, bytes(self._blob), b"\0")
        return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks

    def _primitive(self, part: Faces, material: Material) -> dict[str, Any]:
        attributes = {
            "POSITION": self._accessor(
                to_axes(part.points).astype("<f4"), "VEC3", _VERTICES, bounds=True
            ),
            "NORMAL": self._accessor(to_axes(part.normals).astype("<f4"), "VEC3", _VERTICES),
        }
        if part.uv is not None:
            attributes["TEXCOORD_0"] = self._accessor(part.uv.astype("<f4"), "VEC2", _VERTICES)
        indices = part.triangles.reshape(-1, 1)
        small = len(part.points) < 2**16 - 1
        return {
            "attributes": attributes,
            "indices": self._accessor(
                indices.astype("<u2" if small else "<u4"), "SCALAR", _INDICES
            ),
            "material": self._material(material),
        }

    def _material(self, material: Material) -> int:
        if material not in self._materials:
            self._materials[material] = self._add("materials", material.record())
        return self._materials[material]

    def _accessor(
        self, values: NDArray[Any], kind: str, target: int | None = None, bounds: bool = False
    ) -> int:
        """`values` (n, components)."""
        self._blob += b"\0" * (-len(self._blob) % 4)
        view = {"buffer": 0, "byteOffset": len(self._blob), "byteLength": values.nbytes}
        if target is not None:
            view["target"] = target
        self._blob += values.tobytes()
        component = {"f": _FLOAT}.get(values.dtype.kind, _U16 if values.itemsize == 2 else _U32)
        found: dict[str, Any] = {
            "bufferView": self._add("bufferViews", view),
            "componentType": component,
            "count": len(values),
            "type": kind,
        }
        if bounds:
            found["min"] = values.min(axis=0).tolist()
            found["max"] = values.max(axis=0).tolist()
        return self._add("accessors", found)

    def _add(self, table: str, record: dict[str, Any]) -> int:
        self._tables[table].append(record)
        return len(self._tables[table]) - 1


def to_axes(values: Floats) -> Floats:
    """(..., 3) from x east, y north, z up to x east, y up, z south."""
    return np.stack((values[..., 0], values[..., 2], -values[..., 1]), axis=-1) + 0.0


def turned(headings: Floats) -> Floats:
    """(n, 4) quaternions of headings (n,), each on the side of the one before it, so that
    in between the shorter turn is taken."""
    half = np.unwrap(headings) / 2.0
    half -= 2.0 * math.pi * np.round(half[0] / (2.0 * math.pi))
    zero = np.zeros_like(half)
    return np.stack((zero, np.sin(half), zero, np.cos(half)), axis=-1)


def _chunk(kind: int, content: bytes, filler: bytes) -> bytes:
    content += filler * (-len(content) % 4)
    return struct.pack("<II", len(content), kind) + content
