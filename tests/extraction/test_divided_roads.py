"""A wide road with a visible median is two roads; markings and other wide roads are one."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np
import pytest

from roadlang_standard.extraction.networks.found_network import FoundNetwork
from roadlang_standard.extraction.photos.aerial import Request, roads_of_evidence, roads_of_photo
from roadlang_standard.extraction.photos.chroma import mean_chroma
from roadlang_standard.extraction.photos.divided_roads import _median, with_medians
from roadlang_standard.extraction.photos.photo_confidence import CHROMA
from roadlang_standard.extraction.photos.photo_evidence import Seen
from roadlang_standard.extraction.photos.road_net import Net

SIZE, MIDDLE, WIDTH = 256, 90, 22
GRASS, ASPHALT = (60, 110, 80), (120, 120, 120)


def scene(median: float = 4, usual: int = 8, width: int = WIDTH) -> tuple[Any, Any]:
    """A wide road from left to right with a median (pixels), three usual ones below it, and the
    surface that a net would see: no median in it."""
    picture = np.full((SIZE, SIZE, 3), GRASS, np.uint8)
    surface = np.zeros((SIZE, SIZE), np.float32)
    for row, wide in ((MIDDLE, width), (150, usual), (190, usual), (230, usual)):
        top, bottom = row - wide // 2, row + wide // 2
        picture[top:bottom] = ASPHALT
        surface[top:bottom] = 0.95
    large = cv2.resize(picture, None, fx=4, fy=4, interpolation=cv2.INTER_NEAREST)
    half = round(2 * median)
    large[4 * MIDDLE - half : 4 * MIDDLE + half] = GRASS
    picture = cv2.resize(large, (SIZE, SIZE), interpolation=cv2.INTER_AREA)
    noise = np.random.default_rng(0).normal(0, 4, picture.shape)
    return np.clip(picture + noise, 0, 255).astype(np.uint8), surface


def near_the_wide_road(found: FoundNetwork) -> list[float]:
    """The heights of the roads that run along it, from the top."""
    heights = [float(np.median(road.points[:, 1])) for road in found.roads]
    return sorted(height for height in heights if height < MIDDLE + WIDTH)


def found_in(picture: Any, surface: Any) -> tuple[FoundNetwork, Seen | None]:
    seen = Seen(surface, surface)
    found = roads_of_evidence(seen)
    return found, with_medians(picture, seen, found)


@pytest.mark.parametrize("turned", [False, True])
def test_a_median_parts_a_wide_road(turned: bool) -> None:
    picture, surface = scene()
    if turned:
        picture, surface = picture.transpose(1, 0, 2).copy(), surface.T.copy()
    found, divided = found_in(picture, surface)
    assert divided is not None
    apart = roads_of_evidence(divided)
    assert len(apart.roads) == len(found.roads) + 1
    axis = 0 if turned else 1
    heights = sorted(float(np.median(road.points[:, axis])) for road in apart.roads)[:2]
    assert heights == pytest.approx([MIDDLE - 7, MIDDLE + 7], abs=2)


def test_only_the_strip_of_the_median_loses_its_evidence() -> None:
    picture, surface = scene()
    divided = found_in(picture, surface)[1]
    assert divided is not None
    cleared = np.flatnonzero((divided.surface != surface).any(axis=1))
    assert MIDDLE - 5 <= cleared[0] < cleared[-1] <= MIDDLE + 5
    assert (divided.surface[cleared[0] : cleared[-1] + 1, 20:-20] == 0).all()


@pytest.mark.parametrize(
    ("median", "usual", "width"),
    [(0, 8, WIDTH), (0.25, 8, WIDTH), (4, 18, WIDTH), (4, 8, 12), (8, 8, 40)],
    ids=["plain", "a painted line", "wide like the others", "narrow", "an avenue of a finer photo"],
)
def test_other_roads_stay_one(median: float, usual: int, width: int) -> None:
    assert found_in(*scene(median, usual, width))[1] is None


def test_a_median_is_where_it_is_seen() -> None:
    picture, surface = scene()
    picture[MIDDLE - 2 : MIDDLE + 2, SIZE // 2 :] = ASPHALT
    divided = found_in(picture, surface)[1]
    assert divided is not None
    gone = np.flatnonzero((divided.surface != surface).any(axis=0))
    assert gone[0] < 20
    assert SIZE // 2 - 25 < gone[-1] < SIZE // 2 + 25


def test_where_four_roads_meet_there_is_no_median() -> None:
    picture, surface = scene()
    surface[:, 124:132] = 0.95
    divided = found_in(picture, surface)[1]
    assert divided is not None
    assert (divided.surface[MIDDLE - 4 : MIDDLE + 4, 124:132] > 0).all()
    assert (divided.surface[MIDDLE, 40:100] == 0).all()


def test_no_roads_no_medians() -> None:
    picture, surface = scene()
    assert found_in(picture, np.zeros_like(surface))[1] is None


def test_photos_are_read_this_way_and_a_given_width_is_believed() -> None:
    picture, _ = scene()

    def gray_is_road(tile: Any) -> Any:
        """A net that takes what is gray for road, and medians up to 6 px as well."""
        spread = tile.max(axis=2).astype(int) - tile.min(axis=2)
        gray = cv2.morphologyEx((spread < 35).astype(np.uint8), cv2.MORPH_CLOSE, np.ones((7, 7)))
        return np.repeat(0.95 * gray[None, ::2, ::2], 2, axis=0).astype(np.float32)

    net = Net(gray_is_road, "")
    found = roads_of_photo(picture, net=net)
    assert len(near_the_wide_road(found)) == 2
    assert found.scores[CHROMA] == pytest.approx(mean_chroma(picture), abs=0.01)
    told = Request(width=20.0)
    assert len(near_the_wide_road(roads_of_photo(picture, told, net))) == 1


@pytest.mark.parametrize(("width", "clear"), [(20.0, 3), (29.0, 4)])
def test_what_blends_into_a_median_is_no_part_of_the_carriageways(width: float, clear: int) -> None:
    """Beside the strip of three pixels it is blurred, the more the wider the road is."""
    colors = np.full((30, 2 * 15 + 1, 3), 120.0)
    middle = colors.shape[1] // 2
    colors[:, middle - 1 : middle + 2] = 160.0
    plain = _median(colors, width)
    blended = colors.copy()
    for away in range(2, clear):
        blended[:, [middle - away, middle + away]] = 140.0
    assert np.array_equal(_median(blended, width).contrast, plain.contrast)
    blended[:, [middle - clear, middle + clear]] = 140.0
    assert (_median(blended, width).contrast < plain.contrast).all()
