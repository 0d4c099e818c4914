"""Connections of junctions as roads, so that signals can be measured on them."""

from __future__ import annotations

import numpy as np

from ...geometry import Arc, Curve, CurveFrame, Straight, chain
from ...geometry.networks.junction_model import Connection
from ...ir.batch import RoadBatch
from ...ir.scene_junctions import SceneConnection
from ..perturbing.root_roads import undisplaced_road

_SPACING = 0.5


def connection_curve(connection: Connection | SceneConnection) -> Curve:
    """Its lines and arcs."""
    pieces = [
        Straight(length) if curvature == 0.0 else Arc(1.0 / abs(curvature), length * curvature)
        for length, curvature in connection.pieces
    ]
    x, y, heading = connection.start
    return chain(pieces, (x, y), heading, spacing=_SPACING).curve()


def connection_batch(name: str, connection: Connection) -> RoadBatch:
    """A connection, sampled every half meter. It is nowhere displaced: junctions are frozen."""
    curve = connection_curve(connection)
    stations = curve.stations(count=max(3, int(np.ceil(curve.length / _SPACING)) + 1))
    frame = CurveFrame.of(curve, stations)
    width = np.interp(stations, [0.0, curve.length], connection.widths)[None, :]
    return undisplaced_road(name, name, frame, width, 1.0)
