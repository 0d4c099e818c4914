"""Which expectations have a margin at every moment, and that it is their robustness there."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from roadlang import stl
from roadlang.api import Verdict
from roadlang.envs.margins import _robustness, margin_formula
from tests.judging.test_drives import REGISTRY, condition

VALUES = {"x": np.array([-2.0, 0.5, 3.0, 0.5]), "y": np.array([1.0, 0.5, -1.0, 4.0])}


@pytest.mark.parametrize(
    "text",
    [
        "x < 1", "x <= y", "x > 1", "x >= y", "x == y", "x != y", "not x < 1",
        "x < 1 and y > 0", "x < 1 or y > 0", "x < 1 -> y > 0", "x < 1 <-> y > 0", "x < 1 xor y > 0",
        "x < 1 and y > 0 and x + y > 2", "not (x < 1 or y > 0)", "true", "false", "true -> x < 1",
        "abs(x) - y / 2 < max(x, y)", "x ^ 2 < y",
    ],
)  # fmt: skip
def test_a_margin_is_the_robustness_at_a_sample(text: str) -> None:
    formula = stl.parse(text)
    found = _robustness(stl.normal_form(formula), VALUES.__getitem__, 4)
    np.testing.assert_array_equal(found, formula.robustness(np.arange(4.0), VALUES))


@pytest.mark.parametrize("x", [np.inf, -np.inf, 0.0, 2.0])
@pytest.mark.parametrize("y", [np.inf, -np.inf, 0.0])
@pytest.mark.parametrize(
    "text", ["x < y", "x >= y", "x == y", "x != y", "x - y > 0", "x + y > 0", "x * y > 0",
             "x / y > 0", "min(x, y) - max(x, y) < 1"],
)  # fmt: skip
def test_equal_infinities_are_0_apart(text: str, x: float, y: float) -> None:
    formula, values = stl.parse(text), {"x": np.array([x]), "y": np.array([y])}
    found = _robustness(stl.normal_form(formula), values.__getitem__, 1)
    np.testing.assert_array_equal(found, formula.robustness(np.zeros(1), values))


SPEED = {"v": ("speed", {"agent": "ego"})}
NEAR = {"<": ["v", 12.0]}


def verdict(formula: Any, **changes: Any) -> Verdict:
    domain = changes.pop("domain", "drive")
    stated = {**condition(formula, **changes.pop("signals", SPEED)), **changes}
    return Verdict("ok", "", domain, None, None, formula=stated)


@pytest.mark.parametrize("formula", [NEAR, {"always": NEAR}, {"eventually": NEAR}])
def test_the_margin_of_always_is_that_of_what_always_holds(formula: Any) -> None:
    assert str(margin_formula(verdict(formula), REGISTRY)) == "v < 12"


@pytest.mark.parametrize(
    "without",
    [
        verdict(NEAR, domain="road"),
        Verdict("ok", "", "drive", None, None, formula=None),
        Verdict("ok", "", "drive", None, None, formula={"monitor": {"kind": "calm"}}),
        verdict({"always": {"eventually": NEAR}}),
        verdict({"and": [NEAR, {"once": NEAR}]}),
        verdict(NEAR, evaluation={"robustness": "time"}),
        verdict(NEAR, signals={"v": ("time", {})}),
    ],
    ids=["over a road", "no formula", "a monitor", "nested", "of the past", "a shift in time",
         "of nobody"],
)  # fmt: skip
def test_what_is_not_known_from_now_has_no_margin(without: Verdict) -> None:
    assert margin_formula(without, REGISTRY) is None
