"""The points of many lines at once are those of each line alone, to the last bit."""

from __future__ import annotations

import numpy as np

from roadlang_standard.extraction.even_points import even_points, even_points_of

RNG = np.random.default_rng(8)


def test_lines_of_all_lengths_have_the_points_that_each_has_alone() -> None:
    lines = [np.cumsum(RNG.normal(size=(count, 2)), axis=0) for count in [*range(2, 40), 300]]
    lines[7][3] = lines[7][2]  # two points in one place
    lines[9][:] = lines[9][0]  # no length
    steps = RNG.uniform(0.3, 4.0, len(lines)).tolist()
    for line, step, found in zip(lines, steps, even_points_of(lines, steps), strict=True):
        assert found.tobytes() == even_points(line, step=step).tobytes()


def test_of_no_lines_there_are_none() -> None:
    assert even_points_of([], []) == []
