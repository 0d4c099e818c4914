"""Which wide roads have a median, and where along them: of roads that are known."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from roadlang_standard.extraction.networks.found_network import FoundNetwork, FoundRoad
from roadlang_standard.extraction.photos.divided_roads import with_medians
from roadlang_standard.extraction.photos.photo_evidence import Seen

HIGH, WIDE, MIDDLE = 100, 256, 40
GRASS, ASPHALT = (60, 110, 80), (120, 120, 120)


def level(row: int, width: float, begin: int = 0, end: int = WIDE) -> FoundRoad:
    """A road from left to right."""
    along = np.arange(float(begin), end)
    points = np.column_stack([along, np.full(len(along), float(row))])
    return FoundRoad(0, 1, points, np.full(len(along), width))


def photo(width: int = 22, median: int = 4, off: int = 0) -> Any:
    """A road on grass, with grass in the middle of it, or pixels below its middle."""
    picture = np.full((HIGH, WIDE, 3), GRASS, np.uint8)
    picture[MIDDLE - width // 2 : MIDDLE + width // 2 + 1] = ASPHALT
    top = MIDDLE + off - median // 2
    picture[top : top + median] = GRASS
    return picture


def cleared(picture: Any, road: FoundRoad, usual: float = 8.0) -> Any:
    """Of which pixels (h, w) the evidence is gone, where most roads have the usual width."""
    roads = (road, level(75, usual), level(90, usual))
    surface = np.ones((HIGH, WIDE), np.float32)
    nodes = np.array([[0.0, MIDDLE], [WIDE, MIDDLE]])
    found = FoundNetwork(nodes, roads, np.zeros((HIGH, WIDE), bool))
    divided = with_medians(picture, Seen(surface, surface), found)
    return np.zeros((HIGH, WIDE), bool) if divided is None else divided.surface == 0


@pytest.mark.parametrize(
    ("width", "usual", "is_examined"),
    [
        (16, 8, True), (14, 8, False),  # a narrow road has no room for a median
        (28, 8, True), (32, 8, False),  # an avenue of a finer photo
        (18, 12, True), (16, 12, False),  # hardly wider than the others
        (24, 16, False),  # where the others are wide, the photo is finer
    ],
)  # fmt: skip
def test_roads_of_some_widths_are_examined(width: int, usual: int, is_examined: bool) -> None:
    assert cleared(photo(width), level(MIDDLE, width), usual).any() == is_examined


@pytest.mark.parametrize(
    ("road", "median", "is_long"),
    [(256, 60, True), (256, 20, False), (34, 34, True), (22, 22, False)],
)
def test_a_median_is_long_or_most_of_a_short_road(road: int, median: int, is_long: bool) -> None:
    picture = photo()
    picture[MIDDLE - 3 : MIDDLE + 4, median:] = ASPHALT
    found = cleared(picture, level(MIDDLE, 22.0, end=road))
    assert found.any() == is_long


@pytest.mark.parametrize(("gap", "is_bridged"), [(18, True), (50, False)])
def test_a_median_goes_on_across_a_crosswalk(gap: int, is_bridged: bool) -> None:
    picture = photo()
    picture[MIDDLE - 3 : MIDDLE + 4, 120 : 120 + gap] = ASPHALT
    found = cleared(picture, level(MIDDLE, 22.0))
    assert found[MIDDLE, 20:100].all()
    assert found[MIDDLE, 120 + gap // 2] == is_bridged


@pytest.mark.parametrize("off", [-3, 0, 3])
def test_the_strip_lies_where_the_median_does(off: int) -> None:
    found = cleared(photo(off=off), level(MIDDLE, 22.0))
    rows = np.flatnonzero(found[:, WIDE // 2])
    assert rows.mean() == pytest.approx(MIDDLE + off, abs=1.0)


@pytest.mark.parametrize(("lighter", "is_seen"), [(5, False), (20, True)])
def test_a_median_differs_from_the_carriageways(lighter: int, is_seen: bool) -> None:
    picture = photo()
    picture[MIDDLE - 2 : MIDDLE + 2] = np.add(ASPHALT, lighter)
    assert cleared(picture, level(MIDDLE, 22.0)).any() == is_seen


def test_the_edge_of_a_shadow_and_wheel_tracks_are_no_medians() -> None:
    shaded, worn = photo(median=0), photo(median=0)
    shaded[:MIDDLE] //= 2
    for row in range(MIDDLE - 11, MIDDLE + 12):
        worn[row] = np.add(ASPHALT, 25 if row // 3 % 2 else -25)
    for picture in (shaded, worn):
        assert not cleared(picture, level(MIDDLE, 22.0)).any()


def test_noise_of_the_photo_neither_hides_a_median_nor_looks_like_one() -> None:
    """Colors are averaged along the road."""
    noise = np.random.default_rng(1).normal(0.0, 40.0, (HIGH, WIDE, 3))
    divided, plain = (
        (photo(median=median) + noise).clip(0, 255).astype(np.uint8) for median in (4, 0)
    )
    assert cleared(divided, level(MIDDLE, 22.0))[MIDDLE, 20:-20].all()
    assert not cleared(plain, level(MIDDLE, 22.0)).any()
