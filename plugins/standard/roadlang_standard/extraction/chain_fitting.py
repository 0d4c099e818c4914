"""Chains of lines as fair curves: fitted to what was seen, then through the nodes they meet at."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import maximum_filter1d
from scipy.spatial import cKDTree

from roadlang.geometry import Booleans, Floats

from .centers import centers
from .chains import LineChain
from .edges import normals
from .fairing import SeenOffsets, even_points, faired
from .junction_points import at_stations, extended, foot_station
from .smoothing import curvature, resample, smooth, stations

Layer = NDArray[np.float32]
_FITS, _EASINGS = 2, 7
_UNSEEN, _HARDLY = 1.0, 1e-3
"""Weights of the traced line where the road's edges do not say where its middle is; and where it
says little itself, near junctions."""
_FADE = 12.0
_COVERED, _MOSTLY = 0.02, 0.7
"""Weight of the traced line where something covers the picture, unless it covers most of it."""


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
class Run:
    """The curve (n, 2) of a chain, a point about each pixel; a closed one repeats its first point.

    It was fitted beside what was `traced`. `reached` are lengths along it of the chain's nodes,
    about; those of a closed run are its parts' starts.
    """

    chain: LineChain
    curve: Floats
    traced: Traced
    reached: tuple[float, ...]

    @property
    def nodes(self) -> list[int]:
        """The chain's nodes; of a closed one the first is not repeated."""
        return self.chain.nodes[:-1] if self.chain.closed else self.chain.nodes

    def is_end(self, place: int) -> bool:
        """Whether the run ends at its node of this index."""
        return not self.chain.closed and place in (0, len(self.nodes) - 1)


def fitted(
    chain: LineChain,
    nodes: Mapping[int, Floats],
    free: tuple[bool, bool],
    surface: Layer,
    fit: Fit,
) -> Run:
    """The fair curve of a chain between `nodes`, its ends wherever they fall; `free` ones are dead
    ends."""
    pieces = [line.points if forward else line.points[::-1] for line, forward in chain.parts]
    traced = resample(np.vstack([pieces[0], *[piece[1:] for piece in pieces[1:]]]))
    inner = [piece[0] for piece in pieces[1:]]
    shares = np.cumsum([0.0, *[line.length for line, _ in chain.parts]])
    tiny = _is_tiny(traced, chain.closed, fit)
    curve = traced if tiny else _without_waves(traced, inner, chain.closed, free, fit)
    if fit.fair and not tiny:
        curve = even_points(curve, chain.closed)
        ends = [free[0] and not chain.closed, *[False] * len(inner), free[1] or chain.closed]
        places = [nodes[node] for node, end in zip(chain.nodes, ends, strict=True) if not end]
        seen = Traced(traced, np.array(places).reshape(-1, 2))
        for _ in range(_FITS):
            curve = _fitted_again(curve, seen, (), surface, fit, chain.closed)
            curve = even_points(curve, chain.closed)
    else:
        seen = Traced(traced, np.zeros((0, 2)))
    reached = shares / shares[-1] * stations(curve)[-1]
    return Run(chain, curve, seen, tuple(reached[:-1] if chain.closed else reached))


def _is_tiny(traced: Floats, closed: bool, fit: Fit) -> bool:
    """Whether a ring has no room for the tightest bend: smoothed, it would shrink to a point."""
    return closed and bool(stations(traced)[-1] < 2 * np.pi * fit.tightest)


def _without_waves(
    traced: Floats, inner: list[Floats], closed: bool, free: tuple[bool, bool], fit: Fit
) -> Floats:
    """The traced line smoothed; near junctions it says little."""
    tolerance = max(0.8, 0.1 * fit.width)
    if closed:
        ring = smooth(traced[:-1], fit.waves, tolerance, fit.tightest, closed=True)
        return np.vstack([ring, ring[:1]])
    weights = np.where(fit.is_covered(traced), _COVERED, 1.0)
    for place in [traced[0], traced[-1], *inner]:
        near = np.hypot(*(traced - place).T) < 0.6 * fit.width
        if near.sum() < 0.5 * len(traced):
            weights[near] = 0.02
    return smooth(traced, fit.waves, tolerance, fit.tightest, weights, free=free)


