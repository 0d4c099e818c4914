"""A monitor of a stream gives sample by sample what the whole trace gives."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang import stl
from roadlang.diagnostics import DiagnosticError
from roadlang.stl.evaluate.stream_nodes import Sample, StreamPointwise
from roadlang.stl.formula.horizon import horizon
from tests.stl_draws import FormulaDraw, draw_trace


@pytest.mark.parametrize(
    ("text", "instead"),
    [
        ("always (x < 1)", "to see when it fails, leave `always` out: `x < 1`"),
        ("eventually (x < 1)", "give the operator an interval with an end"),
        ("always eventually (x < 1)", "give the operator an interval with an end"),
    ],
)
def test_what_to_watch_in_place_of_a_formula_without_bounds(text: str, instead: str) -> None:
    with pytest.raises(DiagnosticError, match="RL309") as caught:
        stl.StreamMonitor(stl.parse(text))
    assert caught.value.diagnostics[0].help[0].startswith(instead)


@pytest.mark.parametrize("origin", [0.0, 1_700_000_000.0])
@pytest.mark.parametrize("seed", range(44))
def test_every_sample_has_the_robustness_of_the_whole_trace(seed: int, origin: float) -> None:
    formula = FormulaDraw(seed, divisions=seed % 5 == 0).formula(1 + seed % 3)
    if np.isinf(horizon(formula)):
        with pytest.raises(DiagnosticError, match="RL309"):
            stl.StreamMonitor(formula)
        return
    positions, signals = draw_trace(seed, (1, 2, 7, 25)[seed % 4], 1, even=seed % 2 == 0)
    positions = origin + positions
    row = {name: values[0] for name, values in signals.items()}
    monitor = stl.StreamMonitor(formula)

    decided: list[stl.DecidedSample] = []
    for k, position in enumerate(positions):
        decided += monitor.push(position, {name: values[k] for name, values in row.items()})
        overdue = positions[: k + 1] + monitor.delay < position - 1e-3
        assert len(decided) >= np.count_nonzero(overdue)
        if not formula.looks_ahead:
            assert len(decided) == k + 1
    decided += monitor.finish()

    assert [sample.position for sample in decided] == pytest.approx(list(positions), abs=1e-6)
    np.testing.assert_array_equal(
        [sample.rho for sample in decided], formula.robustness(positions, row)
    )


@pytest.mark.parametrize("seed", range(40))
def test_long_windows_of_past_operators(seed: int) -> None:
    rng = np.random.default_rng(seed)
    text = [
        "historically[3, 40] (x < 1)",
        "once[0, 25] (x > 1.5)",
        "(x > -1) since[2, 30] (y > 1)",
        "(x > -1) since (y > 1)",
        "eventually[5, 20] historically[0, 7] (x > -0.5)",
    ][seed % 5]
    x, y = np.round(rng.normal(0, 1, (2, 400)), 1)
    formula = stl.parse(text)
    monitor = stl.StreamMonitor(formula)

    pushed = [monitor.push(k, {"x": x[k], "y": y[k]}) for k in range(400)]
    decided = [sample.rho for samples in [*pushed, monitor.finish()] for sample in samples]

    np.testing.assert_array_equal(decided, formula.robustness(np.arange(400), {"x": x, "y": y}))


def test_memory_depends_on_the_interval_and_not_on_the_stream() -> None:
    formula = stl.parse("(x < 2) since (y > 0) and historically[0, 10] (x < 1) and once (y > 5)")
    monitor = stl.StreamMonitor(formula)
    for k in range(3000):
        monitor.push(k, {"x": float(k % 7), "y": -1.0 / (k + 1)})

    queues = [
        value
        for _, node, _ in monitor._steps
        for value in vars(node or object).values()
        if hasattr(value, "popleft")
    ]

    assert queues
    assert max(map(len, queues)) <= 12


@pytest.mark.parametrize(
    ("position", "values", "code"),
    [
        (0.0, {"x": 1.0}, "RL301"),
        (float("nan"), {"x": 1.0}, "RL301"),
        (2.0, {"y": 1.0}, "RL304"),
        (2.0, {"x": float("nan")}, "RL302"),
    ],
)
def test_a_sample_that_does_not_fit_is_refused_and_forgotten(
    position: float, values: dict[str, float], code: str
) -> None:
    monitor = stl.StreamMonitor(stl.parse("once[0, 5] (x > 0)"))
    monitor.push(1.0, {"x": 3.0})

    with pytest.raises(DiagnosticError, match=code):
        monitor.push(position, values)

    assert monitor.push(2.0, {"x": 1.0}) == (stl.DecidedSample(2.0, 3.0),)


@pytest.mark.parametrize("seed", range(36))
def test_a_boolean_monitor_decides_where_robustness_is_zero(seed: int) -> None:
    formula = FormulaDraw(seed, bounded=True).formula(1 + seed % 3)
    positions, signals = draw_trace(seed, 24, 1, even=seed % 2 == 0)
    row = {name: np.round(values[0]) for name, values in signals.items()}
    monitor = stl.StreamMonitor(formula, boolean=True)
    found: list[stl.DecidedSample] = []
    for k, position in enumerate(positions):
        found += monitor.push(position, {name: float(values[k]) for name, values in row.items()})
    found += monitor.finish()
    assert [sample.rho > 0 for sample in found] == formula.truth(positions, row).tolist()


def test_samples_of_uneven_inputs_wait_for_each_other() -> None:
    """Whatever pieces two inputs come in, they are joined sample by sample."""
    draw = np.random.default_rng(3)
    for _ in range(40):
        streams = [[(float(time), draw.uniform()) for time in range(9)] for _ in range(2)]
        cuts = [[0, *np.sort(draw.integers(0, 10, 3)).tolist(), 9] for _ in streams]
        node = StreamPointwise(lambda first, second: first - second, 2)
        found: list[Sample] = []
        for step in range(4):
            pieces = [s[at[step] : at[step + 1]] for s, at in zip(streams, cuts, strict=True)]
            found.extend(node.step(pieces))
        assert found == [(a[0], a[1] - b[1]) for a, b in zip(*streams, strict=True)]
