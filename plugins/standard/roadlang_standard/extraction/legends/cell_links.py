"""Which cells of a grid are joined: one rule for paths, networks and tiles.

Cells join by their sides, and by their corners where no side leads from one to the other. Where
roads are drawn two cells wide, each square of four road cells is one place of the road.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

Cell = tuple[int, int]
"""Row and column."""
Place = tuple[int, int]
"""Row and column in half cells: even at the center of a cell, odd at the center of a square."""

_SIDES = ((0, 1), (1, 0), (0, -1), (-1, 0))
_CORNERS = ((1, 1), (1, -1), (-1, -1), (-1, 1))


def joined_cells(road: NDArray[np.bool_]) -> dict[Cell, list[Cell]]:
    """The cells that each road cell of a grid (h, w) is joined to."""
    cells = {(int(y), int(x)) for y, x in np.argwhere(road)}
    at_corners = joined_at_corners(road)
    links: dict[Cell, list[Cell]] = {cell: [] for cell in sorted(cells)}
    for y, x in links:
        links[y, x] += [(y + dy, x + dx) for dy, dx in _SIDES if (y + dy, x + dx) in cells]
        for dy, dx in _CORNERS:
            place = (min(y, y + dy), min(x, x + dx), int(dy != dx))
            if (y + dy, x + dx) in cells and at_corners[place]:
                links[y, x].append((y + dy, x + dx))
    return links


def joined_at_corners(road: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """(h - 1, w - 1, 2): for each square of four cells of a grid (h, w), whether those from its
    upper left to its lower right, and from its upper right to its lower left, are joined."""
    upper_left, upper_right = road[:-1, :-1], road[:-1, 1:]
    lower_left, lower_right = road[1:, :-1], road[1:, 1:]
    falling = upper_left & lower_right & ~upper_right & ~lower_left
    rising = upper_right & lower_left & ~upper_left & ~lower_right
    return np.stack([falling, rising], axis=-1)


def joined_places(road: NDArray[np.bool_]) -> dict[Place, list[Place]]:
    """The places of a grid's roads, in order, each with those that it is joined to.

    A dead end of a road two cells wide is moved half a cell out, to the middle of its last cells.
    """
    cells = joined_cells(road)
    squares = joined_cells(squares_of(road))
    links: dict[Place, list[Place]] = {
        (2 * y + 1, 2 * x + 1): [(2 * v + 1, 2 * u + 1) for v, u in near]
        for (y, x), near in squares.items()
    }
    owners = {cell: tuple(_squares_with(cell, squares)) for cell in cells}
    places = {cell: owners[cell] or ((2 * cell[0], 2 * cell[1]),) for cell in cells}
    for cell in cells:
        for place in places[cell]:
            links.setdefault(place, [])
    wide_links = {place: len(near) for place, near in links.items()}
    for cell, near in cells.items():
        for other in near:
            if not set(owners[cell]) & set(owners[other]):
                a, b = _nearest(places[cell], places[other], wide_links)
                if b not in links[a]:
                    links[a].append(b)
    _lengthen(links)
    return {place: links[place] for place in sorted(links)}


def squares_of(road: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """(h - 1, w - 1): whether a cell and those right of it, below it and between are all road."""
    return np.asarray(road[:-1, :-1] & road[:-1, 1:] & road[1:, :-1] & road[1:, 1:])


def is_wide(road: NDArray[np.bool_]) -> bool:
    """Whether roads are more than two cells wide somewhere."""
    return bool(squares_of(squares_of(road)).any())


def is_square(place: Place) -> bool:
    """Whether a place is the middle of four cells."""
    return place[0] % 2 == 1


def _squares_with(cell: Cell, squares: dict[Cell, list[Cell]]) -> Iterator[Place]:
    y, x = cell
    for v, u in ((y - 1, x - 1), (y - 1, x), (y, x - 1), (y, x)):
        if (v, u) in squares:
            yield (2 * v + 1, 2 * u + 1)


def _nearest(
    one: tuple[Place, ...], two: tuple[Place, ...], wide_links: dict[Place, int]
) -> tuple[Place, Place]:
    """A place of each that are nearest to each other, if possible not the end of a wide road."""

    def rank(pair: tuple[Place, Place]) -> tuple[int, int, list[Place]]:
        (y, x), (v, u) = pair
        ends = sum(wide_links[place] == 1 for place in pair)
        return (y - v) ** 2 + (x - u) ** 2, ends, sorted(pair)

    return min(((a, b) for a in one for b in two), key=rank)


def _lengthen(links: dict[Place, list[Place]]) -> None:
    for place in [place for place, near in links.items() if len(near) == 1 and is_square(place)]:
        (other,) = links[place]
        tip = tuple(p + int(np.sign(p - q)) for p, q in zip(place, other, strict=True))
        links[place].append((tip[0], tip[1]))
        links[tip[0], tip[1]] = [place]
