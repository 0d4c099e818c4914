"""Which samples the windows of temporal operators hold."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from roadlang import stl
from roadlang.stl.evaluate.axis import SamplePositions
from roadlang.stl.evaluate.trace import FloatArray
from roadlang.stl.formula.interval import Interval
from tests.stl_draws import FormulaDraw, draw_trace


@pytest.mark.parametrize("path", [False, True])
@pytest.mark.parametrize("past", [False, True])
@pytest.mark.parametrize("closed", [False, True])
@pytest.mark.parametrize("seed", range(10))
def test_chosen_windows_reach_the_samples_that_each_of_them_holds(
    seed: int, closed: bool, past: bool, path: bool
) -> None:
    positions, _ = draw_trace(seed, 11, 1, even=seed % 2 == 0)
    wrap = float(positions[-1] - positions[0]) + 0.5 if closed else None
    interval = FormulaDraw(seed).interval()
    windows = SamplePositions.of(positions, wrap).windows(interval, (0, 10), past=past, path=path)
    if windows is None:
        return
    chosen = np.random.default_rng(seed).random(11) < 0.4

    expected = set()
    for window in np.flatnonzero(chosen).tolist():
        held = windows.samples(window)
        expected |= set(held.tolist())
        if path and held.size:
            expected |= set(windows.before(window, held.size).tolist())
    reached = windows.span[0] + np.flatnonzero(windows.reached(chosen, path=path))

    assert set(reached.tolist()) == expected


def test_a_long_violated_trace_is_explained() -> None:
    """Quadratic work would take half an hour here."""
    x = np.zeros(1_000_000)
    x[:300] = 3.0

    why = stl.parse("always eventually[0, 100] (x > 2)").explain(np.arange(x.size), {"x": x})

    assert why.verdict == "violated"
    assert [(part.start, part.end) for part in why.stretches] == [(300, 999_999)]


@pytest.mark.parametrize("seed", range(60))
def test_windows_of_even_grids_are_those_that_a_search_finds(seed: int) -> None:
    rng = np.random.default_rng(seed)
    step = float(rng.choice([0.1, 0.25, 1 / 3, 1e-9, 7.0, 40.0]))
    origin = float(rng.choice([0.0, 3.1, -2.0, 1.7e9 if step > 1e-3 else 0.0]))
    places = np.arange(int(rng.integers(2, 40)), dtype=np.float64)
    positions: FloatArray = origin + step * places
    axis = SamplePositions.of(positions)
    searched = replace(axis, pitch=None)
    lo = step * rng.choice([0, 1, 2, 5, 50]) + step * rng.choice([0, 0, 1e-7, -1e-7, 1e-5, 0.4])
    width = step * rng.choice([0, 1, 3, 60, np.inf]) + step * rng.choice([0, 1e-7, 0.6])
    interval = Interval(max(0.0, float(lo)), float(max(0.0, lo) + width))
    first = int(rng.integers(0, axis.size))
    targets = (first, int(rng.integers(first, axis.size)))
    for past in (False, True):
        for path in (False, True):
            found = axis.windows(interval, targets, past=past, path=path)
            expected = searched.windows(interval, targets, past=past, path=path)
            assert (found is None) == (expected is None)
            if found is None or expected is None:
                continue
            np.testing.assert_array_equal(
                found.ends - found.starts >= 0, expected.ends >= expected.starts
            )
            held = expected.ends >= expected.starts
            np.testing.assert_array_equal(found.starts[held], expected.starts[held])
            np.testing.assert_array_equal(found.ends[held], expected.ends[held])
            assert (found.first, found.span, found.flipped) == (
                expected.first, expected.span, expected.flipped
            )  # fmt: skip
            assert found.even == expected.even
