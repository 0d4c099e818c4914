"""Photos: rendered scenes with known truth, shaded and covered; light, hints, tiles."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from roadlang_standard.extraction.photos.aerial import Request, roads_of_evidence, roads_of_photo
from roadlang_standard.extraction.photos.exposure import even_exposure, even_view
from roadlang_standard.extraction.photos.photo_evidence import Seen
from roadlang_standard.extraction.photos.road_net import evidence, road_net
from training.rendering.aerial import render_aerial


def main_road(found: Any) -> Any:
    return max(found.roads, key=lambda road: road.length)


def inner(points: Any, size: Any, margin: int = 8) -> Any:
    return points[(points > margin).all(axis=1) & (points < size - margin).all(axis=1)]


@pytest.mark.parametrize("seed", [901, 903, 904])
def test_a_road_that_is_30_percent_hidden_is_found(seed: int, distance_to: Any) -> None:
    scene = render_aerial("curve", seed, size=320, hidden=0.3)
    (true,) = scene.truth.roads
    road = main_road(roads_of_photo(scene.image))
    assert distance_to(inner(road.points, 320), true.points).mean() < 1.0
    assert distance_to(inner(true.points, 320), road.points).max() < 12
    assert abs(np.median(road.widths) / true.width - 1) < 0.2


@pytest.mark.parametrize("asphalt", [0.2, 0.35])
def test_a_dark_road_is_found(asphalt: float, distance_to: Any) -> None:
    scene = render_aerial("bend", 12, size=320, asphalt=asphalt)
    (true,) = scene.truth.roads
    road = main_road(roads_of_photo(scene.image))
    assert distance_to(inner(true.points, 320), road.points).mean() < 3


def test_brightness_and_contrast_do_not_matter() -> None:
    scene = render_aerial("suburb", 21, size=256).image
    dim = np.clip(scene * 0.6, 0, 255).astype(np.uint8)
    difference = even_exposure(scene).astype(int) - even_exposure(dim)
    assert np.abs(difference).mean() < 2.5


def test_tiles_leave_no_seam(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("roadlang_standard.extraction.photos.road_net._TILE", 320)
    scene = render_aerial("suburb", 8, size=460).image
    net = road_net().predict
    whole, part = (
        evidence(even_view(np.ascontiguousarray(shown)), net, mirrored=False)
        for shown in (scene, scene[100:400, 100:400])
    )
    gap = np.abs(whole[200:380, 200:380] - part[100:280, 100:280])
    assert gap.mean() < 0.005


def test_two_clicks_draw_a_road_where_none_is_seen() -> None:
    rng = np.random.default_rng(0)
    meadow = rng.integers(90, 110, (200, 260, 3)).astype(np.uint8)
    assert not any(road.confidence > 0.9 for road in roads_of_photo(meadow).roads)
    clicks = ((20.0, 100.0), (240.0, 120.0))
    found = roads_of_photo(meadow, Request(through=clicks, width=8.0, only_through=True))
    (road,) = found.roads
    ends = sorted([tuple(road.points[0]), tuple(road.points[-1])])
    assert np.hypot(*(np.array(ends) - clicks).T).max() < 12
    assert (road.widths == 8).all()


def test_one_point_is_enough_where_all_roads_are_faint() -> None:
    faint = np.zeros((120, 160), np.float32)
    faint[55:63] = 0.6
    seen = Seen(faint, faint)
    found = roads_of_evidence(seen, Request(through=((20.0, 40.0),), only_through=True))
    (road,) = found.roads
    assert road.points[:, 1] == pytest.approx(59.0, abs=20.0)
    dark = Seen(np.zeros_like(faint), np.zeros_like(faint))
    assert roads_of_evidence(dark, Request(through=((20.0, 40.0),), only_through=True)).roads == ()


def test_what_is_boxed_out_stays_out() -> None:
    scene = render_aerial("grid", 5, size=256)
    box = ((0.0, 0.0), (128.0, 255.0))
    found = roads_of_photo(scene.image, Request(leave_out=(box,)))
    assert found.roads
    assert min(road.points[:, 0].min() for road in found.roads) > 110
