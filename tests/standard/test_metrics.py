"""Metrics of drives against motions that are known in closed form."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

import roadlang
from roadlang.diagnostics import DiagnosticError
from roadlang.ir.trace import AgentTrace
from roadlang_standard import metrics

TIME = np.linspace(0.0, 10.0, 101)


def straight(name: str, x: float, speed: float, acceleration: float = 0.0) -> AgentTrace:
    """An agent on a straight line to the east, with constant acceleration."""
    zero = np.zeros(len(TIME))
    return AgentTrace(
        name,
        TIME,
        x + speed * TIME + 0.5 * acceleration * TIME**2,
        zero,
        zero,
        speed + acceleration * TIME,
        zero + acceleration,
        zero,
        zero,
        0.5 * np.sin(2.0 * math.pi * TIME),
        zero,
        zero,
        4.0,
        2.0,
    )


def circle(name: str, radius: float, speed: float) -> AgentTrace:
    heading = speed / radius * TIME
    zero = np.zeros(len(TIME))
    x, y = radius * np.sin(heading), radius * (1 - np.cos(heading))
    return AgentTrace(
        name, TIME, x, y, heading, zero + speed, zero, zero, zero, zero, zero, zero, 4.0, 2.0
    )


def test_time_to_collision_is_the_gap_by_the_closing_speed() -> None:
    found = metrics.time_to_collision(straight("ego", 0.0, 10.0), straight("lead", 54.0, 5.0))
    assert found == pytest.approx((50.0 - 5.0 * TIME) / 5.0, abs=1e-9)
    assert metrics.time_exposed(found, TIME, 4.0) == pytest.approx(4.0, abs=0.11)
    assert metrics.time_integrated(found, TIME, 4.0) == pytest.approx(8.0, abs=0.5)


def test_who_falls_back_never_collides() -> None:
    found = metrics.time_to_collision(straight("ego", 0.0, 5.0), straight("lead", 54.0, 10.0))
    assert np.isinf(found).all()


def test_headway_is_the_distance_of_the_fronts_by_the_speed_of_the_one_behind() -> None:
    behind, ahead = straight("ego", 0.0, 10.0), straight("lead", 54.0, 10.0)
    assert metrics.time_headway(behind, ahead) == pytest.approx(5.4)
    assert np.isinf(metrics.time_headway(ahead, behind)).all()


def test_the_root_of_the_mean_square_of_a_sine_is_its_amplitude_by_root_two() -> None:
    ego = straight("ego", 0.0, 10.0)
    assert metrics.cross_track_rms(ego) == pytest.approx(0.5 / math.sqrt(2), rel=1e-6)


def test_lateral_acceleration_on_a_circle() -> None:
    ego = circle("ego", 50.0, 10.0)
    assert metrics.max_lateral_acceleration(ego) == pytest.approx(2.0, rel=1e-9)


def test_comfort_of_constant_braking() -> None:
    found = metrics.comfort(straight("ego", 0.0, 30.0, -2.0))
    assert (found.rms, found.longitudinal, found.lateral) == pytest.approx((2.0, 2.0, 0.0))
    assert (found.jerk, found.uncomfortable) == pytest.approx((0.0, 1.0))
    gentle = metrics.comfort(straight("ego", 0.0, 30.0, -1.0))
    assert (gentle.rms, gentle.uncomfortable) == pytest.approx((1.0, 0.0))


def test_a_drive_and_its_file_have_the_same_metrics(tmp_path: Path) -> None:
    text = """
    road main { draw with waypoints { points: [(0m, 0m), (60m, 0m), (90m, 25m)] }, width: 7m }
    agent ego is car on main at 5m { drive with pure_pursuit { speed: 9m/s } }
    agent lead is car on main at 40m { drive with pure_pursuit { speed: 5m/s } }
    simulate with builtin { duration: 4s }
    """
    found = roadlang.loads(text).sample()[0].run()
    path = tmp_path / "scene.trace.json"
    path.write_text(found.to_json())
    again = roadlang.read_drive(path)
    for trace in (found.trace, again):
        ego, lead = trace.agents["ego"], trace.agents["lead"]
        assert metrics.comfort(ego).longitudinal > 0.1
        assert 0.0 < metrics.time_to_collision(ego, lead).min() < 10.0
    assert metrics.comfort(again.agents["ego"]) == metrics.comfort(found.trace.agents["ego"])


def test_a_file_that_is_no_trace_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "scene.trace.json"
    path.write_text("{}")
    with pytest.raises(DiagnosticError, match="RL721"):
        roadlang.read_drive(path)
    with pytest.raises(DiagnosticError, match="RL721"):
        roadlang.read_drive(tmp_path / "none.json")


VALUES = arrays(np.float64, st.integers(1, 30), elements=st.floats(-1e3, 1e3))
STEP = 0.1


@given(VALUES)
def test_the_mean_lies_between_the_extremes(values: np.ndarray) -> None:
    size = np.abs(values)
    time = np.linspace(0.0, STEP * (len(values) - 1), len(values))
    assert size.min() - 1e-6 <= metrics.rms(values, time) <= size.max() + 1e-6


@given(VALUES, st.floats(-1e3, 1e3))
def test_exposure_is_at_most_the_duration(values: np.ndarray, threshold: float) -> None:
    time = np.linspace(0.0, STEP * (len(values) - 1), len(values))
    assert 0.0 <= metrics.time_exposed(values, time, threshold) <= time[-1] + 1e-9
    assert metrics.time_integrated(values, time, threshold) >= 0.0


EGO = straight("ego", 0.0, 5.0)
anything: Any = metrics


@pytest.mark.parametrize(
    ("error", "told", "call"),
    [
        (
            TypeError,
            "`second` must be an agent of a trace",
            lambda: anything.time_headway(EGO, "b"),
        ),
        (TypeError, "`first` must be an agent", lambda: anything.time_to_collision({}, EGO)),
        (TypeError, "`agent` must be an agent", lambda: anything.comfort("ego")),
        (TypeError, "`agent` must be an agent", lambda: anything.cross_track_rms(None)),
        (TypeError, "`agent` must be an agent", lambda: anything.max_lateral_acceleration(3)),
        (TypeError, "`values` must be an array of numbers", lambda: anything.rms("abc", TIME)),
        (TypeError, "`values` must be an array of numbers", lambda: anything.rms([1j], [0])),
        (TypeError, "`values` must be", lambda: anything.rms([[1], [1, 2]], [0, 1])),
        (TypeError, "`threshold` must be", lambda: anything.time_exposed([1], [0], "3s")),
        (ValueError, "not NaN", lambda: anything.time_exposed([1], [0], math.nan)),
        (ValueError, "of the shape", lambda: anything.time_exposed(np.ones((2, 2)), [0, 1], 1)),
        (ValueError, "not 2 and 1 samples", lambda: anything.rms([3, 4], [0])),
        (ValueError, "not 3 and 2 samples", lambda: anything.time_exposed([1, 2, 3], [0, 1], 2)),
        (ValueError, "in ascending order", lambda: anything.time_exposed([1, 2], [1, 0], 2)),
        (ValueError, "in ascending order", lambda: anything.rms([1, 2], [0, math.inf])),
    ],
)
def test_wrong_arguments_are_refused_by_name(
    error: type[Exception], told: str, call: Callable[[], object]
) -> None:
    with pytest.raises(error, match=told):
        call()


def test_agents_of_two_drives_are_not_compared() -> None:
    short = replace(EGO, **{name: getattr(EGO, name)[:50] for name in ("time", "x", "y")})
    with pytest.raises(ValueError, match="agents of one drive, not of 101 and 50 times"):
        metrics.time_to_collision(EGO, short)


def test_what_is_infinite_or_unknown_counts_as_such() -> None:
    """The last sample stands for no time."""
    assert metrics.time_exposed([1.0, np.inf, 3.0], [0, 1, 2], 2.5) == 1.0
    assert metrics.time_integrated([1.0, np.inf, -np.inf], [0, 1, 2], 2.5) == 1.5
    assert metrics.time_integrated([1.0, -np.inf, 3.0], [0, 1, 2], 2.5) == np.inf
    for measure in (metrics.time_exposed, metrics.time_integrated):
        assert math.isnan(measure([1.0, np.nan, 3.0], [0, 1, 2], 2.5))
        assert measure([], [], 2.5) == 0.0
