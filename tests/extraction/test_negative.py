"""Photos whose roads are dark on light ground, as in snow, are also looked at as negatives."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
import pytest

from benchmarks.extraction.conditions import gray_infrared, snow
from benchmarks.extraction.scores import Case, relaxed_f1
from roadlang_standard.extraction.networks.found_network import FoundNetwork, FoundRoad
from roadlang_standard.extraction.photos.aerial import Request, _worth
from roadlang_standard.extraction.photos.crosscheck import checked_roads
from roadlang_standard.extraction.photos.negative import exposures
from roadlang_standard.extraction.photos.road_net import road_net
from training.rendering.aerial import render_aerial

EXAMPLES = Path(__file__).parents[2] / "examples"


def seen(sure: float, length: float) -> FoundNetwork:
    """One straight road."""
    line = np.array([(0.0, 5.0), (length, 5.0)])
    road = FoundRoad(0, 1, line, np.full(2, 8.0), confidence=sure)
    return FoundNetwork(line, (road,), np.zeros((10, 2000), bool))


def test_a_summer_photo_in_color_is_looked_at_as_it_is() -> None:
    for name in ("village.jpg", "hairpin.jpg"):
        image = cv2.imread(str(EXAMPLES / name))
        (look,) = exposures(image)
        assert look is image


def test_light_ground_is_also_looked_at_as_a_gray_negative() -> None:
    image = np.full((64, 64, 3), (250, 230, 240), np.uint8)
    image[30:34] = (40, 50, 60)
    itself, negative = exposures(image)
    assert itself is image
    assert (np.ptp(negative, axis=2) == 0).all()
    assert negative[32, 5, 0] > 190 > 40 > negative[5, 5, 0]


def test_margins_without_data_are_no_dark_roads() -> None:
    image = cv2.imread(str(EXAMPLES / "village.jpg"))
    image = np.clip(image.astype(int) // 3 + 150, 0, 255).astype(np.uint8)
    image[:, :40] = 0
    assert len(exposures(image)) == 1


def test_a_gray_photo_is_also_looked_at_as_its_negative() -> None:
    gray = cv2.cvtColor(cv2.imread(str(EXAMPLES / "village.jpg")), cv2.COLOR_BGR2GRAY)
    image, negative = exposures(cv2.merge([gray] * 3))
    assert (negative == 255 - image).all()


def test_one_tone_has_one_look() -> None:
    assert len(exposures(np.full((32, 32, 3), (10, 200, 90), np.uint8))) == 1


@pytest.mark.parametrize(
    ("sure", "length", "is_better"),
    [(0.8, 1000.0, True), (0.5, 1500.0, False)],
)
def test_an_exposure_is_better_by_sure_roads_and_a_little_by_long_ones(
    sure: float, length: float, is_better: bool
) -> None:
    assert (_worth(seen(sure, length)) > _worth(seen(0.9, 100.0))) is is_better
    assert _worth(seen(sure, length)) < _worth(seen(0.95, 1000.0))


def test_plowed_roads_are_found_in_snow() -> None:
    rendering = render_aerial("suburb", 88001, 320)
    image = snow(rendering, 1)
    found = checked_roads(image, Request(), road_net())
    case = Case.of_lines(image, [np.asarray(line) for line in rendering.truth.polylines()])
    assert relaxed_f1(case, [road.points for road in found.roads]) > 0.8


def test_infrared_is_gray_and_shows_plants_brighter_than_roads() -> None:
    rendering = render_aerial("suburb", 88001, 320)
    image = gray_infrared(rendering, 1).astype(int)
    road = rendering.truth.mask() > 0
    assert image[road].mean() < image[~road].mean() - 20
