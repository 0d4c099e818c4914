"""Where roads meet: the point that their fitted lines agree on."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from roadlang.geometry import Floats

from .smoothing import stations

_THROUGH, _GUESS = 1e4, 1e-4
_ROUNDS = 4


@dataclass(frozen=True)
class Passing:
    """A curve (n, 2) near a place; `through` if it goes on beyond, not if it ends there."""

    curve: Floats
    through: bool


def meeting_point(guess: Floats, passing: Sequence[Passing], limit: float) -> Floats:
    """The point (2,) nearest to the tangents of all curves, at most `limit` pixels from the guess.

    Curves that go through count far more than those that end: a side road ends on the road that
    it joins, and two roads that cross meet where they cross.
    """
    place = np.asarray(guess, float)
    curves = [(_Measured.of(line.curve), _THROUGH if line.through else 1.0) for line in passing]
    for _ in range(_ROUNDS):
        system, right = _GUESS * np.eye(2), _GUESS * guess
        for curve, weight in curves:
            foot, normal = curve.foot(place)
            outer = weight * (normal[:, None] * normal)
            system, right = system + outer, right + outer @ foot
        place = np.linalg.solve(system, right)
        away = float(np.hypot(*(place - guess)))
        if away > limit:
            place = np.asarray(guess + (place - guess) * limit / away)
    return np.asarray(place)


@dataclass(frozen=True)
class _Measured:
    """A polyline (n, 2), how far along it each point is (n,), and its steps: as vectors (n - 1, 2),
    and their lengths (n - 1,)."""

    curve: Floats
    along: Floats
    steps: Floats
    lengths: Floats

    @staticmethod
    def of(curve: Floats) -> _Measured:
        steps, along = curve[1:] - curve[:-1], np.zeros(max(1, len(curve)))
        lengths = np.hypot(steps[:, 0], steps[:, 1])
        np.cumsum(lengths, out=along[1:])
        return _Measured(curve, along, steps, lengths)

    def foot(self, place: Floats) -> tuple[Floats, Floats]:
        """The point nearest to a place, and the normal there."""
        station = self.foot_station(place, 0.0, 0.0)
        before, after = max(0.0, station - 1.5), min(float(self.along[-1]), station + 1.5)
        a, b, at = _at(self.curve, self.along, np.array([before, after, station]))
        ahead = (b - a) / max(1e-9, float(np.hypot(*(b - a))))
        return at, np.array([-ahead[1], ahead[0]])

    def foot_station(self, place: Floats, expected: float, doubt: float) -> float:
        """As `foot_station`."""
        start, step, length = self.curve[:-1], self.steps, self.lengths
        share = ((place - start) * step).sum(axis=1) / np.maximum(length**2, 1e-18)
        share = np.minimum(np.maximum(share, 0.0), 1.0)
        off = start + share[:, None] * step - place
        away, along = np.hypot(off[:, 0], off[:, 1]), self.along[:-1] + share * length
        if doubt:
            away += doubt * np.abs(along - expected)
        return float(along[int(away.argmin())])


def foot_station(curve: Floats, place: Floats, expected: float, doubt: float) -> float:
    """Length along a polyline (n, 2) at its point nearest to a place; each pixel of distance from
    the `expected` length counts as `doubt` pixels."""
    return _Measured.of(curve).foot_station(place, expected, doubt)


def at_stations(curve: Floats, at: Floats) -> Floats:
    """Points (m, 2) of a polyline at lengths along it."""
    return _at(curve, stations(curve), at)


def _at(curve: Floats, along: Floats, at: Floats) -> Floats:
    found = np.empty((len(at), 2))
    for axis in (0, 1):
        found[:, axis] = np.interp(at, along, curve[:, axis])
    return found


def extended(curve: Floats, by: tuple[float, float]) -> Floats:
    """The polyline carried straight on at its start and its end by so many pixels."""
    parts = [curve]
    look = min(4, len(curve) - 1)
    if by[0] > 0:
        parts.insert(0, _beyond(curve[0], curve[look], by[0])[::-1])
    if by[1] > 0:
        parts.append(_beyond(curve[-1], curve[-1 - look], by[1]))
    return np.vstack(parts)


def _beyond(end: Floats, before: Floats, by: float) -> Floats:
    ahead = (end - before) / max(1e-9, float(np.hypot(*(end - before))))
    return np.asarray(end + np.arange(1.0, max(2.0, np.ceil(by) + 1))[:, None] * ahead)
