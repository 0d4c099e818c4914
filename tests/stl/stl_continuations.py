"""Continuations of a trace, many values on each of many choices of later positions."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from tests.stl_draws import NAMES

Floats = NDArray[np.float64]
_VALUES = np.array([-1e6, -50, -3, -2, -1.5, -1, -0.5, 0, 0.5, 1, 1.5, 2, 3, 50, 1e6])


def continuations(
    seed: int,
    positions: Floats,
    signals: dict[str, Floats],
    *,
    choices: int,
    variants: int,
    values: Floats = _VALUES,
) -> Iterator[tuple[Floats, dict[str, Floats]]]:
    """(positions, signals (variants, S)) that begin with the trace; the first is no longer."""
    rng = np.random.default_rng(seed)
    yield positions, {name: row[None] for name, row in signals.items()}
    for _ in range(choices):
        spacing = rng.choice([0.02, 0.1, 0.25, 0.5, 0.5, 1.3])
        count = int(rng.choice([1, 2, 5, 30, 80]))
        even = rng.random() < 0.7
        steps = np.full(count, spacing) if even else rng.choice([0.05, 0.3, 2.0, 9.0], count)
        later = positions[-1] + np.cumsum(steps)
        extended = {}
        for name in NAMES:
            switches = rng.random((variants, count)) < rng.choice([0.02, 0.2, 1.0])
            drawn = rng.choice(values, (variants, count))
            held = np.maximum.accumulate(np.where(switches, np.arange(count), 0), axis=1)
            ahead = np.take_along_axis(drawn, held, axis=1)
            seen = np.broadcast_to(signals[name], (variants, positions.size))
            extended[name] = np.concatenate([seen, ahead], axis=1)
        yield np.concatenate([positions, later]), extended
