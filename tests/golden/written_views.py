"""What each format writes of a scene and of its drive, in lines: every element and number."""

from __future__ import annotations

import json
import re
import xml.etree.ElementTree as ET
from collections.abc import Iterator, Mapping

import cv2
import numpy as np

from roadlang import DiagnosticError
from roadlang.api import Backend, Scene, Trace
from roadlang_formats.emit_commonroad import CommonRoadBackend
from roadlang_formats.emit_geojson import GeoJsonBackend
from roadlang_formats.emit_gltf import GltfBackend
from roadlang_formats.emit_lanelet2 import Lanelet2Backend
from roadlang_formats.emit_mujoco import MujocoBackend
from roadlang_formats.emit_openscenario import OpenScenarioBackend
from roadlang_formats.emit_road_mask import RoadMaskBackend
from roadlang_formats.emit_scenic import ScenicBackend
from roadlang_formats.emit_sumo import SumoBackend
from tests.formats.glb_reader import ReadGlb
from tests.golden.scene_views import sampled
from tests.golden.summaries import array, of_json, of_text, runs

_ORIGIN = (0.84, 0.2)
ROUNDED = 2e-6
"""What may differ of numbers that are written with six decimals."""
BACKENDS: tuple[Backend, ...] = (
    CommonRoadBackend(),
    GeoJsonBackend(origin=_ORIGIN),
    GltfBackend(),
    Lanelet2Backend(origin=_ORIGIN),
    MujocoBackend(),
    OpenScenarioBackend(),
    RoadMaskBackend(scale=0.6, margin=3.0),
    ScenicBackend(),
    SumoBackend(objects=True),
)
OTHERS: dict[str, tuple[Backend, ...]] = {
    "conditions": (GltfBackend(collision="unreal"), OpenScenarioBackend(version="1.2")),
    "values": (GeoJsonBackend(origin=_ORIGIN, lanes=False), ScenicBackend(behaviors=False)),
}
"""Formats with other options, of some scenes."""
_NUMBER = re.compile(r"(?<![\w.])[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?(?![\w.])")


def written_lines(name: str, *, driven: bool = False) -> Iterator[str]:
    """The files of the first scene, and of its drive, in every format but OpenDRIVE."""
    scene = sampled(name, 1)[0]
    trace = scene.run().trace if driven else None
    others = () if driven else OTHERS.get(name, ())
    for backend in (*BACKENDS, *others):
        if trace is None or type(backend).drive_files is not Backend.drive_files:
            yield f"--- {backend.name}"
            yield from _files(backend, scene.record, trace)


def _files(backend: Backend, scene: Scene, trace: Trace | None) -> Iterator[str]:
    try:
        files: Mapping[str, str | bytes] = (
            backend.files(scene) if trace is None else backend.drive_files(scene, trace)
        )
    except DiagnosticError as error:
        yield f"refused: {error.diagnostics[0].message}"
        return
    for ending, content in files.items():
        if not ending.endswith("xodr"):
            yield f"file {ending}"
            yield from _content(ending, content)


def _content(ending: str, content: str | bytes) -> Iterator[str]:
    match content:
        case bytes() if ending.endswith("glb"):
            yield from _binary_meshes(ReadGlb.of(content))
        case bytes():
            pixels = cv2.imdecode(np.frombuffer(content, np.uint8), cv2.IMREAD_GRAYSCALE)
            assert pixels is not None
            yield array(pixels.astype(float).ravel().tolist(), pixels.shape)
        case str() if content.startswith("<"):
            yield from _by_path(content)
        case str() if ending.endswith("json"):
            yield from of_json(json.loads(content))
        case _:
            yield from of_text(content)


def _binary_meshes(found: ReadGlb) -> Iterator[str]:
    document = dict(found.document)
    for name in ("asset", "bufferViews"):
        document.pop(name)
    yield from of_json(document)
    tables: dict[str, list[float]] = {}
    for place, accessor in enumerate(found.document["accessors"]):
        kind = f"{accessor['type']} of {accessor['componentType']}"
        values = np.asarray(found.values(place), dtype=float)
        tables.setdefault(kind, []).extend(values.ravel().tolist())
    for kind, numbers in tables.items():
        yield f"{kind}: {array(numbers)}"


def _by_path(text: str) -> Iterator[str]:
    """The elements of each path from the root together: how many each parent has, what they say,
    and their numbers."""
    level: dict[str, list[list[ET.Element]]] = {"": [[ET.fromstring(text)]]}
    while level:
        below: dict[str, list[list[ET.Element]]] = {}
        for path, families in level.items():
            elements = [element for family in families for element in family]
            if path:
                counts = " ".join(runs([str(len(family)) for family in families]))
                yield f"{path}: {counts}"
            said = [_said_by(element) for element in elements]
            for name in dict.fromkeys(key for one in said for key in one):
                texts = [one.get(name, "(none)") for one in said]
                numbers = [float(n) for text in texts for n in _NUMBER.findall(text)]
                words = " ".join(runs([_NUMBER.sub("#", text) for text in texts]))
                yield f"{path} {name} {words}: {array(numbers)}"
            for tag in dict.fromkeys(child.tag for element in elements for child in element):
                key = f"{path}/{tag.split('}')[-1]}"
                below[key] = [element.findall(tag) for element in elements]
        level = below


def _said_by(element: ET.Element) -> dict[str, str]:
    text = (element.text or "").strip()
    return {**element.attrib, **({"text": text} if text else {})}
