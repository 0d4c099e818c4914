"""Roads for kinds tested by themselves."""

from __future__ import annotations

import numpy as np

from roadlang.api import RoadBatch
from roadlang.geometry import Curve, CurveFrame
from roadlang.world.perturbing.root_roads import undisplaced_road


def road_of(points: list[tuple[float, float]], closed: bool = False) -> RoadBatch:
    curve = Curve.through(points, closed)
    frame = CurveFrame.of(curve, curve.stations(spacing=1.0))
    return undisplaced_road("main", "main", frame, np.full((1, 1), 8.0), 1.0)
