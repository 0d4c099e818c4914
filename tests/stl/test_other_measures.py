"""Average and weighted robustness: by their definitions, with the sign of robustness."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from roadlang import stl
from roadlang.cli.main import main
from roadlang.diagnostics import DiagnosticError
from roadlang.stl.formula.measures import AtLeast
from tests.stl_draws import FormulaDraw, draw_trace
from tests.stl_reference import Reference


class AverageReference(Reference):
    """One sign part of all margins, and means over windows, one sample at a time."""

    def part(self, formula: stl.Formula, k: int, sign: int) -> float:
        limit: Any = max if sign > 0 else min
        match formula:
            case stl.Truth() | stl.Comparison():
                return float(limit(self.rho(formula)[k], 0.0))
            case stl.Not(p):
                return -self.part(p, k, -sign)
            case stl.And(ps):
                return min((self.part(p, k, sign) for p in ps), default=limit(math.inf, 0.0))
            case stl.Or(ps):
                return max((self.part(p, k, sign) for p in ps), default=limit(-math.inf, 0.0))
            case stl.Next() | stl.Prev() | AtLeast():
                return float(limit(self._plain(formula, k, sign), 0.0))
            case stl.UnaryTemporal(interval, p):
                samples = self._window(formula, k, interval)
                extreme, none = (min, math.inf) if formula.least else (max, -math.inf)
                values = [self.part(p, i, sign) for i in samples]
                return _mean([extreme(values[: n + 1]) for n in range(len(values))],
                             limit(none, 0.0))  # fmt: skip
            case stl.BinaryTemporal(interval, p, q):
                found = []
                for i in self._window(formula, k, interval):
                    path = range(i + 1, k + 1) if formula.past else range(k, i)
                    held = min((self.part(p, j, sign) for j in path), default=math.inf)
                    found.append(min(self.part(q, i, sign), held))
                return _mean([max(found[: n + 1]) for n in range(len(found))],
                             limit(-math.inf, 0.0))  # fmt: skip
        raise TypeError(formula)

    def _window(self, formula: Any, k: int, interval: stl.Interval | None) -> list[int]:
        """From the near end to the far one."""
        behind = self._behind(k, interval)[::-1] if formula.past else []
        return behind if formula.past else self._ahead(k, interval)

    def _plain(self, formula: Any, k: int, sign: int) -> float:
        values = [self.part(formula.operand, i, sign) for i in range(len(self.positions))]
        operand = stl.Comparison(">", stl.Variable("v"), stl.Constant(0.0))
        return Reference(self.positions, {"v": values}).rho(formula.with_parts([operand]))[k]


def _mean(values: list[float], default: float) -> float:
    return sum(values) / len(values) if values else default


@pytest.mark.parametrize("seed", range(60))
def test_averages_are_those_of_the_definition(seed: int) -> None:
    formula = FormulaDraw(seed).formula(1 + seed % 2)
    positions, signals = draw_trace(seed, (1, 2, 8)[seed % 3], 2, even=seed % 2 == 0)
    found = stl.average_robustness(formula, positions, signals)
    rho = formula.robustness(positions, signals)
    plain = stl.normal_form(formula)
    for variant in range(2):
        row = {name: values[variant] for name, values in signals.items()}
        reference = AverageReference(positions, row)
        expected = [
            reference.part(plain, k, 1 if holds else -1)
            for k, holds in enumerate(reference.satisfied(formula))
        ]
        np.testing.assert_allclose(found[variant], expected, atol=1e-9)
    assert (np.sign(found) == np.sign(rho))[np.abs(rho) > 0].all()


def test_a_lap_is_averaged_as_well() -> None:
    formula = stl.parse("eventually[0, 2] (x > 0)")
    found = stl.average_robustness(formula, [0, 1, 2], {"x": [1.0, 2.0, 4.0]}, wrap=3)
    np.testing.assert_allclose(found, [7 / 3, 10 / 3, 4])


@pytest.mark.parametrize("seed", range(40))
def test_weights_leave_the_sign(seed: int) -> None:
    formula = FormulaDraw(seed).formula(1 + seed % 3)
    positions, signals = draw_trace(seed, 9, 2, even=seed % 2 == 0)
    rho = formula.robustness(positions, signals)
    np.testing.assert_array_equal(stl.weighted_robustness(formula, positions, signals, {}), rho)
    junctions = [part for part in stl.normal_form(formula).walk()
                 if isinstance(part, stl.And | stl.Or) and len(part.operands) > 1]  # fmt: skip
    if junctions:
        weights = {junctions[0].operands[0]: 3.0}
        found = stl.weighted_robustness(formula, positions, signals, weights)
        finite = np.isfinite(rho) & np.isfinite(found)
        assert (np.sign(found) == np.sign(rho))[finite].all()


def test_weights_by_hand() -> None:
    both, either = stl.parse("x > 0 and y > 0"), stl.parse("x > 0 or y > 0")
    x, y = stl.parse("x > 0"), stl.parse("y > 0")
    signals = {"x": np.array([2.0, -2.0, -2.0]), "y": np.array([4.0, 4.0, -3.0])}
    weights = {x: 3.0, y: 1.0}
    found = stl.weighted_robustness(both, [0, 1, 2], signals, weights)
    assert found.tolist() == [0.5, -1.5, -1.5]
    found = stl.weighted_robustness(either, [0, 1, 2], signals, weights)
    assert found.tolist() == [1.5, 1.0, -0.5]


@pytest.mark.parametrize(("part", "weight"), [("x > 0", 0.0), ("x > 0", math.inf), ("x > 9", 1.0)])
def test_weights_that_mean_nothing_are_refused(part: str, weight: float) -> None:
    with pytest.raises(DiagnosticError, match="RL342"):
        stl.weighted_robustness(
            stl.parse("x > 0 and y > 0"), [0], {"x": [1], "y": [1]}, {stl.parse(part): weight}
        )


@pytest.mark.parametrize(
    ("measure", "robustness"), [("space", 4), ("time", 3), ("time-left", 0), ("average", 1)]
)
def test_the_command_says_what_is_measured(
    measure: str, robustness: float, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    trace = tmp_path / "x.csv"
    trace.write_text("time,x\n0,-1\n1,-1\n2,-1\n3,4\n4,1\n5,1\n6,1\n")
    command = ["monitor", "eventually[0, 3] (x > 0)", str(trace), "--robustness", measure, "--json"]
    with pytest.raises(SystemExit, match="0"):
        main(command)
    found = json.loads(capfd.readouterr().out)
    assert (found["robustness"], found["verdict"]) == (robustness, "satisfied")
    assert found["range"] == [4, 4]
    assert len(found["trace"]) == 7


def test_measures_of_time_go_without_other_options(
    tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    trace = tmp_path / "x.csv"
    trace.write_text("time,x\n0,-1\n1,4\n")
    with pytest.raises(SystemExit, match="2"):
        main(["monitor", "x > 0", str(trace), "--robustness", "time", "--wrap", "9"])
    assert "--robustness time cannot be used with" in capfd.readouterr().err


@pytest.mark.filterwarnings("error")
def test_sums_of_huge_numbers_are_infinite_without_a_word() -> None:
    phi, huge = stl.parse("always (x + x > 0)"), {"x": [1.7e308] * 4}
    assert stl.average_robustness(phi, range(4), huge)[0] == np.inf
    assert stl.smooth_rho(phi, range(4), huge, sharpness=10).rho == np.inf
    assert stl.parse("always (x > 0)").rho(range(4), huge) == 1.7e308
