"""An explanation leads from the formula to the meter, the comparison and the value to blame."""

from __future__ import annotations

import json
import math
from typing import Any

import numpy as np
import pytest

from roadlang import stl
from tests.stl_draws import FormulaDraw, draw_trace


def _explain(text: Any, **signals: Any) -> Any:
    samples = len(next(iter(signals.values())))
    return stl.parse(text).explain(np.arange(float(samples)), signals)


def test_the_chain_ends_at_the_comparison_that_decides() -> None:
    found = _explain("always (e > 6 implies eventually[1, 2] (e < 3))", e=[0, 7, 5, 4, 2])
    assert [(link.formula, link.position, link.rho) for link in found.chain] == [
        ("always (e > 6 implies eventually[1, 2] (e < 3))", 0, -1),
        ("e > 6 implies eventually[1, 2] (e < 3)", 1, -1),
        ("e > 6", 1, 1),
    ]
    assert (found.position, found.predicate, found.values) == (1, "e > 6", {"e": 7})
    assert found.verdict == "violated"


def test_all_violated_stretches_are_told() -> None:
    found = _explain("always (x < 5 and y > 0)", x=[1, 6, 7, 1, 9], y=[1, 1, -2, 1, 1])
    assert [(s.start, s.end, s.predicate, s.worst, s.worst_position) for s in found.stretches] == [
        (1, 2, "x < 5", -2, 2),
        (2, 2, "y > 0", -2, 2),
        (4, 4, "x < 5", -4, 4),
    ]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("eventually[0, 2] (x > 9)", [(0, 2)]),
        ("not always[0, 2] (x < 9)", [(0, 2)]),
        ("(x < 6) until[3, 4] (x > 9)", [(1, 1), (3, 4)]),
        ("not (x > 0 until x > 5)", [(0, 4), (1, 1)]),
        ("always (x > 0)", []),
        ("x < 9 iff x < 1", [(0, 0), (0, 0)]),
    ],
)
def test_stretches_of_each_operator(text: str, expected: Any) -> None:
    found = _explain(text, x=[1, 6, 4, 3, 2])
    assert [(s.start, s.end) for s in found.stretches] == expected


def test_strictness_decides_at_zero() -> None:
    assert len(_explain("always (x > 0)", x=[1, 0, 1]).stretches) == 1
    assert _explain("always (x >= 0)", x=[1, 0, 1]).stretches == ()


def test_an_empty_window_is_named() -> None:
    found = _explain("eventually[9, 12] (x > 0)", x=[1, 2])
    assert (found.rho, found.window_empty) == (-math.inf, True)
    assert "no sample in the window of eventually[9, 12] (x > 0)" in str(found)
    assert json.loads(json.dumps(found.to_json()))["rho"] == "-inf"


@pytest.mark.parametrize("seed", range(30))
@pytest.mark.parametrize("closed", [False, True])
def test_every_link_is_worth_what_the_whole_is(seed: int, closed: bool) -> None:
    formula = FormulaDraw(seed).formula(1 + seed % 3)
    positions, signals = draw_trace(seed, 9, 2, even=seed % 2 == 0)
    wrap = float(positions[-1] - positions[0]) + 0.5 if closed else None
    found = formula.explain(positions, signals, variant=1, wrap=wrap)
    assert found.rho == formula.rho(positions, signals, wrap=wrap)[1]
    if not found.window_empty:
        assert {abs(link.rho) for link in found.chain} == {abs(found.rho)}
    satisfied = formula.satisfied(positions, signals, wrap=wrap)[1]
    assert satisfied or found.stretches or math.isinf(found.rho) or "true" in str(formula)
    assert not (satisfied and found.stretches)
