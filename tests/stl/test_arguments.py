"""What a program hands over instead of formulas, signals and parameters is named."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from roadlang import DiagnosticError, stl

TIME = np.arange(4.0)
X = np.array([0.0, 1.0, 0.5, 2.0])
SIGNALS = {"x": X}
LOW: Any = stl.parse("always (x < 3)")
STL: Any = stl
RECORDINGS = [(TIME, SIGNALS)]
TEXT = "always (x < a)"
A = stl.Parameter("a", 0, 3)
Y = stl.Variable("x")

WRONG: list[tuple[Callable[[], Any], str]] = [
    (lambda: STL.parse(3), "`text` must be text, not 3"),
    (lambda: STL.Always(None, "x < 1").rho(TIME, SIGNALS), "`part of Always` must be a formula"),
    (lambda: STL.Always((0, 1), LOW), "`interval` must be an `Interval` or None, not (0, 1)"),
    (lambda: STL.Comparison("<", "x", 5).rho(TIME, SIGNALS), "`side of Comparison` must be a term"),
    (
        lambda: STL.Comparison("<", STL.Negate(5), Y).rho(TIME, SIGNALS),
        "`part of Negate` must be a",
    ),
    (lambda: STL.Comparison("<", STL.Variable(5), Y).rho(TIME, SIGNALS), "`name of Variable` must"),
    (
        lambda: STL.Comparison("<", STL.Constant("a"), Y).rho(TIME, SIGNALS),
        "`value of Constant` mu",
    ),
    (lambda: STL.weighted_robustness(LOW, TIME, SIGNALS, None), "`weights` must be a map from"),
    (lambda: STL.sampling_error(LOW, TIME, SIGNALS, None, "held"), "`rates` must be a map"),
    (lambda: STL.StreamMonitor(STL.parse("x < 1")).push(0, None), "`values` must be a map"),
    (lambda: STL.read_breach(None), "`text` must be text, not None"),
    (lambda: STL.read_latex(b"x"), "`text` must be text, not b'x'"),
    (lambda: STL.read_staliro(3), "`text` must be text, not 3"),
    (lambda: STL.read_trace(3), "`path` must be a path"),
    (lambda: LOW.rho(TIME, None), "`signals` must be a map, such as a dict, not None"),
    (lambda: LOW.rho(TIME, X, semantics="linear"), "`signals` must be a map"),
    (lambda: LOW.verdict(TIME, {3: X}), "`signals` must be a map whose keys are texts, not 3"),
    (lambda: LOW.rho(TIME, SIGNALS, wrap="9"), "`wrap` must be a number, not '9'"),
    (lambda: LOW.explain(TIME, SIGNALS, variant="a"), "`variant` must be an integer, not 'a'"),
    (lambda: STL.average_robustness("x < 3", TIME, SIGNALS), "`formula` must be a formula, which"),
    (lambda: STL.time_robustness("x < 3", TIME, SIGNALS), "`formula` must be a formula"),
    (lambda: STL.smooth_rho(3, TIME, SIGNALS), "`formula` must be a formula"),
    (lambda: STL.dense_function(3, TIME, SIGNALS, "held"), "`formula` must be a formula"),
    (lambda: STL.OnlineMonitor("x < 3"), "`formula` must be a formula"),
    (lambda: STL.StreamMonitor("x < 3"), "`formula` must be a formula"),
    (lambda: STL.OnlineMonitor(LOW).push("0", {"x": 1.0}), "`position` must be a number, not '0'"),
    (lambda: STL.OnlineMonitor(LOW).push(0.0, 1.0), "`signals` must be a map"),
    (lambda: _stream().push(0.0, {"x": None}), "`values['x']` must be a number, not None"),
    (lambda: STL.Interval("0", 3), "`lo` must be a number, not '0'"),
    (lambda: STL.Parameter("a", "0", 3), "`low` must be a number, not '0'"),
    (lambda: STL.mine(3, [A], RECORDINGS), "`text` must be text, not 3"),
    (lambda: STL.mine(TEXT, [("a", 0, 3)], RECORDINGS), "`parameters` must be a list of `Param"),
    (lambda: STL.mine_front(TEXT, [], RECORDINGS), "`parameters` must be a list of `Parameter`s"),
    (lambda: STL.mine(TEXT, [A], (TIME, SIGNALS)), "`recordings` must be a list of pairs"),
    (lambda: STL.mine(TEXT, [A], RECORDINGS, margin="1"), "`margin` must be a number, not '1'"),
    (lambda: STL.mine(TEXT, [A], RECORDINGS, digits=0), "`digits` must be at least 1, not 0"),
    (lambda: STL.mine_front(TEXT, [A], RECORDINGS, points=1), "`points` must be at least 2"),
]


def _stream() -> Any:
    return STL.StreamMonitor(stl.parse("once[0, 1] (x > 1)"))


@pytest.mark.parametrize(("call", "says"), WRONG, ids=[says for _, says in WRONG])
def test_an_argument_that_is_wrong_is_named(call: Callable[[], Any], says: str) -> None:
    with pytest.raises((TypeError, ValueError)) as caught:
        call()
    assert says in str(caught.value)


@pytest.mark.parametrize("semantics", ["sampled", "held", "linear"])
@pytest.mark.parametrize("variant", [2, -1])
def test_a_variant_that_is_not_there(semantics: Any, variant: int) -> None:
    both = {"x": np.stack([X, X + 1.0])}
    with pytest.raises(DiagnosticError, match=f"it is {variant}, but there are 2 variants"):
        LOW.explain(TIME, both, variant=variant, semantics=semantics)


def test_rows_of_different_lengths_are_no_signal() -> None:
    with pytest.raises(DiagnosticError, match=r"RL303.*`x` must be an array, but has rows of diff"):
        LOW.rho(TIME, {"x": [[1.0, 2.0], [3.0]]})


def test_a_sample_of_several_numbers_is_none() -> None:
    monitor: Any = stl.OnlineMonitor(LOW)
    monitor.push(0.0, {"x": [1.0]})
    with pytest.raises(DiagnosticError, match=r"RL303.*`x` must be one number, but has shape"):
        monitor.push(1.0, {"x": [[1.0], [2.0]]})
    assert monitor.push(1.0, {"x": np.float32(0.5)}) == (-np.inf, 2.0)


def test_a_parameter_that_is_given_twice() -> None:
    with pytest.raises(DiagnosticError, match=r"RL342.*`a`: it is given twice"):
        stl.mine(TEXT, [A, A], RECORDINGS)


@pytest.mark.parametrize("rate", [-2.0, np.nan])
def test_a_rate_of_change_is_0_or_more(rate: float) -> None:
    """-2 gave a negative bound on an error."""
    with pytest.raises(DiagnosticError, match=r"RL342.*`x`: its rate of change is"):
        stl.sampling_error(LOW, TIME, SIGNALS, {"x": rate}, "linear")


def test_nothing_follows_the_end_of_a_stream() -> None:
    monitor = stl.StreamMonitor(stl.parse("x < 3"))
    monitor.push(0.0, {"x": 1.0})
    monitor.finish()
    with pytest.raises(RuntimeError, match="make another `StreamMonitor`"):
        monitor.push(1.0, {"x": 1.0})


def test_monitors_say_what_they_watch_and_know() -> None:
    online, stream = (
        stl.OnlineMonitor(LOW),
        stl.StreamMonitor(stl.parse("eventually[0, 2] (x < 1)")),
    )
    online.push(0.0, {"x": 1.0})
    stream.push(0.0, {"x": 1.0})
    assert repr(online) == "<OnlineMonitor of always (x < 3): unknown, robustness in [-inf, 2]>"
    assert repr(stream) == "<StreamMonitor of eventually[0, 2] (x < 1): 1 sample, delay 2>"


@pytest.mark.parametrize(
    ("formula", "told"),
    [
        (lambda: STL.Comparison("<<", Y, Y), "`op` of Comparison must be one of `<`, `<=`,"),
        (lambda: STL.Comparison("<", STL.Arithmetic("%", Y, Y), Y), "`op` of Arithmetic must be"),
        (lambda: STL.Comparison("<", STL.Apply("sin", (Y,)), Y), "`function` of Apply must be one"),
    ],
)
def test_operators_that_there_are_not_are_told(formula: Callable[[], Any], told: str) -> None:
    with pytest.raises(ValueError, match=re.escape(told)):
        stl.Not(formula()).rho(TIME, SIGNALS)
