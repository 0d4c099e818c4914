"""At which sizes a photo is looked at, and which specks of a mask are noise."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np
import pytest

from roadlang_standard.extraction.masks.mask_parts import without_holes, without_specks
from roadlang_standard.extraction.networks.found_network import FoundNetwork, FoundRoad
from roadlang_standard.extraction.photos import aerial
from roadlang_standard.extraction.photos.aerial import Request, roads_of_photo
from roadlang_standard.extraction.photos.scale import resized, view_scales
from training.rendering.aerial import render_aerial


def photo(height: int = 800, width: int = 1000) -> np.ndarray:
    return np.random.default_rng(3).integers(0, 255, (height, width, 3), dtype=np.uint8)


@pytest.mark.parametrize(
    ("meters_per_pixel", "scales"),
    [
        (0.3, (1.0, 1 / 3)),
        (0.18, (0.6, 0.2)),
        (0.01, (0.3, 0.1)),
        (0.7, (1.0,)),
        (0.9, (1.0,)),
        (5.0, (1.0,)),
    ],
)
def test_a_photo_of_high_resolution_is_looked_at_smaller_too_and_none_larger(
    meters_per_pixel: float, scales: tuple[float, ...]
) -> None:
    assert view_scales(photo(), meters_per_pixel) == pytest.approx(scales, rel=1e-3)


def test_a_small_photo_keeps_64_pixels() -> None:
    assert view_scales(photo(160, 400), 0.09) == pytest.approx((1.0, 64 / 160))
    assert view_scales(photo(60, 400), 0.09) == (1.0,)


def test_a_photo_without_fine_detail_is_looked_at_in_half_its_size_too() -> None:
    assert view_scales(photo()) == (1.0,)
    assert view_scales(resized(photo(300, 300), 4.0)) == (1.0, 0.5)


def test_a_stated_resolution_or_blur_does_not_hide_roads() -> None:
    scene = render_aerial("curve", 904, size=320)
    length = _length(roads_of_photo(scene.image))
    assert length > 150
    stated = roads_of_photo(scene.image, Request(meters_per_pixel=0.3))
    assert _length(stated) > 0.8 * length
    assert _length(roads_of_photo(cv2.GaussianBlur(scene.image, (0, 0), 2))) > 0.8 * length


def _length(found: FoundNetwork) -> float:
    return sum(road.length for road in found.roads)


@pytest.mark.parametrize(("least", "filled"), [(9, False), (10, True)])
def test_a_hole_of_as_many_pixels_as_asked_for_stays(least: int, filled: bool) -> None:
    mask = np.ones((20, 20), bool)
    mask[5:8, 5:8] = False
    assert without_holes(mask, least).all() == filled
    assert without_specks(~mask, least).any() != filled


def test_a_smaller_view_is_better_only_where_its_roads_are_surer(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """However long they are: narrow roads are missed in it, and others run together."""

    def viewed(image: Any, scale: float, request: Any, net: Any) -> FoundNetwork:
        line = np.array([(0.0, 5.0), (300.0 / scale, 5.0)])
        road = FoundRoad(0, 1, line, np.full(2, 8.0), confidence=0.75 + 0.1 * scale)
        return FoundNetwork(line, (road,), np.zeros((64, 64), bool), scores={"scale": scale})

    monkeypatch.setattr(aerial, "_view", viewed)
    monkeypatch.setattr(aerial, "view_scales", lambda image, meters: (1.0, 0.1))
    image = np.full((64, 64, 3), (60, 110, 80), np.uint8)
    net: Any = object()
    assert aerial.roads_of_photo(image, net=net).scores["scale"] == 1.0
