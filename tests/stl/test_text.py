"""Formulas are written in the language of scene files, with or without units."""

from __future__ import annotations

import math
from typing import Any

import pytest

from roadlang import stl
from roadlang.diagnostics import DiagnosticError
from tests.stl_draws import FormulaDraw


@pytest.mark.parametrize(
    ("written", "canonical"),
    [
        ("G (e < 10)", "always (e < 10)"),
        ("F[5:20] G[0:30] (d < 1)", "eventually[5, 20] always[0, 30] (d < 1)"),
        ("!(a < 1) && b < 2 || c > 1", "not (a < 1) and b < 2 or c > 1"),
        ("a < 1 -> b < 2", "a < 1 implies b < 2"),
        ("(a < 1) U[2, inf] (b < 2)", "a < 1 until[2, inf] b < 2"),
        ("always (p > 0) and q > 0", "always (p > 0) and q > 0"),
        ("0 < x < 3", "0 < x and x < 3"),
        ("always[0m, 1km] (v < 36km/h)", "always[0, 1000] (v < 10)"),
        ("once[5, 20m] (ego.speed > 1)", "once[5, 20] (ego.speed > 1)"),
        ("always[1, 2ms] (e > 1)", "always[0.001, 0.002] (e > 1)"),
        ("abs(k) < 0.1/m", "abs(k) < 0.1"),
        ("a - (b - 1) > -2", "a - (b - 1) > -2"),
    ],
)
def test_text_is_read_and_printed_canonically(written: str, canonical: str) -> None:
    assert str(stl.parse(written)) == canonical


@pytest.mark.parametrize(
    ("written", "canonical"),
    [
        ("(x * y) * z", "x * y * z"),
        ("x * (y * z)", "x * (y * z)"),
        ("(x * y) / z", "x * y / z"),
        ("(x / y) * z", "x / y * z"),
        ("x / (y * z)", "x / (y * z)"),
        ("x * (y / z)", "x * (y / z)"),
        ("(x / y) / z", "x / y / z"),
        ("x / (y / z)", "x / (y / z)"),
        ("(x + y) - z", "x + y - z"),
        ("x - (y + z)", "x - (y + z)"),
        ("x - (y - z)", "x - (y - z)"),
        ("(x - y) - z", "x - y - z"),
        ("(x + y) * z", "(x + y) * z"),
        ("x + (y * z)", "x + y * z"),
        ("x ^ (y ^ z)", "x ^ (y ^ z)"),
        ("(x ^ y) ^ z", "(x ^ y) ^ z"),
        ("(x * y) ^ z", "(x * y) ^ z"),
        ("x * (y ^ z)", "x * y ^ z"),
        ("-(x + y)", "-(x + y)"),
        ("-(x * y)", "-(x * y)"),
        ("(-x) * y", "-x * y"),
        ("-x ^ y", "-x ^ y"),
        ("(-x) ^ y", "(-x) ^ y"),
        ("x - (-y)", "x - -y"),
    ],
)
def test_terms_are_printed_with_the_brackets_that_they_need(written: str, canonical: str) -> None:
    formula = stl.parse(f"{written} < 1")
    assert str(formula) == f"{canonical} < 1"
    assert stl.parse(str(formula)) == formula


@pytest.mark.parametrize("seed", range(70))
def test_printed_formulas_read_back(seed: int) -> None:
    formula = FormulaDraw(seed).formula(1 + seed % 3)
    once = stl.parse(str(formula))
    assert stl.parse(str(once)) == once
    assert str(once) == str(formula)
    assert stl.from_json(stl.to_json(formula)) == formula


@pytest.mark.parametrize(
    ("text", "code", "column", "fix"),
    [
        ("always clearance", "RL320", 8, "(clearance > 0)"),
        ("x", "RL320", 1, "(x > 0)"),
        ("(a < b) + 1 > 0", "RL321", 2, None),
        ("abbs(x) < 1", "RL322", 1, "abs"),
        ('"x" < 1', "RL323", 1, "x"),
        ("x < 1..2", "RL323", 5, None),
        ("rise close > 2 and q", "RL001", 6, "(close > 2)"),
        ("always (next abs(x) < 3)", "RL001", 14, "(abs(x) < 3)"),
        ("x < 5parsec", "RL324", 5, "5"),
        ("x < 5meters", "RL324", 5, "5m"),
        ("x < 5 meters", "RL009", 5, "5m"),
        ("always[0m, 5m] F[0s, 2s] (e < 1)", "RL325", 18, None),
        ("always[0, x] (e < 1)", "RL326", 11, None),
        ("abs(x, y) < 1", "RL327", 1, None),
        ("abs(a: x) < 1", "RL327", 1, None),
        ("max(x) < 1", "RL327", 1, None),
        ("max(x, b: y) < 1", "RL327", 1, None),
        ("always[50, 0] (e < 1)", "RL305", 7, "[0, 50]"),
        ("always[-1, 0] (e < 1)", "RL305", 7, "[0, 0]"),
        ("always[-9, -1] (e < 1)", "RL305", 7, None),
    ],
)
def test_nonsense_is_refused_at_its_place(
    text: str, code: str, column: int, fix: str | None
) -> None:
    with pytest.raises(DiagnosticError) as refusal:
        stl.parse(text)
    (found,) = refusal.value.diagnostics
    assert found.span is not None
    assert (found.code, found.span.column) == (code, column)
    assert [edit.replacement for edit in found.fixes] == ([fix] if fix else [])
    assert found.help


