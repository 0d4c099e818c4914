"""Roads of a typed grid: straight lines through centers of cells, corners round inside theirs."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from roadlang.geometry import RoadNetwork
from roadlang.ir.picture import Picture
from roadlang_standard.extract_pixels import Pixel

CELL = 8.0


def typed(*rows: str, cell: float = CELL) -> RoadNetwork:
    return Pixel().extract(Picture(None, cell, {"#": "road"}, rows)).network


def test_a_typed_corner_is_two_straight_lines_and_a_quarter_circle() -> None:
    (edge,) = typed("####", "#...", "#...").edges
    radius = CELL / 2
    curve, arc = edge.curve, np.pi / 2 * radius
    assert curve.length == pytest.approx(12 + arc + 20, abs=1e-4)
    points = curve.at(curve.stations(0.1))
    corner = (points[:, 0] < 8) & (points[:, 1] > 16)  # the upper left cell
    away = np.hypot(*(points[corner] - [8, 16]).T)
    assert away == pytest.approx(radius, abs=1e-4)
    off_line = np.minimum(np.abs(points[:, 0] - 4), np.abs(points[:, 1] - 20))
    assert off_line[~corner].max() < 1e-9


@pytest.mark.parametrize("cell", [2.0, 8.0, 12.0, 30.0])
def test_the_radius_of_a_typed_corner_is_half_a_cell(cell: float) -> None:
    (edge,) = typed("##", "#.", cell=cell).edges
    curve = edge.curve
    tightest = np.abs(curve.curvature(curve.stations(cell / 100))).max()
    assert 1 / tightest == pytest.approx(cell / 2, rel=0.01)


@pytest.mark.parametrize(
    "rows",
    [
        ("##...", ".##..", "..###"),  # stairs
        ("#....", ".#...", "..###"),  # diagonal, then straight
        ("#.#", ".#."),  # a right angle between diagonals
        (".##.", "#..#", ".##."),  # a ring
        ("##", "##"),  # the smallest ring
    ],
)
def test_the_center_line_never_leaves_its_cells(rows: tuple[str, ...]) -> None:
    for edge in typed(*rows).edges:
        points = edge.curve.at(edge.curve.stations(0.05))
        column, row = points[:, 0] / CELL, len(rows) - points[:, 1] / CELL
        # From corner to corner, a diagonal passes a point that belongs to four cells.
        inside = [
            any(
                rows[r][c] == "#" and abs(x - c - 0.5) <= 0.501 and abs(y - r - 0.5) <= 0.501
                for r in range(len(rows))
                for c in range(len(rows[0]))
            )
            for x, y in zip(column, row, strict=True)
        ]
        assert all(inside)


def test_a_ring_is_round_at_its_first_cell_too() -> None:
    network = typed("###", "#.#", "###")
    (edge,) = network.edges
    assert edge.curve.closed
    assert edge.length == pytest.approx(4 * CELL + 2 * np.pi * CELL / 2, abs=1e-3)
    assert np.abs(edge.curve.curvature(edge.curve.stations(0.05))).max() < 1.01 / (CELL / 2)
    assert network.node(edge.start).position == pytest.approx(tuple(edge.curve.at(0.0)))


def test_a_loop_at_a_junction_starts_and_ends_at_the_center_of_its_cell() -> None:
    network = typed("...###", "####.#", "...###")
    loop = next(edge for edge in network.edges if edge.start == edge.end)
    assert network.node(loop.start).position == (28, 12)
    assert loop.curve.at([0, loop.length]).tolist() == [[28, 12], [28, 12]]


def test_what_is_typed_straight_between_junctions_is_straight() -> None:
    network = typed("..#..#..", "########", "..#..#..")
    for edge in network.edges:
        points = edge.curve.at(edge.curve.stations(0.5))
        legs = [b - a for a, b in pairwise(points)]
        assert max(abs(leg[0] * legs[0][1] - leg[1] * legs[0][0]) for leg in legs) < 1e-9
