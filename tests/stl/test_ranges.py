"""[lo, hi] holds the robustness of every continuation, and no less than that."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from roadlang import stl
from roadlang.stl.formula.normal_form import normal_form
from roadlang.stl.formula.strengthening import strengthened
from tests.stl.stl_continuations import continuations
from tests.stl_draws import FormulaDraw, draw_trace


def _seen(seed: Any, samples: Any) -> Any:
    positions, signals = draw_trace(seed, samples, 1, even=seed % 2 == 0)
    return positions, {name: values[0] for name, values in signals.items()}


MANY = [pytest.param(seed, marks=pytest.mark.slow) for seed in range(40, 120)]


@pytest.mark.parametrize("seed", [*range(40), *MANY])
def test_no_continuation_leaves_the_range(seed: Any) -> None:
    formula = FormulaDraw(seed).formula(1 + seed % 3)
    positions, row = _seen(seed, (1, 2, 5, 9, 14)[seed % 5])
    lo, hi = (float(end) for end in formula.range(positions, row))
    for later, signals in continuations(seed, positions, row, choices=12, variants=60):
        rho = formula.rho(later, signals)
        assert lo - 1e-9 <= rho.min()
        assert rho.max() <= hi + 1e-9


def _reached(seed: Any) -> Any:
    """Whether random continuations come to both ends (or beyond 1e5 where an end is infinite).

    Infinite intervals are left out: only a continuation without end reaches their range.
    """
    formula = FormulaDraw(seed, bounded=True, past=seed % 3 == 0).formula(1 + seed % 3)
    positions, row = _seen(seed, (1, 2, 5, 9, 14)[seed % 5])
    lo, hi = (float(end) for end in formula.range(positions, row))
    least, greatest = max(lo + 1e-9, -1e5), min(hi - 1e-9, 1e5)
    low = high = False
    for later, signals in continuations(seed, positions, row, choices=40, variants=150):
        rho = np.asarray(formula.rho(later, signals))
        low |= bool(rho.min() <= least)
        high |= bool(rho.max() >= greatest)
        if low and high:
            return True
    return False


@pytest.mark.parametrize("seed", range(30))
def test_continuations_reach_both_ends(seed: int) -> None:
    assert _reached(seed)


@pytest.mark.slow
def test_both_ends_are_reached_but_where_luck_fails() -> None:
    """Some ends need one of many later samples at one instant: random ones may miss it."""
    reached = [_reached(seed) for seed in range(200)]
    assert sum(reached) >= 0.97 * len(reached)


@pytest.mark.parametrize("seed", [*range(40), *MANY])
def test_verdicts_hold_for_every_continuation(seed: Any) -> None:
    """Signals and bounds are whole numbers, so that robustness is often zero."""
    formula = FormulaDraw(seed, bounded=True).formula(1 + seed % 3)
    positions, row = _seen(seed, (1, 3, 6)[seed % 3])
    row = {name: np.round(values) for name, values in row.items()}
    verdict = formula.verdict(positions, row)
    whole = np.arange(-4.0, 5.0)
    for later, signals in continuations(
        seed, positions, row, choices=10, variants=60, values=whole
    ):
        satisfied = formula.satisfied(later, signals)
        assert verdict != "satisfied" or satisfied.all()
        assert verdict != "violated" or not satisfied.any()


@pytest.mark.parametrize(
    ("text", "lo", "hi"),
    [
        ("always (x > 0)", -math.inf, 1),
        ("always[0, 2] (x > 0)", 1, 1),
        ("always[0, 3] (x > 0)", -math.inf, 1),
        ("eventually[5, 9] (abs(x) < 3)", -math.inf, 3),
        ("eventually[5, 9] (x < 1 and x > 2)", -math.inf, -0.5),
        ("eventually[5, 9] (x + y < 1 and x > 2 and y > 0)", -math.inf, -1 / 3),
        ("eventually[5, 9] historically[0, 3] (x < 9)", -math.inf, math.inf),
        ("eventually[3, 4] historically[2, 9] (x < 9)", -math.inf, 7),
        ("eventually[5, 9] (x > limit and x < 4)", -math.inf, 1),
        ("(x > 0) until (y > 5)", -4, 1),
        ("x > 0 iff always (y > 0)", -1, 1),
        ("always (x > 0) and eventually (x < -1)", -math.inf, -0.5),
        ("eventually (x > 5) or always (x < 4)", -0.5, math.inf),
        ("always[0, 9] (x > y) and (x < 9) until[3, 8] (x + 2 < y)", -math.inf, -1),
        ("eventually[5, 9] (x * x < 3)", -math.inf, 3),
        ("eventually[5, 9] (x ^ 2 < 3 and x * y > 5)", -math.inf, 3),
    ],
)
def test_ranges_known_by_hand(text: str, lo: float, hi: float) -> None:
    signals: dict[str, Any] = {"x": [1, 2, 3], "y": [1, 1, 1], "limit": 2}
    assert stl.parse(text).range([0, 1, 2], signals) == pytest.approx((lo, hi))


def test_closed_roads_have_no_continuation() -> None:
    lo, hi = stl.parse("always[0, 90] (x > 0)").range([0, 1, 2], {"x": [1, 2, 3]}, wrap=3)
    assert (float(lo), float(hi)) == (1, 1)


def test_numbers_per_variant_hold_for_later_samples_too() -> None:
    formula = stl.parse("eventually[5, 9] (abs(x) < limit)")
    lo, hi = formula.range([0, 1], {"x": np.zeros((3, 2)), "limit": [[1], [2], [3]]})
    assert lo.tolist() == [-math.inf] * 3
    assert hi.tolist() == [1, 2, 3]


@pytest.mark.parametrize(
    ("text", "verdict"),
    [
        ("x >= 1", "satisfied"),
        ("x > 1", "violated"),
        ("always[0, 2] (x >= 1)", "satisfied"),
        ("always[0, 2] (x > 1)", "violated"),
        ("always (x >= 1)", "unknown"),
        ("always (x > 1)", "violated"),
        ("eventually (x >= 2)", "satisfied"),
        ("eventually (x > 2)", "unknown"),
        ("eventually (x > 9)", "unknown"),
        ("eventually[3, 4] (x == x + 1)", "violated"),
        ("(x > 1 until x > 2) iff true", "violated"),
        ("true", "satisfied"),
    ],
)
def test_verdicts(text: str, verdict: str) -> None:
    formula = stl.parse(text)
    assert formula.verdict([0, 1, 2], {"x": [1.0, 2.0, 2.0]}) == verdict


@pytest.mark.parametrize("seed", range(70))
def test_strengthening_changes_no_robustness(seed: int) -> None:
    formula = normal_form(FormulaDraw(seed).formula(2 + seed % 2))
    positions, row = _seen(seed, 9)
    np.testing.assert_array_equal(
        strengthened(formula).robustness(positions, row), formula.robustness(positions, row)
    )


@pytest.mark.parametrize(
    ("formula", "verdict"),
    [
        ("always (abs(x) > 0)", "unknown"),  # a later x may be 0
        ("always (abs(x) >= 0)", "satisfied"),
        ("always (x * x >= 0)", "satisfied"),
        ("always (x * x > 0)", "unknown"),
        ("eventually (x * x < 0)", "violated"),
        ("eventually (abs(x) <= 0)", "unknown"),
        ("eventually (abs(x) < 0)", "violated"),
        ("always (x * x + y ^ 2 >= 0)", "satisfied"),
        ("always (x * y >= 0)", "unknown"),
        ("always (min(x * x, 3) <= 3)", "satisfied"),
    ],
)
def test_what_a_later_sample_can_just_touch(formula: str, verdict: str) -> None:
    """The one sample seen satisfies all of them but those about squares below 0."""
    assert stl.parse(formula).verdict([0.0], {"x": [1.0], "y": [1.0]}) == verdict


@pytest.mark.parametrize(("k", "verdict"), [(2.0, "satisfied"), (-2.0, "violated")])
def test_a_number_that_stays_bounds_products_of_later_samples(k: float, verdict: str) -> None:
    signals: dict[str, Any] = {"x": np.ones((2, 2)), "k": [[k], [2 * k]]}
    formula = stl.parse("always (k * (x * x) >= 0)")
    assert list(formula.verdict([0.0, 1.0], signals)) == [verdict] * 2
