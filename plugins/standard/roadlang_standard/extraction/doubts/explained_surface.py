"""What of a surface its roads explain, and how much of the picture's rim it is: a chessboard is no
road of even width, and what surrounds all that is drawn is its ground."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TypeVar

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans

from ..colors.fast_median import median
from ..masks.mask_parts import parts_and_boxes
from ..networks.found_network import FoundRoad

_Value = TypeVar("_Value", np.int32, np.float32)
_FINE = 3
"""Bits of the fraction of a pixel to which lines are drawn."""


@dataclass(frozen=True)
class ExplainedSurface:
    """The connected parts (n,) of a mask (h, w): their labels (h, w), how many pixels they have in
    all, and within half a width, and a pixel, of any road, and their share of the rim."""

    labels: NDArray[np.int32]
    areas: NDArray[np.int64]
    near: NDArray[np.int64]
    rims: NDArray[np.float64]

    @staticmethod
    def of(mask: Booleans, roads: Sequence[FoundRoad], measured: bool = True) -> ExplainedSurface:
        """That of a mask (h, w), with its roads, whose widths were `measured`, not given."""
        _, labels, stats = parts_and_boxes(mask)
        drawn = np.zeros(mask.shape, np.uint8)
        inner = None if measured else cv2.distanceTransform(mask.view(np.uint8), cv2.DIST_L2, 5)
        for road in roads:
            usual = road.usual_width if inner is None else median(2 * _along(road, inner) - 1)
            wide = max(1, round(usual)) + 2
            line = np.round(road.points * 2**_FINE).astype(np.int32)
            cv2.polylines(drawn, [line], False, 1, wide, cv2.LINE_8, _FINE)
        near = np.bincount(labels[(drawn > 0) & mask], minlength=len(stats))
        rim = np.concatenate([labels[0], labels[-1], labels[:, 0], labels[:, -1]])
        rims = np.bincount(rim, minlength=len(stats)) / len(rim)
        areas = stats[:, cv2.CC_STAT_AREA].astype(np.int64)
        return ExplainedSurface(labels, areas, near, rims)

    def shares(self, part: Sequence[FoundRoad]) -> tuple[float, float]:
        """Of what part of a network lies on, the share that roads explain, 1 where it lies on
        nothing; and the share of the picture's rim that has it."""
        on = np.unique(np.concatenate([_along(road, self.labels) for road in part]))
        on = on[on > 0]
        area = int(self.areas[on].sum())
        return (float(self.near[on].sum() / area) if area else 1.0), float(self.rims[on].sum())


def _along(road: FoundRoad, layer: NDArray[_Value]) -> NDArray[_Value]:
    """The values (n,) of a layer (h, w) along a road."""
    last = (layer.shape[1] - 1, layer.shape[0] - 1)
    columns, rows = np.clip(np.round(road.points).astype(int), 0, last).T
    return np.asarray(layer[rows, columns])
