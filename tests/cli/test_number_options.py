"""Options that are numbers say what was expected, whatever is written instead."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click
import pytest

import roadlang
from roadlang.cli.finite_range import FiniteNumber, FiniteRange, Seed, WholeNumber
from roadlang.cli.quantities import seconds

BELOW_256 = WholeNumber(1, 256)
SHARE = FiniteRange(0, 1, min_open=True, max_open=True)


@pytest.mark.parametrize(
    ("type_", "written", "said"),
    [
        (BELOW_256, "nan", "'nan' is not a whole number: write one from 1 to 256."),
        (BELOW_256, "1e2", "'1e2' is not a whole number: write one from 1 to 256."),
        (BELOW_256, "2.5", "'2.5' is not a whole number: write one from 1 to 256."),
        (BELOW_256, "1_0", "'1_0' is not a whole number: write one from 1 to 256."),
        (BELOW_256, "\uff11", "is not a whole number: write one from 1 to 256."),
        (BELOW_256, "", "'' is not a whole number: write one from 1 to 256."),
        (BELOW_256, "0", "0 is out of range: write a whole number from 1 to 256."),
        (BELOW_256, "-3", "-3 is out of range: write a whole number from 1 to 256."),
        (BELOW_256, "9" * 9000, "9... is out of range: write a whole number from 1 to 256."),
        (WholeNumber(min=1), "0", "0 is out of range: write a whole number of at least 1."),
        (Seed(), "1e5", "'1e5' is not a whole number: write one of at least 0."),
        (Seed(), "-1", "-1 is out of range: write a whole number of at least 0."),
        (Seed(), str(2**63), "a seed is at most 9223372036854775807."),
        (SHARE, "1", "1 is out of range: write a number above 0 and below 1."),
        (SHARE, "1_0", "'1_0' is not a finite number: write a number above 0 and below 1."),
        (FiniteRange(0, 1), "inf", "'inf' is not a finite number: write a number from 0 to 1."),
        (FiniteNumber(), "nan", "'nan' is not a finite number: write a number."),
        (seconds(min=0.1), "-5", "-5s is out of range: write a number of at least 0.1s."),
        (seconds(min=0, min_open=True), "0", "0s is out of range: write a number above 0s."),
    ],
)
def test_what_is_no_such_number_is_answered_with_one(
    type_: click.ParamType[Any], written: str, said: str
) -> None:
    with pytest.raises(click.BadParameter) as caught:
        type_.convert(written, None, None)
    assert caught.value.message.endswith(said)


def test_numbers_between_the_bounds_are_taken() -> None:
    assert BELOW_256.convert(" 256 ", None, None) == 256
    assert BELOW_256.convert(1, None, None) == 1
    assert Seed().convert(str(2**63 - 1), None, None) == 2**63 - 1
    assert SHARE.convert("0.25", None, None) == 0.25


def test_a_seed_in_python_has_the_same_bounds(tmp_path: Path) -> None:
    path = tmp_path / "a.rl"
    path.write_text("road main { draw with waypoints { points: [(0m, 0m), (80m, 0m)] } }\n")
    scenario = roadlang.load(path)
    assert scenario.sample(seed=2**63 - 1)[0].record.provenance.seed == 2**63 - 1
    with pytest.raises(ValueError, match="`seed` must be at most 9223372036854775807"):
        scenario.sample(seed=2**63)
