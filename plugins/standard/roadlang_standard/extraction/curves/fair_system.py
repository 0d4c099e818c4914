"""The linear system of a fair curve: offsets that are pulled, and hardly differ from each other."""

from __future__ import annotations

import numpy as np

from roadlang.geometry import Floats

_ZEROS = np.zeros(3)


def differences(values: Floats, order: int) -> Floats:
    """As `numpy.diff`, which takes longer for short lines."""
    for _ in range(order):
        values = values[1:] - values[:-1]
    return values


def spread(weighted: Floats, order: int) -> Floats:
    """The differences' transpose: (n,) of values (n - order,)."""
    return differences(_padded(weighted, order), order)


def system(pull: Floats, second: Floats, third: Floats) -> Floats:
    """Of sums of weighted squares of values (n,), weighted by `pull`, of their second differences
    (n - 2,) and of their third ones (n - 3,), the matrix, by its diagonals (4, n) from the main one
    down.

    Its entries are products of the differences' factors (1, -2, 1) and (-1, 3, -3, 1) that are 0,
    1, 2 and 3 points apart.
    """
    banded = np.zeros((len(pull), 4)).T  # by columns, as LAPACK reads it: else it is copied
    two, three = _padded(second, 2), _padded(third, 3)
    a, b, c = _shifted(two, 2)
    d, _, _, g = _shifted(three, 3)
    _, e3, f3, g3 = _shifted(3.0 * three, 3)
    _, e9, f9, _ = _shifted(9.0 * three, 3)
    banded[0] = pull + (a + 4.0 * b + c) + (d + e9 + f9 + g)
    banded[1, :-1] = -2.0 * (b + c)[:-1] - (e3 + f9 + g3)[:-1]
    banded[2, :-2] = second + (f3 + g3)[:-2]
    banded[3, :-3] = -third
    return banded


def _shifted(padded: Floats, order: int) -> list[Floats]:
    """Of padded values (n + order,) those of the differences that end, and so on, and begin at
    each point."""
    count = len(padded) - order
    return [padded[k : k + count] for k in range(order + 1)]


def _padded(values: Floats, order: int) -> Floats:
    return np.concatenate([_ZEROS[:order], values, _ZEROS[:order]])
