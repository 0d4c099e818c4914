"""Pictures that our own renderer did not make: bare ground, a painted road, discs of shade."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np
import pytest

from roadlang_standard.extraction.photos.aerial import Request
from roadlang_standard.extraction.photos.crosscheck import checked_roads
from roadlang_standard.extraction.photos.road_net import road_net

SIZE = 400
PEN = 1.4  # OpenCV draws an anti-aliased line so much wider than it is told


def painted(seed: Any, road: Any, ground: Any, width: Any, shaded: float = 0.0) -> Any:
    """A picture (h, w, 3), and the center line (n, 2) of its one road."""
    rng = np.random.default_rng(seed)
    patches = cv2.GaussianBlur(rng.standard_normal((SIZE, SIZE)).astype(np.float32), (0, 0), 20)
    image = np.array(ground) * (1 + 0.08 * patches / patches.std())[..., None]
    turn = rng.uniform(0, np.pi)
    along = np.linspace(-0.8, 0.8, 400) * SIZE
    line = np.c_[along, 45 * np.sin(along / 90 + rng.uniform(0, 6))]
    line = line @ np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]]) + SIZE / 2
    cover = np.zeros((SIZE, SIZE), np.uint8)
    at = [np.round(line * 16).astype(np.int32)]
    cv2.polylines(cover, at, False, 255, width, cv2.LINE_AA, 4)
    image += (cover / 255.0)[..., None] * (np.array(road) - image)
    line = line[((line > 2) & (line < SIZE - 3)).all(axis=1)]
    image *= 1 - 0.55 * _shade(rng, line, width, shaded)[..., None]
    noisy = image + rng.normal(0, 4, image.shape)
    return np.clip(noisy, 0, 255).astype(np.uint8), line


def _shade(rng: Any, line: Any, width: Any, share: Any) -> Any:
    """Discs along the road until so much of it lies under them."""
    shade = np.zeros((SIZE, SIZE), np.float32)
    x, y = line.round().astype(int).T
    while (shade[y, x] > 0.5).mean() < share:
        middle = line[rng.integers(len(line))] + rng.normal(0, 0.3 * width, 2)
        cv2.circle(shade, tuple(middle.round().astype(int).tolist()), int(0.9 * width), 1.0, -1)
    return cv2.GaussianBlur(shade, (0, 0), 1)


GROUNDS = {"meadow": (60, 110, 80), "sand": (140, 170, 180), "night": (50, 70, 55)}


@pytest.mark.parametrize("ground", GROUNDS)
@pytest.mark.parametrize("gray", [30, 110, 200])
def test_a_clear_road_is_found_whether_dark_or_bright(
    ground: str, gray: int, distance_to: Any
) -> None:
    image, line = painted(gray, (gray,) * 3, GROUNDS[ground], 9)
    roads = checked_roads(image, Request(), road_net()).roads
    away = np.min([distance_to(line, road.points) for road in roads], axis=0)
    assert (away < 3).mean() > 0.9


@pytest.mark.parametrize("seed", range(4))
def test_a_road_with_a_third_in_shadow_is_one_road(seed: int, distance_to: Any) -> None:
    image, line = painted(seed, (105, 105, 110), GROUNDS["meadow"], 10, shaded=0.33)
    (road,) = checked_roads(image, Request(), road_net()).roads
    away = distance_to(line, road.points)
    assert away.mean() < 1
    assert (away < 4).mean() > 0.95
    assert np.median(road.widths) == pytest.approx(10 + PEN, rel=0.12)
