"""A margin without data is no ink; the ground of a mask, stated as no data, is its ground."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from roadlang.images.image_file import open_image
from roadlang.images.no_data import on_its_ground, within_margins
from tests.images.test_tiff_bands import tiff_of

PAPER, ROAD = 240, 30


def drawing(margin: int = 0) -> np.ndarray:
    """(100, 120, 3) a dark road on pale ground, and black columns on the left."""
    pixels = np.full((100, 120, 3), PAPER, np.uint8)
    pixels[45:53] = ROAD
    pixels[:, :margin] = 0
    return pixels


def read(path: Path, pixels: np.ndarray, no_data: int = 0) -> np.ndarray:
    path.write_bytes(tiff_of(pixels, no_data=str(no_data)))
    return open_image(path, path.name, None).pixels


def test_a_margin_of_a_drawing_gets_the_color_of_its_ground(tmp_path: Path) -> None:
    expected = drawing()
    expected[:, :40] = PAPER
    assert (read(tmp_path / "a.tif", drawing(margin=40)) == expected).all()


def test_a_margin_all_around_does_too(tmp_path: Path) -> None:
    y, x = np.indices((100, 120))
    outside = np.abs(y - 50) + np.abs(x - 60) > 49
    turned = np.where(outside[..., None], 0, drawing()).astype(np.uint8)
    found = read(tmp_path / "a.tif", turned)
    assert (found[outside] == PAPER).all()
    assert (found[~outside] == turned[~outside]).all()


@pytest.mark.parametrize("kind", [np.uint8, np.uint16])
def test_the_ground_of_a_mask_is_no_margin(tmp_path: Path, kind: type[np.integer]) -> None:
    mask = np.zeros((100, 120, 3), kind)
    mask[45:53] = 255
    mask[:, 60:66] = 255
    assert (read(tmp_path / "a.tif", mask) == np.where(mask > 0, 255, 0)).all()


def test_tiles_of_masks_keep_their_ground(tmp_path: Path) -> None:
    mask = np.zeros((100, 120), np.bool_)
    mask[45:53] = True
    assert within_margins(mask) is None
    assert within_margins(~mask) is not None
    assert within_margins(np.zeros((4, 4), np.bool_)) is None


def test_the_margin_of_a_photo_stays() -> None:
    photo = np.random.default_rng(1).integers(0, 255, (80, 80, 3)).astype(np.uint8)
    photo[:, :20] = 0
    shown = np.ones((80, 80), np.bool_)
    shown[:, :20] = False
    assert (on_its_ground(photo, shown) == photo).all()
