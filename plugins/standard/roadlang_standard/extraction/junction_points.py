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
    lengths = [stations(line.curve) for line in passing]
    for _ in range(_ROUNDS):
        system, right = _GUESS * np.eye(2), _GUESS * guess
        for line, along in zip(passing, lengths, strict=True):
            foot, normal = _foot(line.curve, along, place)
            weight = _THROUGH if line.through else 1.0
            outer = weight * np.outer(normal, normal)
            system, right = system + outer, right + outer @ foot
        place = np.linalg.solve(system, right)
        away = float(np.hypot(*(place - guess)))
        if away > limit:
            place = np.asarray(guess + (place - guess) * limit / away)
    return np.asarray(place)


def _foot(curve: Floats, along: Floats, place: Floats) -> tuple[Floats, Floats]:
    """The point of a polyline nearest to a place, and the normal there."""
    station = _foot_station(curve, along, place, 0.0, 0.0)
    before, after = max(0.0, station - 1.5), min(float(along[-1]), station + 1.5)
    a, b, at = _at(curve, along, np.array([before, after, station]))
    ahead = (b - a) / max(1e-9, float(np.hypot(*(b - a))))
    return at, np.array([-ahead[1], ahead[0]])


def foot_station(curve: Floats, place: Floats, expected: float, doubt: float) -> float:
    """Length along a polyline (n, 2) at its point nearest to a place; each pixel of distance from
    the `expected` length counts as `doubt` pixels."""
    return _foot_station(curve, stations(curve), place, expected, doubt)


def _foot_station(
    curve: Floats, lengths: Floats, place: Floats, expected: float, doubt: float
) -> float:
    start, step = curve[:-1], curve[1:] - curve[:-1]
    length = np.hypot(*step.T)
    share = ((place - start) * step).sum(axis=1) / np.maximum(length**2, 1e-18)
    share = np.minimum(np.maximum(share, 0.0), 1.0)
    along = lengths[:-1] + share * length
    away = np.hypot(*(start + share[:, None] * step - place).T)
    if doubt:
        away += doubt * np.abs(along - expected)
    return float(along[int(np.argmin(away))])


def at_stations(curve: Floats, at: Floats) -> Floats:
    """Points (m, 2) of a polyline at lengths along it."""
    return _at(curve, stations(curve), at)


def _at(curve: Floats, along: Floats, at: Floats) -> Floats:
    return np.column_stack([np.interp(at, along, column) for column in curve.T])


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
