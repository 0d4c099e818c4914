"""Times and scales as options: with units, as in scene files, or as plain numbers."""

from __future__ import annotations

import click
import pytest

from roadlang.cli.quantities import QuantityRange, pixel_size, seconds


@pytest.mark.parametrize(
    ("option", "written", "value"),
    [
        (seconds(), "60", 60.0),
        (seconds(), "60s", 60.0),
        (seconds(), "1.5min", 90.0),
        (seconds(), "250 ms", 0.25),
        (seconds(), "1e2s", 100.0),
        (pixel_size(), "0.5", 0.5),
        (pixel_size(), "0.5m/px", 0.5),
        (pixel_size(), "25cm/px", 0.25),
    ],
)
def test_a_number_may_have_a_unit(option: QuantityRange, written: str, value: float) -> None:
    assert option.convert(written, None, None) == pytest.approx(value)


@pytest.mark.parametrize("written", ["60m", "60km/h", "s", "sixty", "", "6..0s", "60 s s", "60%"])
def test_what_is_no_time_is_refused_with_an_example(written: str) -> None:
    with pytest.raises(click.BadParameter, match="such as 60s"):
        seconds().convert(written, None, None)


@pytest.mark.parametrize("written", ["10ms", "0", "-1s"])
def test_bounds_hold_for_the_time_in_seconds(written: str) -> None:
    with pytest.raises(click.BadParameter, match=r"write a number of at least 0\.1s"):
        seconds(min=0.1).convert(written, None, None)


@pytest.mark.parametrize("written", ["nan", "infs", "1e999s"])
def test_what_is_not_finite_is_refused(written: str) -> None:
    with pytest.raises(click.BadParameter):
        seconds().convert(written, None, None)
