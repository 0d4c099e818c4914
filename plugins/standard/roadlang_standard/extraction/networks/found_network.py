"""What an extractor finds, in pixels: roads between nodes, widths, confidence."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Floats

from ..colors.fast_median import median

EDGE_LINES = "edge lines"
"""The method by which roads between two lines are found."""

NO_ROAD = 0.45
"""The confidence, at most, of what is more likely something other than a road."""


@dataclass(frozen=True)
class FoundRoad:
    """One road: center line (n, 2) in pixels, y down, (0, 0) the center of the top-left pixel.

    A closed road repeats its first point at the end. `width_error` is the standard error of the
    widths (n,), also in pixels. `linked` is the share of the length bridged without evidence.
    `confidences` (n,) are those at the points, where they differ; `confidence` is their mean.
    """

    start: int
    end: int
    points: Floats
    widths: Floats
    width_error: float = 0.0
    confidence: float = 1.0
    linked: float = 0.0
    confidences: Floats | None = None

    @property
    def closed(self) -> bool:
        """Whether it ends where it begins."""
        return self.start == self.end

    @cached_property
    def length(self) -> float:
        """Pixels."""
        steps = self.points[1:] - self.points[:-1]
        return float(np.hypot(steps[:, 0], steps[:, 1]).sum())

    @cached_property
    def usual_width(self) -> float:
        """Median of its widths, pixels."""
        return median(self.widths)

    def less_sure(self, factor: float) -> FoundRoad:
        """The same road, with so many times the confidence."""
        along = None if self.confidences is None else self.confidences * factor
        return replace(self, confidence=round(self.confidence * factor, 4), confidences=along)


@dataclass(frozen=True)
class FoundNetwork:
    """Nodes (x, y) by index, the roads between them, and how they were found.

    `mask` is (h, w) bool, the pixels taken for road.
    """

    nodes: Floats
    roads: tuple[FoundRoad, ...]
    mask: NDArray[np.bool_]
    method: str = ""
    remarks: tuple[str, ...] = ()
    scores: dict[str, float] = field(default_factory=dict)
    directions: NDArray[np.float64] | None = None
    """(h, w, 2) unit vectors, y down, where a legend says in which direction traffic runs; else
    zero"""
    printed: NDArray[np.bool_] | None = None
    """(h, w) where the lines of ruled paper are, which nobody drew; None without any"""
    has_widths: bool = True
    """whether the widths were measured or given, not only how wide a cell is"""

    @property
    def confidence(self) -> float:
        """Mean over the length of the roads, 0 without roads."""
        lengths = np.array([road.length for road in self.roads])
        if not len(lengths):
            return 0.0
        return float((lengths * [road.confidence for road in self.roads]).sum() / lengths.sum())

    def scaled(self, factor: float, shape: tuple[int, int]) -> FoundNetwork:
        """The same roads in a picture `factor` times as large, of `shape`."""
        import cv2

        def moved(points: Floats) -> Floats:
            return (points + 0.5) * factor - 0.5

        roads = tuple(
            FoundRoad(
                r.start,
                r.end,
                moved(r.points),
                r.widths * factor,
                r.width_error * factor,
                r.confidence,
                r.linked,
                r.confidences,
            )
            for r in self.roads
        )
        mask = (
            cv2.resize(self.mask.astype(np.uint8), shape[::-1], interpolation=cv2.INTER_NEAREST) > 0
        )
        nodes = moved(self.nodes) if len(self.nodes) else self.nodes
        return FoundNetwork(nodes, roads, mask, self.method, self.remarks, self.scores)
