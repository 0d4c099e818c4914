"""Arc length of a planar piecewise cubic, and its inverse."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..arrays import Floats, SharedArrays
from ..errors import GeometryError
from .gauss_legendre import path_lengths, subdivided
from .spline import PiecewiseCubic
from .spline_rows import lengths_of_pieces

_FINEST = 64
_TOLERANCE = 1e-11


@dataclass(frozen=True, eq=False)
class ArcLength(SharedArrays):
    """A table of parameters (k,) and the arc length (k,) at each, fine enough to invert."""

    spline: PiecewiseCubic
    parameters: Floats
    lengths: Floats

    @classmethod
    def of(cls, spline: PiecewiseCubic) -> ArcLength:
        """Refines the table until halving its steps changes no length."""
        return cls.of_each([spline])[0]

    @classmethod
    def of_each(cls, splines: Sequence[PiecewiseCubic]) -> list[ArcLength]:
        """That of each spline, in order, as `of`."""
        cuts, open_ones = 4, list(range(len(splines)))
        lengths = lengths_of_pieces(splines, cuts)
        tables: dict[int, ArcLength] = {}
        while open_ones and cuts < _FINEST:
            cuts, refined = 2 * cuts, []
            halves = lengths_of_pieces([splines[index] for index in open_ones], cuts)
            for index, found in zip(open_ones, halves, strict=True):
                together = found.reshape(-1, 2).sum(axis=1)
                change = np.abs(together - lengths[index].ravel()).max()
                lengths[index] = found
                if change > _TOLERANCE * together.sum():
                    refined.append(index)
                else:
                    tables[index] = cls._with(splines[index], found)
            open_ones = refined
        for index in open_ones:
            tables[index] = cls._with(splines[index], lengths[index])
        return [tables[index] for index in range(len(splines))]

    @classmethod
    def _with(cls, spline: PiecewiseCubic, lengths: Floats) -> ArcLength:
        """The table of the lengths (m, cuts) of the steps into which the pieces are cut."""
        total = np.concatenate([[0.0], np.cumsum(lengths)])
        if not np.isfinite(total[-1]) or total[-1] <= 0.0:
            raise GeometryError("the curve has no finite length")
        knots = spline.knots
        inner = subdivided(knots[:-1], knots[1:], lengths.shape[1])
        return cls(spline, np.concatenate([inner.ravel(), knots[-1:]]), total)

    @property
    def total(self) -> float:
        """Meters."""
        return float(self.lengths[-1])

    def parameter(self, s: Floats) -> Floats:
        """The parameter at each arc length in [0, total], by Newton's method in its table cell."""
        cell = np.searchsorted(self.lengths, s, side="right") - 1
        cell = np.clip(cell, 0, len(self.lengths) - 2)
        low, high = self.parameters[cell], self.parameters[cell + 1]
        rest = s - self.lengths[cell]
        span = np.maximum(self.lengths[cell + 1] - self.lengths[cell], np.finfo(float).tiny)
        u = low + (high - low) * np.clip(rest / span, 0.0, 1.0)
        for _ in range(12):
            missing = rest - path_lengths(self.spline, low, u)
            speed = np.maximum(self.spline.speed(u), 1e-12)
            following = np.clip(u + missing / speed, low, high)
            moved = np.abs(following - u).max(initial=0.0)
            u = following
            # Newton's method squares the error: what is left is far below rounding.
            if moved <= 1e-9 * float(self.parameters[-1]):
                break
        return np.asarray(u)

    def length_at(self, u: Floats) -> Floats:
        """The arc length at each parameter, within its table cell whatever the rounding."""
        cell = np.searchsorted(self.parameters, u, side="right") - 1
        cell = np.clip(cell, 0, len(self.parameters) - 2)
        low, high = self.lengths[cell], self.lengths[cell + 1]
        length = low + path_lengths(self.spline, self.parameters[cell], u)
        return np.asarray(np.clip(length, low, high))
