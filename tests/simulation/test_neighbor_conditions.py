"""`prev`, `rise` and `fall` in the conditions of controllers look at the step before."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang import DiagnosticError, stl
from roadlang.simulation.signals.conditions import ControllerCondition

STEPS = np.array([[1.0, -1.0], [-1.0, -1.0], [2.0, 3.0], [4.0, -2.0]])
"""(steps, agents) of the signal x"""


@pytest.mark.parametrize(
    "text", ["prev (x > 0)", "rise (x > 0)", "fall (x > 0)", "once[0, 1] (rise (x > 0))"]
)
def test_every_step_has_the_truth_of_the_trace(text: str) -> None:
    formula = stl.parse(text)
    condition = ControllerCondition(formula.to_json(), {}, 2)
    found = [condition.now(0.5 * k, lambda name, k=k: STEPS[k]) for k in range(4)]  # type: ignore[misc]
    np.testing.assert_array_equal(
        np.array(found).T, formula.truth(0.5 * np.arange(4), {"x": STEPS.T})
    )


def test_the_next_step_is_not_known() -> None:
    condition = ControllerCondition(stl.parse("next (x > 0)").to_json(), {}, 2)
    with pytest.raises(DiagnosticError, match="RL513"):
        condition.now(0.0, lambda name: STEPS[0])
