"""Roads of a grid of cells, exactly: through the centers of cells, corners and crossings kept."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..networks.found_network import FoundNetwork, FoundRoad
from .cell_links import Place, is_square, joined_places


def roads_of_cells(road: NDArray[np.bool_], thickness: float | None = None) -> FoundNetwork:
    """The network of a boolean grid (h, w) whose roads are one or two cells wide.

    Without a `thickness` roads are as wide as they are drawn; where all are drawn one cell wide,
    that says nothing of their width.
    """
    links = joined_places(road)
    ends = {cell for cell, near in links.items() if len(near) != 2}
    roads = []
    used: set[tuple[Place, Place]] = set()
    for start in sorted(ends):
        for step in links[start]:
            if (start, step) not in used:
                roads.append(_follow(start, step, links, ends, used))
    touched = {cell for path in roads for cell in path}
    for start in sorted(set(links) - touched):
        if start not in touched and len(links[start]) == 2:
            path = _follow(start, links[start][0], links, {start}, used)
            touched |= set(path)
            roads.append(path)
    index: dict[Place, int] = {}
    for path in roads:
        for cell in (path[0], path[-1]):
            index.setdefault(cell, len(index))
    nodes = np.array([(x, y) for y, x in index], float).reshape(-1, 2) / 2
    found = tuple(_road(path, index, thickness) for path in roads)
    drawn = any(is_square(place) for place in links)
    return FoundNetwork(nodes, found, road, "cells", has_widths=thickness is not None or drawn)


def _follow(
    start: Place,
    step: Place,
    links: dict[Place, list[Place]],
    ends: set[Place],
    used: set[tuple[Place, Place]],
) -> list[Place]:
    path = [start, step]
    used |= {(start, step), (step, start)}
    while path[-1] not in ends:
        onward = next(cell for cell in links[path[-1]] if cell != path[-2])
        used |= {(path[-1], onward), (onward, path[-1])}
        path.append(onward)
    return path


def _road(path: list[Place], index: dict[Place, int], thickness: float | None) -> FoundRoad:
    points = np.array([(x, y) for y, x in path], float) / 2
    widths = np.array([2.0 if y % 2 or x % 2 else 1.0 for y, x in path])
    if thickness is not None:
        widths[:] = thickness
    return FoundRoad(index[path[0]], index[path[-1]], points, widths)
