"""Points along roads, for many arc lengths in many candidates at once."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...evaluate.candidates import CandidateBatch
from ...geometry.arrays import Floats
from ...geometry.numbers.row_interpolation import interpolated_in_rows
from ...ir.batch import RoadBatch
from .named_roads import named_road


@dataclass(frozen=True, eq=False)
class RoadPlaces:
    """Arrays (R,): where the center line is, its heading, the width of the road there, and the arc
    length of the root road at that place."""

    x: Floats
    y: Floats
    heading: Floats
    width: Floats
    station: Floats


def places_along(
    name: str, candidates: CandidateBatch, rows: NDArray[np.intp], at: Floats
) -> RoadPlaces:
    """The places at arc lengths `at` (R,) along the road of the candidates at `rows` (R,).

    Arc lengths are those along the road itself; beyond an end, the end.
    """
    lines = _lines_of(name, candidates)
    along = lines["along"]
    last = along[rows if len(along) > 1 else np.zeros_like(rows), -1]
    where = np.minimum(np.maximum(at, 0.0), last)
    columns = [lines[each] for each in ("x", "y", "heading", "width", "station")]
    return RoadPlaces(*interpolated_in_rows(where, rows, along, columns))


def from_root(
    name: str, candidates: CandidateBatch, rows: NDArray[np.intp], stations: Floats
) -> Floats:
    """Arc lengths (R,) along the road of candidates, of `stations` (R,) of its root."""
    return _translated(name, candidates, rows, stations, "station", "along")


def to_root(name: str, candidates: CandidateBatch, rows: NDArray[np.intp], at: Floats) -> Floats:
    """Arc lengths (R,) along the root of the road of candidates, at `at` (R,) along the road."""
    return _translated(name, candidates, rows, at, "along", "station")


def _translated(
    name: str,
    candidates: CandidateBatch,
    rows: NDArray[np.intp],
    places: Floats,
    known: str,
    wanted: str,
) -> Floats:
    lines = _lines_of(name, candidates)
    return interpolated_in_rows(places, rows, lines[known], [lines[wanted]])[0]


def _lines_of(name: str, candidates: CandidateBatch) -> dict[str, Floats]:
    return candidates.once(("lines along", name), lambda: _lines(named_road(name, candidates)))


def _lines(road: RoadBatch) -> dict[str, Floats]:
    """Arc length, x, y, heading, width and arc length of the root (V or 1, S) at the points of a
    road; of a closed one, up to its first point again."""
    points, heading, root = road.points, road.heading, road.stations
    width = np.broadcast_to(road.width, (len(road.width), points.shape[1]))
    if road.closed:
        points = np.concatenate([points, points[:, :1]], axis=1)
        turns = np.rint((heading[:, -1:] - heading[:, :1]) / (2 * np.pi))
        heading = np.concatenate([heading, heading[:, :1] + 2 * np.pi * turns], axis=1)
        width = np.concatenate([width, width[:, :1]], axis=1)
        root = np.append(root, road.period or 0.0)
    x, y = points[..., 0], points[..., 1]
    steps = np.hypot(np.diff(x, axis=1), np.diff(y, axis=1))
    arc = np.concatenate([np.zeros((len(points), 1)), np.cumsum(steps, axis=1)], axis=1)
    parts = {"along": arc, "x": x, "y": y, "heading": heading, "width": width}
    return parts | {"station": root[None, :]}
