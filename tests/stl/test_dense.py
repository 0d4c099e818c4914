"""Between the samples, signals are held or linear; robustness is that of the definitions."""

from __future__ import annotations

import contextlib
import io
import math
import random
from typing import Any

import numpy as np
import pytest

from roadlang import stl
from roadlang.diagnostics import DiagnosticError
from roadlang.stl.formula.formulas import COMPOUNDS, Measured, SampleStep, TruthChange
from tests.dense_reference import DenseReference, Grid
from tests.stl_draws import NAMES, FormulaDraw

QUICK = [seed for seed in range(75) if seed not in (11, 16, 29, 38, 62, 68, 71, 74)]
"""Seeds of formulas that the reference can value within a second or two."""


class DenseDraw(FormulaDraw):
    """Formulas that have a meaning between samples, with bounds that a double holds exactly."""

    def interval(self) -> stl.Interval | None:
        draw = self.random
        if draw.random() < 0.2:
            return None
        lo = draw.choice([0, 0, 0, 0.25, 0.5, 1, 3])
        return stl.Interval(lo, lo + draw.choice([0, 0.25, 0.5, 1, 1.75, 4, math.inf]))

    def _of_shape(self, shape: type[Any]) -> list[type[Any]]:
        counting = (SampleStep, TruthChange, Measured)
        return [
            kind
            for kind in COMPOUNDS.values()
            if issubclass(kind, shape) and not issubclass(kind, counting)
        ]


def draw_grids(seed: int, *, same: bool) -> dict[str, Grid]:
    """Signals of 1 to 6 samples a quarter to one apart, whole numbers for ties."""
    draw = random.Random(seed)

    def times() -> list[float]:
        steps = [draw.choice([0.25, 0.5, 0.5, 1]) for _ in range(draw.randint(0, 5))]
        start = draw.choice([0, 0.25])
        return [start + sum(steps[:k]) for k in range(len(steps) + 1)]

    shared = times()
    grids: dict[str, Grid] = {}
    for name in NAMES:
        grid = shared if same else [-0.5, *times()]
        grids[name] = (grid, [float(draw.randint(-4, 4)) for _ in grid])
    return grids


@pytest.mark.parametrize("semantics", ["held", "linear"])
@pytest.mark.parametrize("seed", QUICK[:50])
def test_robustness_is_that_of_the_definitions(seed: int, semantics: Any) -> None:
    formula = DenseDraw(seed, bounded=True).formula(1 + seed % 3)
    grids = draw_grids(seed, same=seed % 2 == 0)
    used = {name: grids[name] for name in formula.variables}
    if not used:
        return
    reference = DenseReference(used, linear=semantics == "linear")
    first, last = float(reference.start), float(reference.end)
    times = sorted({first, last, *np.linspace(first, last, 5).tolist()})
    signals = {name: stl.OwnGrid(*grid) for name, grid in grids.items()}

    found = formula.robustness(times, signals, semantics=semantics)

    np.testing.assert_allclose(found, [reference.rho(formula, t) for t in times], atol=1e-9)
    assert formula.rho(times, signals, semantics=semantics) == found[0]


@pytest.mark.parametrize("semantics", ["held", "linear"])
@pytest.mark.parametrize("seed", QUICK)
def test_durations_are_those_of_the_definitions(seed: int, semantics: Any) -> None:
    """At all breakpoints of the result, next to them, and in between."""
    draw = DenseDraw(9000 + seed, bounded=True)
    interval, operand = draw.interval(), draw.formula(seed % 3)
    amount = draw.random.choice([0, 0.25, 0.5, 0.75, 1, 2])
    op: Any = draw.random.choice([">=", ">", "<", "<="])
    formula = stl.Duration(interval, operand, op, amount)
    grids = draw_grids(seed, same=seed % 2 == 0)
    used = {name: grids[name] for name in formula.variables}
    if not used:
        return
    reference = DenseReference(used, linear=semantics == "linear")
    signals = {name: stl.OwnGrid(*grid) for name, grid in grids.items()}
    first, last = float(reference.start), float(reference.end)
    function = stl.dense_function(formula, [first], signals, semantics)
    breaks = first + function.times
    # Eighths are exact; at other breakpoints a double may be on either side of a jump.
    exact = [t for t in breaks.tolist() if (8 * t).is_integer()]
    between = (breaks[:-1] + np.diff(breaks) * draw.random.uniform(0.1, 0.9)).tolist()
    times = sorted({first, last, *exact, *between})

    found = formula.robustness(times, signals, semantics=semantics)

    np.testing.assert_allclose(found, [reference.rho(formula, t) for t in times], atol=1e-9)


