"""Mining finds the tightest parameters with which a formula still holds."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from roadlang.diagnostics import DiagnosticError
from roadlang.stl.explain.mining import mine, mine_front
from roadlang.stl.explain.parameters import Parameter
from roadlang.stl.formula.terms import number_text

POSITIONS = np.arange(0.0, 50.0, 0.5)
RECORDINGS = [
    (POSITIONS, {"e": 3 + 2 * np.sin(POSITIONS / 5)}),
    (POSITIONS, {"e": 4.25 + np.cos(POSITIONS / 7)}),
]
WORST = max(float(signals["e"].max()) for _, signals in RECORDINGS)


def test_thresholds_from_above_and_below() -> None:
    upper = mine("always (e <= limit)", [Parameter("limit", 0, 20)], RECORDINGS)
    assert WORST <= upper.values["limit"] <= WORST * (1 + 1e-5)
    assert 0 <= upper.rho < 1e-4
    lower = mine("always (e >= limit)", [Parameter("limit", -20, 20)], RECORDINGS)
    assert lower.values["limit"] == pytest.approx(1.0, abs=1e-3)


def test_the_shortest_interval() -> None:
    mined = mine("eventually[0, tau] (e < 3.6)", [Parameter("tau", 0, 40)], RECORDINGS)
    assert str(mined.formula) == f"eventually[0, {number_text(mined.values['tau'])}]" \
        " (e < 3.6)"  # fmt: skip
    first = min(p for p, e in zip(POSITIONS, RECORDINGS[1][1]["e"], strict=True) if e < 3.6)
    assert mined.values["tau"] == pytest.approx(first, abs=1e-4)


def test_the_first_parameter_is_tightest() -> None:
    text = "always (e > high implies eventually[0, tau] (e < high))"
    mined = mine(text, [Parameter("tau", 0, 50), Parameter("high", 1, 10)], RECORDINGS)
    assert mined.values["tau"] == 0
    assert mined.at_bound == ("tau",)
    assert mined.values["high"] == pytest.approx(WORST, rel=1e-4)


def test_of_alternatives_each_is_tightened_from_its_loose_side() -> None:
    """With `c` at its loosest, robustness does not depend on `d`: both bounds of `d` are alike."""
    recording = ([0.0, 1.0, 2.0], {"x": [0.1, -0.4, 0.9], "e": [1.0, 2.0, 3.0]})
    parameters = [Parameter("c", 0, 5), Parameter("d", 0, 5)]
    mined = mine("always (x < c or e < d)", parameters, [recording])
    assert mined.values == {"c": 0.0, "d": pytest.approx(3.0, abs=1e-4)}
    assert mined.at_bound == ("c",)
    front = mine_front("always (x < c or e < d)", parameters, [recording], points=6)
    assert [point.values["c"] for point in front] == [0.0, 1.0]
    assert [point.values["d"] for point in front] == [pytest.approx(3.0, abs=1e-4), 0.0]


@pytest.mark.parametrize(
    ("parameter", "told"),
    [
        (Parameter("limit", 5, 0), "the lower one comes first: `limit=0..5`"),
        (Parameter("limit", 2, 2), "two finite numbers, the lower one first"),
        (Parameter("limit", 0, float("inf")), "two finite numbers, the lower one first"),
        (Parameter("limit", -1e308, 1e308), "they are too far apart"),
        (Parameter("", 0, 1), "it is not a name"),
        (Parameter("e", 0, 1), "it is a signal of the trace"),
    ],
)
def test_a_parameter_that_makes_no_sense_is_refused(parameter: Parameter, told: str) -> None:
    with pytest.raises(DiagnosticError, match=r"RL342(.|\n)*" + told):
        mine("always (e <= limit)", [parameter], RECORDINGS)


def test_bounds_may_be_as_far_apart_as_numbers_go() -> None:
    mined = mine("always (e <= limit)", [Parameter("limit", -8e307, 9e307)], RECORDINGS)
    assert WORST <= mined.values["limit"] <= 1e297


def test_margins() -> None:
    mined = mine("always (e < limit)", [Parameter("limit", 0, 20)], RECORDINGS, margin=0.5)
    assert mined.values["limit"] == pytest.approx(WORST + 0.5, rel=1e-5)


@pytest.mark.parametrize(
    ("text", "parameter", "code"),
    [
        ("always (e < limit)", Parameter("limit", 0, 1), "RL341"),
        ("always (e < limit)", Parameter("lmit", 0, 1), "RL342"),
        ("always (e < limit)", Parameter("limit", 1, 1), "RL342"),
        ("always (e < limit)", Parameter("limit", 0, np.inf), "RL342"),
        ("always (x < limit)", Parameter("limit", 0, 1), "RL304"),
    ],
)
def test_refusals(text: str, parameter: Any, code: str) -> None:
    with pytest.raises(DiagnosticError, match=code):
        mine(text, [parameter], RECORDINGS)


def test_both_ends_of_an_interval() -> None:
    e = np.where((POSITIONS >= 7) & (POSITIONS <= 9), 1.0, 5.0)

    mined = mine(
        "eventually[a, b] (e < 2)", [Parameter("a", 0, 20), Parameter("b", 0, 20)],
        [(POSITIONS, {"e": e})],
    )  # fmt: skip

    assert mined.values["a"] == pytest.approx(9, abs=1e-4)
    assert mined.values["b"] == pytest.approx(9, abs=1e-3)
    assert mined.not_monotone == ()


def test_values_on_both_sides_of_failing_ones_are_noticed() -> None:
    recordings = [(POSITIONS, {"x": 5 + np.sin(POSITIONS)})]

    gap = mine("always (x < p or x > p + 3)", [Parameter("p", -20, 20)], recordings)
    side = mine("always (x < p or x > p + 3)", [Parameter("p", 3, 20)], recordings)

    assert gap.not_monotone == ("p",)
    assert side.not_monotone == ()
    assert side.values["p"] == pytest.approx(float(recordings[0][1]["x"].max()), abs=1e-4)


def test_windows_cut_off_by_the_end_can_count_as_holding() -> None:
    x = np.zeros(100)
    x[[30, 99]] = 1.0
    y = (np.arange(100) == 34).astype(float)
    recordings = [(np.arange(100.0), {"x": x, "y": y})]
    text = "always (x > 0.5 implies eventually[0, tau] (y > 0.5))"

    with pytest.raises(DiagnosticError, match="RL341") as cut_off:
        mine(text, [Parameter("tau", 0, 20)], recordings)
    assert "`--unknown-holds`" in cut_off.value.diagnostics[0].help[0]
    with pytest.raises(DiagnosticError, match="RL341") as violated:
        mine(text, [Parameter("tau", 0, 2)], recordings)
    assert violated.value.diagnostics[0].help[0].startswith("widen the bounds")
    mined = mine(text, [Parameter("tau", 0, 20)], recordings, unknown_holds=True)
    margin = mine(text, [Parameter("tau", 0, 20)], recordings, unknown_holds=True, margin=0.4)

    assert mined.values["tau"] == pytest.approx(4, abs=1e-4)
    assert margin.values["tau"] == pytest.approx(4, abs=1e-4)


def test_the_front_trades_one_parameter_for_the_other() -> None:
    e = 8 * np.exp(-POSITIONS / 10)
    parameters = [Parameter("tau", 0, 40), Parameter("limit", 0, 8)]

    front = mine_front(
        "eventually[0, tau] always (e <= limit)", parameters, [(POSITIONS, {"e": e})], points=9
    )

    taus = [point.values["tau"] for point in front]
    limits = [point.values["limit"] for point in front]
    assert taus == sorted(taus)
    assert limits == sorted(limits, reverse=True)
    assert (taus[0], limits[0]) == (0, 8)
    assert len(front) >= 8
    for tau, limit in zip(taus, limits, strict=True):
        assert limit == pytest.approx(8 * np.exp(-(tau // 0.5 * 0.5) / 10), rel=1e-4)


def test_a_threshold_at_the_end_of_its_bounds_is_monotone() -> None:
    """All values above 0 hold, 0 does not: what is found is next to it."""
    found = mine("always (x < p)", [Parameter("p", 0, 9)], [([0.0, 1.0], {"x": [0.0, 0.0]})])
    assert found.not_monotone == ()
    assert 0 < found.values["p"] < 1e-9


def test_of_several_recordings_the_one_at_fault_is_named() -> None:
    recordings = [([0.0, 1.0], {"e": [1.0, 2.0]}), ([0.0, 1.0], {"e": [1.0, float("nan")]})]
    with pytest.raises(DiagnosticError, match=r"in `recordings\[1\]`"):
        mine("always (e < a)", [Parameter("a", 0, 9)], recordings)
    with pytest.raises(DiagnosticError) as alone:
        mine("always (e < a)", [Parameter("a", 0, 9)], recordings[1:])
    assert "recordings" not in str(alone.value)


@pytest.mark.parametrize(
    ("text", "tightest"),
    [
        ("eventually[0, a] (x < 3)", 0.0),
        ("always (x >= a)", 0.0),
        ("always (x > a)", -1e-12),  # it is strict: 0 does not hold
    ],
)
def test_a_boundary_at_zero_is_zero(text: str, tightest: float) -> None:
    """Bisection comes no nearer to 0 than the halves of the bounds, such as 4.6e-18."""
    recording = ([0.0, 1.0, 2.0], {"x": [0.0, 1.0, 0.5]})
    assert mine(text, [Parameter("a", -1, 5)], [recording]).values == {"a": tightest}


@pytest.mark.parametrize(
    ("text", "column", "shown"),
    [
        ("always (e < limit) and (e > 0", 24, "("),
        ("always (e < limit and e > limit x)", 33, "x"),
        ("always (e << limit)", 12, "<"),
    ],
)
def test_faults_of_the_text_are_shown_where_it_was_written(
    text: str, column: int, shown: str
) -> None:
    """Not in the formula with numbers in the place of its parameters."""
    with pytest.raises(DiagnosticError) as caught:
        mine(text, [Parameter("limit", -123.25, 20)], RECORDINGS)
    (found,) = caught.value.diagnostics
    assert found.span is not None
    assert found.span.source.text == text
    assert found.span.column == column
    assert found.span.text == shown


def test_a_word_of_formulas_is_no_parameter() -> None:
    with pytest.raises(DiagnosticError, match="`always`: it is a word of formulas"):
        mine("always (e < 3)", [Parameter("always", 0, 20)], RECORDINGS)
