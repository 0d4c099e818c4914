"""Curves and points that the tests of the geometry share."""

from __future__ import annotations

import numpy as np
from hypothesis import strategies as st

from roadlang.geometry import Curve, CurveBatch, self_crossings


def circle(radius: float = 10.0, count: int = 64) -> Curve:
    """Counter-clockwise, starting east of the origin."""
    angle = np.linspace(0.0, 2.0 * np.pi, count, endpoint=False)
    return Curve.through(radius * np.stack([np.cos(angle), np.sin(angle)], axis=1), closed=True)


def line(length: float = 100.0) -> Curve:
    """East from the origin."""
    return Curve.through([(0.0, 0.0), (length, 0.0)])


def wave(length: float = 200.0, height: float = 10.0, wavelength: float = 80.0) -> Curve:
    """A gentle sine road to the east."""
    x = np.linspace(0.0, length, 120)
    return Curve.through(np.stack([x, height * np.sin(2.0 * np.pi * x / wavelength)], axis=1))


def hairpin(radius: float = 5.0, leg: float = 40.0) -> Curve:
    """East, half round to the left, and back west."""
    from roadlang.geometry import Arc, Straight, chain

    return chain([Straight(leg), Arc(radius, np.pi), Straight(leg)], spacing=0.5).curve()


def self_intersects(batch: CurveBatch) -> np.ndarray:
    """(V,) whether each variant crosses or touches itself between its stations."""
    return np.isin(np.arange(batch.variants), self_crossings(batch)[0])


def rotation(angle: float) -> np.ndarray:
    return np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])


def _walk(turns: list[tuple[float, float]]) -> np.ndarray:
    steps = np.array([step for step, _ in turns])
    headings = np.cumsum([turn for _, turn in turns])
    moves = steps[:, None] * np.stack([np.cos(headings), np.sin(headings)], axis=1)
    return np.concatenate([np.zeros((1, 2)), np.cumsum(moves, axis=0)])


def walks(smallest: int = 1, largest: int = 12) -> st.SearchStrategy[np.ndarray]:
    """Points of a road that turns at most 0.8 rad from one to the next, 5 to 30 m apart."""
    step = st.tuples(st.floats(5.0, 30.0), st.floats(-0.8, 0.8))
    return st.lists(step, min_size=smallest, max_size=largest).map(_walk)


def _ring(radii: list[float]) -> np.ndarray:
    angle = np.linspace(0.0, 2.0 * np.pi, len(radii), endpoint=False)
    circle = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    return np.asarray(np.array(radii)[:, None] * circle)


def rings() -> st.SearchStrategy[np.ndarray]:
    """Points of a closed road round the origin."""
    return st.lists(st.floats(20.0, 30.0), min_size=6, max_size=12).map(_ring)


def curves() -> st.SearchStrategy[Curve]:
    """Open and closed curves."""
    return walks(smallest=2).map(Curve.through) | rings().map(lambda p: Curve.through(p, True))


angles = st.floats(-np.pi, np.pi)
shifts = st.tuples(st.floats(-1e4, 1e4), st.floats(-1e4, 1e4))
