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


def undisplaced_road(
    name: str,
    root: str,
    frame: Frame,
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
