"""Curves made together are those that each row of points makes alone, to the last bit."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang.geometry import Curve, GeometryError

RNG = np.random.default_rng(3)


def _line(count: int) -> np.ndarray:
    heading = np.cumsum(RNG.normal(0.0, 0.4, count))
    steps = RNG.uniform(0.5, 9.0, (count, 1)) * np.stack([np.cos(heading), np.sin(heading)], axis=1)
    return np.cumsum(steps, axis=0) + RNG.uniform(-900, 900, 2)


def test_curves_and_their_lengths_are_those_of_each_alone() -> None:
    lines = [_line(count) for count in [*range(2, 30), 90]]
    for line, curve in zip(lines, Curve.through_each(lines), strict=True):
        alone = Curve.through(line)
        assert curve.spline.knots.tobytes() == alone.spline.knots.tobytes()
        assert curve.spline.coefficients.tobytes() == alone.spline.coefficients.tobytes()
        assert curve.arc.parameters.tobytes() == alone.arc.parameters.tobytes()
        assert curve.arc.lengths.tobytes() == alone.arc.lengths.tobytes()
        assert curve.points.tobytes() == alone.points.tobytes()


def test_no_rows_make_no_curves_and_a_row_of_one_point_is_refused() -> None:
    assert Curve.through_each([]) == []
    with pytest.raises(GeometryError, match="at least 2 distinct points"):
        Curve.through_each([_line(5), np.zeros((3, 2))])
