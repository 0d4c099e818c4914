"""Points and normals of many lines at once are those of each line alone, to the last bit."""

from __future__ import annotations

import numpy as np

from roadlang_standard.extraction.curves.edges import CenterLine, normals, normals_in_a_row
from roadlang_standard.extraction.curves.even_points import even_points, even_points_of

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


def test_normals_of_many_lines_are_those_of_each() -> None:
    lines = [CenterLine(RNG.normal(size=(count, 2))) for count in (2, 3, 50)]
    ring = RNG.normal(size=(9, 2))
    lines.insert(1, CenterLine(np.vstack([ring, ring[:1]]), closed=True))
    found = normals_in_a_row(np.concatenate([line.points for line in lines]), lines)
    alone = [normals(line.points, line.closed) for line in lines]
    assert found.tobytes() == np.concatenate(alone).tobytes()
