"""By how much time a verdict may come early or late before it changes."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from roadlang import stl
from roadlang.stl.formula.shapes import Compound
from tests.stl_draws import FormulaDraw, draw_trace
from tests.stl_reference import Reference


def _of_comparison(holds: list[bool], positions: Any, way: int) -> list[float]:
    """By its definition: to the last neighbor that is alike."""
    found = []
    for k, value in enumerate(holds):
        last = k
        while 0 <= last + way < len(holds) and holds[last + way] == value:
            last += way
        distance = abs(float(positions[last] - positions[k]))
        found.append(distance if value else -distance)
    return found


@pytest.mark.parametrize("direction", ["right", "left"])
@pytest.mark.parametrize("seed", range(36))
def test_it_is_that_of_the_definitions(seed: int, direction: Any) -> None:
    formula = stl.normal_form(FormulaDraw(seed).formula(1 + seed % 2))
    positions, signals = draw_trace(seed, (1, 2, 9)[seed % 3], 2, even=seed % 2 == 0)
    found = stl.time_robustness(formula, positions, signals, direction=direction)
    for variant in range(2):
        row = {name: values[variant] for name, values in signals.items()}
        timed, columns = formula, {}

        def replaced(part: stl.Formula) -> stl.Formula:
            if isinstance(part, stl.Comparison):
                holds = Reference(positions, row).satisfied(part)  # noqa: B023
                way = 1 if direction == "right" else -1
                columns[str(part)] = _of_comparison(holds, positions, way)  # noqa: B023
                return stl.Comparison(">", stl.Variable(str(part)), stl.Constant(0.0))
            if isinstance(part, Compound):
                return part.with_parts([replaced(p) for p in part.parts])
            return part

        timed = replaced(formula)
        expected = Reference(positions, columns).rho(timed)
        np.testing.assert_allclose(found[variant], expected, atol=1e-9)


def test_the_sign_is_that_of_robustness() -> None:
    formula, x = stl.parse("always[0, 1] (x > 0)"), {"x": [1, 1, 1, -1, -1]}
    found = stl.time_robustness(formula, [0, 1, 2, 3, 4], x)
    np.testing.assert_array_equal(found, [1, 0, -1, -1, -0.0])
