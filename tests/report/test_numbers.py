"""Numbers as people read them."""

from __future__ import annotations

import math

import pytest

from roadlang.report.numbers import number, percent, plain, quantity


@pytest.mark.parametrize(
    ("value", "digits", "text"),
    [
        (0.0, 3, "0"), (1.5, 3, "1.5"), (-1.25, 3, "\u22121.25"), (999.4, 3, "999"),
        (1000.0, 3, "1,000"), (-1234567.0, 3, "\u22121,234,567"), (1234.5, 6, "1234.5"),
        (1e-4, 3, "0.0001"), (9.9e-5, 3, "9.90e\u221205"), (0.123456, 4, "0.1235"),
        (math.inf, 3, "∞"), (-math.inf, 3, "\u2212∞"),
    ],
)  # fmt: skip
def test_few_digits_commas_and_a_minus(value: float, digits: int, text: str) -> None:
    assert number(value, digits) == text


@pytest.mark.parametrize(
    ("value", "unit", "text"),
    [
        (None, "m", "\u2013"), (2.5, "", "2.5"), (2.5, "m", "2.5\xa0m"),
        (math.pi, "rad", "180\xa0deg"),
        (3.0, "m/s^2", "3\xa0m/s²"), (3.0, "m/s^3", "3\xa0m/s³"),
    ],
)  # fmt: skip
def test_units_are_those_that_people_read(value: float | None, unit: str, text: str) -> None:
    assert quantity(value, unit) == text


def test_terminals_have_the_signs_of_keyboards() -> None:
    assert plain(f"{quantity(-2.5, 'm')} {number(-math.inf)}") == "-2.5 m -inf"
    assert plain(quantity(-1234567.0, "m")) == "-1234567 m"


def test_shares_are_in_percent() -> None:
    assert percent(0.12345) == "12.3%"
    assert percent(1.0) == "100%"
