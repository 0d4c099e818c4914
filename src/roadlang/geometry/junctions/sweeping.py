"""Surfaces of connections and of arms as polygons, and which of them overlap."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from ..arrays import Booleans, Floats
from .arms import ArmKey, ArmLine
from .connection_curves import Fits, along, sampled

TOLERANCE = 0.004
"""Meters by which surfaces may overlap unnoticed."""
_AHEAD = 40.0
_COARSE = np.linspace(0.0, 1.0, 32)
_SAGITTA = 8e-3


def swept_arms(
    arms: Sequence[ArmLine], trims: Mapping[ArmKey, float], fits: Fits, widths: Floats
) -> Booleans:
    """(N, arms) which connections, `widths` (N, 2) wide at their ends, lie on which arm beyond its
    face."""
    import shapely

    points, headings = sampled(fits, _COARSE)
    half = (widths[:, :1] + (widths[:, 1:] - widths[:, :1]) * _COARSE) / 2.0 - TOLERANCE
    # Curves between ends at one point have no place; none of them can be driven.
    rings = np.nan_to_num(ring_round(points, headings, half))
    strips = valid(shapely.polygons(rings))
    found = np.zeros((len(rings), len(arms)), dtype=bool)
    for place, arm in enumerate(arms):
        road = road_beyond(arm, trims, TOLERANCE)
        if road is not None:
            shapely.prepare(road)
            found[:, place] = shapely.intersects(road, strips)
    return found


def road_beyond(arm: ArmLine, trims: Mapping[ArmKey, float], inset: float = 0.0) -> Any:
    """The surface of an arm from its face on, a little narrower by `inset`; None if nothing is
    left of it."""
    import shapely

    start = trims[arm.key] + inset
    other = trims.get((arm.edge.id, "end" if arm.end == "start" else "start"), 0.0)
    stop = min(trims[arm.key] + _AHEAD, float(arm.s[-1]), arm.length - other) - inset
    if stop - start < 0.05:
        return None
    left, right = arm.borders(start, stop)
    if inset:
        across = (right - left) / np.maximum(np.hypot(*(right - left).T), 1e-9)[:, None]
        left, right = left + inset * across, right - inset * across
    return valid(shapely.polygons(np.concatenate([left, right[::-1]])))


def stub(arm: ArmLine, trim: float) -> Any:
    """The surface of an arm from its node to `trim`."""
    import shapely

    left, right = arm.borders(0.0, min(trim, float(arm.s[-1])))
    return valid(shapely.polygons(np.concatenate([left, right[::-1]])))


def strip(fits: Fits, row: int, widths: tuple[float, float]) -> Any:
    """The surface of one connection, to a millimeter."""
    import shapely

    lengths, curvatures = fits.lengths[row], fits.curvatures[row]
    total = float(lengths.sum())
    stops = np.cumsum(lengths)
    s = [np.zeros(1)]
    for length, curvature, stop in zip(lengths, curvatures, stops, strict=True):
        if length > 1e-9:
            step = min(1.0, np.sqrt(_SAGITTA / max(abs(curvature), 1e-6)))
            count = int(np.ceil(length / step)) if curvature else 1
            s.append(stop - length + length * np.arange(1, count + 1) / count)
    shares = np.concatenate(s) / total
    points, headings = along(
        fits.start[[row]], fits.heading[[row]], lengths[None], curvatures[None], shares
    )
    half = (widths[0] + (widths[1] - widths[0]) * shares) / 2.0
    return valid(shapely.polygons(ring_round(points, headings, half[None])[0]))


def valid(polygons: Any) -> Any:
    """The same, corrected where a border runs backwards in a tight bend."""
    import shapely

    good = shapely.is_valid(polygons)
    if np.all(good):
        return polygons
    return np.where(good, polygons, shapely.make_valid(polygons))[()]


def ring_round(points: Floats, headings: Floats, half: Floats) -> Floats:
    """(N, 2k, 2) round lines (N, k, 2) that are 2 `half` (N, k) wide."""
    normal = np.stack([-np.sin(headings), np.cos(headings)], axis=-1) * half[..., None]
    return np.concatenate([points + normal, (points - normal)[:, ::-1]], axis=1)
