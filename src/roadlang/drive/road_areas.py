"""The areas of roads and junctions that a figure fills, from the ground up."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from ..geometry.arrays import Floats
from ..ir.scene_junctions import SceneJunction
from ..scenes.figure_colors import FIGURE_COLORS
from .lane_bands import LaneBand


@dataclass(frozen=True, eq=False)
class RoadArea:
    """The ring (n, 2) around it, in meters."""

    ring: Floats
    color: str
    inner: bool = False
    """within a roadway"""


def road_areas(bands: Sequence[LaneBand], junctions: Iterable[SceneJunction]) -> Iterator[RoadArea]:
    """In order: what lies beside roadways, junctions, roadways, what lies in them."""
    yield from (_area(band) for band in bands if not (band.is_driven or band.inner))
    for junction in junctions:
        yield RoadArea(np.array(junction.area), FIGURE_COLORS.surface)
    yield from (_area(band) for band in bands if band.is_driven)
    yield from (_area(band) for band in bands if band.inner)


def _area(band: LaneBand) -> RoadArea:
    color = FIGURE_COLORS.of_lane(drivable=band.is_driven, raised=band.raised)
    return RoadArea(band.ring, color, band.inner)
