"""Formulas pasted from Breach and from papers are read as they were meant."""

from __future__ import annotations

from typing import Any

import pytest

from roadlang import stl
from roadlang.diagnostics import DiagnosticError


@pytest.mark.parametrize(
    ("pasted", "formula"),
    [
        (
            "alw_[0, 5] (x[t] > 3 => ev_[0, 2] (y[t] < 1))",
            "always[0, 5] (x > 3 implies eventually[0, 2] (y < 1))",
        ),
        ("not ev_[0,10] (speed[t]>100)  % km/h", "not eventually[0, 10] (speed > 100)"),
        ("(x[t] > 0) until_[1, 3] (abs(y[t]) < 2)", "x > 0 until[1, 3] abs(y) < 2"),
        ("alw ((gear[t]==2) and (v[t]~=3))", "always (gear == 2 and v != 3)"),
        ("ev_[0,1] (hist_[0,2] (x[t] < 1))", "eventually[0, 1] historically[0, 2] (x < 1)"),
    ],
)
def test_breach(pasted: str, formula: str) -> None:
    assert str(stl.read_breach(pasted)) == formula


@pytest.mark.parametrize(
    ("pasted", "formula"),
    [
        (
            r"\mathbf{G}_{[0, 5]} (x > 3 \implies \mathbf{F}_{[0,2]} (y < 1))",
            "always[0, 5] (x > 3 implies eventually[0, 2] (y < 1))",
        ),
        (
            r"$\phi_3 := \Box_{[0,\infty)} \left( |e_1| \geq 10 \rightarrow"
            r" \Diamond_{[5,20]} \square_{[0,30]} (d_{1} < 10 \wedge e_1 < 10) \right)$",
            "always (abs(e_1) >= 10 implies"
            " eventually[5, 20] always[0, 30] (d_1 < 10 and e_1 < 10))",
        ),
        (
            r"(x \leq 3) \mathbin{\mathcal{U}}_{[2,30]} (\neg (y > 2))",
            "x <= 3 until[2, 30] not (y > 2)",
        ),
        (r"(x \leq 3) \, \mathbf{U} \, (\lvert y\rvert > 2 \lor \top)",
         "x <= 3 until (abs(y) > 2 or true)"),
        (r"\mathsf{always}_{[0,10]} (v \le 30)", "always[0, 10] (v <= 30)"),
    ],
)  # fmt: skip
def test_latex(pasted: str, formula: str) -> None:
    assert str(stl.read_latex(pasted)) == formula


@pytest.mark.parametrize(
    ("reader", "pasted", "code"),
    [
        (stl.read_breach, "alw (x[t+1] > 0)", "RL331"),
        (stl.read_breach, "alw_[0, 5 (x[t] > 0)", "RL0"),
        (stl.read_latex, r"\mathbf{F}_{(0,3]} (\mu > 0)", "RL026"),
        (stl.read_latex, r"\frac{", "RL0"),
        (stl.read_latex, "", "RL0"),
    ],
)
def test_what_cannot_be_read(reader: Any, pasted: str, code: str) -> None:
    with pytest.raises(DiagnosticError, match=code):
        reader(pasted)
