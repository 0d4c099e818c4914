"""The parts of a mask: the same, whether all pixels are looked at, or runs, or those in doubt."""

import cv2
import numpy as np
import pytest
from scipy.ndimage import label

from roadlang_standard.extraction.drawings.road_regions import (
    PaperParts,
    _may_be_long,
    road_regions,
)
from roadlang_standard.extraction.masks.mask_parts import (
    _may_have_small_parts,
    areas_of,
    boxes_of,
    opened_by_square,
    parts_and_boxes,
    parts_of,
    small_parts,
    where_parts,
)


def drawn(share: float) -> np.ndarray:
    """Spots on (300, 400) pixels, and a large square that holds some of the paper."""
    rng = np.random.default_rng(7)
    mask = rng.random((300, 400)) < share
    mask[50:250, 60:300] = True
    mask[100:200, 100:200] = False
    return mask


@pytest.mark.parametrize("most", [2, 12, 5000])
@pytest.mark.parametrize("diagonal", [False, True])
@pytest.mark.parametrize("share", [0.0, 0.02, 0.5, 0.98])
def test_small_parts_are_those_of_fewer_pixels(share: float, diagonal: bool, most: int) -> None:
    mask = drawn(share)
    labels, _ = label(mask, np.ones((3, 3)) if diagonal else None)
    few = np.bincount(labels.ravel()) < most
    few[0] = False
    found = small_parts(mask, most, 8 if diagonal else 4)
    assert np.array_equal(np.zeros_like(mask) if found is None else found, few[labels])
    assert (found is None) == (not few.any())


@pytest.mark.parametrize("diagonal", [False, True])
@pytest.mark.parametrize("share", [0.0, 0.01, 0.5, 1.0])
def test_boxes_and_areas_are_those_of_opencv(share: float, diagonal: bool) -> None:
    mask = drawn(share)
    near = 8 if diagonal else 4
    count, labels, boxes = parts_and_boxes(mask, near)
    expected, seen, stats, _ = cv2.connectedComponentsWithStats(
        mask.view(np.uint8), connectivity=near
    )
    assert count == expected
    assert np.array_equal(labels, seen)
    assert np.array_equal(boxes[1:], stats[1:])
    assert (boxes_of(labels, count) is None) == (share == 0.5)  # so many runs take longer


@pytest.mark.parametrize("share", [0.0, 0.01, 0.5, 1.0])
def test_parts_are_chosen_and_counted_by_runs_as_by_pixels(share: float) -> None:
    count, labels = parts_of(drawn(share))
    chosen = np.arange(count) % 3 == 1
    assert np.array_equal(where_parts(chosen, labels), chosen[labels])
    assert np.array_equal(areas_of(labels, count), np.bincount(labels.ravel()))


def test_only_pictures_with_a_long_part_are_searched_for_roads_between_lines() -> None:
    ring, filled = (np.zeros((400, 500), np.uint8) for _ in range(2))
    for size in (120, 150):
        cv2.ellipse(ring, (250, 200), (size + 60, size), 0, 0, 360, 1, 3)
    cv2.line(filled, (0, 180), (499, 260), 1, 24)
    for page in (ring, filled):
        cv2.circle(page, (40, 40), 9, 1, 2)  # as in a letter: measured alone
    for page, expected in ((ring, True), (filled, False)):
        ink = page > 0
        labels, count = PaperParts.about(ink).labels, PaperParts.about(ink).count
        rim = np.concatenate([labels[0], labels[-1], labels[:, 0], labels[:, -1]])
        rims = np.bincount(rim, minlength=count)
        assert _may_be_long(ink, labels, areas_of(labels, count), rims) == expected
        assert bool(road_regions(ink)) == expected


@pytest.mark.parametrize("connectivity", [4, 8])
def test_outlines_tell_that_no_part_is_small(connectivity: int) -> None:
    large, spot, cut_off, hole = (np.zeros((60, 80), np.uint8) for _ in range(4))
    for mask in (large, spot, cut_off, hole):
        cv2.line(mask, (0, 30), (79, 34), 1, 12)
    spot[5, 5:8] = 1
    cv2.line(cut_off, (0, 1), (1, 0), 1)  # what is in the picture's corner is no hole within it
    hole[30:32, 40] = 0
    masks = [mask > 0 for mask in (large, spot, cut_off, hole)]
    found = [_may_have_small_parts(mask, 8, connectivity) for mask in masks]
    assert found == [False, True, True, False]
    found = [_may_have_small_parts(~mask, 8, connectivity) for mask in masks]
    assert found == [False, False, connectivity == 4, True]


def test_what_a_square_opens_stays_where_it_is() -> None:
    """With squares of an even side, too."""
    strip = np.zeros((20, 20), bool)
    strip[:, 4:8] = True
    barbed = strip.copy()
    barbed[5, 8:14] = True
    for size in (2, 3, 4):
        assert (opened_by_square(barbed, size) == strip).all()
    assert not opened_by_square(barbed, 5).any()
