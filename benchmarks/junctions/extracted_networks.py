"""Networks as roadlang reads them from pictures: random drawings, typed grids, and photos."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from benchmarks.junctions.random_networks import RandomNetwork, random_network
from roadlang.geometry import RoadNetwork
from roadlang.geometry.lanes.cross_section import CrossSection
from roadlang.ir.picture import Picture
from roadlang_standard.extract_auto import Auto

SHAPES = (
    "star 45",
    "two junctions",
    "double road",
    "roundabout",
    "grid",
    "town",
    "mixed",
    "oblique",
)
_SCALE = 0.4
_FINER, _SHIFT = 4, 4
_MARGIN = 20.0


def drawn_network(seed: int) -> RandomNetwork:
    """A random network drawn as filled roads of one or two widths, 0.4 m/px, and extracted."""
    rng = np.random.default_rng([seed, 77])
    shape = SHAPES[seed % len(SHAPES)]
    network = random_network(shape, seed).network
    widths = rng.uniform(5.0, 11.0, 2)
    picture = drawing(network, {e.id: float(rng.choice(widths)) for e in network.edges})
    return _with_lanes("drawn", Auto().extract(Picture(picture, _SCALE)).network, rng)


def typed_network(seed: int) -> RandomNetwork:
    """Streets typed as characters in cells of 6 to 12 m: rows, columns, diagonals and dead ends."""
    rng = np.random.default_rng([seed, 78])
    rows, columns = int(rng.integers(8, 15)), int(rng.integers(12, 24))
    cells = np.zeros((rows, columns), bool)
    for _ in range(int(rng.integers(1, 4))):
        first, last = np.sort(rng.choice(columns, 2, replace=False))
        cells[int(rng.integers(1, rows - 1)), first : last + 1] = True
    for _ in range(int(rng.integers(2, 5))):
        first, last = np.sort(rng.choice(rows, 2, replace=False))
        cells[first : last + 1, int(rng.integers(1, columns - 1))] = True
    if rng.random() < 0.4:
        row, column, way = (
            int(rng.integers(rows // 2)),
            int(rng.integers(columns)),
            rng.choice([-1, 1]),
        )
        for step in range(int(rng.integers(4, 8))):
            if row + step < rows and 0 <= column + way * step < columns:
                cells[row + step, column + way * step] = True
    text = tuple("".join("#" if cell else "." for cell in row) for row in cells)
    picture = Picture(None, float(rng.uniform(6.0, 12.0)), {"#": "road"}, text)
    return _with_lanes("typed", Auto().extract(picture).network, rng)


def photo_networks(manifest: Path) -> Iterator[RandomNetwork]:
    """The networks of the photos that a manifest lists (see `benchmarks.extraction`)."""
    rng = np.random.default_rng(79)
    for entry in json.loads(manifest.read_text())["images"]:
        if "drawing" in entry.get("kind", ""):
            continue
        image = cv2.imread(str(manifest.parent / entry["file"]))
        scale = float(entry.get("metres_per_pixel") or 1.0)
        picture = Picture(np.asarray(image, np.uint8), scale)
        yield _with_lanes("photo", Auto().extract(picture).network, rng)


def _with_lanes(kind: str, network: RoadNetwork, rng: np.random.Generator) -> RandomNetwork:
    """The network with as many lanes of about 3 m as its roads are wide, some of them one-way."""
    sections = {}
    for edge in network.edges:
        lanes = int(np.clip(round(float(np.median(edge.widths)) / 3.0), 1, 6))
        one_way = bool(rng.random() < 0.15)
        sections[edge.id] = CrossSection.of_lane_count(lanes, edge.width, oneway=one_way)
    return RandomNetwork(kind, network, sections)


def drawing(network: RoadNetwork, widths: dict[int, float]) -> NDArray[np.uint8]:
    """Dark roads of these widths in meters on white (h, w, 3), anti-aliased."""
    west, south, east, north = network.bounds
    origin = np.array([west - _MARGIN, north + _MARGIN])
    size = np.ceil((np.array([east - west, north - south]) + 2 * _MARGIN) / _SCALE).astype(int)
    canvas = np.full((size[1] * _FINER, size[0] * _FINER), 255, np.uint8)
    for edge in network.edges:
        points = edge.curve.at(edge.curve.stations(0.5))
        pixels = (points - origin) * [1.0, -1.0] / _SCALE * _FINER - 0.5
        fixed = np.rint(pixels * 2**_SHIFT).astype(np.int32)
        thickness = max(1, round(widths[edge.id] / _SCALE * _FINER))
        cv2.polylines(canvas, [fixed], edge.curve.closed, 60, thickness, cv2.LINE_8, _SHIFT)
    small = cv2.resize(canvas, (int(size[0]), int(size[1])), interpolation=cv2.INTER_AREA)
    return np.asarray(small[..., None].repeat(3, axis=2), np.uint8)
