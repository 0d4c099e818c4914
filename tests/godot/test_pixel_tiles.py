"""Tiles: one per road pixel, with the mask of its four neighbors."""

from __future__ import annotations

import base64
from dataclasses import replace

import cv2
import numpy as np
import pytest
from hypothesis import given
from hypothesis.extra.numpy import arrays

from roadlang_godot.build.frame import SceneOrigin
from roadlang_godot.build.layout import layout_of
from roadlang_godot.build.road_tiles import (
    EAST,
    NORTH,
    NORTH_EAST,
    SOUTH,
    SOUTH_EAST,
    SOUTH_WEST,
    WEST,
    coarsened,
    neighbor_masks,
    tile_parts,
    with_corners_joined,
)
from roadlang_godot.faults import EngineError
from roadlang_godot.net import protocol
from roadlang_godot.net.protocol import Message
from tests.godot.godot_scenes import pieces, road, scene, straight, town

maps = arrays(bool, (12, 17))


def test_the_four_bits_are_the_four_neighbors() -> None:
    cross = np.array([[0, 1, 0], [1, 1, 1], [0, 1, 0]], bool)
    masks = neighbor_masks(cross)
    assert masks[1, 1] == NORTH | EAST | SOUTH | WEST
    assert masks[0, 1] == SOUTH
    assert masks[1, 0] == EAST
    assert masks[1, 2] == WEST
    assert masks[2, 1] == NORTH


@given(maps)
def test_neighbors_agree_about_each_other(pixels: np.ndarray) -> None:
    masks = neighbor_masks(pixels)
    joined_east = (masks[:, :-1] & EAST > 0) & pixels[:, :-1]
    joined_west = (masks[:, 1:] & WEST > 0) & pixels[:, :-1] & pixels[:, 1:]
    assert np.array_equal(joined_east, joined_west)


@given(maps)
def test_cells_that_touch_are_joined_by_sides(pixels: np.ndarray) -> None:
    """The tiles have as many parts as the pixels, where corners count."""
    filled = with_corners_joined(pixels)
    assert (filled >= pixels).all()
    by_sides = cv2.connectedComponents(filled.astype(np.uint8), connectivity=4)[0]
    by_corners = cv2.connectedComponents(pixels.astype(np.uint8), connectivity=8)[0]
    assert by_sides == by_corners


def test_a_diagonal_road_becomes_a_stair_without_side_branches() -> None:
    masks = neighbor_masks(with_corners_joined(np.eye(6, dtype=bool)))
    joined = (masks[..., None] >> np.arange(4) & 1).sum(axis=-1)
    assert joined.max() == 2
    assert (joined == 1).sum() == 2


def test_a_road_of_two_pixels_is_one_surface() -> None:
    masks = neighbor_masks(np.ones((2, 5), bool))
    assert masks[0, 2] == EAST | SOUTH | WEST | SOUTH_EAST | SOUTH_WEST
    assert masks[1, 0] == NORTH | EAST | NORTH_EAST


@given(maps)
def test_every_road_pixel_becomes_one_tile(pixels: np.ndarray) -> None:
    things = tile_parts(pixels, 8.0, (0.0, 0.0), 1, SceneOrigin())
    assert sum(len(thing.content) // 5 for thing in things) == pixels.sum()
    for thing in things:
        assert len(thing.message(0, 1)) + protocol.HEADER_BYTES <= protocol.BULK_DATAGRAM


def test_fine_pixels_are_taken_together() -> None:
    fine = np.zeros((7, 9), bool)
    fine[3:7, 0:4] = True
    coarse = coarsened(fine, 4)
    assert coarse.tolist() == [[False, False, False], [True, False, False]]


@pytest.mark.parametrize("factor", [2, 3, 4])
def test_thin_roads_stay_whole_where_pixels_are_taken_together(factor: int) -> None:
    road = np.zeros((60, 84), bool)
    road[20:30] = True  # wide
    road[0:20, 41] = True  # leads to it
    road[45, 10:80] = True  # alone
    for step in range(12):
        road[46 + step, 12 + step] = True  # a diagonal one
    coarse = coarsened(road, factor)
    parts = cv2.connectedComponents(coarse.astype(np.uint8), connectivity=8)[0] - 1
    assert parts == 2
    blocks = np.kron(coarse, np.ones((factor, factor), bool))[-60:, :84]
    thin = road.copy()
    thin[20:30] = False
    assert blocks[thin].all()
    wide = np.flatnonzero(blocks[:, 5])
    assert 20 - factor < wide.min() <= 20 + factor
    assert 29 - factor <= wide.max() < 29 + factor


def test_a_scene_with_a_mask_is_built_of_tiles() -> None:
    roads, network = town()
    mask = np.zeros((10, 12), np.uint8)
    mask[4, :] = 255
    png = base64.b64encode(cv2.imencode(".png", mask)[1]).decode()
    pixelled = replace(network, mask=png, mask_scale=8.0)
    kinds = {t.kind for t in layout_of(scene(*roads, networks=[pixelled]), "tiles").parts}
    assert Message.TILES in kinds
    assert Message.SEGMENT not in kinds


def test_a_road_without_pixels_cannot_be_built_of_tiles() -> None:
    with pytest.raises(EngineError, match="RL514"):
        layout_of(scene(road("main", pieces(straight(50)))), "tiles")
