"""Roads of a grid of cells, exactly: through the centers of cells, corners and crossings kept."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .found_network import FoundNetwork, FoundRoad

Cell = tuple[int, int]
_SIDES = ((0, 1), (1, 0), (0, -1), (-1, 0))
_CORNERS = ((1, 1), (1, -1), (-1, -1), (-1, 1))


def roads_of_cells(road: NDArray[np.bool_], thickness: float | None = None) -> FoundNetwork:
    """The network of a boolean grid (h, w): neighbors join by sides, else by corners.

    Without a `thickness` roads are as wide as a cell, which says nothing of their width.
    """
    links = _links(road)
    ends = {cell for cell, near in links.items() if len(near) != 2}
    roads = []
    used: set[tuple[Cell, Cell]] = set()
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
    index: dict[Cell, int] = {}
    for path in roads:
        for cell in (path[0], path[-1]):
            index.setdefault(cell, len(index))
    nodes = np.array([(x, y) for y, x in index], float).reshape(-1, 2)
    width = 1.0 if thickness is None else thickness
    found = tuple(_road(path, index, width) for path in roads)
    return FoundNetwork(nodes, found, road, "cells", has_widths=thickness is not None)


def _links(road: NDArray[np.bool_]) -> dict[Cell, list[Cell]]:
    cells = {(int(y), int(x)) for y, x in np.argwhere(road)}
    links: dict[Cell, list[Cell]] = {cell: [] for cell in sorted(cells)}
    for y, x in links:
        links[y, x] += [(y + dy, x + dx) for dy, dx in _SIDES if (y + dy, x + dx) in cells]
        for dy, dx in _CORNERS:
            if (y + dy, x + dx) in cells and (y + dy, x) not in cells and (y, x + dx) not in cells:
                links[y, x].append((y + dy, x + dx))
    return links


def _follow(
    start: Cell,
    step: Cell,
    links: dict[Cell, list[Cell]],
    ends: set[Cell],
    used: set[tuple[Cell, Cell]],
) -> list[Cell]:
    path = [start, step]
    used |= {(start, step), (step, start)}
    while path[-1] not in ends:
        onward = next(cell for cell in links[path[-1]] if cell != path[-2])
        used |= {(path[-1], onward), (onward, path[-1])}
        path.append(onward)
    return path


def _road(path: list[Cell], index: dict[Cell, int], width: float) -> FoundRoad:
    points = np.array([(x, y) for y, x in path], float)
    return FoundRoad(index[path[0]], index[path[-1]], points, np.full(len(points), width))