@pytest.mark.parametrize("text", ["gap(ego, lead) > 0m", "always (e < distance(a, b))"])
def test_signals_of_several_things_are_for_scene_files(text: str) -> None:
    with pytest.raises(DiagnosticError, match="write the formula as an `expect`") as refusal:
        stl.parse(text)
    assert refusal.value.diagnostics[0].code == "RL322"


def test_all_faults_are_told_at_once() -> None:
    with pytest.raises(DiagnosticError) as refusal:
        stl.parse("always[2, 1] (x) and abbs(y) < 3mtr")
    assert [found.code for found in refusal.value.diagnostics] == [
        "RL305", "RL320", "RL322", "RL324",
    ]  # fmt: skip


@pytest.mark.parametrize("bounds", [(2, 1), (-1, 1), (math.inf, math.inf), (math.nan, 1)])
def test_intervals_are_closed_and_ahead(bounds: tuple[float, ...]) -> None:
    with pytest.raises(DiagnosticError, match="RL305"):
        stl.Interval(*bounds)


@pytest.mark.parametrize(
    "value", [None, 3, "x", {}, {"alway": True}, {"<": ["x"]}, {"not": 1, "and": []},
              {"always": True, "interval": [3, 1]}, {"and": 3}, {"<": ["x", {"sin": ["x"]}]}],
)  # fmt: skip
def test_json_that_is_no_formula_is_refused(value: Any) -> None:
    with pytest.raises(DiagnosticError, match="RL3"):
        stl.from_json(value)


@pytest.mark.parametrize("text", ["alw_[0, 5] (x[t] < 1)", "x[t] < 1", "ev_[0, 2] (x < 1)"])
def test_formulas_of_breach_are_recognized(text: str) -> None:
    with pytest.raises(DiagnosticError) as refusal:
        stl.parse(text)
    assert any("read_breach" in hint for hint in refusal.value.diagnostics[0].help)


@pytest.mark.parametrize(
    ("text", "code", "line"),
    [
        ("always (1/x < 2)", "RL324", "put spaces around `/`: `1 / x`"),
        ("always (x > 5m/v)", "RL324", "put spaces around `/`: `5m / v`"),
        ("always (x > 5qq)", "RL324", "leave the unit away (`5`)"),
        ("always[0, 5deg] (x < 1)", "RL328", "an interval cannot be in `deg`"),
        ("always[0, 5%] (x < 1)", "RL328", "an interval cannot be in `%`"),
        ("always[0, 5m/s] (x < 1)", "RL328", "an interval cannot be in `m/s`"),
        ("always[0, 5) (x < 1)", "RL026", "intervals include both ends: close it with `]`"),
        ("F[0, 5s) (x < 1)", "RL026", "intervals include both ends: close it with `]`"),
        ("(x < 1) until[0, 5) (x > 1)", "RL026", "intervals include both ends"),
        ("always(0, 5] (x < 1)", "RL026", "intervals include both ends: write `[0, 5]`"),
        ("always]0s, 5s[ (x < 1)", "RL026", "intervals include both ends: write `[0s, 5s]`"),
        ("(x < 1) since[1, 5[ (x > 1)", "RL026", "intervals include both ends: write `[1, 5]`"),
        ("(x < 1) until(0, 5) (x > 1)", "RL026", "write `[0, 5]`"),
        ("count(0, 5] (x < 1) >= 2", "RL026", "intervals include both ends: write `[0, 5]`"),
        ("duration[0, 5) (x < 1) > 2", "RL026", "intervals include both ends: close it with `]`"),
        ("next[0, 1] (x > 1)", "RL001", "`next` counts samples, not time: leave the interval out"),
        ("always (lateral error < 1)", "RL001", "in back quotes: `` `lateral error` ``"),
        ("always (l\u00fccke < 1)", "RL007", "in back quotes: `` `l\u00fccke` ``"),
        ("x > 3 /\\ y < 2", "RL006", "write `and`"),
    ],
)
def test_numbers_and_intervals_that_make_no_sense_are_explained(
    text: str, code: str, line: str
) -> None:
    with pytest.raises(DiagnosticError) as raised:
        stl.parse(text)

    (diagnostic,) = raised.value.diagnostics
    assert diagnostic.code == code
    assert any(line in said for said in (diagnostic.message, *diagnostic.help))


@pytest.mark.parametrize("text", ["out = always (x > 0)", "out = always (x > 0)\n", "a.b = x > 0"])
def test_the_name_that_a_specification_of_rtamt_has_is_told(text: str) -> None:
    with pytest.raises(DiagnosticError) as caught:
        stl.parse(text)
    (found,) = caught.value.diagnostics
    assert found.code == "RL001"
    assert found.help == (f"a formula has no name: write `{text.partition('= ')[2].strip()}`",)


def test_one_equals_sign_between_numbers_is_still_that_of_a_comparison() -> None:
    with pytest.raises(DiagnosticError) as caught:
        stl.parse("x = 3")
    assert [(found.code, found.help) for found in caught.value.diagnostics] == [
        ("RL010", ("write `==`",))
    ]
