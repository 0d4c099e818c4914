"""Where RTAMT follows the definitions, RTAMT and roadlang agree. Needs RTAMT, and skips without."""

from __future__ import annotations

import contextlib
import io
from typing import Any

import numpy as np
import pytest

from roadlang import stl
from roadlang.diagnostics import DiagnosticError
from tests.stl_draws import FormulaDraw, draw_trace

SAMPLES = 24


def _robustness_by_rtamt(text: Any, positions: Any, row: Any) -> Any:
    rtamt = pytest.importorskip("rtamt")
    with contextlib.redirect_stdout(io.StringIO()):
        specification = rtamt.StlDiscreteTimeSpecification()
        for name in row:
            specification.declare_var(name, "float")
        specification.set_sampling_period(500, "ms", 0.1)
        specification.spec = text
        specification.parse()
        trace = {name: [float(x) for x in values] for name, values in row.items()}
        trace["time"] = [float(x) for x in positions]
        return [value for _, value in specification.evaluate(trace)]


def _sayable(seed: Any) -> bool:
    formula = FormulaDraw(seed, corners=False).formula(1 + seed % 3)
    try:
        formula.to_rtamt()
    except DiagnosticError:
        return False
    return True


@pytest.mark.parametrize("seed", [seed for seed in range(130) if _sayable(seed)])
def test_full_traces_agree(seed: Any) -> None:
    formula = FormulaDraw(seed, corners=False).formula(1 + seed % 3)
    positions, signals = draw_trace(seed, SAMPLES, 1, even=True)
    row = {name: values[0] for name, values in signals.items()}
    expected = _robustness_by_rtamt(formula.to_rtamt(), positions - positions[0], row)
    np.testing.assert_allclose(formula.robustness(positions, row), expected, atol=1e-9)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("always[0, 5] (e < 10)", "(always[0,5] (e < 10))"),
        ("always[0, inf] (e < 10)", "(always (e < 10))"),
        ("always[2, inf] (e < 10)", "(always[2,2] (always (e < 10)))"),
        ("a > 1 iff b > 2", "(((not (a > 1)) or (b > 2)) and ((a > 1) or (not (b > 2))))"),
        ("rise (a > 1)", "(rise (a > 1))"),
        ("prev next (a > 1)", "(s_prev (s_next (a > 1)))"),
        ("(a > 1) release (b > 1)", "(not ((not (a > 1)) until (not (b > 1))))"),
        ("abs(-a) != 1", "(abs((0 - a)) !== 1)"),
        ("(a > -1) until[0, 2] (b > 2)", "((a > (0 - 1)) until[0,2] (b > 2))"),
    ],
)
def test_text_for_rtamt(text: str, expected: str) -> None:
    assert stl.parse(text).to_rtamt() == expected


@pytest.mark.parametrize("text", ["true", "s > 0", "min(a, b) > 0", "ego.speed > 1",
                                  "(a > 1) until[2, inf] (b > 2)", "a^2 > 1"])  # fmt: skip
def test_what_rtamt_cannot_say(text: str) -> None:
    with pytest.raises(DiagnosticError, match="RL330"):
        stl.parse(text).to_rtamt()
