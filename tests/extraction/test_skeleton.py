"""Thinning keeps what is connected connected, and leaves lines one pixel wide in the middle."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np
from hypothesis import given
from hypothesis.extra.numpy import arrays

from roadlang_standard.extraction.skeleton import skeleton


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
