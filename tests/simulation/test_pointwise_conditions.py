"""Which conditions depend on the sample alone at which they are judged."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang import stl
from roadlang.simulation.signals.conditions import ControllerCondition


@pytest.mark.parametrize(
    ("text", "is_pointwise"),
    [
        ("x > 1", True),
        ("not (x > 1) and (y < 2 or x < 3)", True),
        ("(x > 1) implies (y < 2)", True),
        ("once[0, 1] (x > 1)", False),
        ("historically (x > 1)", False),
        ("(x > 1) since (y > 1)", False),
        ("prev (x > 1)", False),
        ("rise (x > 1)", False),
        ("(y > 1) and not (once[0, 2] (x > 1))", False),
    ],
)
def test_operators_that_look_back_are_not_pointwise(text: str, is_pointwise: bool) -> None:
    formula = stl.to_json(stl.parse(text))
    assert ControllerCondition(formula, {}, 1).is_pointwise is is_pointwise


def test_all_samples_at_once_are_as_one_after_the_other() -> None:
    rng = np.random.default_rng(1)
    x, limit = rng.normal(size=(30, 4)), np.array([0.0, 0.5, -0.5, 9.0])
    formula = stl.to_json(stl.parse("x < limit or x > 1"))
    condition = ControllerCondition(formula, {"limit": limit}, 4)
    together = condition.at_once(30, lambda name: x)
    for number, row in enumerate(x):
        alone = condition.now(float(number), {"x": row}.__getitem__)
        np.testing.assert_array_equal(together[number], alone)
    np.testing.assert_array_equal(together, (x < limit) | (x > 1))
