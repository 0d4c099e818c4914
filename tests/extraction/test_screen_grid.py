"""The grid of a drawing program is behind what is drawn; streets at even spaces are none."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np

from roadlang.api import Picture
from roadlang_standard.extract_auto import Auto
from roadlang_standard.extraction.drawings.screen_grid import without_grid


def _grid(space: int = 20, color: tuple[int, int, int] = (235, 235, 235)) -> np.ndarray:
    image = np.full((300, 400, 3), 255, np.uint8)
    image[::space] = color
    image[:, ::space] = color
    return image


def _line(edge: Any) -> np.ndarray:
    return np.asarray(edge.curve.at(np.linspace(0.0, edge.length, 200)))


def test_roads_drawn_upon_a_grid_are_found_alone(distance_to: Any) -> None:
    plain, on_grid = (np.full((300, 400, 3), 255, np.uint8), _grid())
    for image in (plain, on_grid):
        cv2.polylines(image, [np.array([(30, 250), (160, 120), (370, 60)])], False, 0, 9)
    cleaned = without_grid(on_grid)
    assert (cleaned != plain).any(axis=2).mean() < 0.001
    found = Auto().extract(Picture(on_grid, 1.0)).network.edges
    alone = Auto().extract(Picture(plain, 1.0)).network.edges
    assert len(found) == len(alone) == 1
    assert distance_to(_line(found[0]), _line(alone[0])).max() < 0.3


def test_blank_squared_paper_has_no_road() -> None:
    found = Auto().extract(Picture(_grid(24, (140, 170, 220)), 1.0))
    assert not found.network.edges


def test_the_margin_of_ruled_paper_is_printed_too() -> None:
    page = np.full((300, 400, 3), (248, 252, 252), np.uint8)
    page[40::24] = page[41::24] = (225, 185, 150)
    page[:, 55:57] = (110, 110, 230)
    assert (without_grid(page) == (248, 252, 252)).all(axis=2).mean() > 0.99
    assert (without_grid(np.rot90(page)) == (248, 252, 252)).all(axis=2).mean() > 0.99
    road = page.copy()
    road[:, 150:160] = 40
    left = without_grid(road)
    assert (left[:, 150:160] == 40).mean() > 0.9
    assert (left[:, 50:60] == (248, 252, 252)).mean() > 0.9
    short = page.copy()
    short[:, 55:57] = (248, 252, 252)
    short[60:200, 55:57] = 40
    assert (without_grid(short)[64:78, 55:57] == 40).all()


def test_five_streets_each_way_are_streets() -> None:
    streets = np.full((300, 400, 3), 255, np.uint8)
    streets[40:280:48, 20:380] = 60
    streets[20:280, 40:380:64] = 60
    assert without_grid(streets) is streets
    uneven = _grid()
    uneven[::20] = 255
    uneven[7:300:31] = 200
    uneven[150] = 200
    assert (without_grid(uneven)[7] == 200).mean() > 0.9


def test_a_photo_stays_as_it_is() -> None:
    photo = np.random.default_rng(1).integers(0, 255, (100, 100, 3)).astype(np.uint8)
    assert without_grid(photo) is photo
