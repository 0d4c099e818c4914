"""Systems with three diagonals."""

import subprocess
import sys

import numpy as np
import pytest
from scipy.linalg import solve_banded

from roadlang.geometry.numbers.tridiagonal import solve_tridiagonal


@pytest.mark.parametrize("dominant", [True, False])
@pytest.mark.parametrize("equations", [2, 3, 5, 64, 65, 200])
def test_solutions_are_those_of_lapack_to_the_last_bit(equations: int, dominant: bool) -> None:
    random = np.random.default_rng(equations)
    bands = random.normal(size=(3, equations))
    bands[1] *= 30.0 if dominant else 0.1  # rows are exchanged where it is small
    right = random.normal(size=(equations, 2))
    found = solve_tridiagonal(bands, right)
    np.testing.assert_array_equal(found, solve_banded((1, 1), bands, right))


def test_a_singular_system_is_refused() -> None:
    bands = np.array([[0.0, 1.0, 1.0], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]])
    with pytest.raises(ValueError, match="singular"):
        solve_tridiagonal(bands, np.ones((3, 1)))


@pytest.mark.parametrize("equations", [3, 100])
def test_numbers_that_are_not_finite_are_refused(equations: int) -> None:
    bands = np.ones((3, equations))
    bands[1, 1] = np.nan
    with pytest.raises(ValueError, match="NaN"):
        solve_tridiagonal(bands, np.ones((equations, 2)))


def test_a_road_through_few_points_does_not_load_scipy() -> None:
    """It takes as long as all else that a small scene needs."""
    code = (
        "import sys, roadlang\n"
        "text = 'road main { draw with waypoints {"
        " points: [(0m, 0m), (50m, 9m), (90m, 0m), (140m, 20m)] } }'\n"
        "roadlang.loads(text).sample(2)\n"
        "assert 'scipy' not in sys.modules\n"
    )
    subprocess.run([sys.executable, "-c", code], check=True)
