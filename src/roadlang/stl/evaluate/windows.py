"""Which samples each window of a temporal operator holds."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

IntArray = NDArray[np.intp]
BoolArray = NDArray[np.bool_]


@dataclass(frozen=True)
class Windows:
    """Samples `starts[k]..ends[k]` of the operand for each sample that is evaluated; end < start:
    none.

    Past operators look at time backwards (`flipped`), closed roads repeat the operand (`laps`);
    `starts`, `ends` and `first` count from the beginning of the operand's `span` seen that way.
    `span` is the samples of the operand that are needed, in their own order.
    """

    starts: IntArray
    ends: IntArray
    first: int
    span: tuple[int, int]
    flipped: bool
    laps: int
    known_even: tuple[int, int] | None = None
    """`even`, where that is known without a look at every window."""

    @property
    def count(self) -> int:
        """Number of windows."""
        return int(self.starts.size)

    def samples(self, window: int) -> IntArray:
        """The samples of one window as indices on the axis, from its near end to its far end."""
        return self._on_axis(np.arange(self.starts[window], self.ends[window] + 1))

    def before(self, window: int, sample: int) -> IntArray:
        """For until: the samples from the one that is evaluated to the `sample`-th of its
        window."""
        return self._on_axis(np.arange(self.first + window, self.starts[window] + sample))

    def reached(self, chosen: BoolArray, *, path: bool) -> BoolArray:
        """(span,) which samples of the span the `chosen` windows (count,) hold; `path`: and those
        on the way to them."""
        held = chosen & (self.ends >= self.starts)
        starts = self.first + np.flatnonzero(held) if path else self.starts[held]
        samples = self.span[1] - self.span[0] + 1
        edges = np.zeros(samples * self.laps + 1, dtype=np.intp)
        np.add.at(edges, starts, 1)
        np.add.at(edges, self.ends[held] + 1, -1)
        covered = (np.cumsum(edges[:-1]) > 0).reshape(self.laps, samples)
        reached: BoolArray = np.asarray(covered.any(axis=0))
        return reached[::-1] if self.flipped else reached

    def _on_axis(self, counted: IntArray) -> IntArray:
        low, high = self.span
        counted = counted % (high - low + 1)
        return high - counted if self.flipped else low + counted

    @cached_property
    def even(self) -> tuple[int, int] | None:
        """(offset, width) if window k is [k + offset, k + offset + width), clipped at the end."""
        if self.known_even is not None:
            return self.known_even
        last = (self.span[1] - self.span[0] + 1) * self.laps - 1
        steps = np.arange(self.count)
        offset = int(self.starts[0])
        width = int((self.ends - steps).max()) - offset + 1
        regular = (self.starts == np.minimum(offset + steps, last + 1)).all()
        clipped = np.minimum(offset + width - 1 + steps, last)
        return (offset, width) if regular and (self.ends == clipped).all() else None
