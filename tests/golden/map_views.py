"""Maps that are read and written, whole ones and ones with a fault, in lines."""

from __future__ import annotations

import json
import random
import re
import tempfile
import xml.etree.ElementTree as ET
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from roadlang import DiagnosticError
from roadlang.api import Extraction
from roadlang.geometry import Edge, RoadNetwork
from roadlang.geometry.earth.local_projection import LocalProjection
from roadlang_formats.emit_opendrive import OpenDriveBackend
from roadlang_formats.read_geojson import GeoJson
from roadlang_formats.read_opendrive import OpenDriveMap
from roadlang_formats.read_osm import OpenStreetMap
from roadlang_formats.read_scene import SceneMap
from tests.formats.small_maps import straight, xodr
from tests.golden.geometry_views import plain_value
from tests.golden.language_views import said
from tests.golden.random_maps import lines_of_streets, opendrive_map, street_extract
from tests.golden.scene_views import sampled
from tests.golden.summaries import array, of_json, of_svg

Read = Callable[[Path], Any]
_OTHERS = ("", "x", "nan", "-1", "0", "1", "2", "3.5", "1e9", "100", "-0.5", "none")
_VALUES: tuple[Any, ...] = (None, True, 3, -1.5, "x", [], {}, "yes", "Polygon", 1e9, "2")


def network_lines_of(found: Extraction | RoadNetwork) -> Iterator[str]:
    """The nodes, roads, lanes, junctions, objects and remarks of a map."""
    network = found if isinstance(found, RoadNetwork) else found.network
    yield f"  origin {network.origin} bounds {array(network.bounds)}"
    yield f"  nodes {_numbers([(node.id, *node.position) for node in network.nodes])}"
    for edge in network.edges:
        yield from _edge(edge)
    for junction in network.junctions or ():
        bare = replace(junction, turns=tuple(replace(t, curve=None) for t in junction.turns))
        yield from of_json(plain_value(bare), "  junction")
        curves = [turn.curve for turn in junction.turns if turn.curve is not None]
        for curve in curves:
            yield f"    along {_numbers(curve.at(np.linspace(0.0, curve.length, 7)))}"
    if isinstance(found, Extraction):
        yield from of_json(plain_value(found.objects), "  objects")
        yield from (f"  remark: {remark}" for remark in found.remarks)


def _edge(edge: Edge) -> Iterator[str]:
    s = np.linspace(0.0, edge.length, 11)
    ends = f"{edge.start}-{edge.end}"
    yield f"  road {edge.id} {ends} {edge.name!r} closed {edge.curve.closed} {edge.length:.9g}"
    yield f"    at {_numbers(edge.curve.at(s))} bends {_numbers(edge.curve.curvature(s))}"
    if edge.elevations is not None:
        yield f"    heights {_numbers(edge.elevations)}"
    section = edge.cross_section
    if section is None:
        yield f"    width {_numbers(edge.width.at(s))}"
        return
    for lane in section.lanes:
        bare = {k: v for k, v in plain_value(lane).items() if k not in ("width", "id")}
        yield f"    lane {lane.id} {bare} {_numbers(lane.width.at(s))}"
    yield f"    center {section.center_marking} {_numbers([section.border_offsets(x) for x in s])}"


def _numbers(values: Any) -> str:
    return array(np.asarray(values, dtype=float).ravel().tolist())


def _read(read: Read, path: Path, text: str) -> Iterator[str]:
    """What was read of a file, or why it was refused."""
    path.write_text(text, encoding="utf-8")
    try:
        yield from network_lines_of(read(path))
    except DiagnosticError as error:
        for found in error.diagnostics:
            yield f"  {said(found)}".replace(str(path), "FILE")


def _briefly(lines: Iterator[str]) -> str:
    """Everything that was read in one line: the sizes of its parts and one number for all."""
    found = list(lines)
    if not found or " RL" in found[0]:
        return " / ".join(line.strip().replace("\n", " / ") for line in found)
    numbers = [float(n) for n in re.findall(r"-?\d+\.?\d*(?:e[-+]?\d+)?", " ".join(found))]
    remarks = [line.strip() for line in found if line.startswith("  remark")]
    return f"{len(found)} lines, {len(numbers)} numbers, {_numbers(numbers)} {' '.join(remarks)}"


def opendrive_lines(first: int, count: int) -> Iterator[str]:
    """Random maps in OpenDRIVE: pieces, lanes, links, junctions."""
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(first, first + count):
            yield f"map {seed}"
            yield from _read(OpenDriveMap().read, Path(folder) / "a.xodr", opendrive_map(seed))


def street_map_lines(first: int, count: int) -> Iterator[str]:
    """Random streets, as OpenStreetMap and as GeoJSON, with other options each."""
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        for seed in range(first, first + count):
            options: dict[str, Any] = {
                "lane_width": (3.25, 2.5, 4.0)[seed % 3],
                "traffic": ("right", "left")[seed % 2],
                "buildings": seed % 3 != 1,
            }
            yield f"streets {seed} {options}"
            osm = OpenStreetMap(service=seed % 4 != 1, **options)
            yield from _read(osm.read, folder / "a.osm", street_extract(seed))
            lines = GeoJson(**options, origin=None if seed % 2 else (0.8378, 0.192))
            text = json.dumps(lines_of_streets(seed))
            yield from _read(lines.read, folder / "a.geojson", text)


