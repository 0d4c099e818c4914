"""`road: tiles`: the pixels that an extractor took for road, as cells."""

from __future__ import annotations

import base64
from typing import TYPE_CHECKING

import numpy as np

from roadlang.api import Code

from .faults import fault
from .frame import SceneOrigin
from .road_tiles import coarsened, tile_parts, with_corners_joined
from .scene_part import ScenePart

if TYPE_CHECKING:
    from roadlang.api import Scene

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
        parts += tile_parts(cells, size, network.mask_origin, len(parts) + 1, frame)
    if not parts:
        raise fault(Code.TILES_WITHOUT_PIXELS, scene=scene.name)
    return parts
