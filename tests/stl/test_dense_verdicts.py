"""Signals that are held or linear: satisfaction at exactly 0, ranges and verdicts."""

from __future__ import annotations

import json
import random
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from roadlang import stl
from roadlang.cli.main import main
from tests.dense_reference import DenseReference, Moment
from tests.stl.test_dense import DenseDraw, draw_grids
from tests.stl_draws import NAMES

SEMANTICS = ["held", "linear"]


class BooleanReference(DenseReference):
    """1 where a comparison holds and -1 where it does not, in exact arithmetic."""

    def _value(self, node: Any, at: Moment) -> Any:
        if not isinstance(node, stl.Comparison):
            return super()._value(node, at)
        time, side = at
        if side:  # the difference keeps its sign up to the next moment at which it can change
            times = sorted({*self._candidates(node), self.start, self.end})
            beyond = [t for t in times if (t > time if side > 0 else t < time)]
            if beyond:
                near = beyond[0] if side > 0 else beyond[-1]
                at = (time + near) / 2, 0
        x, y = self.value(node.left, at), self.value(node.right, at)
        holds = {"<": x < y, "<=": x <= y, ">": x > y, ">=": x >= y, "==": x == y, "!=": x != y}
        return Fraction(1 if holds[node.op] else -1)


@pytest.mark.parametrize("semantics", SEMANTICS)
@pytest.mark.parametrize("seed", [seed for seed in range(44) if seed not in (26, 29, 41)])
def test_satisfaction_is_that_of_the_definitions(seed: int, semantics: Any) -> None:
    formula = DenseDraw(1000 + seed, bounded=True).formula(1 + seed % 3)
    grids = draw_grids(seed, same=seed % 2 == 0)
    used = {name: grids[name] for name in formula.variables}
    if not used:
        return
    reference = BooleanReference(used, linear=semantics == "linear")
    first, last = float(reference.start), float(reference.end)
    times = sorted({first, last, *np.linspace(first, last, 5).tolist()})
    signals = {name: stl.OwnGrid(*grid) for name, grid in grids.items()}

    truth = formula.truth(times, signals, semantics=semantics)

    assert truth.tolist() == [reference.rho(formula, time) > 0 for time in times]
    assert formula.satisfied(times, signals, semantics=semantics) == truth[0]
    rho = formula.robustness(times, signals, semantics=semantics)
    assert (truth[rho > 1e-9]).all()
    assert not (truth[rho < -1e-9]).any()


@pytest.mark.parametrize(
    ("text", "held", "linear"),
    [
        ("always (x >= 0)", True, True),
        ("always (x > 0)", False, False),
        ("eventually (x == 1)", False, True),
        ("eventually[0, 0.5] (x < 2)", False, True),
        ("(x > 1) until (x <= 1)", True, True),
        ("(x > 1) until (x < 1)", True, False),
    ],
)
def test_at_exactly_zero_the_comparison_decides(text: str, held: bool, linear: bool) -> None:
    formula, x = stl.parse(text), {"x": [2.0, 0.0]}
    assert formula.satisfied([0, 1], x, semantics="held") == held
    assert formula.satisfied([0, 1], x, semantics="linear") == linear


@pytest.mark.parametrize("semantics", SEMANTICS)
@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("eventually[2, 3] always[0, 1] (abs(x) < 5)", (-np.inf, 5.0)),
        ("always[2, 3] eventually[0, 1] (abs(x) > -5)", (5.0, np.inf)),
        ("always[2, 3] ((abs(x) > -6) until[0, 1] (abs(x) > -5))", (5.0, np.inf)),
    ],
)
def test_what_is_known_of_every_moment_holds_behind_the_last_one_too(
    text: str, expected: tuple[float, float], semantics: Any
) -> None:
    lo, hi = stl.parse(text).range([0, 1], {"x": [1, 2]}, semantics=semantics)
    assert (float(lo), float(hi)) == expected


@pytest.mark.parametrize("semantics", SEMANTICS)
@pytest.mark.parametrize("seed", [seed for seed in range(24) if seed not in (5, 11, 14, 17)])
def test_no_continuation_leaves_the_range(seed: int, semantics: Any) -> None:
    draw = random.Random(seed)
    formula = DenseDraw(seed, bounded=True).formula(1 + seed % 3)
    times = np.cumsum([0.25, *(draw.choice([0.25, 0.5, 1]) for _ in range(draw.randint(0, 4)))])
    seen = {name: [float(draw.randint(-4, 4)) for _ in times] for name in NAMES}
    lo, hi = formula.range(times, seen, semantics=semantics)
    verdict = formula.verdict(times, seen, semantics=semantics)
    for _ in range(8):
        later = times[-1] + np.cumsum([draw.choice([0.01, 0.25, 1, 3]) for _ in range(5)])
        positions = np.concatenate([times, later[: draw.randint(0, 5)]])
        values = [-50.0, -3, -1, 0, 1, 2, 50]
        signals = {
            name: seen[name] + [draw.choice(values) for _ in range(positions.size - times.size)]
            for name in NAMES
        }
        rho = formula.rho(positions, signals, semantics=semantics)
        assert lo - 1e-9 <= rho <= hi + 1e-9
        if verdict != "unknown":
            satisfied = formula.satisfied(positions, signals, semantics=semantics)
            assert satisfied == (verdict == "satisfied")


