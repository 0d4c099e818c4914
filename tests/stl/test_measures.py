"""`count[a, b] (p) <= 3` and `duration[a, b] (p) < 2s`: how often and for how long p holds."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from roadlang import stl, testing
from roadlang.diagnostics import DiagnosticError
from tests.stl.stl_continuations import continuations
from tests.stl_draws import FormulaDraw, draw_trace
from tests.stl_reference import Reference

SECONDS = np.arange(6.0)
X = {"x": np.array([5.0, -1.0, 3.0, 4.0, -2.0, 1.0])}


@pytest.mark.parametrize(
    ("text", "rho"),
    [
        ("count (x > 0) >= 1", 5),
        ("count (x > 0) >= 3", 3),
        ("count (x > 0) > 3", 1),
        ("count (x > 0) >= 5", -1),
        ("count (x > 0) >= 7", -np.inf),
        ("count (x > 0) <= 4", 1),
        ("count (x > 0) < 4", -1),
        ("count (x > 0) >= 2.5", 3),
        ("count (x > 0) >= 0", np.inf),
        ("count (x > 0) == 4", 1),
        ("count (x > 0) != 4", -1),
        ("2 <= count (x > 0) < 5", 1),
        ("3 > count[1, 3] (x > 0)", 1),
        ("duration (x > 0) >= 3s", 3),
        ("duration (x > 0) > 3s", -1),
        ("duration (x > 0) < 2s", -4),
        ("duration[0s, 2.5s] (x > 0) >= 1.5s", 3),
        ("duration[0s, 2.5s] (x > 0) > 1.5s", -1),
        ("duration[1s, 1s] (x > 0) > 0s", -np.inf),
        ("count[0, 5] (rise (x > 0)) <= 2", -1),
        ("count[0, 5] (rise (x > 0)) <= 3", 3),
    ],
)
def test_robustness_is_the_level_that_is_held_long_enough(text: str, rho: float) -> None:
    formula = stl.parse(text)
    assert formula.rho(SECONDS, X) == rho
    assert formula.satisfied(SECONDS, X) == (rho > 0)
    assert stl.parse(str(formula)) == formula
    assert stl.from_json(formula.to_json()) == formula


@pytest.mark.parametrize("seed", [seed for seed in range(36) if seed not in (15, 35)])
def test_windows_of_any_length_equal_the_definition(seed: int) -> None:
    draw = FormulaDraw(seed)
    op: Any = draw.random.choice(["<", "<=", ">", ">="])
    kind: Any = draw.random.choice([stl.Count, stl.Duration])
    amount = draw.random.choice([0.0, 1.0, 2.0, 5.0, 11.0])
    formula = kind(draw.interval(), draw.formula(seed % 2), op, amount)
    positions, signals = draw_trace(seed, (1, 2, 17, 64)[seed % 4], 2, even=seed % 3 > 0)
    wrap = float(positions[-1] - positions[0]) + 0.5 if seed % 5 == 0 else None

    found = formula.robustness(positions, signals, wrap=wrap)

    for variant in range(2):
        row = {name: values[variant] for name, values in signals.items()}
        reference = Reference(positions, row, wrap)
        np.testing.assert_array_equal(found[variant], reference.rho(formula))
        assert formula.truth(positions, row, wrap=wrap).tolist() == reference.satisfied(formula)


@pytest.mark.parametrize("seed", range(2, 16))
def test_no_continuation_leaves_the_range(seed: int) -> None:
    draw = FormulaDraw(seed, corners=False)
    op: Any = draw.random.choice(["<", "<=", ">", ">="])
    kind: Any = draw.random.choice([stl.Count, stl.Duration])
    amount = draw.random.choice([1.0, 2.0, 3.5])
    formula = kind(draw.interval(), draw.formula(seed % 3), op, amount)
    if seed % 2:
        formula = stl.Always(draw.interval(), formula)
    positions, signals = draw_trace(seed, 9, 1, even=seed % 2 == 0)
    row = {name: values[0] for name, values in signals.items()}
    lo, hi = formula.range(positions, row)
    verdict = formula.verdict(positions, row)

    for longer, values in continuations(seed, positions, row, choices=12, variants=30):
        rho = formula.rho(longer, values)
        assert (rho >= lo - 1e-9).all()
        assert (rho <= hi + 1e-9).all()
        if verdict in ("satisfied", "violated"):
            assert (formula.satisfied(longer, values) == (verdict == "satisfied")).all()


@pytest.mark.parametrize(
    ("text", "lo", "hi"),
    [
        ("count[0, 9] (x > 0) >= 5", -1, np.inf),
        ("count[0, 9] (x > 0) <= 3", -np.inf, -1),
        ("count[0, 5] (x > 0) >= 5", -1, -1),
        ("duration[0, 9] (x > 0) >= 8s", -np.inf, -1),
        ("duration[0, 9] (x > 0) >= 7s", -np.inf, 3),
        ("duration[0, 9] (x > 0) >= 6s", -np.inf, 4),
        ("duration[0, 5] (x > 0) <= 3s", 1, 1),
    ],
)
def test_what_may_still_come_is_counted(text: str, lo: float, hi: float) -> None:
    found = stl.parse(text).range(SECONDS, X)
    assert [float(end) for end in found] == [lo, hi]


def test_a_stream_knows_a_count_when_its_window_is_over() -> None:
    monitor = stl.StreamMonitor(stl.parse("duration[0, 2] (x > 0) >= 1"))
    found = [monitor.push(time, {"x": x}) for time, x in zip(SECONDS, X["x"], strict=True)]
    assert [len(samples) for samples in found] == [0, 0, 0, 1, 1, 1]
    whole = monitor.formula.robustness(SECONDS, X)
    decided = [sample.rho for samples in [*found, monitor.finish()] for sample in samples]
    assert decided == whole.tolist()


def test_the_explanation_names_the_sample_that_was_one_too_many() -> None:
    why = stl.parse("always (count[0, 3] (x > 0) <= 2)").explain(SECONDS, X)
    assert (why.verdict, why.rho, why.predicate, why.position) == ("violated", -3, "x > 0", 2)
    assert [(s.start, s.end, s.predicate) for s in why.stretches] == [
        (0, 0, "x <= 0"),
        (2, 3, "x <= 0"),
        (5, 5, "x <= 0"),
    ]


def test_a_window_with_too_few_samples_is_said_to_be_so() -> None:
    why = stl.parse("count[0, 1] (x > 0) >= 3").explain(SECONDS, X)
    assert why.window_empty
    assert "too few samples in the window of count[0, 1] (x > 0) >= 3" in str(why)


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("count (x > 1)", "is not compared with a number"),
        ("count (x > 1) + 1 < 3", "is not compared with a number"),
        ("abs(duration (x > 1)) < 3", "is not compared with a number"),
        ("count (x > 1) < y", "which is not a constant"),
        ("count (x > 1) < count (y > 1)", "which is not a constant"),
        ("count (x > 1) < 3s", "which has a unit"),
    ],
)
def test_what_a_count_is_compared_with(text: str, problem: str) -> None:
    with pytest.raises(DiagnosticError, match="RL329") as refused:
        stl.parse(text)
    assert problem in str(refused.value)


P = {">": ["x", 1]}


@pytest.mark.parametrize("value", [["x", "<=", 3], [P, "==", 3], [P, "<", True], [P, "<"], P])
def test_json_that_is_no_count_is_refused(value: Any) -> None:
    with pytest.raises(DiagnosticError, match="RL310"):
        stl.from_json({"count": value})


def test_between_samples_there_is_nothing_to_count() -> None:
    with pytest.raises(DiagnosticError, match="RL311"):
        stl.parse("count (x > 0) > 1").rho(SECONDS, X, semantics="linear")
    with pytest.raises(DiagnosticError, match="RL330"):
        stl.parse("count (x > 0) > 1").to_rtamt()


SCENE = """
road main {{ draw with segments {{ pieces: [straight(200m)] }} }}
agent ego is car on main at 5m {{ drive with lane_follow {{ speed: 12m/s }} }}
agent walkers is pedestrian on main at 50%..60% {{ count: 3, offset: 6m }}
simulate {{ duration: 60s }}
expect e: {formula}
"""


@pytest.mark.parametrize(
    "formula",
    [
        "count[0s, 10s] (rise (ego.speed > 5m/s)) <= 3",
        "always (duration[0s, 10s] (ego.speed > 20m/s) < 2s)",
        "duration[0m, 50m] (curvature(main) > 0.1/m) < 5m",
        "1 <= count[0m, 50m] (curvature(main) < 0.1/m) <= 300",
    ],
)
def test_scenes_count_and_options_keep_their_names(formula: str) -> None:
    assert testing.check(SCENE.format(formula=formula)) == ()


@pytest.mark.parametrize(
    ("formula", "code"),
    [
        ("count[0s, 10s] (ego.speed > 5m/s) <= 3s", "RL329"),
        ("count[0s, 10s] (ego.speed > 5m/s)", "RL329"),
        ("duration[0s, 10s] (ego.speed > 5m/s) < 3", "RL202"),
        ("duration[0s, 10s] (ego.speed > 5m/s) < 3m", "RL201"),
        ("duration[0s, 10s] (ego.speed > 5m/s) < ego.speed", "RL329"),
        ("duration[0m, 10m] (ego.speed > 5m/s) < 3s", "RL351"),
        ("duration[0s, 10s] (ego.speed) < 3s", "RL234"),
    ],
)
def test_check_knows_what_a_count_and_a_duration_are(formula: str, code: str) -> None:
    found = testing.check(SCENE.format(formula=formula))
    assert [diagnostic.code for diagnostic in found] == [code]
