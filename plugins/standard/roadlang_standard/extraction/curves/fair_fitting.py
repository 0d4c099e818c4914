"""Curves fitted to the middle of the road as it was seen, as fair as that allows."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import maximum_filter1d
from scipy.spatial import cKDTree

from roadlang.geometry import Booleans, Floats

from .centers import centers
from .edges import CenterLine, normals_in_a_row
from .fair_lines import SeenOffsets
from .fairing import FULLY, Pace, Rough, faired
from .smoothing import curvature

Layer = NDArray[np.float32]
_EASINGS = 7
_UNSEEN, _HARDLY = 1.0, 1e-3
"""Weights of the traced line where the edges of the road do not show its middle, and near
junctions, where the traced line itself is unreliable."""
COVERED = 0.02
"""Weight of the traced line where something covers the picture, unless it covers most of it."""
_MOSTLY = 0.7


@dataclass(frozen=True)
class Fit:
    """How a curve is fitted, in pixels: to the middle of a road of `width` on a surface whose edge
    is at `level`, within `tolerance`, radii not below `tightest`, from a line rid of waves below
    `waves`. Without `fair` the line alone counts. What is seen says little where the picture is
    `covered` (h, w)."""

    width: float
    level: float
    tolerance: float
    tightest: float
    waves: float
    fair: bool = True
    covered: Booleans | None = None

    def is_covered(self, points: Floats) -> Booleans:
        """Which points (n, 2) lie where something covers the picture."""
        if self.covered is None:
            return np.zeros(len(points), bool)
        x, y = np.round(points).astype(int).T
        inside = (x >= 0) & (y >= 0) & (x < self.covered.shape[1]) & (y < self.covered.shape[0])
        result = np.zeros(len(points), bool)
        result[inside] = self.covered[y[inside], x[inside]]
        return result if result.mean() < _MOSTLY else np.zeros(len(points), bool)


@dataclass(frozen=True)
class Traced:
    """A traced line (m, 2), and the junctions (k, 2) on it."""

    line: Floats
    junctions: Floats


@dataclass(frozen=True)
class Unfitted:
    """A curve (n, 2) of even points, and what was traced beside it. `pins` are offsets to the left
    that are met exactly, by the index of their point."""

    curve: Floats
    traced: Traced
    closed: bool
    pins: tuple[tuple[int, float], ...] = ()


def fitted_fairly(
    lines: Sequence[Unfitted], surface: Layer, fit: Fit, pace: Pace = FULLY
) -> list[Floats]:
    """The fair curve near each of the lines, as many points of it.

    What was seen is let go, little by little, where the curve would be too tight.
    """
    if not lines:
        return []
    outlines = [CenterLine(line.curve, line.closed) for line in lines]
    middles = centers(outlines, surface, fit.width, fit.level)
    sought = [
        Rough(line.curve, seen, line.closed)
        for line, seen in zip(lines, _seen(lines, outlines, middles, fit), strict=True)
    ]
    found = [line.curve for line in lines]
    tight = list(range(len(lines)))
    for _ in range(_EASINGS):
        for index, curve in zip(tight, faired([sought[i] for i in tight], pace), strict=True):
            found[index] = curve
        sharp = {index: curvature(found[index]) > 1.02 / fit.tightest for index in tight}
        tight = [index for index in tight if sharp[index].any()]
        for index in tight:
            sought[index] = _eased(sought[index], sharp[index], fit)
    return found


def _eased(rough: Rough, sharp: Booleans, fit: Fit) -> Rough:
    """The same, with a third of the weight near what is `sharp` (n,)."""
    near = maximum_filter1d(sharp, 2 * int(fit.tightest) + 3)
    weight = rough.seen.weight
    weight = np.where(near, np.maximum(_HARDLY, weight / 3), weight)
    return replace(rough, seen=replace(rough.seen, weight=weight))


def _seen(
    lines: Sequence[Unfitted],
    outlines: Sequence[CenterLine],
    middles: Sequence[tuple[Floats, Booleans]],
    fit: Fit,
) -> list[SeenOffsets]:
    """The middle of the road beside each curve, offsets (n,) where it is even (n,), and the traced
    line where it is not seen."""
    curves = np.concatenate([line.curve for line in lines])
    offset = np.concatenate([offset for offset, _ in middles])
    even = np.concatenate([even for _, even in middles])
    nearest = np.concatenate(
        [line.traced.line[cKDTree(line.traced.line).query(line.curve)[1]] for line in lines]
    )
    aside = ((nearest - curves) * normals_in_a_row(curves, outlines)).sum(axis=1)
    offset = np.where(even, offset, aside)
    covered = np.concatenate([fit.is_covered(line.curve) for line in lines])
    even = even & ~covered
    near = [_near(line.curve, line.traced.junctions, 2.0 * fit.width + 3) for line in lines]
    vague = np.concatenate(near) & ~even
    weight = np.where(vague, _HARDLY, np.where(even, 1.0, np.where(covered, COVERED, _UNSEEN)))
    loose = np.where(vague, max(1.0, 0.25 * fit.width), max(0.6, fit.tolerance))
    loose = np.where(covered, np.maximum(loose, fit.width), loose)
    tolerance = np.where(even, fit.tolerance, loose)
    ends = np.cumsum([len(line.curve) for line in lines])[:-1]
    offsets, weights, tolerances = (
        np.split(values, ends) for values in (offset, weight, tolerance)
    )
    pins = [line.pins for line in lines]
    return [*map(SeenOffsets, offsets, weights, tolerances, pins)]


def _near(curve: Floats, places: Floats, distance: float) -> Booleans:
    """Which points (n,) of the curve lie near one of the places (k, 2)."""
    if not len(places):
        return np.zeros(len(curve), bool)
    return np.asarray(cKDTree(places).query(curve)[0] < distance)