@pytest.mark.parametrize("semantics", ["held", "linear"])
@pytest.mark.parametrize("seed", range(30))
def test_no_moment_has_less_than_always_a_duration(seed: int, semantics: Any) -> None:
    draw = DenseDraw(9500 + seed, bounded=True)
    inner = stl.Duration(draw.interval(), draw.formula(0), ">=", draw.random.choice([0.25, 1]))
    grids = draw_grids(seed, same=True)
    signals = {name: stl.OwnGrid(*grid) for name, grid in grids.items()}
    grid = np.array(grids["x"][0])
    if not inner.variables or grid.size < 2:
        return
    fine = np.unique(np.concatenate([np.linspace(grid[0], grid[-1], 400), grid, grid[:-1] + 1e-9]))
    along = inner.robustness(fine, signals, semantics=semantics)
    least = float(stl.Always(None, inner).rho(fine, signals, semantics=semantics))
    assert least <= along.min() + 1e-9
    function = stl.dense_function(inner, fine, signals, semantics)
    limits = [function.at.min(), function.after.min(), function.before.min()]
    assert least == min(limits)


@pytest.mark.parametrize("seed", range(30))
def test_rtamt_holds_signals_as_we_do(seed: int) -> None:
    """Where no window reaches the end of the trace, behind which RTAMT goes on."""
    rtamt = pytest.importorskip("rtamt")
    rng = np.random.default_rng(seed)
    times, values = 0.5 * np.arange(24), rng.integers(-5, 6, (2, 24)).astype(float)
    text = [
        "always[0,2] (x > 1)",
        "eventually[1,3] (x + y > 0)",
        "always[0,1] eventually[0.5,2] (abs(x) < 3)",
        "(eventually[0,2] (x > 0)) and (historically[0,1] (y < 3))",
        "once[0.5,2] ((x > 0) or (y > 2))",
    ][seed % 5]
    with contextlib.redirect_stdout(io.StringIO()):
        specification = rtamt.StlDenseTimeSpecification()
        specification.declare_var("x", "float")
        specification.declare_var("y", "float")
        specification.spec = text
        specification.parse()
        pairs = [
            [name, [list(pair) for pair in zip(times.tolist(), row.tolist(), strict=True)]]
            for name, row in zip("xy", values, strict=True)
        ]
        changes = specification.evaluate(*pairs)
    moments = np.arange(2.0, 8.0, 0.25)
    theirs = [next(v for t, v in reversed(changes) if t <= moment) for moment in moments]

    ours = stl.dense_function(
        stl.parse(text), times, dict(zip("xy", values, strict=True)), "held"
    ).limits(moments)[1]

    np.testing.assert_allclose(ours, theirs, atol=1e-9)


def test_a_peak_between_the_samples_of_another_signal_is_seen() -> None:
    formula = stl.parse("always (x < y)")
    signals = {"x": stl.OwnGrid([0, 1, 2], [0, 4, 0]), "y": stl.OwnGrid([0, 2], [3, 3])}
    assert formula.rho([0, 2], signals, semantics="linear") == -1


def test_a_window_between_two_samples_is_not_empty() -> None:
    formula, x = stl.parse("always[0.2, 0.8] (x < 0)"), {"x": [0, 9, 9]}
    assert formula.rho([0, 1, 2], x) == np.inf
    assert formula.rho([0, 1, 2], x, semantics="held") == 0
    assert formula.rho([0, 1, 2], x, semantics="linear") == pytest.approx(-7.2)


def test_a_number_is_known_before_and_after_the_positions_asked_for() -> None:
    signals = {"x": stl.OwnGrid([0, 1, 2, 3, 4], [0, 0, 0, 0, 9]), "limit": 5}
    for text in ("eventually[2, 4] (x > limit)", "once (x < limit) and eventually (x > limit)"):
        assert stl.parse(text).robustness([0, 1], signals, semantics="held").tolist() == [4, 4]
    assert stl.parse("always[3, 3] (x < limit)").rho([0], signals, semantics="linear") == 5
    low, high = (signals | {"limit": limit} for limit in ([[5]], [[5], [3]]))
    assert stl.parse("eventually (x > limit)").rho([0, 1], low, semantics="linear") == [4]
    assert stl.parse("eventually (x > limit)").rho([0, 1], high, semantics="held").tolist() == [
        4,
        6,
    ]


def test_more_than_a_duration_is_not_just_that_long() -> None:
    """At 2, which is neither a sample nor the end of a window, 3 seconds are left."""
    signals = {"x": stl.OwnGrid([0, 1.5, 5], [-1, 2, 2])}
    for text, expected in ((">= 3", 2), ("> 3", -np.inf), ("<= 3", np.inf), ("< 3", -2)):
        formula = stl.parse(f"duration (x > 0) {text}")
        assert formula.robustness([0, 2], signals, semantics="held")[1] == expected


