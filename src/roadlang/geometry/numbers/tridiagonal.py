"""Systems of equations with three diagonals, as splines have them."""

from __future__ import annotations

import numpy as np

from ..arrays import Floats

_FEW = 64
"""Equations that are solved here: loading `scipy.linalg` takes as long as thousands of them."""


def solve_tridiagonal(bands: Floats, right: Floats) -> Floats:
    """(n, k) the solutions of n equations for k right sides. `bands` (3, n): the diagonal above the
    main one from its second place on, the main one, and the one below, whose last place is unused.

    Gaussian elimination with row exchanges (`dgtsv` of LAPACK: Anderson et al. 1999), to the last
    bit the same for few equations and for many. Raises ValueError for a singular system, and where
    numbers are not finite.
    """
    if not (np.isfinite(bands).all() and np.isfinite(right).all()):
        raise ValueError("a system of equations must not contain infs or NaNs")
    if len(right) > _FEW:
        from scipy.linalg import LinAlgError, solve_banded

        try:
            return np.asarray(solve_banded((1, 1), bands, right))
        except LinAlgError as error:
            raise ValueError(str(error)) from error
    above, main, below = bands[0, 1:].tolist(), bands[1].tolist(), bands[2, :-1].tolist()
    sides = [_solved(list(above), list(main), list(below), side) for side in right.T.tolist()]
    return np.array(sides).T


def _solved(
    above: list[float], main: list[float], below: list[float], x: list[float]
) -> list[float]:
    """One right side; all lists are changed."""
    last = len(main) - 1
    for row in range(last):
        after = row + 1
        if below[row] == 0.0:
            _check(main[row])
            continue
        if abs(main[row]) >= abs(below[row]):
            factor = below[row] / main[row]
            main[after] -= factor * above[row]
            x[after] -= factor * x[row]
            below[row] = 0.0  # from here on what is two places above the main diagonal
            continue
        factor = main[row] / below[row]
        main[row], above[row], main[after] = (
            below[row], main[after], above[row] - factor * main[after],
        )  # fmt: skip
        below[row] = 0.0
        if after < last:
            below[row], above[after] = above[after], -factor * above[after]
        x[row], x[after] = x[after], x[row] - factor * x[after]
    _check(main[last])
    for row in range(last, -1, -1):
        value = x[row]
        if row < last:
            value -= above[row] * x[row + 1]
        if row < last - 1:
            value -= below[row] * x[row + 2]
        x[row] = value / main[row]
    return x


def _check(pivot: float) -> None:
    if pivot == 0.0:
        raise ValueError("singular matrix")
