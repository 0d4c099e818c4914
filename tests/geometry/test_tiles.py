"""Tiles of a grid: which neighbors a cell has, and its shape."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from roadlang.geometry import GeometryError, TileShape, neighbor_mask, tile_shape, tile_shapes


def grid(text: Any) -> Any:
    return np.array([[cell == "#" for cell in row] for row in text.split()])


@pytest.mark.parametrize(
    ("picture", "mask", "shape"),
    [
        ("... .#. ...", 0, TileShape("dot", 0)),
        (".#. .#. ...", 1, TileShape("end", 0)),
        ("... .## ...", 2, TileShape("end", 1)),
        ("... .#. .#.", 4, TileShape("end", 2)),
        ("... ##. ...", 8, TileShape("end", 3)),
        (".#. .#. .#.", 5, TileShape("straight", 0)),
        ("... ### ...", 10, TileShape("straight", 1)),
        (".#. .## ...", 3, TileShape("corner", 0)),
        ("... .## .#.", 6, TileShape("corner", 1)),
        ("... ##. .#.", 12, TileShape("corner", 2)),
        (".#. ##. ...", 9, TileShape("corner", 3)),
        (".#. .## .#.", 7, TileShape("tee", 0)),
        ("... ### .#.", 14, TileShape("tee", 1)),
        (".#. ##. .#.", 13, TileShape("tee", 2)),
        (".#. ### ...", 11, TileShape("tee", 3)),
        (".#. ### .#.", 15, TileShape("cross", 0)),
    ],
)
def test_the_sixteen_shapes(picture: str, mask: int, shape: Any) -> None:
    cells = grid(picture)
    assert neighbor_mask(cells)[1, 1] == mask
    assert tile_shape(mask) == shape
    assert shape.mask == mask
    assert tile_shapes(cells)[1, 1] == shape


def test_a_turned_picture_has_turned_tiles() -> None:
    cells = grid("..#.. .##.. ..### ..#..")
    plain, turned = tile_shapes(cells), tile_shapes(np.rot90(cells, -1))
    for (row, column), shape in plain.items():
        other = turned[column, cells.shape[0] - 1 - row]
        assert other.name == shape.name
        turns = 2 if shape.name == "straight" else 1 if shape.name in ("dot", "cross") else 4
        assert other.turns == (shape.turns + 1) % turns


def test_neighbors_beyond_the_edge_are_empty_and_empty_cells_have_none() -> None:
    np.testing.assert_array_equal(neighbor_mask(grid("##")), [[2, 8]])
    np.testing.assert_array_equal(neighbor_mask(grid("#.#")), [[0, 0, 0]])


def test_what_is_no_grid_is_refused() -> None:
    for call in (lambda: neighbor_mask([True]), lambda: tile_shape(16), lambda: tile_shape(-1)):
        with pytest.raises(GeometryError):
            call()
