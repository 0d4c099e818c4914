"""Rows of large arrays in blocks that fit the cache."""

from __future__ import annotations

from collections.abc import Iterator

from ..arrays import Floats

_NUMBERS = 1 << 15


def blocks(rows: Floats, numbers: int = _NUMBERS) -> Iterator[slice]:
    """Slices of the rows of a two-dimensional array, of `numbers` each at most: 256 KiB."""
    step = max(1, numbers // max(rows.shape[1], 1))
    for start in range(0, len(rows), step):
        yield slice(start, start + step)
