"""Planar piecewise cubics: interpolating splines, Hermite pieces, evaluation and cutting."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Floats, Integers, SharedArrays, cross, left_of, norm, wrapped
from ..numbers.tridiagonal import solve_tridiagonal


@dataclass(frozen=True, eq=False)
class PiecewiseCubic(SharedArrays):
    """Piece i is `c[i,0] + t c[i,1] + t^2 c[i,2] + t^3 c[i,3]` with `t = u - knots[i]`.

    `knots`: (m+1,) increasing parameters; `coefficients`: (m, 4, 2).
    """

    knots: Floats
    coefficients: Floats

    def locate(self, u: Floats) -> tuple[Integers, Floats]:
        """The piece of each parameter, and the parameter within it; the end pieces extend."""
        piece = np.searchsorted(self.knots, u, side="right") - 1
        piece = np.clip(piece, 0, len(self.coefficients) - 1)
        return piece, u - self.knots[piece]

    def position(self, u: Floats) -> Floats:
        """(..., 2) points at parameters `u`."""
        piece, local = self.locate(u)
        t = local[..., None]
        c = self.coefficients[piece]
        return np.asarray(c[..., 0, :] + t * (c[..., 1, :] + t * (c[..., 2, :] + t * c[..., 3, :])))

    def derivatives(self, u: Floats) -> tuple[Floats, Floats, Floats]:
        """First, second and third derivative by the parameter, each (..., 2)."""
        piece, local = self.locate(u)
        t = local[..., None]
        c = self.coefficients[piece]
        first = c[..., 1, :] + t * (2.0 * c[..., 2, :] + 3.0 * t * c[..., 3, :])
        return first, 2.0 * c[..., 2, :] + 6.0 * t * c[..., 3, :], 6.0 * c[..., 3, :]

    def speed(self, u: Floats) -> Floats:
        """Length of the first derivative."""
        piece, local = self.locate(u)
        t = local[..., None]
        c = self.coefficients[piece]
        first = c[..., 1, :] + t * (2.0 * c[..., 2, :] + 3.0 * t * c[..., 3, :])
        return np.hypot(first[..., 0], first[..., 1])

    def knot_curvatures(self, closed: bool) -> tuple[Floats, Floats]:
        """Curvatures just after and just before each inner knot; the first too if `closed`."""
        after = self._curvature_of_pieces(np.zeros(len(self.coefficients)))
        before = self._curvature_of_pieces(np.diff(self.knots))
        return (after, np.roll(before, 1)) if closed else (after[1:], before[:-1])

    def _curvature_of_pieces(self, local: Floats) -> Floats:
        """Of each piece, at a parameter within it."""
        t = local[:, None]
        c = self.coefficients
        first = c[:, 1] + t * (2.0 * c[:, 2] + 3.0 * t * c[:, 3])
        second = 2.0 * c[:, 2] + 6.0 * t * c[:, 3]
        return np.asarray(cross(first, second) / np.maximum(norm(first), 1e-9) ** 3)

    def between(self, start: float, stop: float) -> PiecewiseCubic:
        """The same curve on [start, stop] alone."""
        inside = self.knots[(self.knots > start) & (self.knots < stop)]
        starts = np.concatenate([[start], inside])
        piece, local = self.locate(starts)
        coefficients = _shifted(self.coefficients[piece], local)
        return PiecewiseCubic(np.concatenate([starts, [stop]]) - start, coefficients)

    def repeated(self) -> PiecewiseCubic:
        """A periodic spline run through twice."""
        period = self.knots[-1] - self.knots[0]
        return PiecewiseCubic(
            np.concatenate([self.knots, self.knots[1:] + period]),
            np.concatenate([self.coefficients, self.coefficients]),
        )

    def reversed(self) -> PiecewiseCubic:
        """The same curve, run through from its end to its start."""
        coefficients = _shifted(self.coefficients, np.diff(self.knots))[::-1]
        signs = np.array([1.0, -1.0, 1.0, -1.0])[:, None]
        return PiecewiseCubic(self.knots[-1] - self.knots[::-1], coefficients * signs)

    def transformed(self, matrix: Floats, shift: Floats) -> PiecewiseCubic:
        """Each point p becomes `matrix @ p + shift`."""
        coefficients = self.coefficients @ matrix.T
        coefficients[:, 0] += shift
        return PiecewiseCubic(self.knots, coefficients)


def interpolate(knots: Floats, points: Floats, closed: bool) -> PiecewiseCubic:
    """The C2 cubic through `points` (n, 2) at `knots`.

    Open: n knots, not-a-knot ends (a parabola through three points, a line through two).
    Closed: n + 1 knots, the last one back at the first point.
    """
    if closed:
        points = np.concatenate([points, points[:1]])
    steps = knots[1:] - knots[:-1]
    chords = (points[1:] - points[:-1]) / steps[:, None]
    slopes = _periodic_slopes(steps, chords) if closed else _open_slopes(steps, chords)
    return from_slopes(knots, points, slopes, slopes)


def hermite(points: Floats, headings: Floats, closed: bool) -> PiecewiseCubic:
    """The G1 cubic through `points` (n, 2) with `headings` (n,), one piece between neighbors.

    Tangents are as long as makes the curvature of a circle exact at its ends, so that on smooth
    data the curvature is accurate to fourth order; there is no ringing at jumps of curvature.
    """
    if closed:
        points = np.concatenate([points, points[:1]])
        headings = np.concatenate([headings, headings[:1]])
    chords = norm(np.diff(points, axis=0))
    half = np.abs(wrapped(np.diff(headings))) / 2.0
    steps = chords / np.sinc(np.minimum(half, 2.0) / np.pi)
    quarter = half / 2.0
    tangent_length = np.where(quarter > 1e-9, np.tan(quarter) / np.maximum(quarter, 1e-9), 1.0)
    tangents = np.stack([np.cos(headings), np.sin(headings)], axis=-1)
    knots = np.concatenate([[0.0], np.cumsum(steps)])
    return from_slopes(
        knots,
        points,
        tangents[:-1] * tangent_length[:, None],
        tangents[1:] * tangent_length[:, None],
        True,
    )


def from_slopes(
    knots: Floats, points: Floats, leaving: Floats, arriving: Floats, per_piece: bool = False
) -> PiecewiseCubic:
    """Cubic pieces from the derivatives at their ends.

    `leaving` and `arriving` are (m, 2) for each piece if `per_piece`, else (m+1, 2) at the knots.
    """
    if not per_piece:
        leaving, arriving = leaving[:-1], arriving[1:]
    step = (knots[1:] - knots[:-1])[:, None]
    chord = (points[1:] - points[:-1]) / step
    return PiecewiseCubic(knots, cubics(step, points[:-1], chord, leaving, arriving))


def cubics(step: Floats, start: Floats, chord: Floats, leaving: Floats, arriving: Floats) -> Floats:
    """The coefficients (m, 4, 2) of pieces that begin at `start` (m, 2) and go on for steps (m, 1)
    of the parameter, by `chord` (m, 2) in each unit of it; (m, 2) derivatives at their ends."""
    bend = (leaving + arriving - 2.0 * chord) / step
    coefficients = np.empty((len(chord), 4, 2))
    coefficients[:, 0], coefficients[:, 1] = start, leaving
    coefficients[:, 2], coefficients[:, 3] = (chord - leaving) / step - bend, bend / step
    return coefficients


def frame_of(first: Floats) -> tuple[Floats, Floats]:
    """Unit tangent and left normal of derivatives (..., 2)."""
    length = np.maximum(np.hypot(first[..., 0], first[..., 1]), np.finfo(float).tiny)
    tangent = first / length[..., None]
    return tangent, left_of(tangent)


def _shifted(coefficients: Floats, by: Floats) -> Floats:
    """Cubics `p(t)` rewritten as `p(t + by)`."""
    d = by[:, None]
    c0, c1, c2, c3 = (coefficients[:, k] for k in range(4))
    return np.stack(
        [
            c0 + d * (c1 + d * (c2 + d * c3)),
            c1 + d * (2.0 * c2 + 3.0 * d * c3),
            c2 + 3.0 * d * c3,
            c3,
        ],
        axis=1,
    )


def _open_slopes(steps: Floats, chords: Floats) -> Floats:
    """Derivatives at the knots of the not-a-knot spline (de Boor 1978, ch. IV)."""
    count = len(steps) + 1
    if count == 2:
        return np.concatenate([chords, chords])
    if count == 3:
        middle = (steps[1] * chords[0] + steps[0] * chords[1]) / (steps[0] + steps[1])
        return np.stack([2.0 * chords[0] - middle, middle, 2.0 * chords[1] - middle])
    bands = np.zeros((3, count))
    right = np.empty((count, 2))
    bands[1, 1:-1] = 2.0 * (steps[:-1] + steps[1:])
    bands[0, 2:] = steps[:-1]
    bands[2, :-2] = steps[1:]
    h = steps[:, None]
    right[1:-1] = 3.0 * (h[1:] * chords[:-1] + h[:-1] * chords[1:])
    bands[1, 0], bands[0, 1] = steps[1], steps[0] + steps[1]
    bands[1, -1], bands[2, -2] = steps[-2], steps[-2] + steps[-1]
    right[0] = _end_condition(steps[0], steps[1], chords[0], chords[1])
    right[-1] = _end_condition(steps[-1], steps[-2], chords[-1], chords[-2])
    return solve_tridiagonal(bands, right)


def _end_condition(outer: float, inner: float, outer_chord: Floats, inner_chord: Floats) -> Floats:
    both = outer + inner
    return ((outer + 2.0 * both) * inner * outer_chord + outer**2 * inner_chord) / both


def _periodic_slopes(steps: Floats, chords: Floats) -> Floats:
    """Derivatives at the knots of the periodic spline, by a rank-one correction of the cycle."""
    before, chord_before = np.roll(steps, 1), np.roll(chords, 1, axis=0)
    diagonal = 2.0 * (before + steps)
    right = 3.0 * (steps[:, None] * chord_before + before[:, None] * chords)
    corner_top, corner_bottom = steps[0], before[-1]
    pivot = -diagonal[0]
    bands = np.zeros((3, len(steps)))
    bands[0, 1:], bands[1], bands[2, :-1] = before[:-1], diagonal, steps[1:]
    bands[1, 0] -= pivot
    bands[1, -1] -= corner_top * corner_bottom / pivot
    edge = np.zeros((len(steps), 1))
    edge[0, 0], edge[-1, 0] = pivot, corner_bottom
    solved = solve_tridiagonal(bands, np.concatenate([right, edge], axis=1))
    plain, correction = solved[:, :2], solved[:, 2]
    share = corner_top / pivot
    factor = (plain[0] + share * plain[-1]) / (1.0 + correction[0] + share * correction[-1])
    slopes = plain - correction[:, None] * factor
    return np.concatenate([slopes, slopes[:1]])
