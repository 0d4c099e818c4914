"""The pieces of which a reference line is made in OpenDRIVE, and their points."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np

from roadlang.geometry import Floats, poses_along

FLATTEST_ARC = 5e-5
"""1/m: arcs that bend less are written as cubics, because CARLA finds points of an arc in single
precision from its center, and loses millimeters for each 10 km of radius."""
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(12)


@dataclass(frozen=True)
class ReferencePiece:
    """A part of a reference line that begins at arc length `s`, in a pose (x, y, heading).

    `numbers`: of an arc its curvature (1/m), of a spiral the curvatures at its ends, of a
    parametric cubic its coefficients aU, bU, cU, dU, aV, bV, cV, dV for a parameter from 0 to 1.
    """

    s: float
    x: float
    y: float
    heading: float
    length: float
    shape: Literal["line", "arc", "spiral", "paramPoly3"]
    numbers: tuple[float, ...] = ()


def pose_on(piece: ReferencePiece, length: float) -> tuple[float, float, float]:
    """x, y and heading `length` meters after the beginning of a piece."""
    if piece.shape == "paramPoly3":
        (point,), (slope,) = along_cubic(piece.numbers, np.array([length / piece.length]))
        cos, sin = math.cos(piece.heading), math.sin(piece.heading)
        turn = math.atan2(slope[1], slope[0])
        x, y = cos * point[0] - sin * point[1], sin * point[0] + cos * point[1]
        return piece.x + float(x), piece.y + float(y), piece.heading + turn
    if not piece.numbers:
        before = after = 0.0
    else:
        before, after = piece.numbers[0], piece.numbers[-1]
    ends = (before, before + (after - before) * length / piece.length)
    start = np.array([piece.x, piece.y, piece.heading])
    if length <= 0.0:
        return piece.x, piece.y, piece.heading
    x, y, heading = poses_along(start, ends, np.array([0.0, length]))[-1].tolist()
    return x, y, heading


def cubic(start: Floats, end: Floats, length: float) -> tuple[float, ...]:
    """The coefficients of the cubic from one pose (3,) to another whose speed at both ends is
    `length`, in the axes of the first pose."""
    cos, sin = np.cos(start[2]), np.sin(start[2])
    dx, dy = end[0] - start[0], end[1] - start[1]
    to = np.array([cos * dx + sin * dy, cos * dy - sin * dx])
    turn = end[2] - start[2]
    leaves = np.array([length, 0.0])
    enters = length * np.array([np.cos(turn), np.sin(turn)])
    c = 3.0 * to - 2.0 * leaves - enters
    d = leaves + enters - 2.0 * to
    return (0.0, length, float(c[0]), float(d[0]), 0.0, 0.0, float(c[1]), float(d[1]))


def along_cubic(numbers: tuple[float, ...], p: Floats) -> tuple[Floats, Floats]:
    """(n, 2) points of a cubic and (n, 2) its derivatives at parameters (n,), in its own axes."""
    coefficients = np.array(numbers).reshape(2, 4)
    powers = np.stack((np.ones_like(p), p, p**2, p**3), axis=1)
    slopes = np.stack((np.zeros_like(p), np.ones_like(p), 2.0 * p, 3.0 * p**2), axis=1)
    return powers @ coefficients.T, slopes @ coefficients.T


def cubic_length(numbers: tuple[float, ...]) -> float:
    """The arc length of a cubic, meters."""
    panels = 8
    at = ((np.arange(panels)[:, None] + (_NODES + 1.0) / 2.0) / panels).ravel()
    speed = np.hypot(*along_cubic(numbers, at)[1].T)
    return float(np.sum(speed * np.tile(_WEIGHTS, panels)) / (2.0 * panels))
