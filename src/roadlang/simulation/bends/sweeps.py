"""The ground that vehicles cover in bends, beside their lines and beyond their width."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ...geometry.curves.bend_room import STRAIGHT
from ..lines.lines import Lines
from ..vehicles.bodies import Bodies

LEAST = 0.2
"""Meters: a vehicle that covers less beyond its width (to first order) fits everywhere."""
SPREAD = 2.0
"""Meters along the line to each side for which a corner counts."""


@dataclass(frozen=True)
class Sweeps:
    """Of N agents; T tables over the M cells of their lines. Table 0 is that of who covers no more
    than its width."""

    table: Integers
    """(N,) the table of each agent"""
    left: Floats
    """(T, M) meters beyond the half width"""
    right: Floats

    @classmethod
    def of(cls, bodies: Bodies, lines: Lines, row: Integers, counts: Booleans) -> Sweeps:
        """`row`: (N,) the line of each agent; `counts`: whether it may meet anybody."""
        table = np.zeros(len(row), dtype=np.int64)
        sides = [np.zeros((2, lines.cells))]
        known: dict[tuple[float, ...], int] = {}
        for agent in np.flatnonzero(counts & ~bodies.walks).tolist():
            size = tuple(float(c[agent]) for c in (bodies.length, bodies.width, bodies.half_base))
            key = (float(row[agent]), *size)
            if key not in known:
                found = swept_beside(lines, int(row[agent]), *size)
                known[key] = len(sides) if found is not None else 0
                sides += [] if found is None else [found]
            table[agent] = known[key]
        both = np.stack(sides)
        return cls(table, np.ascontiguousarray(both[:, 0]), np.ascontiguousarray(both[:, 1]))

    @property
    def is_empty(self) -> bool:
        """Whether nobody covers more than its width."""
        return len(self.left) == 1

    def take(self, agents: Integers) -> Sweeps:
        """Those of some agents."""
        return Sweeps(self.table[agents], self.left, self.right)

    def at(self, agents: Integers, cell: Integers) -> tuple[Floats, Floats]:
        """Meters to the left and right at cells of the lines of some agents, counted in each line;
        the shape of `cell`, whose last axis is over the agents."""
        table = self.table[agents]
        return self.left[table, cell], self.right[table, cell]


def swept_beside(lines: Lines, row: int, length: float, width: float, base: float) -> Floats | None:
    """(2, M) meters to the left and right; None for a line without bends that matter. The middle is
    on the line, and the vehicle points along the line at its rear axle; in a bend of curvature `k`,
    with `f` meters from there to its front, it covers `(f^2 - base^2) k / 2` more outside."""
    first, last = row * lines.cells, int(lines.last[row])
    nodes = slice(first, first + last + 1)
    spacing = float(lines.spacing[row])
    around = math.ceil((0.5 * length + SPREAD) / spacing)
    bend = np.abs(lines.seen_curvature[nodes])
    front = base + 0.5 * length
    if 0.5 * (front * front - base * base) * float(bend.max()) < LEAST:
        return None
    is_bend = bend > STRAIGHT
    wide = np.convolve(is_bend, np.ones(2 * around + 1))
    near = wide[around : around + last + 1] > 0.0
    x, y, heading = (column[nodes] for column in (lines.x, lines.y, lines.heading))
    middle = np.flatnonzero(near)
    body = np.interp(middle - base / spacing, np.arange(last + 1), heading)
    cosine, sine = np.cos(body), np.sin(body)
    out = np.zeros((2, lines.cells))
    behind = np.arange(-around, around + 1)
    for forward in (0.5 * length, 0.0, -base, -0.5 * length):
        for side, left in enumerate((0.5 * width, -0.5 * width)):
            at_x = x[middle] + cosine * forward - sine * left
            at_y = y[middle] + sine * forward + cosine * left
            cells = np.clip(middle[:, None] + behind, 0, last)
            square = (at_x[:, None] - x[cells]) ** 2 + (at_y[:, None] - y[cells]) ** 2
            foot = cells[np.arange(len(middle)), square.argmin(axis=1)]
            across = np.cos(heading[foot]) * (at_y - y[foot])
            across = across - np.sin(heading[foot]) * (at_x - x[foot])
            np.maximum.at(out[side], foot, np.abs(across) - 0.5 * width)
    return _spread(out, math.ceil(SPREAD / spacing))


def _spread(values: Floats, cells: int) -> Floats:
    """(2, M) the greatest within so many cells."""
    wide = np.pad(values, ((0, 0), (cells, cells)), mode="edge")
    windows = np.lib.stride_tricks.sliding_window_view(wide, 2 * cells + 1, axis=1)
    return np.asarray(windows.max(axis=2))
