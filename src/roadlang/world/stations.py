"""Where roads are sampled: stations by arc length, about a meter apart."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..geometry import Curve, DisplacedBatch, Frame
from ..ir.batch import RoadBatch

SPACING = 1.0
FEWEST, MOST = 51, 2001


def stations_of(curve: Curve) -> NDArray[np.float64]:
    """(S,) even stations of a root road: a meter apart, more of a short road, fewer of a long."""
    count = int(np.clip(np.ceil(curve.length / SPACING) + 1, FEWEST, MOST))
    return curve.stations(count=count)


def still(
    name: str, root: str, frame: Frame, width: NDArray[np.float64], confidence: float
) -> RoadBatch:
    """A root road as a batch: one row, not displaced."""
    zeros = np.zeros((1, len(frame.stations)))
    curves = DisplacedBatch(frame, zeros, zeros, zeros)
    return RoadBatch(name, root, curves, width, zeros, confidence)


def is_still(road: RoadBatch) -> bool:
    """Whether a road is its root itself, so that its frame is known exactly."""
    curves = road.curves
    return (
        isinstance(curves, DisplacedBatch)
        and curves.variants == 1
        and not curves.bend.any()
        and not curves.displacement.any()
    )