def _fitted_again(
    curve: Floats,
    traced: Traced,
    pins: tuple[tuple[int, float], ...],
    surface: Layer,
    fit: Fit,
    closed: bool,
) -> Floats:
    """The fair curve near a curve of even points, as many points of it.

    What was seen is let go, little by little, where the curve would be too tight.
    """
    offset, even = centers(curve, surface, fit.width, fit.level, closed)
    _, nearest = cKDTree(traced.line).query(curve)
    aside = ((traced.line[nearest] - curve) * normals(curve, closed)).sum(axis=1)
    offset = np.where(even, offset, aside)
    covered = fit.is_covered(curve)
    even = even & ~covered
    vague = _near(curve, traced.junctions, 2.0 * fit.width + 3) & ~even
    weight = np.where(vague, _HARDLY, np.where(even, 1.0, np.where(covered, _COVERED, _UNSEEN)))
    loose = np.where(vague, max(1.0, 0.25 * fit.width), max(0.6, fit.tolerance))
    loose = np.where(covered, np.maximum(loose, fit.width), loose)
    tolerance = np.where(even, fit.tolerance, loose)
    for _ in range(_EASINGS):
        found = faired(curve, SeenOffsets(offset, weight, tolerance, pins), closed)
        sharp = curvature(found) > 1.02 / fit.tightest
        if not sharp.any():
            break
        near = maximum_filter1d(sharp, 2 * int(fit.tightest) + 3)
        weight = np.where(near, np.maximum(_HARDLY, weight / 3), weight)
    return found


def _near(curve: Floats, places: Floats, distance: float) -> Booleans:
    """Which points (n,) of the curve lie near one of the places (k, 2)."""
    if not len(places):
        return np.zeros(len(curve), bool)
    return np.asarray(cKDTree(places).query(curve)[0] < distance)


def through(run: Run, placed: dict[int, Floats], free: tuple[bool, bool], surface: Layer,
            fit: Fit) -> list[Floats]:  # fmt: skip
    """The run's curve through its nodes where they were `placed`, cut there: a piece each part."""
    places = [placed[node] for node in run.nodes]
    curve, at = _between_ends(run, places, free, fit)
    along = stations(curve)
    index = [int(np.argmin(np.abs(along - station))) for station in at]
    index = _increasing(index, len(curve), run.chain.closed)
    normal = normals(curve, run.chain.closed)
    pins = tuple(
        (i, float((place - curve[i]) @ normal[i])) for i, place in zip(index, places, strict=True)
    )
    if fit.fair and not _is_tiny(run.traced.line, run.chain.closed, fit):
        curve = _fitted_again(curve, run.traced, pins, surface, fit, run.chain.closed)
    else:
        curve = curve + _faded(pins, len(curve))[:, None] * normal
    curve = curve.copy()
    curve[index] = places
    if run.chain.closed:
        curve[-1] = curve[0]
        index = [*index, len(curve) - 1]
    return [curve[a : b + 1] for a, b in pairwise(index)]


def _between_ends(
    run: Run, places: list[Floats], free: tuple[bool, bool], fit: Fit
) -> tuple[Floats, list[float]]:
    """The curve from its first node to its last, and the lengths along it of all nodes."""
    if run.chain.closed:
        ring = _rolled(run.curve, foot_station(run.curve, places[0], 0.0, 0.0))
        at = [0.0] + [
            foot_station(ring, place, expected, 0.05)
            for place, expected in zip(places[1:], run.reached[1:], strict=True)
        ]
        return ring, at
    beyond = 1.5 * fit.width + 6
    by = (0.0 if free[0] else beyond, 0.0 if free[1] else beyond)
    longer = extended(run.curve, by)
    added = float(np.ceil(by[0]))
    at = [
        foot_station(longer, place, expected + added, 0.05)
        for place, expected in zip(places, run.reached, strict=True)
    ]
    if at[-1] - at[0] < 2.0:
        straight = np.linspace(places[0], places[-1], max(2, len(places)))
        return straight, list(stations(straight))
    inner = np.linspace(at[0], at[-1], max(len(places), 2, round(at[-1] - at[0]) + 1))
    return at_stations(longer, inner), [station - at[0] for station in at]


def _rolled(ring: Floats, start: float) -> Floats:
    """A closed curve, begun and ended at this length along it."""
    along = stations(ring)
    at = (start + np.linspace(0.0, along[-1], len(ring))) % along[-1]
    at[-1] = at[0]
    return at_stations(ring, at)


def _increasing(index: list[int], count: int, closed: bool) -> list[int]:
    """Indices of nodes made to increase by at least one, from 0, to the last if not closed."""
    inner = index[1:] if closed else index[1:-1]
    for place, i in enumerate(inner):
        before = inner[place - 1] if place else 0
        inner[place] = int(np.clip(i, before + 1, count - 1 - (len(inner) - place)))
    return [0, *inner] if closed else [0, *inner, count - 1]


def _faded(pins: tuple[tuple[int, float], ...], count: int) -> Floats:
    """Offsets (n,) that meet the pins and fade away from each."""
    offset = np.zeros(count)
    for index, value in pins:
        offset += value * np.clip(1 - np.abs(np.arange(count) - index) / _FADE, 0.0, 1.0)
    return offset
