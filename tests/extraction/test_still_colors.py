"""A map stored as JPEG that is mostly lines has an exact land everywhere, and is no photo."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from roadlang_standard.extraction.colors.tones import Image, flatness
from roadlang_standard.extraction.picture_kinds.exact_colors import has_exact_colors, has_exact_land
from roadlang_standard.extraction.picture_kinds.picture_kind import picture_kind
from roadlang_standard.extraction.picture_kinds.still_colors import has_still_land
from tests.extraction.drawn_maps import as_jpeg

SIDE = 480


def full_of_outlines(land: int, line: int, house: int | None = None) -> Image:
    """Rows of small houses (h, w, 3), outlined or filled, and gray rails beside them."""
    image = np.full((SIDE, SIDE, 3), land, np.uint8)
    rng = np.random.default_rng(3)
    for top in range(4, SIDE, 24):
        for left in range(4, SIDE, 24):
            wide, high = rng.integers(8, 18, 2)
            corner = left + int(wide), top + int(high)
            if house is not None:
                cv2.rectangle(image, (left, top), corner, (house,) * 3, -1)
            cv2.rectangle(image, (left, top), corner, (line,) * 3, 1, cv2.LINE_AA)
    for step in range(0, SIDE, 12):
        cv2.line(image, (step, 0), (SIDE - 1, step), (line,) * 3, 1, cv2.LINE_AA)
    return image


@pytest.mark.parametrize(("land", "line", "house"), [(12, 22, None), (255, 0, 0)])
def test_a_map_that_is_mostly_lines_stored_as_jpeg_is_no_photo(
    land: int, line: int, house: int | None
) -> None:
    image = as_jpeg(full_of_outlines(land, line, house), 80)
    assert has_exact_land(image)
    assert flatness(image) < 0.55
    assert not has_exact_colors(image)
    kind = picture_kind(image)
    assert kind.drawn
    assert kind.exact


def test_a_photo_with_an_even_sky_or_an_overexposed_one_has_no_exact_land() -> None:
    ground = np.random.default_rng(0).normal(90, 30, (SIDE, SIDE, 3)).clip(0, 255).astype(np.uint8)
    for sky in (180, 255):
        photo = ground.copy()
        photo[: SIDE // 2] = sky
        assert not has_still_land(photo)
    lit = np.where(ground > 60, 255, ground).astype(np.uint8)
    assert not has_still_land(lit), "what is white alone may be overexposed"


def test_shades_of_paper_are_no_exact_land() -> None:
    shade = np.linspace(180, 210, SIDE).astype(np.uint8)
    sheet = np.repeat(np.tile(shade, (SIDE, 1))[..., None], 3, axis=2)
    assert not has_still_land(sheet)