_REFERENCES = (
    "+proj=utm +zone=32 +lat_0=48 +lon_0=11",
    "+lat_0=48 +lon_0=11 +x_0=0 +y_0=-0.0",
    "+proj=tmerc +lat_0=48 +lon_0=11 +x_0=500000",
    "+proj=tmerc +lat_0=48 +lon_0=11 +y_0=3.5",
    "+proj=stere +lat_0=-89.5 +lon_0=180",
    "+proj=laea +lat_0=91 +lon_0=11",
    "+proj=aeqd +lat_0=90 +lon_0=-180.5",
    "+proj=tmerc +lat_0=a +lon_0=11",
    "+proj=tmerc +lon_0=11",
    "EPSG:25832",
    "",
)


def place_lines() -> Iterator[str]:
    """Places in degrees by meters from an origin, and the origins that headers state."""
    for origin in ((0.0, 7.0), (48.1, 11.5), (-33.9, 151.2), (64.0, -179.9)):
        projection = LocalProjection(*origin)
        for north in (-3.0, 0.0, 0.01, 2.5):
            row = [
                projection.point(origin[0] + north, origin[1] + east) for east in (-5.0, 0.1, 3.7)
            ]
            yield f"{origin} {north}: {_numbers(row)}"
    with tempfile.TemporaryDirectory() as folder:
        for reference in _REFERENCES:
            header = f"<geoReference>{reference}</geoReference>"
            text = xodr(straight(1, 0.0, 0.0), header=header)
            lines = list(_read(OpenDriveMap().read, Path(folder) / "a.xodr", text))
            yield f"{reference}: {lines[0].split(' bounds')[0]}"


def broken_map_lines(values: int) -> Iterator[str]:
    """Small maps in each of which one attribute or element is missing, odd or doubled: what is
    read, or the message. Every attribute of every tag is missing once or odd, in turn, with so
    many odd values."""
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        for name, text, read in (
            ("a.xodr", opendrive_map(1), OpenDriveMap().read),
            ("a.osm", street_extract(2), OpenStreetMap(buildings=True).read),
        ):
            for title, damaged in _broken_texts(text, values):
                lines = _read(read, folder / name, damaged)
                yield f"{name} {title}: {_briefly(lines)}"
        rng = random.Random(values)
        for _ in range(30):
            document = lines_of_streets(3)
            title = _broken_document(document, rng)
            lines = _read(GeoJson(buildings=True).read, folder / "a.geojson", json.dumps(document))
            yield f"a.geojson {title}: {_briefly(lines)}"


def _broken_texts(text: str, values: int) -> Iterator[tuple[str, str]]:
    """Each fault with a title: where the text is damaged, then the elements and attributes."""
    for end in (0, 30, len(text) // 2, len(text) - 3):
        yield f"cut at {end}", text[:end]
    yield "mismatched", text.replace("</", "</x", 1)
    parents: dict[str, list[tuple[ET.Element, ET.Element]]] = {}
    root = ET.fromstring(text)
    for parent in root.iter():
        for child in parent:
            parents.setdefault(child.tag, []).append((parent, child))
    rng = random.Random(len(text))
    attributes = 0
    for tag, found in parents.items():
        parent, child = rng.choice(found)
        place = list(parent).index(child)
        parent.remove(child)
        yield f"no {tag}", ET.tostring(root, "unicode")
        parent.insert(place, child)
        parent.insert(place, child)
        yield f"{tag} twice", ET.tostring(root, "unicode")
        del parent[place]
        for name in dict.fromkeys(name for _, one in found for name in one.attrib):
            _, having = rng.choice([pair for pair in found if name in pair[1].attrib])
            old = having.attrib.pop(name)
            odd = rng.sample(_OTHERS, values)
            attributes += 1
            if attributes % 2:
                yield f"{tag} without {name}", ET.tostring(root, "unicode")
                odd = []
            for value in odd:
                having.set(name, value)
                yield f"{tag} {name}={value!r}", ET.tostring(root, "unicode")
            having.set(name, old)


def _broken_document(document: Any, rng: random.Random) -> str:
    """Replace or remove one value of a JSON document; returns which."""
    places: list[tuple[Any, Any, str]] = []

    def walk(value: Any, path: str) -> None:
        items = value.items() if isinstance(value, dict) else enumerate(value)
        for key, inner in list(items):
            places.append((value, key, f"{path}.{key}"))
            if isinstance(inner, dict | list):
                walk(inner, f"{path}.{key}")

    walk(document, "")
    holder, key, path = rng.choice(places)
    if rng.random() < 0.3:
        del holder[key]
        return f"{path} removed"
    holder[key] = rng.choice(_VALUES)
    return f"{path} = {holder[key]!r}"


def written_map_lines(name: str) -> Iterator[str]:
    """A scene as OpenDRIVE, what is read of that, and what is read of the scene's JSON."""
    scene = sampled(name, 1)[0]
    backend = OpenDriveBackend(geo_reference="+proj=tmerc +lat_0=48 +lon_0=11")
    text = backend.files(scene.record)["xodr"]
    yield from of_svg(re.sub(r' (date|vendor|revMinor)="[^"]*"', "", text))
    with tempfile.TemporaryDirectory() as place:
        yield "read again"
        yield from _read(OpenDriveMap().read, Path(place) / "a.xodr", text)
        yield "read from the scene"
        yield from _read(SceneMap().read, Path(place) / "a.json", scene.to_json())
