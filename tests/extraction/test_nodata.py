"""Margins without data: turned orthophotos read as the photos they are."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np
import pytest

from roadlang_standard.extraction.colors.nodata import nodata
from roadlang_standard.extraction.photos.aerial import roads_of_photo
from roadlang_standard.extraction.photos.exposure import even_exposure
from roadlang_standard.extraction.picture_kinds.picture_kind import PHOTO, picture_kind
from training.rendering.aerial import render_aerial
from training.rendering.drawings import draw_circuit


def turned(image: Any, margin: Any, degrees: int = 37) -> Any:
    height, width = image.shape[:2]
    matrix = cv2.getRotationMatrix2D((width / 2, height / 2), degrees, 1)
    return cv2.warpAffine(image, matrix, (width, height), borderValue=(margin,) * 3), matrix


@pytest.mark.parametrize("margin", [0, 255])
def test_the_corners_of_a_turned_photo_are_margins(margin: int) -> None:
    scene = render_aerial("suburb", 21, size=256).image
    image, matrix = turned(scene, margin)
    inside = cv2.warpAffine(np.ones((256, 256), np.uint8), matrix, (256, 256)) > 0
    assert nodata(scene) is None
    found = nodata(image)
    assert found is not None
    assert (found != inside).mean() > 0.98
    assert picture_kind(image).name == PHOTO


def test_what_lies_beyond_the_margin_does_not_change_the_light() -> None:
    scene = render_aerial("suburb", 21, size=256).image
    wide = cv2.copyMakeBorder(scene, 64, 64, 64, 64, cv2.BORDER_CONSTANT)
    plain, beside = even_exposure(scene), even_exposure(wide)[64:-64, 64:-64]
    assert np.abs(plain.astype(int) - beside)[64:-64, 64:-64].mean() < 6


def test_roads_are_found_between_margins_and_none_in_them() -> None:
    scene = render_aerial("curve", 904, size=320)
    image, _ = turned(scene.image, 0)
    margin = nodata(image)
    assert margin is not None
    deep = cv2.erode(margin.astype(np.uint8), np.ones((25, 25), np.uint8)) > 0
    found = roads_of_photo(image)
    assert sum(road.length for road in found.roads) > 150
    for road in found.roads:
        x, y = np.clip(road.points.round().astype(int), 0, 319).T
        assert not deep[y, x].any()


def test_paper_is_no_margin_of_a_photo() -> None:
    assert picture_kind(draw_circuit(3, 400).image).drawn


@pytest.mark.parametrize("gain", [0.35, 0.6, 1.5])
def test_a_dim_or_soft_photo_stays_a_photo(gain: float) -> None:
    scene = render_aerial("rural", 5, size=200).image
    soft = cv2.resize(scene, None, fx=3, fy=3, interpolation=cv2.INTER_CUBIC)
    dim = np.clip((soft.astype(float) - 128) * gain + 128, 0, 255).astype(np.uint8)
    assert picture_kind(dim).name == PHOTO


def test_white_land_at_the_rim_of_a_map_is_no_margin_of_a_photo() -> None:
    plan = np.full((300, 400, 3), 255, np.uint8)
    y, x = np.mgrid[:180, :240]
    plan[60:240, 80:320][(x + y) % 6 == 0] = 150  # a park, hatched
    plan[:, 150:157] = plan[140:147] = 0
    assert picture_kind(plan).name != PHOTO


@pytest.mark.parametrize(("side", "is_margin"), [(10, False), (40, True)])
def test_a_dark_corner_is_a_margin_only_where_it_is_large(side: int, is_margin: bool) -> None:
    """A thousandth of the picture may be a shadow; a fortieth is a cut-off corner."""
    image = np.full((256, 256, 3), 120, np.uint8)
    image[:side, :side] = 0
    assert (nodata(image) is not None) == is_margin


def test_a_sliver_along_the_rim_is_a_margin_and_its_edge_no_road() -> None:
    """A photo that was turned by half a degree has a wedge of a few pixels beside it."""
    scene = render_aerial("rural", 5, size=320).image
    image = scene.copy()
    wedge = np.array([[40, 320], [319, 316], [319, 320]], np.int32)
    cv2.fillPoly(image, [wedge], (255, 255, 255))
    margin = nodata(image)
    assert nodata(scene) is None
    assert margin is not None
    assert margin[-1, 250:].all()
    assert not margin[:300].any()
    for road in roads_of_photo(image).roads:
        at_wedge = (road.points[:, 1] > 308) & (road.points[:, 0] > 60)
        assert at_wedge.mean() < 0.2
