"""`road: tiles`: the pixels that an extractor took for road, as cells."""

from __future__ import annotations

import base64
from typing import TYPE_CHECKING

import numpy as np

from roadlang.api import Code

from ..faults import fault
from ..net.scene_part import ScenePart
from .frame import SceneOrigin
from .line import RoadSamples, line_of
from .road_tiles import coarsened, tile_parts, with_corners_joined
from .surface_table import surface_number

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from roadlang.api import Scene, SceneNetwork

SMALLEST_CELL = 2.0
"""Meters; finer pixels are taken together."""


def network_tiles(scene: Scene, frame: SceneOrigin) -> list[ScenePart]:
    """The tiles of every network that has pixels. Raises `EngineError` RL514 where none has."""
    import cv2

    parts: list[ScenePart] = []
    for network in scene.networks:
        if network.mask is None or network.mask_scale is None:
            continue
        packed = np.frombuffer(base64.b64decode(network.mask), dtype=np.uint8)
        pixels = np.asarray(cv2.imdecode(packed, cv2.IMREAD_GRAYSCALE))
        factor = max(1, round(SMALLEST_CELL / network.mask_scale))
        cells = with_corners_joined(coarsened(pixels > 0, factor))
        size = network.mask_scale * factor
        surfaces = _surfaces(scene, network, cells, size)
        parts += tile_parts(cells, size, network.mask_origin, len(parts) + 1, frame, surfaces)
    if not parts:
        raise fault(Code.TILES_WITHOUT_PIXELS, scene=scene.name)
    return parts


def _surfaces(
    scene: Scene, network: SceneNetwork, cells: NDArray[np.bool_], size: float
) -> NDArray[np.int64] | None:
    """(rows, columns) numbers of the surfaces of cells: those of the nearest road of the network.
    None where nobody says any."""
    lines = [line_of(road) for road in scene.roads if road.name in network.roads]
    if not any(line.stretches for line in lines):
        return None
    from scipy.spatial import cKDTree

    stations = [np.arange(line.s[0], line.s[-1], 0.5 * size) for line in lines]
    points = [line.at(s)[0] for line, s in zip(lines, stations, strict=True)]
    owner = np.repeat(np.arange(len(lines)), [len(s) for s in stations])
    rows, columns = np.nonzero(cells)
    x = network.mask_origin[0] + (columns + 0.5) * size
    y = network.mask_origin[1] + (cells.shape[0] - rows - 0.5) * size
    _, nearest = cKDTree(np.vstack(points)).query(np.column_stack((x, y)))
    at = np.concatenate(stations)[nearest]
    found = np.zeros(cells.shape, np.int64)
    for i, (row, column) in enumerate(zip(rows.tolist(), columns.tolist(), strict=True)):
        line = lines[int(owner[nearest[i]])]
        found[row, column] = _surface(line, float(at[i]), np.array([x[i], y[i]]))
    return found


def _surface(line: RoadSamples, station: float, point: NDArray[np.float64]) -> int:
    """The number of the surface of a place beside a station of a road."""
    stretch = next((each for each in line.stretches if station <= each.end), None)
    if stretch is None:
        return 0
    center, heading, _ = line.at(np.array([station]))
    away = point - center[0]
    left = float(away[1] * np.cos(heading[0]) - away[0] * np.sin(heading[0]))
    borders = line.cross_section.border_offsets(station)
    return surface_number(stretch.surfaces[int((borders[1:-1] > left).sum())])
