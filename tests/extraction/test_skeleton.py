"""Thinning keeps what is connected connected, and leaves lines one pixel wide in the middle."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np
import pytest
from hypothesis import given
from hypothesis.extra.numpy import arrays

from roadlang_standard.extraction.masks.skeleton import skeleton, widths_across


def test_a_thick_bar_becomes_its_middle_row() -> None:
    mask = np.zeros((21, 80), bool)
    mask[6:15, 10:70] = True
    thin = skeleton(mask)
    assert thin[10, 18:62].all()
    assert thin.sum() == thin[10].sum()


def test_a_ring_stays_a_ring() -> None:
    mask = np.zeros((80, 80), np.uint8)
    cv2.circle(mask, (40, 40), 25, 1, 7)
    thin = skeleton(mask > 0)
    holes = cv2.connectedComponents((~thin).astype(np.uint8), connectivity=4)[0] - 1
    assert holes == 2
    radius = np.hypot(*(np.argwhere(thin) - 40).T)
    assert abs(radius - 25).max() < 1.5


@given(arrays(bool, (14, 17)))
def test_any_mask_keeps_its_parts(mask: Any) -> None:
    thin = skeleton(mask)
    assert not (thin & ~mask).any()
    parts = [cv2.connectedComponents(m.astype(np.uint8), connectivity=8)[0] for m in (mask, thin)]
    assert parts[0] == parts[1]


def _one_by_one(mask: np.ndarray) -> np.ndarray:
    """Thinning by the rules as they are written (Guo and Hall 1989), for each pixel of a mask."""
    thin = np.pad(mask, 1)
    changed = True
    while changed:
        changed = False
        for odd in (False, True):
            doomed = [(y, x) for y, x in np.argwhere(thin) if _may_go(thin, y, x, odd)]
            for place in doomed:
                thin[place] = False
            changed |= bool(doomed)
    return thin[1:-1, 1:-1]


def _may_go(thin: np.ndarray, y: int, x: int, odd: bool) -> bool:
    ring = ((-1, 0), (-1, 1), (0, 1), (1, 1), (1, 0), (1, -1), (0, -1), (-1, -1))
    p2, p3, p4, p5, p6, p7, p8, p9 = (bool(thin[y + dy, x + dx]) for dy, dx in ring)
    pairs = ((p2, p3, p4), (p4, p5, p6), (p6, p7, p8), (p8, p9, p2))
    crossings = sum(not a and (b or c) for a, b, c in pairs)
    first = (p9 or p2) + (p3 or p4) + (p5 or p6) + (p7 or p8)
    second = (p2 or p3) + (p4 or p5) + (p6 or p7) + (p8 or p9)
    kept = (p2 or p3 or not p5) and p4 if odd else (p6 or p7 or not p9) and p8
    return crossings == 1 and 2 <= min(first, second) <= 3 and not kept


def test_the_rules_are_kept_to_the_pixel() -> None:
    rng = np.random.default_rng(5)
    for blur in (0.8, 1.5, 3.0):
        mask = cv2.GaussianBlur(rng.normal(0, 1, (60, 70)), (0, 0), blur) > 0
        assert (skeleton(mask) == _one_by_one(mask)).all()
    full = np.ones((9, 31), bool)
    assert (skeleton(full) == _one_by_one(full)).all()


def test_a_stroke_is_as_wide_as_the_depth_of_its_middle_says() -> None:
    stroke = np.zeros((40, 60), np.uint8)
    stroke[10:17, 5:55] = 1
    depths = cv2.distanceTransform(stroke, cv2.DIST_L2, 5)[13, 12:48]
    assert widths_across(depths, (0.1, 0.5)) == pytest.approx([7.0, 7.0], abs=0.05)
