"""Mining finds the tightest parameters with which a formula still holds."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from roadlang.diagnostics import DiagnosticError
from roadlang.stl.explain.mining import Parameter, mine
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
