"""How much of a surface its roads explain: a chessboard is no road of even width."""

from __future__ import annotations

from collections.abc import Sequence

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans

from .found_network import FoundRoad

_FINE = 3
"""Bits of the fraction of a pixel to which lines are drawn."""


def explained_shares(mask: Booleans, parts: Sequence[Sequence[FoundRoad]]) -> list[float]:
    """Of what each part of a network lies on in a mask (h, w), the share within half a width, and a
    pixel, of any road; 1 where it lies on nothing."""
    _, labels, stats, _ = cv2.connectedComponentsWithStats(mask.view(np.uint8), connectivity=8)
    drawn = np.zeros(mask.shape, np.uint8)
    for part in parts:
        for road in part:
            wide = max(1, round(float(np.median(road.widths)))) + 2
            line = np.round(road.points * 2**_FINE).astype(np.int32)
            cv2.polylines(drawn, [line], False, 1, wide, cv2.LINE_8, _FINE)
    near = np.bincount(labels[(drawn > 0) & mask], minlength=len(stats))
    shares = []
    for part in parts:
        on = np.unique(np.concatenate([_labels_along(road, labels) for road in part]))
        on = on[on > 0]
        area = int(stats[on, cv2.CC_STAT_AREA].sum())
        shares.append(float(near[on].sum() / area) if area else 1.0)
    return shares


def _labels_along(road: FoundRoad, labels: NDArray[np.int32]) -> NDArray[np.int32]:
    """The labels (n,) of the pixels (h, w) along a road."""
    last = (labels.shape[1] - 1, labels.shape[0] - 1)
    columns, rows = np.clip(np.round(road.points).astype(int), 0, last).T
    return np.asarray(labels[rows, columns])
