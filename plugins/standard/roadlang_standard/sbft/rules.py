"""The rules of the competition: by how much roads keep them."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .interpolation import interpolated

Floats = NDArray[np.float64]

MOST_POINTS = 500
LEAST_LENGTH = 20.0
HALF_WIDTH = 4.0
FEET = 3.280839895
"""in a meter"""
LEAST_RADIUS = 47.0 / FEET
STRAIGHT = 1e-6
"""m^2: less is a circle through points of a straight line"""
MOST = 100.0
"""Meters: no rule is kept by more."""
AT_ONCE = 256
"""Roads judged together, so that their arrays stay in the cache of a processor."""
FAR = 40
"""Nodes: parts of the road that are nearer along it cannot meet unless it bends more sharply than
the rule of radii allows (arcs of less than half a circle; Schur's comparison theorem)."""
CLOSE = 2.0 * HALF_WIDTH + 2.0
"""Meters: quadrangles of a meter in length whose middles are farther apart do not touch."""
EVERY = 4
"""Nodes that are skipped in the first look for parts that meet."""


@dataclass(frozen=True)
class RuleMargins:
    """By how many meters V roads keep each rule; negative: not. Columns (V,)."""

    inside: Floats
    """distance of the edges of the road from those of the map"""
    apart: Floats
    """negative where a cross section crosses the next one; of roads that keep all other rules, the
    distance of parts of the road from other parts"""
    radius: Floats
    """the least radius, more than the least allowed"""
    length: Floats

    @property
    def robustness(self) -> Floats:
        """The least of all."""
        columns = (self.inside, self.apart, self.radius, self.length)
        return np.asarray(np.minimum.reduce(columns))


def judged(points: Floats, size: float) -> RuleMargins:
    """Roads (V, n, 2) in a map of `size` meters."""
    if points.shape[1] > MOST_POINTS:
        none = np.full(len(points), -1.0)
        return RuleMargins(none, none, none, none)
    parts = [
        _judged(points[start : start + AT_ONCE], size) for start in range(0, len(points), AT_ONCE)
    ]
    return RuleMargins(*(np.concatenate(columns) for columns in zip(*parts, strict=True)))


def _judged(points: Floats, size: float) -> tuple[Floats, Floats, Floats, Floats]:
    nodes, counts = interpolated(points)
    is_node = np.arange(nodes.shape[1]) < counts[:, None]
    x, y = np.ascontiguousarray(nodes[..., 0]), np.ascontiguousarray(nodes[..., 1])
    steps_x, steps_y = np.diff(x, axis=1), np.diff(y, axis=1)
    chords = np.sqrt(steps_x * steps_x + steps_y * steps_y)
    least = np.where(chords > 0.0, chords, math.inf)
    ahead_x, ahead_y = _with_last(steps_x / least, counts), _with_last(steps_y / least, counts)
    sides = [
        (x - side * HALF_WIDTH * ahead_y, y + side * HALF_WIDTH * ahead_x) for side in (1.0, -1.0)
    ]
    inside = np.full(len(points), MOST)
    for edge in sides:
        for column in edge:
            margin = np.minimum(column, size - column).min(axis=1)  # the rest repeats the last
            inside = np.minimum(inside, margin)
    apart = _folds((x, y), (ahead_x, ahead_y), sides, is_node[:, 1:])
    radius, length = _radius_left(x, y, counts), chords.sum(axis=1) - LEAST_LENGTH
    good = np.flatnonzero(np.minimum.reduce((inside, apart, radius, length)) >= 0.0)
    apart[good] = np.minimum(apart[good], _far_apart(nodes, counts, sides, good))
    return inside, apart, radius, length


def _with_last(ahead: Floats, counts: NDArray[np.int64]) -> Floats:
    """(V, N) directions at nodes: toward the next, at the last one as before it."""
    out = np.concatenate([ahead, np.zeros((len(ahead), 1))], axis=1)
    column = np.arange(out.shape[1])
    place = np.minimum(column, counts[:, None] - 2)
    return np.asarray(np.take_along_axis(out, place, axis=1))


def _folds(
    nodes: tuple[Floats, Floats],
    ahead: tuple[Floats, Floats],
    sides: list[tuple[Floats, Floats]],
    exists: NDArray[np.bool_],
) -> Floats:
    """(V,) where a bend is so sharp that a cross section crosses the next one, by how far, as a
    negative number."""
    found = np.full(len(exists), MOST)
    for x, y in sides:
        behind = (nodes[0][:, 1:] - x[:, :-1]) * ahead[0][:, 1:]
        behind += (nodes[1][:, 1:] - y[:, :-1]) * ahead[1][:, 1:]
        before = (x[:, 1:] - nodes[0][:, :-1]) * ahead[0][:, :-1]
        before += (y[:, 1:] - nodes[1][:, :-1]) * ahead[1][:, :-1]
        least = np.where(exists, np.minimum(behind, before), MOST).min(axis=1)
        found = np.minimum(found, least)
    return np.where(found < 0.0, found, MOST)


def _radius_left(x: Floats, y: Floats, counts: NDArray[np.int64]) -> Floats:
    """(V,) the least radius of the circles through every second of five nodes, more than allowed;
    the last five are not looked at, and straight roads have none."""
    p, q, r = ((x[:, i : -4 + i or None], y[:, i : -4 + i or None]) for i in (0, 2, 4))
    square = q[0] * q[0] + q[1] * q[1]
    first = (p[0] * p[0] + p[1] * p[1] - square) / 2.0
    second = (square - r[0] * r[0] - r[1] * r[1]) / 2.0
    twice = (p[0] - q[0]) * (q[1] - r[1]) - (q[0] - r[0]) * (p[1] - q[1])
    is_bend = (np.abs(twice) >= STRAIGHT) & (np.arange(twice.shape[1]) < counts[:, None] - 5)
    twice = np.where(is_bend, twice, 1.0)
    center_x = (first * (q[1] - r[1]) - second * (p[1] - q[1])) / twice
    center_y = ((p[0] - q[0]) * second - (q[0] - r[0]) * first) / twice
    square = (center_x - p[0]) * (center_x - p[0]) + (center_y - p[1]) * (center_y - p[1])
    radius = np.sqrt(np.where(is_bend, square, math.inf)).min(axis=1)
    return np.asarray(np.minimum(radius - LEAST_RADIUS, MOST))


def _far_apart(
    nodes: Floats,
    counts: NDArray[np.int64],
    sides: list[tuple[Floats, Floats]],
    rows: NDArray[np.int64],
) -> Floats:
    """(R,) the least gap between parts of some roads that are far from each other along the road.

    First between every fourth node, then between the quadrangles around those that are near.
    """
    out = np.full(len(rows), MOST)
    some = nodes[rows, ::EVERY]
    first, second = np.triu_indices(some.shape[1], FAR // EVERY)
    if not len(first) or not len(rows):
        return out
    x, y = np.ascontiguousarray(some[..., 0].T), np.ascontiguousarray(some[..., 1].T)
    off_x, off_y = x[first] - x[second], y[first] - y[second]
    square = off_x * off_x + off_y * off_y
    square[(second * EVERY)[:, None] >= counts[rows]] = math.inf
    distance = 2.0 * HALF_WIDTH + EVERY + 2.0
    out = np.minimum(np.sqrt(square.min(axis=0)) - 2.0 * HALF_WIDTH, MOST)
    pair, row = np.nonzero(square < distance * distance)
    if len(pair):
        near = np.full(len(rows), math.inf)
        _nearest_quads(near, row, (first[pair], second[pair]), (sides, counts, rows))
        out = np.where(np.isfinite(near), near, np.maximum(out, 1.0))
    return out


def _nearest_quads(
    near: Floats,
    row: NDArray[np.int64],
    pair: tuple[NDArray[np.int64], NDArray[np.int64]],
    roads: tuple[list[tuple[Floats, Floats]], NDArray[np.int64], NDArray[np.int64]],
) -> None:
    """Put into `near` (R,) the least gap between quadrangles around pairs of nodes, of rows."""
    sides, counts, rows = roads
    offset = np.arange(-EVERY // 2, EVERY // 2)
    i, j = np.broadcast_arrays(
        (pair[0] * EVERY)[:, None, None] + offset[:, None],
        (pair[1] * EVERY)[:, None, None] + offset,
    )
    road = np.broadcast_to(rows[row][:, None, None], i.shape).ravel()
    owner = np.broadcast_to(row[:, None, None], i.shape).ravel()
    i, j = i.ravel(), j.ravel()
    exists = (i >= 0) & (j < counts[road] - 1)
    road, owner, i, j = road[exists], owner[exists], i[exists], j[exists]
    a, b = _corners(sides, road, i), _corners(sides, road, j)
    apart = (a.sum(axis=1) - b.sum(axis=1)) / 4.0
    close = (apart * apart).sum(axis=1) <= CLOSE * CLOSE
    np.minimum.at(near, owner[close], _gaps(a[close], b[close]))


def _corners(
    sides: list[tuple[Floats, Floats]], road: NDArray[np.int64], i: NDArray[np.int64]
) -> Floats:
    """(P, 4, 2) corners of the quadrangles after the nodes `i` of some roads."""
    (left_x, left_y), (right_x, right_y) = sides
    columns = [
        (left_x[road, i], left_y[road, i]), (left_x[road, i + 1], left_y[road, i + 1]),
        (right_x[road, i + 1], right_y[road, i + 1]), (right_x[road, i], right_y[road, i]),
    ]  # fmt: skip
    return np.array(columns).transpose(2, 0, 1)


def _gaps(a: Floats, b: Floats) -> Floats:
    """(P,) of pairs of convex quadrangles (P, 4, 2): the greatest separation along the normals of
    their edges; negative where they overlap."""
    best = np.full(len(a), -math.inf)
    for box in (a, b):
        edges = np.roll(box, -1, axis=1) - box
        normals = np.stack((-edges[..., 1], edges[..., 0]), -1)
        length = np.sqrt((normals * normals).sum(axis=-1, keepdims=True))
        normals = normals / np.where(length > 0.0, length, 1.0)
        for side in range(4):
            axis = normals[:, side, None]
            p, q = (a * axis).sum(axis=-1), (b * axis).sum(axis=-1)
            gap = np.maximum(p.min(1) - q.max(1), q.min(1) - p.max(1))
            best = np.maximum(best, gap)
    return best