def test_batches_are_judged_row_by_row() -> None:
    rng = np.random.default_rng(1)
    signals = {"x": rng.normal(0, 1, (3, 9)), "limit": rng.uniform(0, 1, (3, 1))}
    formula = stl.parse("always[0, 2] (x < limit) or eventually[1, 3] (x > limit)")
    times = 0.5 * np.arange(9)

    found = formula.robustness(times, signals, semantics="linear")

    assert found.shape == (3, 9)
    for row in range(3):
        alone = {"x": signals["x"][row], "limit": float(signals["limit"][row, 0])}
        np.testing.assert_array_equal(
            found[row], formula.robustness(times, alone, semantics="linear")
        )


def test_epoch_stamps_give_what_the_same_clock_set_to_zero_gives() -> None:
    rng = np.random.default_rng(3)
    times, x = 0.125 * np.arange(200), rng.normal(0, 1, 200)
    formula = stl.parse("always[0, 5] (x > -3) and (x < 2) until[0.5, 3] (x > 1.5)")
    for semantics in ("held", "linear"):
        expected = formula.robustness(times, {"x": x}, semantics=semantics)
        shifted = formula.robustness(times + 1.7e9, {"x": x}, semantics=semantics)
        np.testing.assert_allclose(shifted, expected, atol=1e-9)


@pytest.mark.parametrize("semantics", ["held", "linear"])
@pytest.mark.parametrize("seed", range(15))
def test_the_bound_of_the_sampling_error_holds(seed: int, semantics: Any) -> None:
    """A finely sampled signal stands for the one that is sampled coarsely."""
    formula = DenseDraw(seed, bounded=True).formula(2)
    fine = np.arange(0, 4.0001, 1 / 64)
    rng = np.random.default_rng(seed)
    truth = {name: np.cumsum(rng.uniform(-1, 1, fine.size)) / 64 * 3 for name in NAMES}
    coarse = {name: values[::16] for name, values in truth.items()}
    rates = dict.fromkeys(NAMES, 3.0)

    expected = formula.rho(fine, truth, semantics="linear")
    found = formula.rho(fine[::16], coarse, semantics=semantics)

    bound = stl.sampling_error(formula, fine[::16], coarse, rates, semantics)
    assert found == expected or abs(found - expected) <= bound + 1e-9


@pytest.mark.parametrize(
    ("text", "semantics"),
    [("next (x > 1)", "held"), ("rise (x > 1)", "linear"), ("x * x > 1", "linear")],
)
def test_what_has_no_value_between_samples_is_refused(text: str, semantics: Any) -> None:
    with pytest.raises(DiagnosticError, match="RL311"):
        stl.parse(text).rho([0, 1], {"x": [1, 2]}, semantics=semantics)


def test_words_that_name_no_way_of_evaluation_are_refused() -> None:
    formula, trace = stl.parse("always (x < 1)"), ([0, 1], {"x": [1, 2]})
    wrong: Any = "dense"
    for call in (formula.rho, formula.robustness, formula.verdict, formula.range, formula.explain):
        with pytest.raises(DiagnosticError, match=r"RL342.*`sampled`, `held`, `linear`"):
            call(*trace, semantics=wrong)
    with pytest.raises(DiagnosticError, match=r"RL342.*`right`, `left`"):
        stl.time_robustness(formula, *trace, direction=wrong)
    for sharpness in (0.0, -1.0, math.nan, math.inf):
        with pytest.raises(DiagnosticError, match=r"RL342.*positive"):
            stl.smooth_rho(formula, *trace, sharpness=sharpness)


def test_a_closed_road_is_evaluated_at_its_samples_alone() -> None:
    with pytest.raises(DiagnosticError, match=r"RL312.*`semantics: held`"):
        stl.parse("always (x > 0)").rho([0, 1], {"x": [1, 2]}, wrap=3, semantics="held")


def test_infinite_samples_are_held_and_refused_on_a_line() -> None:
    formula, x = stl.parse("eventually[0, 1] (x > 1)"), {"x": [0, math.inf, 0]}
    assert formula.rho([0, 1, 2], x, semantics="held") == math.inf
    with pytest.raises(DiagnosticError, match="RL302"):
        formula.rho([0, 1, 2], x, semantics="linear")


def test_signals_that_are_never_known_together_are_refused() -> None:
    signals = {"x": stl.OwnGrid([0, 1], [1, 2]), "y": stl.OwnGrid([2, 3], [1, 2])}
    with pytest.raises(DiagnosticError, match="RL301"):
        stl.parse("x < y").rho([0], signals, semantics="held")


def test_the_bound_and_the_function_need_semantics_between_samples() -> None:
    phi, x = stl.parse("always (x < 5)"), {"x": [0.0, 1.0]}
    with pytest.raises(DiagnosticError, match="none of `held`, `linear`"):
        stl.sampling_error(phi, [0, 1], x, {"x": 1.0}, "lineer")  # type: ignore[arg-type]
    with pytest.raises(DiagnosticError, match="RL342"):
        stl.dense_function(phi, [0, 1], x, "sampled")
