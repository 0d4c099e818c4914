"""Curves of connections: a line, an arc and a line, or two arcs, with exact ends.

Biarcs after Bolton, "Biarc curves" (Computer-Aided Design 7, 1975); the shortest drivable one of
nine ratios of its end tangents is chosen.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Booleans, Floats, cross
from .corners import SMALLEST_RADIUS

TIGHTEST = 1.0 / SMALLEST_RADIUS
_RATIOS = np.array([1.0, 0.85, 1.2, 0.65, 1.6, 0.45, 2.3, 0.3, 3.4])
_LEAST_TURN, _MOST_TURN = np.radians(2.0), np.radians(172.0)
_MOST_TURNING = 4.3
_SHORTEST = 1e-9


@dataclass(frozen=True, eq=False)
class ConnectionEnds:
    """Where N connections start and stop: points (N, 2) and headings (N,), and the greatest radius
    (N,) that the arc of a turn round a curb may have."""

    start: Floats
    heading: Floats
    stop: Floats
    end_heading: Floats
    most_radius: Floats


@dataclass(frozen=True, eq=False)
class Fits:
    """N connections of three pieces: their lengths and curvatures (N, 3), and which can be
    driven."""

    start: Floats
    heading: Floats
    lengths: Floats
    curvatures: Floats
    drivable: Booleans

    @property
    def peak(self) -> Floats:
        """(N,) the greatest curvature."""
        return np.asarray(np.abs(self.curvatures).max(axis=1))

    def pieces(self, row: int) -> tuple[tuple[float, float], ...]:
        """The pieces of one connection that have a length."""
        rows = zip(self.lengths[row].tolist(), self.curvatures[row].tolist(), strict=True)
        return tuple((length, curvature) for length, curvature in rows if length > _SHORTEST)


def fitted(ends: ConnectionEnds, hull: Floats) -> Fits:
    """The curves of connections. `hull` (k, 3): half-planes `a x + b y <= c` that drivable ones
    stay in; without them nearly opposite ends make loops."""
    simple, simple_good = _line_arc_line(ends)
    double, double_good = _biarcs(ends, hull)
    lengths = np.where(simple_good[:, None], simple[0], double[0])
    curvatures = np.where(simple_good[:, None], simple[1], double[1])
    return Fits(ends.start, ends.heading, lengths, curvatures, simple_good | double_good)


def sampled(fits: Fits, shares: Floats) -> tuple[Floats, Floats]:
    """Points (N, k, 2) and headings (N, k) at shares (k,) of the length of each connection."""
    return along(fits.start, fits.heading, fits.lengths, fits.curvatures, shares)


def along(
    start: Floats, heading: Floats, lengths: Floats, curvatures: Floats, shares: Floats
) -> tuple[Floats, Floats]:
    """The same of arrays: points (N, 2), headings (N,), lengths and curvatures (N, pieces)."""
    s = lengths.sum(axis=1)[:, None] * shares
    points = np.repeat(start[:, None, :], len(shares), axis=1)
    headings = np.repeat(heading[:, None], len(shares), axis=1)
    before = np.zeros(len(lengths))
    for piece in range(lengths.shape[1]):
        length, curvature = lengths[:, piece], curvatures[:, piece]
        inner = np.clip(s - before[:, None], 0.0, length[:, None])
        half = curvature[:, None] * inner / 2.0
        chord = inner * np.sinc(half / np.pi)
        points[..., 0] += chord * np.cos(headings + half)
        points[..., 1] += chord * np.sin(headings + half)
        headings += 2.0 * half
        before = before + length
    return points, headings


def _line_arc_line(ends: ConnectionEnds) -> tuple[tuple[Floats, Floats], Booleans]:
    u, v = _unit(ends.heading), _unit(ends.end_heading)
    across = cross(u, v)
    turn = np.arctan2(across, (u * v).sum(axis=-1))
    between = ends.stop - ends.start
    usable = (np.abs(turn) > _LEAST_TURN) & (np.abs(turn) < _MOST_TURN)
    safe = np.where(usable, across, 1.0)
    before = cross(between, v) / safe
    after = cross(u, between) / safe
    half = np.tan(np.abs(np.where(usable, turn, 1.0)) / 2.0)
    radius = np.minimum(np.minimum(before, after) / half, ends.most_radius)
    good = usable & (before > 0.0) & (after > 0.0) & (radius >= SMALLEST_RADIUS)
    radius = np.where(good, radius, 1.0)
    cut = radius * half
    lengths = np.stack([before - cut, radius * np.abs(turn), after - cut], axis=1)
    zero = np.zeros_like(radius)
    curvatures = np.stack([zero, np.sign(turn) / radius, zero], axis=1)
    return (np.maximum(lengths, 0.0), curvatures), good


def _biarcs(ends: ConnectionEnds, hull: Floats) -> tuple[tuple[Floats, Floats], Booleans]:
    """The best of the ratios: the shortest that can be driven, else the one that bends least."""
    count, ratios = len(ends.start), _RATIOS[None, :]
    u, v = _unit(ends.heading), _unit(ends.end_heading)
    between = ends.stop - ends.start
    squared = (between**2).sum(axis=-1)[:, None]
    a = 2.0 * ratios * (1.0 - (u * v).sum(axis=-1))[:, None]
    b = 2.0 * (ratios * (between * u).sum(axis=-1)[:, None] + (between * v).sum(axis=-1)[:, None])
    root = np.sqrt(b * b + 4.0 * a * squared)
    with np.errstate(divide="ignore", invalid="ignore"):
        second = np.where(b > 0.0, 2.0 * squared / (b + root), (root - b) / (2.0 * a))
    second = np.where(np.isfinite(second), second, 1e6)
    first = ratios * second
    with np.errstate(invalid="ignore"):  # arms that meet at one point
        share = (first / (first + second))[..., None]
    near = ends.start[:, None] + first[..., None] * u[:, None]
    far = ends.stop[:, None] - second[..., None] * v[:, None]
    joint = near + share * (far - near)
    headings = np.broadcast_to(ends.heading[:, None], first.shape)
    turn1, length1 = _arc(headings, joint - ends.start[:, None])
    turn2, length2 = _arc(headings + turn1, ends.stop[:, None] - joint)
    lengths = np.stack([length1, length2, np.zeros_like(length1)], axis=-1)
    curvatures = np.stack(
        [turn1 / np.maximum(length1, 1e-12), turn2 / np.maximum(length2, 1e-12), 0.0 * turn1],
        axis=-1,
    )
    peak = np.abs(curvatures).max(axis=-1)
    good = (peak <= TIGHTEST) & (np.abs(turn1) + np.abs(turn2) <= _MOST_TURNING)
    good &= _inside(ends, lengths, curvatures, hull)
    cost = np.round(lengths.sum(axis=-1) * (1.0 + 0.8 * peak), 6)
    cost = np.where(good, cost, 1e9 * (1.0 + np.round(peak, 6)))
    best = cost.argmin(axis=1)
    rows = np.arange(count)
    return (lengths[rows, best], curvatures[rows, best]), good[rows, best]


def _arc(heading: Floats, chord: Floats) -> tuple[Floats, Floats]:
    """The angle by which the arc with this first heading and chord turns, and its length."""
    direction = np.stack([np.cos(heading), np.sin(heading)], axis=-1)
    half = np.arctan2(cross(direction, chord), (direction * chord).sum(axis=-1))
    size = np.hypot(chord[..., 0], chord[..., 1])
    return 2.0 * half, size / np.maximum(np.sinc(half / np.pi), 1e-9)


def _inside(ends: ConnectionEnds, lengths: Floats, curvatures: Floats, hull: Floats) -> Booleans:
    """(N, ratios) which of the curves stay in all half-planes."""
    shape = lengths.shape[:2]
    start = np.repeat(ends.start, shape[1], axis=0)
    heading = np.repeat(ends.heading, shape[1])
    points, _ = along(
        start, heading, lengths.reshape(-1, 3), curvatures.reshape(-1, 3), np.linspace(0.1, 0.9, 9)
    )
    away = points @ hull[:, :2].T - hull[:, 2]
    return np.asarray((away <= 0.0).all(axis=(1, 2)).reshape(shape))


def _unit(heading: Floats) -> Floats:
    return np.stack([np.cos(heading), np.sin(heading)], axis=-1)