@pytest.mark.parametrize(
    ("text", "lo", "hi", "verdict"),
    [
        ("always[0, 2] (x > 0)", 1, 1, "satisfied"),
        ("always[0, 3] (x > 0)", -np.inf, 1, "unknown"),
        ("eventually[0, 3] (x > 5)", -2, np.inf, "unknown"),
        ("always (x < 2)", -np.inf, -1, "violated"),
        ("always[0, 2] (x >= 1)", 0, 0, "satisfied"),
        ("always[0, 2] (x > 1)", 0, 0, "violated"),
        ("always[0, 9] (x >= 1)", -np.inf, 0, "unknown"),
        ("always[0, 9] (x > 1)", -np.inf, 0, "violated"),
        ("eventually[3, 4] (x > 1 and x < 0)", -np.inf, -0.5, "violated"),
        ("eventually[3, 4] once[1, 2] (x > 2)", -np.inf, np.inf, "unknown"),
    ],
)
@pytest.mark.parametrize("semantics", SEMANTICS)
def test_ranges_by_hand(text: str, lo: float, hi: float, verdict: str, semantics: Any) -> None:
    formula, x = stl.parse(text), {"x": [2.0, 1.0, 3.0]}
    assert [float(end) for end in formula.range([0, 1, 2], x, semantics=semantics)] == [lo, hi]
    assert formula.verdict([0, 1, 2], x, semantics=semantics) == verdict


def test_a_batch_has_one_verdict_a_row() -> None:
    x = {"x": np.array([[2.0, 1.0], [-1.0, 2.0]]), "limit": np.array([[0.0], [5.0]])}
    formula = stl.parse("always[0, 1] (x > limit)")
    found = formula.verdict([0, 1], x, semantics="linear")
    assert np.asarray(found).tolist() == ["satisfied", "violated"]
    assert formula.range([0, 1], x, semantics="held").lo.tolist() == [1, -6]


@pytest.fixture
def touching(tmp_path: Path) -> str:
    """A trace that touches 0."""
    trace = tmp_path / "x.csv"
    trace.write_text("time,x\n0,2\n1,0\n2,1\n")
    return str(trace)


@pytest.mark.parametrize(
    ("limit", "code", "verdict"), [(">=", 0, "satisfied"), (">", 4, "violated")]
)
def test_the_command_decides_at_zero(
    limit: str, code: int, verdict: str, touching: str, capfd: pytest.CaptureFixture[str]
) -> None:
    formula = f"always[0, 2] (x {limit} 0)"
    with pytest.raises(SystemExit) as ended:
        main(["monitor", formula, touching, "--semantics", "linear", "--json"])
    found = json.loads(capfd.readouterr().out)
    assert (found["robustness"], found["range"], found["verdict"]) == (0, [0, 0], verdict)
    assert (found["sampling_error"], ended.value.code) == (1.0, code)


def test_the_command_bounds_the_sampling_error(
    touching: str, capfd: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit):
        main(["monitor", "always (x >= 0)", touching, "--semantics", "held"])
    assert "sampling error at most 2, if no signal changes faster" in capfd.readouterr().out


@pytest.mark.parametrize("semantics", ["held", "linear"])
@pytest.mark.parametrize("seed", range(5))
def test_no_continuation_leaves_the_range_of_a_duration(seed: int, semantics: Any) -> None:
    draw = DenseDraw(7700 + seed, bounded=True)
    operator: Any = draw.random.choice([">=", ">", "<", "<="])
    amount = draw.random.choice([0.25, 0.5, 1])
    lasting = stl.Duration(draw.interval(), draw.formula(seed % 2), operator, amount)
    formula = (lasting, stl.Always(stl.Interval(0, 1), lasting))[seed % 2]
    rng = np.random.default_rng(seed)
    times = np.cumsum(rng.choice([0.25, 0.5, 1], size=8))
    signals = {name: rng.integers(-4, 5, 8).astype(float) for name in NAMES}
    for known in (1, 5):
        seen = {name: values[:known] for name, values in signals.items()}
        lo, hi = formula.range(times[:known], seen, semantics=semantics)
        verdict = formula.verdict(times[:known], seen, semantics=semantics)
        for later in (known, known + 1, 8):
            part = {name: values[:later] for name, values in signals.items()}
            rho = formula.rho(times[:later], part, semantics=semantics)
            assert lo - 1e-9 <= rho <= hi + 1e-9
            holds = bool(formula.satisfied(times[:later], part, semantics=semantics))
            assert verdict == "unknown" or holds is (verdict == "satisfied")
