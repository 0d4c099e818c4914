"""Root roads: before any `perturb`, as batches."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ...geometry import CurveFrame, DisplacedBatch
from ...ir.batch import RoadBatch


def undisplaced_road(
    name: str,
    root: str,
    frame: CurveFrame,
    width: NDArray[np.float64],
    confidence: float,
    variants: int = 1,
) -> RoadBatch:
    """A root road as a batch of equal rows, not displaced."""
    zeros = np.zeros((variants, len(frame.stations)))
    return RoadBatch(name, root, DisplacedBatch(frame, zeros), width, zeros, confidence)


def is_undisplaced(road: RoadBatch) -> bool:
    """Whether a road is its root itself, so that its frame is known exactly."""
    curves = road.curves
    return (
        isinstance(curves, DisplacedBatch)
        and curves.variants == 1
        and not curves.displacement.any()
    )
