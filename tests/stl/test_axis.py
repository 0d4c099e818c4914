"""Which samples the windows of temporal operators hold."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang import stl
from roadlang.stl.evaluate.axis import SamplePositions
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
