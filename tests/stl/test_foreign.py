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
        ("phi1 := alw (x[t] < 1)", "always (x < 1)"),
        ("alw_[1, 2] (theta[t] < 1)", "always[1, 2] (theta < 1)"),
        ("ev_[0,1] (hist_[0,2] (x[t] < 1))", "eventually[0, 1] historically[0, 2] (x < 1)"),
    ],
)
def test_breach(pasted: str, formula: str) -> None:
    assert str(stl.read_breach(pasted)) == formula


def test_a_word_of_another_tool_is_no_name_of_a_column() -> None:
    with pytest.raises(DiagnosticError) as raised:
        stl.parse("globally x > 0")
    assert raised.value.diagnostics[0].help == ("did you mean `always`?",)


def test_what_follows_the_name_of_an_operator_stands_in_parentheses() -> None:
    with pytest.raises(DiagnosticError) as raised:
        stl.parse("always (rise x > 0)")
    told = ("write `rise (x > 0)`",)
    assert raised.value.diagnostics[0].help == told


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
        (r"\mathbf{G}(v_{\text{ego}} \geqslant 3)", "always (v_ego >= 3)"),
        (r"\Box_{[0,5]}(x(t) > 3 \land x_1(t) < 2 \land x_{2}(t) \ne 0)",
         "always[0, 5] (x > 3 and x_1 < 2 and x_2 != 0)"),
        (r"\mathbf{F} (\mathit{speed} \gt \frac{v_0}{2})", "eventually (speed > v_0 / 2)"),
        (r"\mathbf{G} (\|x\| \leqslant \frac{\frac{a}{b}}{2})", "always (abs(x) <= a / b / 2)"),
        (r"(x > 0) \mathbin{\mathcal{U}_{[1,2]}} (y > 0)", "x > 0 until[1, 2] y > 0"),
        ("\\begin{equation}\n\\varphi \\coloneqq \\mathbf{G} (x < 1)\\label{eq:phi}\n"
         "\\end{equation}", "always (x < 1)"),
        (r"\[ \boxminus_{[0,2]} (x < 1) \land \diamondminus (y > 0) \]",
         "historically[0, 2] (x < 1) and once (y > 0)"),
        (r"\mathbf{P}_{[0,3]} (x > 1)", "once[0, 3] (x > 1)"),
        (r"\Box (\bigcirc |x| > 0 \land \ominus y > 2)",
         "always (next (abs(x) > 0) and prev (y > 2))"),
        (r"\operatorname{alw}_{[0,2]} x \in [1, 2]", "always[0, 2] (1 <= x and x <= 2)"),
    ],
)  # fmt: skip
def test_latex(pasted: str, formula: str) -> None:
    assert str(stl.read_latex(pasted)) == formula


@pytest.mark.parametrize(
    ("pasted", "formula"),
    [
        ("[]_[0, 5] (x > 3 -> <>_[0, 2] (y < 1))",
         "always[0, 5] (x > 3 implies eventually[0, 2] (y < 1))"),
        (r"[] (x > 3 /\ !(y < 1 \/ z > 2))", "always (x > 3 and not (y < 1 or z > 2))"),
        ("<> [] (x < 1)", "eventually always (x < 1)"),
        ("(x > 0) U_[1, 2] (y > 0)", "x > 0 until[1, 2] y > 0"),
        ("[]_[2, inf) (x < 1)", "always[2, inf] (x < 1)"),
        ("(x > 0) <-> (y > 0)", "x > 0 iff y > 0"),
        ("globally_[0,5] (finally_[0,1] (x > 0))", "always[0, 5] eventually[0, 1] (x > 0)"),
    ],
)  # fmt: skip
def test_staliro(pasted: str, formula: str) -> None:
    assert str(stl.read_staliro(pasted)) == formula


def test_a_formula_of_staliro_is_recognized() -> None:
    with pytest.raises(DiagnosticError) as raised:
        stl.parse("[]_[0, 5] (x > 3)")

    assert raised.value.diagnostics[0].help[-1] == (
        "this looks like S-TaLiRo: `roadlang.stl.read_staliro` reads it"
    )


@pytest.mark.parametrize(
    ("pasted", "expected"),
    [
        (r"x > 0\ \mathcal{U}_{[1,2]}\ y < 0", "(x > 0) until[1, 2] (y < 0)"),
        (r"x > 0\,\mathbf{S}_{[1,2]}\;y < 0", "(x > 0) since[1, 2] (y < 0)"),
        (r"\vert x \vert + \max\{x, y\} < 2", "abs(x) + max(x, y) < 2"),
    ],
)
def test_spaces_and_brackets_of_latex(pasted: str, expected: str) -> None:
    assert stl.read_latex(pasted) == stl.parse(expected)


@pytest.mark.parametrize(
    ("reader", "pasted", "code"),
    [
        (stl.read_breach, "alw (x[t+1] > 0)", "RL331"),
        (stl.read_breach, "alw_[0, 5 (x[t] > 0)", "RL0"),
        (stl.read_latex, r"\mathbf{F}_{(0,3]} (\mu > 0)", "RL026"),
        (stl.read_staliro, "<>_(0,inf) (x > 0)", "RL026"),
        (stl.read_latex, r"\frac{", "RL0"),
        (stl.read_latex, "", "RL0"),
    ],
)
def test_what_cannot_be_read(reader: Any, pasted: str, code: str) -> None:
    with pytest.raises(DiagnosticError, match=code):
        reader(pasted)
