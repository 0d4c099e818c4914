"""Pictures of straight roads to extract."""

from __future__ import annotations

import numpy as np

from tests.extraction.graph_drawings import surface

EVERYTHING = slice(None)


def band(top: int, bottom: int, height: int = 100, width: int = 200) -> np.ndarray:
    """A road across the picture between two rows."""
    return surface(height, width, (slice(top, bottom), EVERYTHING))


def two_lines() -> np.ndarray:
    """The edges of a road, rows 30 to 32 and 60 to 62."""
    return np.asarray(band(30, 33, width=400) + band(60, 63, width=400))


def painted(mask: np.ndarray, road: int = 90, ground: int = 230) -> np.ndarray:
    return np.where(mask[..., None] > 0.5, road, ground).repeat(3, axis=2).astype(np.uint8)
