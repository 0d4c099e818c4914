"""What is known of the variables of a formula before any road is made, and once draws are known."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from roadlang.evaluate.candidates import CandidateBatch
from roadlang.ir.values import Condition
from roadlang.judging.acceptance import Acceptance
from roadlang.judging.variable_bounds import ROUNDING, CandidateBounds, ScenarioBounds
from tests.straight_road import STRAIGHT

TEXT = '''
param most = 1m..3m
road bent from main {
  perturb with sine { amplitude: most, wavelength: 80m }
  perturb with bump { at: 50m, height: -2m, length: 40m }
}
road wide from main { width: 5m..6m }
image plan from """
#########
""" { scale: 20m/px, legend: { "#": road } }
network town from plan
network wavy from town { perturb with sine { amplitude: 1m, wavelength: 60m } }
'''
BENT, INF = 5.0, np.inf


def stated(formula: str, acceptance: Callable[[str], Acceptance]) -> tuple[Acceptance, Condition]:
    found = acceptance(STRAIGHT + TEXT + f"require this: {formula}\n")
    (test,) = (each.test for each in found.requirements if each.name == "this")
    assert isinstance(test, Condition)
    return found, test


@pytest.mark.parametrize(
    ("formula", "bounds"),
    [
        ("always (deviation(bent, main) < 5m)", [(0.0, BENT)]),
        ("always (distance(bent, main) < 5m)", [(0.0, BENT)]),
        ("always (deviation(wide, main) < 5m)", [(0.0, 0.0)]),
        ("always (deviation(wavy, town) < 5m)", [(0.0, INF)]),  # drawn anew for each of its roads
        ("always (deviation(town, town) < 5m)", [(0.0, 0.0)]),
        ("always (width(wide) < 9m)", [(-INF, INF)]),
        ("always (deviation(bent, main) < 2 * most)", [(0.0, BENT), (1.0, 3.0)]),
        ("length(main) > 1m", [(0.0, INF)]),
    ],
)
def test_kinds_state_bounds_for_all_draws(
    formula: str, bounds: list[tuple[float, float]], acceptance: Callable[[str], Acceptance]
) -> None:
    found, test = stated(formula, acceptance)
    variables = ScenarioBounds(found.scenario).variables(test)
    for (low, high), (least, greatest) in zip(variables.values(), bounds, strict=True):
        assert np.ravel(low) == pytest.approx([least], abs=2 * ROUNDING)
        assert np.ravel(high) == pytest.approx([greatest], abs=6 * ROUNDING)


def test_with_known_draws_they_are_closer_and_a_little_wider_than_stated(
    acceptance: Callable[[str], Acceptance],
) -> None:
    """A sine and a bump of 2 m; computed values are rounded, and stated ones are not."""
    found, test = stated("always (deviation(bent, main) < 2 * most)", acceptance)
    candidates = CandidateBatch(found.scenario, 0, np.zeros(4, np.int64), np.arange(4))
    known = CandidateBounds(candidates).variables(test)
    most = np.ravel(known["most"][0])
    assert (known["most"][1] == known["most"][0]).all()
    assert len(set(most.tolist())) == 4
    low, high = known["deviation(bent, main)"]
    assert np.ravel(low).tolist() == [-ROUNDING]
    np.testing.assert_array_equal(high, (most + 2.0) + ROUNDING * (most + 2.0))
