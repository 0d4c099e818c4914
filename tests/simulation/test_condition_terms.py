"""Terms of conditions are evaluated as formulas are, infinities among them."""

from __future__ import annotations

import warnings

import numpy as np
import pytest

from roadlang import stl
from roadlang.diagnostics import DiagnosticError
from roadlang.simulation.signals.conditions import ControllerCondition

NUMBERS = np.array([-np.inf, -2.0, -0.0, 0.0, 0.5, np.inf])
X, Y = (side.ravel() for side in np.meshgrid(NUMBERS, NUMBERS))


def holds(text: str) -> list[bool]:
    condition = ControllerCondition(stl.to_json(stl.parse(text)), {}, len(X))
    found: list[bool] = condition.now(0.0, {"x": X, "y": Y}.__getitem__).tolist()
    return found


@pytest.mark.parametrize("comparison", ["<", "<=", ">", ">=", "==", "!="])
@pytest.mark.parametrize(
    "term", ["x - y", "x + y", "x * y", "x / y", "-x - y", "abs(x) - y", "min(x, y) - max(x, y)"]
)
def test_a_condition_holds_where_its_formula_does(term: str, comparison: str) -> None:
    """Equal infinities are 0 apart, nothing warns, and 0 / 0 is 0."""
    formula = stl.parse(f"{term} {comparison} 0")
    truth = [
        bool(formula.truth(np.zeros(1), {"x": np.array([x]), "y": np.array([y])}))
        for x, y in zip(X, Y, strict=True)
    ]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert holds(f"{term} {comparison} 0") == truth


@pytest.mark.parametrize("text", ["x ^ 2 > y", "x > 0 and once (y - x ^ 2 > 0)"])
def test_conditions_have_no_powers(text: str) -> None:
    with pytest.raises(DiagnosticError, match="RL513") as caught:
        holds(text)
    assert "x^2" in str(caught.value).replace(" ", "")
