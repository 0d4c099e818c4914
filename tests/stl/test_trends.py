"""How the robustness of an operator moves with that of its parts: `trends`, in all small cases."""

from __future__ import annotations

from itertools import product

import pytest

from roadlang import stl
from roadlang.stl.formula.formulas import COMPOUNDS, Pointwise

VALUES = (-3.0, -1.0, 2.0, 4.0)
OPERATORS = [kind for kind in COMPOUNDS.values() if issubclass(kind, Pointwise)]


def parts_of(kind: type[Pointwise]) -> list[stl.Formula]:
    count = 1 if kind is stl.Not else 2
    return [stl.parse(f"p{number} > 0") for number in range(count)]


def robustness(formula: stl.Formula, values: tuple[float, ...]) -> float:
    signals = {f"p{number}": [value] for number, value in enumerate(values)}
    return float(formula.rho([0.0], signals))


@pytest.mark.parametrize("kind", OPERATORS, ids=lambda kind: kind.__name__)
def test_the_robustness_moves_with_each_part_as_its_trend_says(kind: type[Pointwise]) -> None:
    formula = kind.of(parts_of(kind))
    count = len(formula.parts)
    assert len(formula.trends) == count
    for place, trend in enumerate(formula.trends):
        moves = set()
        for values in product(VALUES, repeat=count):
            raised = tuple(v + 0.5 * (number == place) for number, v in enumerate(values))
            change = robustness(formula, raised) - robustness(formula, values)
            moves |= {(change > 0) - (change < 0)} - {0}
        assert moves == ({trend} if trend else {-1, 1})


@pytest.mark.parametrize("kind", OPERATORS, ids=lambda kind: kind.__name__)
def test_the_robustness_is_that_of_a_part_its_sign_turned_or_not(kind: type[Pointwise]) -> None:
    formula = kind.of(parts_of(kind))
    for values in product((-4.0, -3.0, -1.0, 2.0, 5.0), repeat=len(formula.parts)):
        signs = [(-1, 1) if trend == 0 else (trend,) for trend in formula.trends]
        possible = {sign * v for v, these in zip(values, signs, strict=True) for sign in these}
        assert robustness(formula, values) in possible
