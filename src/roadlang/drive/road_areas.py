"""The areas of roads and junctions that a figure fills, from the ground up."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ..geometry.arrays import Floats
from ..ir.scene_junctions import SceneJunction
from ..ir.scene_road import SceneRoad
from ..ir.surface_stretches import junction_surface
from ..scenes.figure_colors import FIGURE_COLORS
from .lane_bands import LaneBand


@dataclass(frozen=True, eq=False)
class RoadArea:
    """The ring (n, 2) around it, in meters."""

    ring: Floats
    color: str
    inner: bool = False
    """within a roadway"""


def road_areas(
    bands: Sequence[LaneBand], junctions: Iterable[SceneJunction], roads: Mapping[str, SceneRoad]
) -> Iterator[RoadArea]:
    """In order: what lies beside roadways, junctions, roadways, what lies in them and on lanes.
    `roads`: all of the scene, by name."""
    covers = [band for band in bands if band.cover is not None]
    bands = [band for band in bands if band.cover is None]
    yield from (_area(band) for band in bands if not (band.is_driven or band.inner))
    for junction in junctions:
        cover = FIGURE_COLORS.of_surface(junction_surface(junction, roads))
        yield RoadArea(np.array(junction.area), cover or FIGURE_COLORS.surface)
    yield from (_area(band) for band in bands if band.is_driven)
    yield from (_area(band) for band in bands if band.inner)
    yield from (RoadArea(band.ring, str(band.cover), True) for band in covers)


def _area(band: LaneBand) -> RoadArea:
    color = FIGURE_COLORS.of_lane(drivable=band.is_driven, raised=band.raised)
    return RoadArea(band.ring, color, band.inner)
