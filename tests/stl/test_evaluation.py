"""Shapes, batches and refusals of `rho`, `robustness` and `satisfied`."""

from __future__ import annotations

import math
import subprocess
import sys
import tracemalloc
from typing import Any

import numpy as np
import pytest

from roadlang import stl
from roadlang.diagnostics import DiagnosticError

PHI3 = stl.parse("always (e > 10 implies eventually[5, 20] always[0, 30] (d < 10 and e < 10))")
NESTED = stl.parse("(e < 10) until[2, 30] (once[0, 9] (d < 5) and (d > 1 since[3, 40] e > 2))")


def _walks(variants: Any, samples: Any) -> Any:
    rng = np.random.default_rng(3)
    steps = rng.normal(0, 1, (2, variants, samples))
    e, d = np.abs(np.cumsum(steps, axis=2))
    return np.arange(float(samples)), {"e": e, "d": d}


@pytest.mark.parametrize("formula", [PHI3, NESTED])
@pytest.mark.parametrize(("variants", "samples"), [(1, 700), (3, 700), (700, 300), (2500, 40)])
def test_a_batch_is_its_variants_one_by_one(formula: Any, variants: int, samples: int) -> None:
    positions, signals = _walks(variants, samples)
    trace = formula.robustness(positions, signals)
    start = formula.rho(positions, signals)
    assert trace.shape == (variants, samples)
    np.testing.assert_array_equal(start, trace[:, 0])
    for variant in range(0, variants, 1 + variants // 4):
        row = {name: values[variant] for name, values in signals.items()}
        np.testing.assert_array_equal(formula.robustness(positions, row), trace[variant])


def test_one_trace_has_no_variant_axis() -> None:
    positions, signals = _walks(1, 20)
    row = {name: values[0] for name, values in signals.items()}
    assert PHI3.robustness(positions, row).shape == (20,)
    assert isinstance(PHI3.rho(positions, row), float)
    assert isinstance(PHI3.verdict(positions, row), str)
    assert PHI3.rho(positions, signals).shape == (1,)


def test_signals_of_all_shapes_meet() -> None:
    formula = stl.parse("always (e < limit + offset * bend)")
    signals: dict[str, Any] = {
        "e": np.array([[1, 2, 3], [4, 5, 6]], dtype=np.int32),
        "limit": np.array([[10.0], [20.0]]),
        "bend": np.array([0.0, 1.0, 0.0], dtype=np.float32),
        "offset": 2,
    }
    assert formula.robustness([0, 1, 2], signals).tolist() == [[7, 7, 7], [14, 14, 14]]
    assert formula.rho([0, 1, 2], {**signals, "e": 1.0}).tolist() == [9, 19]


def test_a_formula_without_signals_of_the_batch_still_has_its_shape() -> None:
    signals: dict[str, Any] = {"e": np.zeros((4, 3)), "x": 1.0}
    assert stl.parse("true").rho([0, 1, 2], signals).tolist() == [np.inf] * 4
    assert stl.parse("x < 3").robustness([0, 1, 2], signals).shape == (4, 3)
    assert stl.parse("always (x < 3)").satisfied([0, 1, 2], signals).tolist() == [True] * 4


def test_strictness_matters_to_satisfaction_only() -> None:
    signals = {"x": [1.0, 2.0]}
    strict, weak = stl.parse("always (x > 1)"), stl.parse("always (x >= 1)")
    assert strict.rho([0, 1], signals) == weak.rho([0, 1], signals) == 0
    assert not strict.satisfied([0, 1], signals)
    assert weak.satisfied([0, 1], signals)
    assert strict.truth([0, 1], signals).tolist() == [False, True]


@pytest.mark.parametrize(
    ("positions", "signals", "code", "told"),
    [
        ([], {"x": []}, "RL300", "no sample"),
        ([0, 1], {"x": np.empty((0, 2))}, "RL300", "no sample"),
        ([0, 0], {"x": [1, 1]}, "RL301", "0 is followed by 0"),
        ([0, float("nan")], {"x": [1, 1]}, "RL301", "position 1 is nan"),
        ([[0, 1]], {"x": [1, 1]}, "RL301", "shape"),
        (["a"], {"x": [1]}, "RL301", "not numbers"),
        ([0, 1], {"x": [1, float("nan")]}, "RL302", "`x` is nan at position 1"),
        ([0, 1], {"x": [[1, 1], [1, float("nan")]]}, "RL302", "position 1 of variant 1"),
        ([0, 1], {"x": [1, 2, 3]}, "RL303", "has (3,)"),
        ([0, 1], {"x": ["a", "b"]}, "RL303", "must be numbers"),
        ([0, 1], {"x": np.zeros((2, 2)), "y": np.zeros((3, 2))}, "RL303", "agree"),
        ([0, 1], {"xx": [1, 2]}, "RL304", "no signal `x`"),
    ],
)
def test_bad_traces_are_refused(positions: Any, signals: Any, code: str, told: str) -> None:
    with pytest.raises(DiagnosticError) as refusal:
        stl.parse("always (x > 0)").rho(positions, signals)
    (found,) = refusal.value.diagnostics
    assert found.code == code
    assert told in found.message


@pytest.mark.parametrize(
    ("signals", "told"),
    [
        ({"cross-track": [1, 2]}, "did you mean `` `cross-track` `` (in back quotes)?"),
        ({"cros": [1, 2]}, "did you mean `cros`?"),
        (
            {"cross": stl.OwnGrid([0, 1], [1, 2]), "track": [1, 2]},
            "signals with grids of their own need `semantics`: `held` or `linear`",
        ),
    ],
)
def test_what_to_write_instead_is_told(signals: Any, told: str) -> None:
    with pytest.raises(DiagnosticError) as refusal:
        stl.parse("cross-track > 0").rho([0, 1], signals)
    assert refusal.value.diagnostics[0].help[0] == told


def test_a_value_that_is_no_number_is_found_in_any_chunk() -> None:
    positions, signals = _walks(3000, 100)
    signals["d"][2345, 67] = np.nan
    with pytest.raises(DiagnosticError, match="`d` is nan at position 67 of variant 2345"):
        stl.parse("d > 0 until[0, 2] e > 0").rho(positions, signals)


def test_the_root_of_a_negative_number_is_refused() -> None:
    with pytest.raises(DiagnosticError, match="RL307"):
        stl.parse("x ^ 0.5 < 2").robustness([0, 1, 2], {"x": [0.0, 1.0, -1.0]})


@pytest.mark.parametrize(
    ("text", "robustness"),
    [
        ("1 / x < 2", [-np.inf, -np.inf, 1.0, 3.0]),
        ("-1 / x < 2", [np.inf, np.inf, 3.0, 1.0]),
        ("x / x < 2", [2.0, 2.0, 1.0, 1.0]),
        ("1 / x == 2 / x", [0.0, 0.0, -1.0, -1.0]),
        ("x * (1 / x) >= 1", [-1.0, -1.0, 0.0, 0.0]),
        ("x ^ -1 > 3", [np.inf, np.inf, -2.0, -4.0]),
    ],
)
def test_a_division_by_zero_is_infinite_and_zero_by_zero_is_zero(
    text: str, robustness: list[float]
) -> None:
    """-0 counts as 0, and equal infinities are 0 apart."""
    found = stl.parse(text).robustness(range(4), {"x": [0.0, -0.0, 1.0, -1.0]})
    assert found.tolist() == robustness


def test_infinite_samples_are_welcome() -> None:
    """As of a time to collision while nobody comes closer."""
    formula = stl.parse("always (ttc > 2)")
    assert formula.rho([0, 1, 2], {"ttc": [np.inf, 5.0, np.inf]}) == 3.0
    assert formula.rho([0, 1], {"ttc": [np.inf, np.inf]}) == np.inf
    assert formula.satisfied([0, 1], {"ttc": [np.inf, np.inf]})
    assert stl.parse("ttc == inf").rho([0], {"ttc": [np.inf]}) == 0.0
    watched = stl.OnlineMonitor(formula)
    assert watched.push(0.0, {"ttc": np.inf}) == (-np.inf, np.inf)
    assert watched.push(1.0, {"ttc": 1.0})[1] == -1.0
    assert "1" in str(formula.explain([0, 1], {"ttc": [np.inf, 1.0]}))


@pytest.mark.parametrize("wrap", [2.0, 1.0, float("nan"), float("inf")])
def test_a_lap_is_longer_than_its_samples(wrap: float) -> None:
    with pytest.raises(DiagnosticError, match="RL306"):
        stl.parse("x > 0").rho([0, 1, 2], {"x": [0, 1, 2]}, wrap=wrap)


def test_working_memory_stays_within_a_fifth_of_a_signal() -> None:
    positions, signals = _walks(8000, 250)
    for formula in (PHI3, NESTED):
        formula.robustness(positions, signals)
        tracemalloc.start()
        result = formula.robustness(positions, signals)
        _, peak = tracemalloc.get_traced_memory()
        tracemalloc.stop()
        assert peak - result.nbytes < (0.2 if formula is PHI3 else 0.6) * result.nbytes


def test_importing_and_parsing_is_light() -> None:
    code = (
        "import sys, roadlang.stl as stl; stl.parse('always[0, 5] (x < 1)');"
        "print([m for m in ('numpy', 'scipy', 'cv2', 'lark') if m in sys.modules]);"
        "stl.parse('x < 1').rho([0], {'x': [0]});"
        "print([m for m in ('scipy', 'cv2', 'lark') if m in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.split("\n")[:2] == ["[]", "[]"]


def test_all_public_names_are_there() -> None:
    assert all(getattr(stl, name) is not None for name in stl.__all__)
    assert set(stl.__all__) == set(dir(stl))


@pytest.mark.parametrize(
    ("formula", "rho", "truth"),
    [
        ("inf <= inf", 0.0, True),
        ("inf < inf", 0.0, False),
        ("inf == inf", 0.0, True),
        ("inf != inf", 0.0, False),
        ("-inf >= -inf", 0.0, True),
        ("-inf < inf", math.inf, True),
        ("max(x, inf) <= inf", 0.0, True),
        ("always (x < inf)", math.inf, True),
        ("always (x <= -inf)", -math.inf, False),
    ],
)
def test_comparisons_with_infinity(formula: str, rho: float, truth: bool) -> None:
    """A limit that is `inf` is a limit that nothing exceeds, another `inf` included."""
    parsed = stl.parse(formula)
    assert parsed.rho([0.0, 1.0], {"x": [1.0, 2.0]}) == rho
    assert bool(parsed.satisfied([0.0, 1.0], {"x": [1.0, 2.0]})) is truth


@pytest.mark.parametrize(
    ("text", "x", "rho"),
    [
        ("x * y - x * y < 2", 1e200, 2.0),
        ("x * y < x * y + 1", 1e200, 0.0),
        ("x * y > 5", 1e200, math.inf),
        ("always (1e200 * x * 1e200 - 1e200 * x * 1e200 < 1)", 3.0, 1.0),
        ("x + y < 1", 1.7e308, -math.inf),
        ("x ^ 2 - x ^ 2 <= 0", 1e200, 0.0),
    ],
)
def test_numbers_that_overflow_are_infinite_and_never_nan(text: str, x: float, rho: float) -> None:
    formula = stl.parse(text)
    signals = {"x": [x, x], "y": [x, x]}

    assert formula.rho([0, 1], signals) == rho
    assert formula.verdict([0, 1], signals) in ("satisfied", "violated", "unknown")
    assert not np.isnan(formula.range([0, 1], signals)).any()


def test_masked_samples_are_refused_where_a_formula_reads_them() -> None:
    masked = np.ma.array([1.0, 99.0, 2.0], mask=[False, True, False])
    whole = np.ma.array([1.0, 3.0, 2.0])

    with pytest.raises(DiagnosticError, match="RL302"):
        stl.parse("always (x < 5)").rho([0, 1, 2], {"x": masked})
    with pytest.raises(DiagnosticError, match="RL301"):
        stl.parse("always (x < 5)").rho(masked, {"x": whole})
    assert stl.parse("always (x < 5)").rho([0, 1, 2], {"x": whole, "y": masked}) == 2


def test_an_interval_from_zero_without_end_is_none() -> None:
    assert stl.parse("always[0, inf] (x > 0)") == stl.parse("always (x > 0)")
    assert stl.parse("(x > 0) since[0, inf] (y > 0)") == stl.parse("(x > 0) since (y > 0)")
    assert str(stl.Once(stl.UNBOUNDED, stl.parse("x > 0"))) == "once (x > 0)"
