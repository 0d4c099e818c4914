"""Blocks of scenes that are searched for together."""

from __future__ import annotations

import pytest

from roadlang.search.searching import _even_blocks


@pytest.mark.parametrize(
    ("scenes", "workers", "sizes"),
    [
        (400, 1, [133, 133, 134]),  # for a block of 16 more costs as much as one of 133
        (400, 2, [100] * 4),
        (1000, 2, [125] * 8),
        (400, 5, [80] * 5),
        (400, 7, [133, 133, 134]),  # blocks would be less than half as large
        (0, 2, []),
        (40, 8, [40]),
    ],
)
def test_every_worker_has_as_many_blocks_unless_they_were_small(
    scenes: int, workers: int, sizes: list[int]
) -> None:
    blocks = _even_blocks(1, 1 + scenes, 128, workers)
    assert [len(block) for block in blocks] == sizes
    assert [scene for block in blocks for scene in block] == [*range(1, 1 + scenes)]
