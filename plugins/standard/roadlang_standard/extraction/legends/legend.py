"""Pictures with a legend: a character of a text grid, or a color of a drawing, is a thing."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import cv2
import numpy as np
from numpy.typing import NDArray

from ..colors.colors import bgr
from ..colors.tones import Image
from ..drawings.surface_roads import roads_of_surface
from ..networks.found_network import FoundNetwork
from .cell_links import is_wide
from .grid import roads_of_cells

ROAD = "road"
DIRECTIONS = {
    "eastbound": (1.0, 0.0),
    "westbound": (-1.0, 0.0),
    "northbound": (0.0, -1.0),
    "southbound": (0.0, 1.0),
}
"""Directions of one-way roads, in pixels: y runs down."""
ROADS = (ROAD, *DIRECTIONS)
_EXACT = 12
"""Levels of a channel by which pixels of a color may be off."""
_FINER = 8
"""Pixels of the picture in which the surface of a typed road is seen, for each character."""


@dataclass(frozen=True)
class LegendObject:
    """An object in pixels: center, sides, and heading (radians, clockwise as y runs down)."""

    kind: str
    x: float
    y: float
    length: float
    width: float
    heading: float = 0.0


def read_text(
    rows: Sequence[str], legend: Mapping[str, str], thickness: float | None = None
) -> tuple[FoundNetwork, tuple[LegendObject, ...]]:
    """Roads between the centers of road characters, and a thing for each other character."""
    width = max((len(row) for row in rows), default=0)
    cells = np.array([list(row.ljust(width)) for row in rows], dtype="<U1").reshape(
        len(rows), width
    )
    kinds = dict(legend)
    road = np.isin(cells, [c for c, kind in kinds.items() if kind in ROADS])
    objects = tuple(
        LegendObject(kinds[str(cells[y, x])], float(x), float(y), 1.0, 1.0)
        for y, x in np.argwhere(~road)
        if str(cells[y, x]) in kinds
    )
    directions = _directions({name: np.isin(cells, _keys(kinds, name)) for name in DIRECTIONS})
    found = _wide_roads(road, thickness) if is_wide(road) else roads_of_cells(road, thickness)
    return replace(found, directions=directions), objects


def _wide_roads(road: NDArray[np.bool_], thickness: float | None) -> FoundNetwork:
    """The roads of a grid that are more than two cells wide, by their surface."""
    surface = np.kron(road, np.ones((_FINER, _FINER))).astype(np.float32)
    width = None if thickness is None else thickness * _FINER
    found = roads_of_surface(surface, "legend", width=width, specks=2)
    return found.scaled(1 / _FINER, (road.shape[0], road.shape[1]))


def _keys(legend: Mapping[str, str], kind: str) -> list[str]:
    return [key for key, named in legend.items() if named == kind]


def _directions(where: Mapping[str, NDArray[np.bool_]]) -> NDArray[np.float64] | None:
    """(h, w, 2) directions, from where each is; None where no road has any."""
    if not any(mask.any() for mask in where.values()):
        return None
    return np.asarray(
        sum(mask[..., None] * np.array(DIRECTIONS[name]) for name, mask in where.items())
    )


def read_colors(
    image: Image, legend: Mapping[str, str], thickness: float | None = None
) -> tuple[FoundNetwork, tuple[LegendObject, ...]]:
    """Roads and things of a drawing (h, w, 3): each pixel belongs to the legend's nearest color.

    A color that is far from all of the legend's is nothing. Roads of one or two pixels are read
    cell by cell.
    """
    names = list(legend)
    palette = np.array([bgr(name) for name in names], float)
    label = _nearest(image, palette)
    exact = np.abs(image.astype(np.int16) - palette[label].astype(np.int16)).max(axis=2) <= _EXACT
    roads = [i for i, name in enumerate(names) if legend[name] in ROADS]
    road = np.isin(label, roads)
    objects = tuple(
        drawn
        for i, name in enumerate(names)
        if i not in roads
        for drawn in _objects(label == i, exact, legend[name])
    )
    directions = _directions({
        name: np.isin(label, [i for i, key in enumerate(names) if legend[key] == name])
        for name in DIRECTIONS
    })  # fmt: skip
    if not is_wide(road):
        return replace(roads_of_cells(road, thickness), directions=directions), objects
    found = roads_of_surface(road.astype(np.float32), "legend", width=thickness, specks=2)
    return replace(found, directions=directions), objects


def _nearest(image: Image, palette: NDArray[np.float64], far: float = 60.0) -> NDArray[np.intp]:
    """Index of the nearest color (h, w), -1 where all are far."""
    best = np.full(image.shape[:2], far, np.float32)
    label = np.full(image.shape[:2], -1, np.intp)
    pixels = image.astype(np.float32)
    for index, color in enumerate(palette.astype(np.float32)):
        away = np.abs(pixels - color).max(axis=2)
        closer = away < best
        best[closer], label[closer] = away[closer], index
    return label


def _objects(mask: NDArray[np.bool_], exact: NDArray[np.bool_], kind: str) -> list[LegendObject]:
    """The spots of a color, but for rims of other things, where colors are mixed: these are thin,
    and no pixel of them has the color itself."""
    spots, label = cv2.connectedComponents(mask.astype(np.uint8), connectivity=8)
    inner = cv2.erode(mask.astype(np.uint8), np.ones((3, 3), np.uint8)) > 0
    kept = np.zeros(spots, bool)
    kept[label[mask & (exact | inner)]] = True
    kept[0] = False
    mask = kept[label]
    found, _ = cv2.findContours(mask.astype(np.uint8), cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    objects = []
    for outline in found:
        corners = outline.reshape(-1, 2).astype(np.float32)
        (x, y), (a, b), angle = cv2.minAreaRect(corners)
        length, width, turn = (a + 1, b + 1, angle) if a >= b else (b + 1, a + 1, angle + 90)
        heading = float(np.deg2rad((turn + 90) % 180 - 90))
        objects.append(LegendObject(kind, float(x), float(y), float(length), float(width), heading))
    return sorted(objects, key=lambda object_: (object_.y, object_.x))
